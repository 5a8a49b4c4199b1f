//! A grid with its place on the surface.

use carom_halfspace::Grid;
use carom_special::RangeError;

use crate::gap::Gap;

/// A grid whose middle lies anywhere on the surface.
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
    /// The grid about a place.
    ///
    /// # Errors
    /// [`RangeError`] unless the place is finite.
    pub fn about(middle: [f64; 2], grid: Grid) -> Result<Self, RangeError> {
        RangeError::finite("x", middle[0])?;
        RangeError::finite("y", middle[1])?;
        Ok(Self { grid, middle })
    }

    /// The cells.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The place of their middle, about which torques and twists count.
    #[must_use]
    pub const fn middle(&self) -> [f64; 2] {
        self.middle
    }

    /// Other cells about the same place.
    #[must_use]
    pub const fn with(self, grid: Grid) -> Self {
        Self { grid, ..self }
    }

    /// The gap of this height at (x, y) of the surface, infinite where no body is.
    ///
    /// # Errors
    /// As [`Gap::new`].
    pub fn gap(&self, height: impl Fn(f64, f64) -> f64) -> Result<Gap, RangeError> {
        let [x, y] = self.middle;
        Gap::from_function(self.grid, |at_x, at_y| height(x + at_x, y + at_y))
    }
}
