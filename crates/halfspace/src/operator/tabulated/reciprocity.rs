//! Betti's theorem for a table of coefficients.

use super::{NAMES, TabulatedKernel};
use crate::Coefficients;
use crate::operator::OperatorError;

/// Deviation from reciprocity, relative to the largest coefficient, that counts as rounding of the table.
const ROUNDING: f64 = 1e-3;

impl TabulatedKernel {
    /// Checks that the displacement of one cell along i due to a traction on another along l equals the converse,
    /// `A_il(offset) = A_li(-offset)`, as Betti's theorem says for elastic bodies, to 1e-3 of the largest
    /// coefficient; returns the mean of both.
    ///
    /// # Errors
    /// [`OperatorError::NotReciprocal`] with the pair that differs most.
    pub fn reciprocal(&self) -> Result<Self, OperatorError> {
        let largest = self.values.iter().map(Coefficients::largest).fold(0.0, f64::max);
        let (nx, ny) = (self.grid.nx() as i32, self.grid.ny() as i32);
        let mut worst = (ROUNDING * largest, None);
        for rows in 1 - ny..ny {
            for columns in 1 - nx..nx {
                let own = self.coefficients(columns, rows);
                let other = self.coefficients(-columns, -rows);
                for (i, names) in NAMES.iter().enumerate() {
                    for (l, of) in names.iter().enumerate() {
                        let (value, converse) = (own.rows[i][l], other.rows[l][i]);
                        if (value - converse).abs() > worst.0 {
                            let by = NAMES[l][i];
                            let error = OperatorError::NotReciprocal {
                                of,
                                value,
                                by,
                                converse,
                                columns,
                                rows,
                            };
                            worst = ((value - converse).abs(), Some(error));
                        }
                    }
                }
            }
        }
        if let Some(error) = worst.1 {
            return Err(error);
        }
        Self::from_function(self.grid, |columns, rows| {
            let mut mean = self.coefficients(columns, rows);
            let other = self.coefficients(-columns, -rows);
            for (i, row) in mean.rows.iter_mut().enumerate() {
                for (l, entry) in row.iter_mut().enumerate() {
                    *entry = 0.5 * (*entry + other.rows[l][i]);
                }
            }
            mean
        })
    }
}
