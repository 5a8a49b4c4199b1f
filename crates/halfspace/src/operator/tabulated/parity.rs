//! The parity rules (4.23) of a body that is symmetric about both axes.

use super::{NAMES, OperatorError};
use crate::Coefficients;

/// The sign of coefficient `[i][l]` at the offset `[-x, -y]`, `[x, -y]` or `[-x, y]`, given the signs of the offset.
const fn factor(i: usize, l: usize, [x, y]: [f64; 2]) -> f64 {
    match (i, l) {
        (0, 1) | (1, 0) => x * y,
        (0, 2) | (2, 0) => x,
        (1, 2) | (2, 1) => y,
        _ => 1.0,
    }
}

/// The coefficients at an offset with these signs, from those at its magnitudes; signum is 0 at 0, where an odd
/// coefficient vanishes.
pub(super) fn with_parity(mut value: Coefficients, signs: [f64; 2]) -> Coefficients {
    for (i, row) in value.rows.iter_mut().enumerate() {
        for (l, entry) in row.iter_mut().enumerate() {
            *entry *= factor(i, l, signs);
        }
    }
    value
}

/// Checks that the coefficients at an offset >= 0 agree with their own mirror image: what is odd in a direction
/// is zero where the offset in it is zero.
pub(super) fn check(value: &Coefficients, columns: i32, rows: i32) -> Result<(), OperatorError> {
    let signs = [columns.signum(), rows.signum()].map(f64::from);
    for (i, row) in value.rows.iter().enumerate() {
        for (l, entry) in row.iter().enumerate() {
            if *entry != 0.0 && factor(i, l, signs) == 0.0 {
                return Err(OperatorError::Odd { of: NAMES[i][l], value: *entry, columns, rows });
            }
        }
    }
    Ok(())
}
