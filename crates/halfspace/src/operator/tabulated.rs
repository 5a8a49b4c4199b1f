//! Kernels given by the user as a table or as a function of the offset (section 16.2).

use super::length::Sizes;
use super::memory;
use super::plan::Plan;
use super::product::{Term, apply};
use super::spectrum::Spectrum;
use super::{
    Axis, DisplacementField, OperatorError, SurfaceOperator, Threads, TractionField, Workspace,
};
use crate::{Coefficients, Grid};

/// The response of a body to unit tractions on one cell, at every offset of a grid.
///
/// For bodies other than half-spaces whose response depends on the offset only: a layer, a hollow
/// cylinder, a measured point-load response. The coefficients are those of (4.14): `rows[i][l]` is
/// displacement i due to traction l; offsets are source minus receiver, in cells.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_halfspace::operator::TabulatedKernel;
/// let text = "columns,rows,zz\n0,0,3.5\n1,0,1.0\n0,1,1.0\n1,1,0.7\n";
/// let kernel = TabulatedKernel::from_csv(Grid::new(2, 2, 1.0, 1.0)?, text)?;
/// assert_eq!(kernel.coefficients(-1, 1).rows[2][2], 0.7);
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
#[derive(Debug, Clone)]
pub struct TabulatedKernel {
    grid: Grid,
    /// Offsets `1 - nx..nx` by `1 - ny..ny`, columns running fastest.
    values: Vec<Coefficients>,
}

/// Names of the coefficients in a table, by row and column of (4.14).
const NAMES: [[&str; 3]; 3] = [["xx", "xy", "xz"], ["yx", "yy", "yz"], ["zx", "zy", "zz"]];

impl TabulatedKernel {
    /// From `function(columns, rows)`, which is called once for every offset.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`], and [`OperatorError::Kernel`] if a value is not finite.
    pub fn from_function(
        grid: Grid,
        function: impl Fn(i32, i32) -> Coefficients,
    ) -> Result<Self, OperatorError> {
        memory::check(Self::bytes(grid))?;
        let (nx, ny) = (grid.nx() as i32, grid.ny() as i32);
        let mut values = Vec::with_capacity((2 * grid.nx() - 1) * (2 * grid.ny() - 1));
        for rows in 1 - ny..ny {
            for columns in 1 - nx..nx {
                let value = function(columns, rows);
                if !value.rows.iter().flatten().all(|v| v.is_finite()) {
                    return Err(OperatorError::Kernel { columns, rows });
                }
                values.push(value);
            }
        }
        Ok(Self { grid, values })
    }

    /// From comma-separated text.
    ///
    /// The header line names the columns: `columns`, `rows` (the offset in cells, integers) and any
    /// of `xx, xy, xz, yx, yy, yz, zx, zy, zz`; coefficients not named are zero. If all offsets are
    /// >= 0, the others follow from the parity rules (4.23) of a body symmetric about both axes.
    ///
    /// # Errors
    /// [`OperatorError`] for a line that cannot be read, an offset of the grid that is missing, and
    /// a grid too large for memory.
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
        let absent = std::cell::Cell::new(None);
        let kernel = Self::from_function(grid, |columns, rows| {
            let (key, sign) = if symmetric {
                ((columns.abs(), rows.abs()), [columns.signum(), rows.signum()])
            } else {
                ((columns, rows), [1, 1])
            };
            match entries.get(&key) {
                Some(value) => with_parity(*value, sign.map(f64::from)),
                None => {
                    absent.set(absent.get().or(Some(key)));
                    Coefficients::default()
                }
            }
        })?;
        match absent.get() {
            Some((columns, rows)) => Err(OperatorError::Absent { columns, rows }),
            None => Ok(kernel),
        }
    }

    fn bytes(grid: Grid) -> u128 {
        72 * (2 * grid.nx() as u128 - 1) * (2 * grid.ny() as u128 - 1)
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The nine coefficients at an offset, source minus receiver; zero beyond the grid.
    #[must_use]
    pub fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        let (nx, ny) = (self.grid.nx() as i32, self.grid.ny() as i32);
        if columns.abs() >= nx || rows.abs() >= ny {
            return Coefficients::default();
        }
        let at = (rows + ny - 1) as usize * (2 * self.grid.nx() - 1) + (columns + nx - 1) as usize;
        self.values[at]
    }

    fn is_zero(&self, of: Axis, by: Axis) -> bool {
        self.values.iter().all(|value| value.rows[of as usize][by as usize] == 0.0)
    }
}

/// The parity rules (4.23); signum is 0 at 0, where an odd coefficient vanishes.
fn with_parity(mut value: Coefficients, [x, y]: [f64; 2]) -> Coefficients {
    let factor = |i: usize, l: usize| match (i, l) {
        (0, 1) | (1, 0) => x * y,
        (0, 2) | (2, 0) => x,
        (1, 2) | (2, 1) => y,
        _ => 1.0,
    };
    for (i, row) in value.rows.iter_mut().enumerate() {
        for (l, entry) in row.iter_mut().enumerate() {
            *entry *= factor(i, l);
        }
    }
    value
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

/// The operator of a [`TabulatedKernel`].
#[derive(Clone)]
pub struct KernelOperator {
    kernel: TabulatedKernel,
    plan: Plan,
    spectra: [[Option<Spectrum>; 3]; 3],
}

impl KernelOperator {
    /// The operator of `kernel`; its products are computed on `threads`.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] before the transforms are allocated.
    pub fn new(kernel: TabulatedKernel, threads: Threads) -> Result<Self, OperatorError> {
        let grid = kernel.grid();
        let held = Axis::ALL.map(|of| Axis::ALL.map(|by| !kernel.is_zero(of, by)));
        let count = held.iter().flatten().filter(|held| **held).count();
        let sizes = Sizes::of(grid);
        memory::check(count as u128 * sizes.general_spectrum() + sizes.workspace(3, threads))?;
        let plan = Plan::new(grid, threads);
        let spectra = Axis::ALL.map(|of| {
            Axis::ALL.map(|by| {
                let (i, l) = (of as usize, by as usize);
                held[i][l].then(|| {
                    Spectrum::general(&plan, |columns, rows| {
                        kernel.coefficients(columns, rows).rows[i][l]
                    })
                })
            })
        });
        Ok(Self { kernel, plan, spectra })
    }

    pub(super) const fn threads(&self) -> Threads {
        self.plan.threads
    }
}

impl SurfaceOperator for KernelOperator {
    fn grid(&self) -> Grid {
        self.kernel.grid()
    }

    fn is_coupled(&self) -> bool {
        let [u, v, w] = &self.spectra;
        [&u[2], &v[2], &w[0], &w[1]].iter().any(|spectrum| spectrum.is_some())
    }

    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        self.kernel.coefficients(columns, rows)
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        let term = |of: Axis, by: Axis| {
            let spectrum = self.spectra[of as usize][by as usize].as_ref();
            Ok(spectrum.map(|spectrum| Term { spectrum, sign: 1.0 }))
        };
        apply(&self.plan, term, tractions, displacements, workspace)
    }
}

impl std::fmt::Debug for KernelOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("KernelOperator").field("grid", &self.kernel.grid()).finish_non_exhaustive()
    }
}
