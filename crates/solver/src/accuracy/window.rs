//! A grid with its position on the surface.

use carom_halfspace::Grid;
use carom_special::RangeError;

use crate::gap::Gap;

/// A grid whose centre may lie anywhere on the surface.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_solver::Window;
/// let window = Window::about([2.0, 0.0], Grid::new(3, 3, 0.1, 0.1)?)?;
/// let gap = window.gap(|x, y| x + y)?;
/// assert!((gap.heights().get(1, 2).unwrap() - 2.1).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    grid: Grid,
    middle: [f64; 2],
}

impl Window {
    /// A grid centred at a point.
    ///
    /// # Errors
    /// [`RangeError`] unless the point is finite.
    pub fn about(middle: [f64; 2], grid: Grid) -> Result<Self, RangeError> {
        RangeError::finite("x", middle[0])?;
        RangeError::finite("y", middle[1])?;
        Ok(Self { grid, middle })
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The centre of the grid, about which torques and twists are taken.
    #[must_use]
    pub const fn middle(&self) -> [f64; 2] {
        self.middle
    }

    /// Another grid with the same centre.
    #[must_use]
    pub const fn with(self, grid: Grid) -> Self {
        Self { grid, ..self }
    }

    /// The gap whose height at the point (x, y) of the surface is `height`, infinite where there is
    /// no body.
    ///
    /// # Errors
    /// As [`Gap::new`].
    pub fn gap(&self, height: impl Fn(f64, f64) -> f64) -> Result<Gap, RangeError> {
        let [x, y] = self.middle;
        Gap::from_function(self.grid, |at_x, at_y| height(x + at_x, y + at_y))
    }
}
