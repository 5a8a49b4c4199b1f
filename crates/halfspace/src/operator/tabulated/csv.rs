//! Tables of coefficients as comma-separated text.

use super::parity::{self, with_parity};
use super::{NAMES, TabulatedKernel};
use crate::operator::{OperatorError, memory};
use crate::{Coefficients, Grid};

impl TabulatedKernel {
    /// From comma-separated text.
    ///
    /// The header line names the columns: `columns`, `rows` (the offset in cells, integers) and any
    /// of `xx, xy, xz, yx, yy, yz, zx, zy, zz`; coefficients not named are zero. If all offsets are
    /// >= 0, the others follow from the parity rules (4.23) of a body symmetric about both axes.
    ///
    /// # Errors
    /// [`OperatorError`] for a line that cannot be read, an offset of the grid that is missing, a coefficient
    /// that its parity forbids, and a grid too large for memory.
    pub fn from_csv(grid: Grid, text: &str) -> Result<Self, OperatorError> {
        memory::check(Self::bytes(grid))?;
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let (_, head) = lines.next().ok_or_else(|| table_error(1, "no head"))?;
        let head = Head::parse(head)?;
        let mut entries = std::collections::HashMap::new();
        let mut symmetric = true;
        for (number, line) in lines {
            let (offset, value) = head.entry(number + 1, line)?;
            symmetric &= offset.0 >= 0 && offset.1 >= 0;
            if entries.insert(offset, value).is_some() {
                return Err(table_error(number + 1, "this offset was given before"));
            }
        }
        // In the order of the offsets, so that always the same one is named.
        let (nx, ny) = (grid.nx() as i32, grid.ny() as i32);
        let first = |count: i32| if symmetric { 0 } else { 1 - count };
        for rows in first(ny)..ny {
            for columns in first(nx)..nx {
                let absent = OperatorError::Absent { columns, rows };
                let value = entries.get(&(columns, rows)).ok_or(absent)?;
                if symmetric {
                    parity::check(value, columns, rows)?;
                }
            }
        }
        Self::from_function(grid, |columns, rows| {
            let (key, signs) = if symmetric {
                ((columns.abs(), rows.abs()), [columns.signum(), rows.signum()])
            } else {
                ((columns, rows), [1, 1])
            };
            entries.get(&key).map_or_else(Coefficients::default, |value| {
                with_parity(*value, signs.map(f64::from))
            })
        })
    }
}

fn table_error(line: usize, reason: impl Into<String>) -> OperatorError {
    OperatorError::Table { line, reason: reason.into() }
}

/// The meaning of each column of a table.
struct Head(Vec<Column>);

#[derive(Clone, Copy)]
enum Column {
    Columns,
    Rows,
    Value(usize, usize),
}

impl Head {
    fn parse(line: &str) -> Result<Self, OperatorError> {
        let column = |name: &str| match name.trim() {
            "columns" => Ok(Column::Columns),
            "rows" => Ok(Column::Rows),
            name => NAMES
                .iter()
                .enumerate()
                .find_map(|(i, row)| row.iter().position(|n| *n == name).map(|l| (i, l)))
                .map(|(i, l)| Column::Value(i, l))
                .ok_or_else(|| table_error(1, format!("unknown column \"{name}\""))),
        };
        let columns: Vec<Column> = line.split(',').map(column).collect::<Result<_, _>>()?;
        let has = |wanted: fn(&Column) -> bool| columns.iter().filter(|c| wanted(c)).count() == 1;
        if !has(|c| matches!(c, Column::Columns)) || !has(|c| matches!(c, Column::Rows)) {
            return Err(table_error(1, "must name columns and rows once"));
        }
        Ok(Self(columns))
    }

    /// Offset and coefficients of one line.
    fn entry(
        &self,
        number: usize,
        line: &str,
    ) -> Result<((i32, i32), Coefficients), OperatorError> {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        if cells.len() != self.0.len() {
            let reason = format!("{} values, the head names {}", cells.len(), self.0.len());
            return Err(table_error(number, reason));
        }
        let bad = |cell: &str| table_error(number, format!("\"{cell}\" is not a number"));
        let mut offset = (0, 0);
        let mut value = Coefficients::default();
        for (column, cell) in self.0.iter().zip(cells) {
            match column {
                Column::Columns => offset.0 = cell.parse().map_err(|_| bad(cell))?,
                Column::Rows => offset.1 = cell.parse().map_err(|_| bad(cell))?,
                Column::Value(i, l) => {
                    let number: f64 = cell.parse().map_err(|_| bad(cell))?;
                    value.rows[*i][*l] =
                        if number.is_finite() { number } else { return Err(bad(cell)) };
                }
            }
        }
        Ok((offset, value))
    }
}
