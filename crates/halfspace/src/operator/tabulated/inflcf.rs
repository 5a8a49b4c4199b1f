//! Tables of coefficients in the format of the program CONTACT.

use super::TabulatedKernel;
use crate::operator::{OperatorError, memory};
use crate::{Coefficients, Grid};
use carom_special::RangeError;

/// The units of a file of influence coefficients of the program CONTACT, which holds displacements times the shear
/// modulus of the pair over tractions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InflcfUnits {
    length: f64,
    shear_modulus: f64,
}

impl InflcfUnits {
    /// Lengths of the file are in `length` metres, 1e-3 for millimetres; `shear_modulus` is that of the pair of
    /// bodies, Pa: 2/(1/G_1 + 1/G_2).
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite and > 0.
    pub fn new(length: f64, shear_modulus: f64) -> Result<Self, RangeError> {
        RangeError::positive("length", length)?;
        RangeError::positive("shear_modulus", shear_modulus)?;
        Ok(Self { length, shear_modulus })
    }
}

/// Relative difference of cell widths that counts as rounding of the file.
const ROUNDING: f64 = 1e-4;
/// Where each number of a line stands in (4.14): n, x, y due to n, x, y.
const ORDER: [usize; 3] = [2, 0, 1];

impl TabulatedKernel {
    /// From a file of influence coefficients (`inflcf`) of the program CONTACT: one matrix, all nine coefficients
    /// in the order n, x, y (312), symmetric in x and not in y.
    ///
    /// In the file the offset is receiver minus source, here source minus receiver. The file may have more offsets
    /// than the grid; comments begin with `%`.
    ///
    /// # Errors
    /// [`OperatorError::Table`] for a line that cannot be read, another kind of file, other cells or fewer
    /// offsets than those of the grid, [`OperatorError::TooLarge`].
    pub fn from_inflcf(grid: Grid, text: &str, units: InflcfUnits) -> Result<Self, OperatorError> {
        memory::check(Self::bytes(grid))?;
        let mut lines = Lines(text.lines().enumerate());
        let size = head(&mut lines, grid, units)?;
        let values = matrix(&mut lines, size)?;
        let [mx, my] = size;
        let scale = units.length / units.shear_modulus;
        Self::from_function(grid, |columns, rows| {
            // Receiver minus source; the file has those >= 0 along x.
            let (ix, iy) = (-columns, -rows);
            let row = (iy + my as i32 - 1) as usize;
            let known = &values[row * mx + ix.unsigned_abs() as usize];
            let sign = if ix < 0 { -1.0 } else { 1.0 };
            let mut value = Coefficients::default();
            for (i, of) in ORDER.into_iter().enumerate() {
                for (l, by) in ORDER.into_iter().enumerate() {
                    let odd = (of == 0) != (by == 0);
                    value.rows[of][by] = scale * known[3 * i + l] * if odd { sign } else { 1.0 };
                }
            }
            value
        })
    }
}

/// The lines that hold numbers, without comments, and their numbers from 1.
struct Lines<'a>(std::iter::Enumerate<std::str::Lines<'a>>);

impl Lines<'_> {
    /// The first `COUNT` numbers of the next line that has any, and the number of the line.
    fn numbers<const COUNT: usize>(
        &mut self,
        what: &str,
    ) -> Result<(usize, [f64; COUNT]), OperatorError> {
        let mut line = 0;
        for (i, text) in self.0.by_ref() {
            line = i + 1;
            let words: Vec<&str> =
                text.split('%').next().unwrap_or_default().split_whitespace().collect();
            if words.is_empty() {
                continue;
            }
            if words.len() < COUNT {
                let found = words.len();
                return Err(table_error(line, format!("{found} numbers, not {COUNT}: {what}")));
            }
            let mut numbers = [0.0; COUNT];
            for (number, word) in numbers.iter_mut().zip(words) {
                *number = finite(word).ok_or_else(|| {
                    table_error(line, format!("\"{word}\" is not a finite number ({what})"))
                })?;
            }
            return Ok((line, numbers));
        }
        Err(table_error(line + 1, format!("the file ends before {what}")))
    }
}

/// A number as Fortran writes it, which may be 1D-3.
fn finite(word: &str) -> Option<f64> {
    word.replace(['d', 'D'], "e").parse().ok().filter(|number: &f64| number.is_finite())
}

fn table_error(line: usize, reason: String) -> OperatorError {
    OperatorError::Table { line, reason }
}

/// Reads the four lines of the head; returns how many offsets >= 0 the file has along each axis.
fn head(
    lines: &mut Lines<'_>,
    grid: Grid,
    units: InflcfUnits,
) -> Result<[usize; 2], OperatorError> {
    let (line, [matrices, _]) = lines.numbers("number of matrices, convex body")?;
    if matrices != 1.0 {
        return Err(table_error(
            line,
            format!(
                "{matrices} matrices, one for each loaded row of cells: must be 1, the same for all rows"
            ),
        ));
    }
    let (line, [uncoupled, order]) = lines.numbers("quasi-identity, order of the axes")?;
    if uncoupled != 0.0 || order != 312.0 {
        let reason = format!(
            "{uncoupled} and {order}: must be 0 and 312, nine numbers a line in the order n, x, y"
        );
        return Err(table_error(line, reason));
    }
    let (line, [along, across]) = lines.numbers("symmetry in x and in y")?;
    if along != 1.0 || across != 0.0 {
        let reason = format!("{along} and {across}: must be 1 and 0, symmetric in x and not in y");
        return Err(table_error(line, reason));
    }
    let (line, [mx, my, dx, dy]) = lines.numbers("cells and their widths")?;
    for (name, own, given) in [("dx", grid.dx(), dx), ("dy", grid.dy(), dy)] {
        let given = given * units.length;
        let is_same = (given - own).abs() <= ROUNDING * own;
        if !is_same {
            let reason = format!("{name} is {given} m in the file and {own} m in the grid");
            return Err(table_error(line, reason));
        }
    }
    let counts = [("mx", grid.nx(), mx), ("my", grid.ny(), my)];
    for (name, own, given) in counts {
        let whole = given.fract() == 0.0 && given >= own as f64 && given <= f64::from(MOST);
        if !whole {
            let reason = format!(
                "{name} is {given}: must be whole, at least the {own} cells of the grid and at most {MOST}"
            );
            return Err(table_error(line, reason));
        }
    }
    Ok([mx as usize, my as usize])
}

/// The most cells of a file along an axis.
const MOST: i32 = 100_000;

/// Reads the coefficients: for each offset along y from 1 - my to my - 1 those along x from 0 to mx - 1.
fn matrix(lines: &mut Lines<'_>, [mx, my]: [usize; 2]) -> Result<Vec<[f64; 9]>, OperatorError> {
    let mut values = Vec::new();
    for row in 0..2 * my - 1 {
        for ix in 0..mx {
            let iy = row as i64 + 1 - my as i64;
            let what = format!("the coefficients of {ix} columns and {iy} rows");
            let (line, numbers) = lines.numbers::<11>(&what)?;
            if numbers[0] != ix as f64 {
                let reason = format!("it begins with {}, not with {ix}: {what}", numbers[0]);
                return Err(table_error(line, reason));
            }
            values.push(std::array::from_fn(|i| numbers[2 + i]));
        }
    }
    Ok(values)
}
