//! Gaps of simple shapes over a plane.

use std::f64::consts::TAU;

use carom_halfspace::{Field, Grid};
use carom_special::RangeError;

use super::Gap;

impl Gap {
    /// A sphere on a plane, R - sqrt(R^2 - r^2); no body beyond the radius R.
    ///
    /// ```
    /// use carom_halfspace::Grid;
    /// use carom_solver::Gap;
    /// let gap = Gap::sphere(Grid::new(3, 3, 0.6, 0.6)?, 1.0)?;
    /// assert!((gap.heights().get(0, 1).unwrap() - 0.2).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn sphere(grid: Grid, radius: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        Self::from_function(grid, |x, y| sagitta(radius, x * x + y * y))
    }

    /// A cylinder along y on a plane, R - sqrt(R^2 - x^2); no body beyond the radius R.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn cylinder(grid: Grid, radius: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        Self::from_function(grid, |x, _| sagitta(radius, x * x))
    }

    /// A cone whose sides rise by `slope` of the distance from its tip.
    ///
    /// # Errors
    /// [`RangeError`] unless the slope is finite and positive.
    pub fn cone(grid: Grid, slope: f64) -> Result<Self, RangeError> {
        RangeError::positive("slope", slope)?;
        Self::from_function(grid, |x, y| slope * (x * x + y * y).sqrt())
    }

    /// A wedge along y whose sides rise by `slope` of the distance from its edge.
    ///
    /// # Errors
    /// [`RangeError`] unless the slope is finite and positive.
    pub fn wedge(grid: Grid, slope: f64) -> Result<Self, RangeError> {
        RangeError::positive("slope", slope)?;
        Self::from_function(grid, |x, _| slope * x.abs())
    }

    /// Waves along x and y, `A_x (1 - cos(2 pi x/L_x)) + A_y (1 - cos(2 pi y/L_y))`, with a crest in
    /// the middle of the grid.
    ///
    /// # Errors
    /// [`RangeError`] unless amplitudes are finite and not negative, wavelengths positive.
    pub fn wavy(
        grid: Grid,
        amplitudes: [f64; 2],
        wavelengths: [f64; 2],
    ) -> Result<Self, RangeError> {
        for axis in 0..2 {
            RangeError::non_negative("amplitude", amplitudes[axis])?;
            RangeError::positive("wavelength", wavelengths[axis])?;
        }
        let wave = |axis: usize, at: f64| {
            let half = libm::sin(0.5 * TAU * at / wavelengths[axis]);
            2.0 * amplitudes[axis] * half * half
        };
        Self::new(Field::from_function(grid, |x, y| wave(0, x) + wave(1, y)))
    }
}

/// R - sqrt(R^2 - d), without cancellation.
fn sagitta(radius: f64, square: f64) -> f64 {
    let left = radius * radius - square;
    if left < 0.0 { f64::INFINITY } else { square / (radius + left.sqrt()) }
}
