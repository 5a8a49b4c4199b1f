//! The gap between two surfaces in space.

use carom_geometry::{ContactPoint, Placed};
use carom_halfspace::{Field, Grid};
use carom_special::RangeError;

use super::Gap;

impl Gap {
    /// The distance of two touching surfaces along their common normal, on a grid in the tangent
    /// plane with the axes of the contact; infinite where a line along the normal misses either
    /// body.
    ///
    /// ```
    /// use carom_geometry::{ContactPoint, Placed, Surface};
    /// use carom_halfspace::Grid;
    /// use carom_solver::Gap;
    /// let ball = Placed::new(Surface::sphere(1.0)?).at([0.0, 0.0, 1.0])?;
    /// let floor = Placed::new(Surface::plane());
    /// let touch = ContactPoint::find(&ball, &floor)?;
    /// let gap = Gap::between(Grid::new(3, 3, 0.6, 0.6)?, [&ball, &floor], &touch)?;
    /// assert!((gap.heights().get(2, 1).unwrap() - 0.2).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the bodies face each other in no cell.
    pub fn between(
        grid: Grid,
        [one, two]: [&Placed; 2],
        touch: &ContactPoint,
    ) -> Result<Self, RangeError> {
        let frame = touch.frame();
        let distance = |x: f64, y: f64| {
            let place = touch.point() + x * frame.x() + y * frame.y();
            let (up, down) = (one.entry(&place, &frame.z()), two.entry(&place, &-frame.z()));
            up.zip(down).map_or(f64::INFINITY, |(up, down)| up + down)
        };
        Self::new(Field::from_function(grid, distance))
    }
}
