//! Kernels given by the user as a table or as a function of the offset (section 16.2).

mod blocks;
mod csv;
mod definite;
mod inflcf;
mod operator;
mod parity;
mod reciprocity;

pub use blocks::KernelBlock;
pub use inflcf::InflcfUnits;
pub use operator::KernelOperator;

use super::{Axis, OperatorError, memory};
use crate::{Coefficients, Grid};

/// The response of a body to unit tractions on one cell, at every offset of a grid.
///
/// For bodies other than half-spaces whose response depends on the offset only: a layer, a hollow
/// cylinder, a measured point-load response. The coefficients are those of (4.14): `rows[i][l]` is
/// displacement i due to traction l, in m/Pa; offsets are source minus receiver, in cells.
///
/// A table comes from a function, from comma-separated text, from blocks of numbers or from a file of the
/// program CONTACT. [`TabulatedKernel::reciprocal`] checks that it obeys Betti's theorem, and
/// [`KernelOperator::check_definite`] that every traction does positive work, as those of elastic bodies do.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_halfspace::operator::TabulatedKernel;
/// let text = "columns,rows,zz\n0,0,3.5\n1,0,1.0\n0,1,1.0\n1,1,0.7\n";
/// let kernel = TabulatedKernel::from_csv(Grid::new(2, 2, 1.0, 1.0)?, text)?;
/// assert_eq!(kernel.coefficients(-1, 1).rows[2][2], 0.7);
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
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

    /// All coefficients times `factor`.
    ///
    /// # Errors
    /// [`OperatorError::Kernel`] if a product is not finite.
    pub fn scaled(&self, factor: f64) -> Result<Self, OperatorError> {
        Self::from_function(self.grid, |columns, rows| {
            let mut value = self.coefficients(columns, rows);
            value.rows.iter_mut().flatten().for_each(|entry| *entry *= factor);
            value
        })
    }

    /// The coefficients of cells twice as wide: the mean displacement of four cells due to the same traction
    /// on four cells. A single row or column keeps its coefficients. Offsets beyond the table take its last values.
    ///
    /// # Errors
    /// [`OperatorError::Range`] if the grid cannot be made coarser.
    fn coarser(&self) -> Result<Self, OperatorError> {
        self.coarser_towards(self.grid.coarser()?)
    }

    /// The coefficients of cells twice as wide along the axes along which those of `wanted` are wider.
    fn coarser_towards(&self, wanted: Grid) -> Result<Self, OperatorError> {
        let own = self.grid;
        let twice = own.coarser()?;
        let [along, across] = [
            Halves::of(own.nx(), wanted.dx() > own.dx()),
            Halves::of(own.ny(), wanted.dy() > own.dy()),
        ];
        let pick = |wider: bool, wide: f64, own: f64| if wider { wide } else { own };
        let grid = Grid::new(
            if along.step == 2 { twice.nx() } else { own.nx() },
            if across.step == 2 { twice.ny() } else { own.ny() },
            pick(wanted.dx() > own.dx(), twice.dx(), own.dx()),
            pick(wanted.dy() > own.dy(), twice.dy(), own.dy()),
        )?;
        let (nx, ny) = (own.nx() as i32, own.ny() as i32);
        Self::from_function(grid, |columns, rows| {
            let mut sum = Coefficients::default();
            for (column, x) in along.weights {
                for (row, y) in across.weights {
                    let known = self.coefficients(
                        (along.step * columns + column).clamp(1 - nx, nx - 1),
                        (across.step * rows + row).clamp(1 - ny, ny - 1),
                    );
                    let pairs = sum.rows.iter_mut().flatten().zip(known.rows.iter().flatten());
                    pairs.for_each(|(sum, known)| *sum += x * y * known);
                }
            }
            sum
        })
    }

    fn is_zero(&self, of: Axis, by: Axis) -> bool {
        self.values.iter().all(|value| value.rows[of as usize][by as usize] == 0.0)
    }
}

/// How cells along one axis are joined: offsets in fine cells for one coarse cell, and the offsets about it with
/// their weights.
struct Halves {
    step: i32,
    weights: &'static [(i32, f64)],
}

impl Halves {
    const fn of(count: usize, wider: bool) -> Self {
        match count > 1 && wider {
            true => Self { step: 2, weights: &[(-1, 0.5), (0, 1.0), (1, 0.5)] },
            false => Self { step: 1, weights: &[(0, 1.0)] },
        }
    }
}
