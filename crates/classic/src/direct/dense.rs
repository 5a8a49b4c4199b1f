//! Dense linear systems of cells.

use carom_dense::{Factors, Mat};

use super::DirectError;

/// Greatest number of unknowns of a dense system, whose matrix takes 200 MB.
const MOST_UNKNOWNS: usize = 5000;

/// An unknown and its equation: a traction along `direction` on a cell, and the displacement of
/// that cell along `test`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unknown {
    pub(crate) cell: usize,
    pub(crate) direction: [f64; 3],
    pub(crate) test: [f64; 3],
    /// Additional coefficient of the unknown in its own equation.
    pub(crate) own: f64,
    /// The right-hand side.
    pub(crate) right: f64,
}

/// Solves for the unknowns by elimination; `block` holds the nine coefficients of two cells,
/// receiver first.
pub(crate) fn solve(
    unknowns: &[Unknown],
    block: impl Fn(usize, usize) -> [[f64; 3]; 3],
) -> Result<Vec<f64>, DirectError> {
    let count = unknowns.len();
    if count == 0 {
        return Ok(Vec::new());
    }
    if count > MOST_UNKNOWNS {
        return Err(DirectError::TooMany { unknowns: count, allowed: MOST_UNKNOWNS });
    }
    let matrix = Mat::from_fn(count, count, |row, column| {
        let (to, from) = (&unknowns[row], &unknowns[column]);
        let coefficients = block(to.cell, from.cell);
        let part = |(test, row): (&f64, &[f64; 3])| test * dot(row, &from.direction);
        let by_traction: f64 = to.test.iter().zip(&coefficients).map(part).sum();
        by_traction + if row == column { to.own } else { 0.0 }
    });
    let right: Vec<f64> = unknowns.iter().map(|unknown| unknown.right).collect();
    let amounts = Factors::new(&matrix).solve(&right);
    if amounts.iter().all(|amount| amount.is_finite()) {
        Ok(amounts)
    } else {
        Err(DirectError::Singular { unknowns: count })
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// One axis.
pub(crate) const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
