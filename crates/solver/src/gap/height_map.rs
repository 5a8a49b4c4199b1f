//! Measured heights of a surface.

use carom_halfspace::{Field, Grid};

use super::Gap;

/// Heights of a surface on a regular lattice, row by row, x and y ascending.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_solver::HeightMap;
/// let map = HeightMap::from_rows(&[vec![0.0, 1.0], vec![3.0, 2.0]])?;
/// let gap = map.gap(Grid::new(2, 2, 0.5, 0.5)?)?;
/// assert_eq!(gap.heights().values(), [3.0, 2.0, 0.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    columns: usize,
    values: Vec<f64>,
}

/// Why rows of numbers are not a height map.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum HeightMapError {
    /// There are no values.
    #[error("the height map is empty")]
    Empty,
    /// A row is longer or shorter than the first.
    #[error("row {row} of the height map has {found} values, the first {expected}")]
    Ragged {
        /// The row, from 1.
        row: usize,
        /// Number of values in this row.
        found: usize,
        /// Number of values in the first row.
        expected: usize,
    },
    /// A value is infinite or not a number.
    #[error("the height map is {value} in row {row}, column {column}: must be finite")]
    NotFinite {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The value.
        value: f64,
    },
    /// A height is so large that its square times a modulus overflows.
    #[error(
        "the height map is {value:e} in row {row}, column {column}: must be at most 1e100 times the \
         longer side of the grid"
    )]
    TooLarge {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The value.
        value: f64,
    },
    /// The size differs from that of the grid.
    #[error(
        "the height map has {} x {} values, the grid {} x {} cells",
        .found[0], .found[1], .grid[0], .grid[1]
    )]
    OtherSize {
        /// Columns and rows of the height map.
        found: [usize; 2],
        /// Columns and rows of the grid.
        grid: [usize; 2],
    },
}

/// The largest height over the longer side of the grid.
const MOST_HEIGHT: f64 = 1e100;

impl HeightMap {
    /// From heights row by row, y ascending, `columns` in each row.
    ///
    /// # Errors
    /// As [`HeightMap::from_rows`].
    pub fn new(columns: usize, values: Vec<f64>) -> Result<Self, HeightMapError> {
        if columns == 0 || values.is_empty() {
            return Err(HeightMapError::Empty);
        }
        let found = values.len() % columns;
        if found > 0 {
            let row = values.len() / columns + 1;
            return Err(HeightMapError::Ragged { row, found, expected: columns });
        }
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(Self { columns, values }),
            Some(place) => {
                let (row, column, value) =
                    (place / columns + 1, place % columns + 1, values[place]);
                Err(HeightMapError::NotFinite { row, column, value })
            }
        }
    }

    /// From the rows of heights, y ascending.
    ///
    /// # Errors
    /// [`HeightMapError`] if there are no values, rows differ in length, or a value is not finite.
    pub fn from_rows(rows: &[Vec<f64>]) -> Result<Self, HeightMapError> {
        let columns = rows.first().map_or(0, Vec::len);
        if columns == 0 {
            return Err(HeightMapError::Empty);
        }
        for (i, row) in rows.iter().enumerate() {
            if row.len() != columns {
                let (row, found) = (i + 1, row.len());
                return Err(HeightMapError::Ragged { row, found, expected: columns });
            }
        }
        Self::new(columns, rows.concat())
    }

    /// Number of columns.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.values.len() / self.columns
    }

    /// The gap to a plane that rests on the highest point.
    ///
    /// # Errors
    /// [`HeightMapError::OtherSize`] unless the grid has one cell for each value.
    pub fn gap(&self, grid: Grid) -> Result<Gap, HeightMapError> {
        self.gap_over(grid, f64::INFINITY)
    }

    /// The gap of a paraboloid of this radius with the heights h on it, r^2/(2 R) - h, minus its
    /// least value; an infinite radius gives a plane.
    ///
    /// # Errors
    /// [`HeightMapError::OtherSize`] unless the grid has one cell for each value,
    /// [`HeightMapError::TooLarge`] unless the heights are at most 1e100 times the longer side of the grid.
    pub fn gap_over(&self, grid: Grid, radius: f64) -> Result<Gap, HeightMapError> {
        let found = [self.columns, self.rows()];
        let cells = [grid.nx(), grid.ny()];
        if found != cells {
            return Err(HeightMapError::OtherSize { found, grid: cells });
        }
        self.check_heights(grid)?;
        let heights = self.values.iter().zip(grid.centres());
        let mut gaps: Vec<f64> =
            heights.map(|(height, (x, y))| 0.5 * (x * x + y * y) / radius - height).collect();
        let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        gaps.iter_mut().for_each(|gap| *gap -= lowest);
        let other = HeightMapError::OtherSize { found, grid: [grid.nx(), grid.ny()] };
        Gap::new(Field::new(grid, gaps).map_err(|_| other)?).map_err(|_| other)
    }

    fn check_heights(&self, grid: Grid) -> Result<(), HeightMapError> {
        let longer = f64::max(grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy());
        match self.values.iter().position(|value| value.abs() > MOST_HEIGHT * longer) {
            None => Ok(()),
            Some(place) => {
                let (row, column) = (place / self.columns + 1, place % self.columns + 1);
                let value = self.values[place];
                Err(HeightMapError::TooLarge { row, column, value })
            }
        }
    }
}
