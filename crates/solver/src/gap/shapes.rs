//! Gaps of simple shapes above a plane.

use std::f64::consts::TAU;

use carom_halfspace::Grid;
use carom_special::RangeError;

use super::{Gap, Outline};

/// A shape about the origin, given by its height above a plane.
///
/// ```
/// use carom_solver::Shape;
/// assert_eq!(Shape::Cone { slope: 0.5 }.height(3.0, 4.0), 2.5);
/// assert_eq!(Shape::Sphere { radius: 1.0 }.height(2.0, 0.0), f64::INFINITY);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// x^2/(2 R_x) + y^2/(2 R_y); infinite radii are allowed.
    Paraboloid {
        /// The relative radii of curvature R_x and R_y.
        radii: [f64; 2],
    },
    /// R - sqrt(R^2 - r^2); no body beyond the radius R.
    Sphere {
        /// R.
        radius: f64,
    },
    /// Along y, R - sqrt(R^2 - x^2); no body beyond the radius R.
    Cylinder {
        /// R.
        radius: f64,
    },
    /// A cone: the height is `slope` times the distance from its tip.
    Cone {
        /// Rise over distance.
        slope: f64,
    },
    /// A wedge along y: the height is `slope` times the distance from its edge.
    Wedge {
        /// Rise over distance.
        slope: f64,
    },
    /// `A_x (1 - cos(2 pi x/L_x)) + A_y (1 - cos(2 pi y/L_y))`, with a crest at the origin.
    Wavy {
        /// A_x and A_y, half of the heights from crest to trough.
        amplitudes: [f64; 2],
        /// L_x and L_y.
        wavelengths: [f64; 2],
    },
    /// A flat punch: zero inside the outline, no body outside.
    Punch(Outline),
}

impl Shape {
    /// The height at (x, y), infinite where there is no body.
    #[must_use]
    pub fn height(&self, x: f64, y: f64) -> f64 {
        match self {
            Self::Paraboloid { radii } => 0.5 * (x * x / radii[0] + y * y / radii[1]),
            Self::Sphere { radius } => sagitta(*radius, x * x + y * y),
            Self::Cylinder { radius } => sagitta(*radius, x * x),
            Self::Cone { slope } => slope * (x * x + y * y).sqrt(),
            Self::Wedge { slope } => slope * x.abs(),
            Self::Wavy { amplitudes, wavelengths } => {
                let wave = |axis: usize, at: f64| {
                    let half = libm::sin(0.5 * TAU * at / wavelengths[axis]);
                    2.0 * amplitudes[axis] * half * half
                };
                wave(0, x) + wave(1, y)
            }
            Self::Punch(outline) => {
                if outline.holds(x, y) {
                    0.0
                } else {
                    f64::INFINITY
                }
            }
        }
    }

    /// Sides of a rectangle about the origin that contains part of the body: where to start looking
    /// for the contact. A cone and a wedge have no length scale; their sides are 1.
    #[must_use]
    pub fn sides(&self) -> [f64; 2] {
        match self {
            Self::Paraboloid { radii: [x, y] } => {
                let side = 2.0 * x.min(*y);
                [if side.is_finite() { side } else { 1.0 }; 2]
            }
            Self::Sphere { radius } | Self::Cylinder { radius } => [2.0 * radius; 2],
            Self::Cone { .. } | Self::Wedge { .. } => [1.0; 2],
            Self::Wavy { wavelengths, .. } => *wavelengths,
            Self::Punch(outline) => outline.reach().map(|reach| 2.0 * reach),
        }
    }

    /// Checks that lengths and slopes are positive and finite (radii of a paraboloid may be
    /// infinite, amplitudes zero), and that an outline has an area.
    ///
    /// # Errors
    /// [`RangeError`] that names the first value out of range.
    pub fn check(&self) -> Result<(), RangeError> {
        match self {
            Self::Paraboloid { radii } => {
                for radius in *radii {
                    RangeError::check("radius", radius, radius > 0.0, "> 0")?;
                }
            }
            Self::Sphere { radius } | Self::Cylinder { radius } => {
                RangeError::positive("radius", *radius)?;
            }
            Self::Cone { slope } | Self::Wedge { slope } => {
                RangeError::positive("slope", *slope)?;
            }
            Self::Wavy { amplitudes, wavelengths } => {
                for axis in 0..2 {
                    RangeError::non_negative("amplitude", amplitudes[axis])?;
                    RangeError::positive("wavelength", wavelengths[axis])?;
                }
            }
            Self::Punch(outline) => outline.check()?,
        }
        Ok(())
    }
}

impl Gap {
    /// A flat punch: zero gap inside the outline, no body outside.
    ///
    /// # Errors
    /// [`RangeError`] for lengths that are not positive, corners that are not finite, fewer than
    /// three corners or corners on one line, and if no cell centre lies inside.
    pub fn punch(grid: Grid, outline: &Outline) -> Result<Self, RangeError> {
        Self::of_shape(grid, &Shape::Punch(outline.clone()))
    }

    /// A shape above a plane, with its origin at the centre of the grid.
    ///
    /// ```
    /// use carom_halfspace::Grid;
    /// use carom_solver::{Gap, Shape};
    /// let gap = Gap::of_shape(Grid::new(3, 3, 0.6, 0.6)?, &Shape::Sphere { radius: 1.0 })?;
    /// assert!((gap.heights().get(0, 1).unwrap() - 0.2).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Shape::check`]; also if no cell lies below the body.
    pub fn of_shape(grid: Grid, shape: &Shape) -> Result<Self, RangeError> {
        shape.check()?;
        Self::from_function(grid, |x, y| shape.height(x, y))
    }

    /// [`Shape::Sphere`] about the centre of the grid.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn sphere(grid: Grid, radius: f64) -> Result<Self, RangeError> {
        Self::of_shape(grid, &Shape::Sphere { radius })
    }

    /// [`Shape::Cylinder`] about the centre of the grid.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn cylinder(grid: Grid, radius: f64) -> Result<Self, RangeError> {
        Self::of_shape(grid, &Shape::Cylinder { radius })
    }

    /// [`Shape::Cone`] about the centre of the grid.
    ///
    /// # Errors
    /// [`RangeError`] unless the slope is finite and positive.
    pub fn cone(grid: Grid, slope: f64) -> Result<Self, RangeError> {
        Self::of_shape(grid, &Shape::Cone { slope })
    }

    /// [`Shape::Wedge`] about the centre of the grid.
    ///
    /// # Errors
    /// [`RangeError`] unless the slope is finite and positive.
    pub fn wedge(grid: Grid, slope: f64) -> Result<Self, RangeError> {
        Self::of_shape(grid, &Shape::Wedge { slope })
    }

    /// [`Shape::Wavy`] about the centre of the grid.
    ///
    /// # Errors
    /// [`RangeError`] unless amplitudes are finite and not negative, wavelengths positive.
    pub fn wavy(
        grid: Grid,
        amplitudes: [f64; 2],
        wavelengths: [f64; 2],
    ) -> Result<Self, RangeError> {
        Self::of_shape(grid, &Shape::Wavy { amplitudes, wavelengths })
    }
}

/// R - sqrt(R^2 - d), without cancellation.
fn sagitta(radius: f64, square: f64) -> f64 {
    let left = radius * radius - square;
    if left < 0.0 { f64::INFINITY } else { square / (radius + left.sqrt()) }
}
