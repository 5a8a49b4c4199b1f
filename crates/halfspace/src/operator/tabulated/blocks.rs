//! Tables of coefficients as blocks of numbers, one for each pair of a displacement and a traction.

use super::parity::{self, with_parity};
use super::{NAMES, TabulatedKernel};
use crate::operator::{Axis, OperatorError, memory};
use crate::{Coefficients, Grid};

/// One coefficient of (4.14) at all offsets: a row of numbers for each offset along y.
#[derive(Debug, Clone, PartialEq)]
pub struct KernelBlock {
    of: Axis,
    by: Axis,
    columns: usize,
    values: Vec<f64>,
}

impl KernelBlock {
    /// The block `name`, `xx` to `zz`: displacement, then traction. `rows[m][n]` belongs to the offset of n columns
    /// and m rows, source minus receiver, both counted from 0; or, if there are 2 nx - 1 by 2 ny - 1 numbers, from
    /// 1 - nx and 1 - ny.
    ///
    /// # Errors
    /// [`OperatorError::Block`] for another name, no number, rows of unlike length, or a number that is not
    /// finite.
    pub fn new(name: &str, rows: &[Vec<f64>]) -> Result<Self, OperatorError> {
        let wrong = |reason: String| OperatorError::Block { name: name.to_owned(), reason };
        let place = NAMES.iter().flatten().position(|known| *known == name).ok_or_else(|| {
            wrong(format!("its name must be one of {}", NAMES.as_flattened().join(", ")))
        })?;
        let columns = rows.first().map_or(0, Vec::len);
        if columns == 0 {
            return Err(wrong("it has no number".to_owned()));
        }
        for (m, row) in rows.iter().enumerate() {
            if row.len() != columns {
                let found = row.len();
                return Err(wrong(format!(
                    "row {} has {found} numbers, row 1 has {columns}",
                    m + 1
                )));
            }
            if let Some(n) = row.iter().position(|value| !value.is_finite()) {
                let (row, value) = (m + 1, row[n]);
                return Err(wrong(format!(
                    "the number in row {row}, column {} is {value}: must be finite",
                    n + 1
                )));
            }
        }
        let (of, by) = (Axis::ALL[place / 3], Axis::ALL[place % 3]);
        Ok(Self { of, by, columns, values: rows.concat() })
    }

    /// Columns and rows.
    const fn size(&self) -> [usize; 2] {
        [self.columns, self.values.len() / self.columns]
    }

    fn name(&self) -> &'static str {
        NAMES[self.of as usize][self.by as usize]
    }
}

impl TabulatedKernel {
    /// From blocks of numbers; coefficients without a block are zero. All blocks have nx columns and ny rows, and
    /// the coefficients at negative offsets follow from the parity rules (4.23); or all have 2 nx - 1 columns and
    /// 2 ny - 1 rows.
    ///
    /// # Errors
    /// [`OperatorError::Block`] for no block, one given twice or of another size, [`OperatorError::Odd`] for a
    /// coefficient that its parity forbids, [`OperatorError::TooLarge`].
    pub fn from_blocks(grid: Grid, blocks: &[KernelBlock]) -> Result<Self, OperatorError> {
        memory::check(Self::bytes(grid))?;
        let quarter = [grid.nx(), grid.ny()];
        let whole = quarter.map(|count| 2 * count - 1);
        let first = blocks.first().ok_or_else(|| OperatorError::Block {
            name: "zz".to_owned(),
            reason: "it is missing, as are all others".to_owned(),
        })?;
        let (size, mut held) = (first.size(), [[None; 3]; 3]);
        for block in blocks {
            let wrong =
                |reason: String| OperatorError::Block { name: block.name().to_owned(), reason };
            let [columns, rows] = block.size();
            if block.size() != size || (size != quarter && size != whole) {
                return Err(wrong(format!(
                    "it has {columns} columns and {rows} rows: must have {} and {}, or {} and {}, as all blocks",
                    quarter[0], quarter[1], whole[0], whole[1]
                )));
            }
            let place: &mut Option<&KernelBlock> = &mut held[block.of as usize][block.by as usize];
            if place.replace(block).is_some() {
                return Err(wrong("it is given twice".to_owned()));
            }
        }
        let at = |column: usize, row: usize| Coefficients {
            rows: held.map(|of| {
                of.map(|block| block.map_or(0.0, |block| block.values[row * size[0] + column]))
            }),
        };
        if size == whole && size != quarter {
            let [nx, ny] = quarter.map(|count| count as i32);
            return Self::from_function(grid, |columns, rows| {
                at((columns + nx - 1) as usize, (rows + ny - 1) as usize)
            });
        }
        for row in 0..quarter[1] {
            for column in 0..quarter[0] {
                parity::check(&at(column, row), column as i32, row as i32)?;
            }
        }
        Self::from_function(grid, |columns, rows| {
            let value = at(columns.unsigned_abs() as usize, rows.unsigned_abs() as usize);
            with_parity(value, [columns.signum(), rows.signum()].map(f64::from))
        })
    }
}
