//! The rectangular grid of equal cells that carries tractions and displacements.

use carom_special::RangeError;

use crate::{Offset, Rectangle};

/// `nx` by `ny` cells of full widths `dx` by `dy`.
///
/// Fields on the grid are slices of `nx * ny` values, x running fastest: the cell in column
/// `ix` and row `iy` has index `ix + nx * iy`; x and y ascend with the indices.
///
/// ```
/// use carom_halfspace::Grid;
/// let grid = Grid::new(40, 20, 0.1, 0.2)?;
/// assert_eq!(grid.cells(), 800);
/// assert_eq!(grid.index(3, 2), 83);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    nx: usize,
    ny: usize,
    cell: Rectangle,
}

/// Greatest number of cells along an axis.
const MOST_CELLS: usize = 1 << 30;

impl Grid {
    /// A grid of `nx` by `ny` cells of full widths `dx` by `dy`.
    ///
    /// # Errors
    /// [`RangeError`] if a count is zero or above 2^30 or a width not finite and positive.
    pub fn new(nx: usize, ny: usize, dx: f64, dy: f64) -> Result<Self, RangeError> {
        let count = |field, n: usize| {
            RangeError::check(field, n as f64, (1..=MOST_CELLS).contains(&n), "in 1..=2^30")
        };
        count("nx", nx)?;
        count("ny", ny)?;
        RangeError::positive("dx", dx)?;
        RangeError::positive("dy", dy)?;
        Ok(Self { nx, ny, cell: Rectangle::new(dx, dy)? })
    }

    /// Number of columns, along x.
    #[must_use]
    pub const fn nx(&self) -> usize {
        self.nx
    }

    /// Number of rows, along y.
    #[must_use]
    pub const fn ny(&self) -> usize {
        self.ny
    }

    /// Full width of a cell along x.
    #[must_use]
    pub const fn dx(&self) -> f64 {
        self.cell.width_x()
    }

    /// Full width of a cell along y.
    #[must_use]
    pub const fn dy(&self) -> f64 {
        self.cell.width_y()
    }

    /// One cell.
    #[must_use]
    pub const fn cell(&self) -> Rectangle {
        self.cell
    }

    /// Number of cells.
    #[must_use]
    pub const fn cells(&self) -> usize {
        self.nx * self.ny
    }

    /// Area of a cell.
    #[must_use]
    pub fn cell_area(&self) -> f64 {
        self.cell.area()
    }

    /// Index of the cell in column `ix` and row `iy`.
    #[must_use]
    pub const fn index(&self, ix: usize, iy: usize) -> usize {
        ix + self.nx * iy
    }

    /// Coordinate x of the centres of column `ix`, from the centre of the grid.
    #[must_use]
    pub fn centred_x(&self, ix: usize) -> f64 {
        (ix as f64 - 0.5 * (self.nx as f64 - 1.0)) * self.dx()
    }

    /// Coordinate y of the centres of row `iy`, from the centre of the grid.
    #[must_use]
    pub fn centred_y(&self, iy: usize) -> f64 {
        (iy as f64 - 0.5 * (self.ny as f64 - 1.0)) * self.dy()
    }

    /// A grid with the same centre and cells twice as wide, half as many (rounded up) along each
    /// axis. A single row or column, along which nothing varies, keeps its width.
    ///
    /// # Errors
    /// [`RangeError`] if a width overflows.
    pub fn coarser(self) -> Result<Self, RangeError> {
        let wide = |count: usize, width: f64| if count == 1 { width } else { 2.0 * width };
        let (dx, dy) = (wide(self.nx, self.dx()), wide(self.ny, self.dy()));
        Self::new(self.nx.div_ceil(2), self.ny.div_ceil(2), dx, dy)
    }

    /// The centres (x, y) of all cells, from the centre of the grid, in the order of their indices.
    pub fn centres(self) -> impl Iterator<Item = (f64, f64)> {
        let row = move |iy| (0..self.nx).map(move |ix| (self.centred_x(ix), self.centred_y(iy)));
        (0..self.ny).flat_map(row)
    }

    /// The offset of a source `columns` cells along x and `rows` along y from the receiver.
    #[must_use]
    pub fn offset(&self, columns: i32, rows: i32) -> Offset {
        Offset { x: f64::from(columns) * self.dx(), y: f64::from(rows) * self.dy() }
    }
}
