//! A surface with its position and attitude in space.

use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::attitude::Attitude;
use crate::surface::{LocalSurface, Surface, SurfaceError};

/// The first step of a search along a line, relative to the size of the body.
const FIRST_STEP: f64 = 1e-8;
/// Greatest number of bisections of a crossing: down to the last digit.
const HALVINGS: usize = 70;

/// A surface with its position and attitude in space.
///
/// ```
/// use carom_geometry::{Attitude, Placed, Surface};
/// let egg = Placed::new(Surface::ellipsoid([0.03, 0.02, 0.015])?)
///     .at([0.0, 0.0, 0.015])?
///     .turned(Attitude::from_angles(0.0, 0.0, 0.5)?);
/// let bottom = egg.local(&[0.0; 3].into())?;
/// assert!((bottom.normal().z + 1.0).abs() < 1e-15);
/// # Ok::<(), carom_geometry::SurfaceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Placed {
    surface: Surface,
    centre: Vector3<f64>,
    attitude: Attitude,
}

impl Placed {
    /// The surface at the origin, with its axes parallel to those of space.
    #[must_use]
    pub fn new(surface: Surface) -> Self {
        Self { surface, centre: Vector3::zeros(), attitude: Attitude::ALIGNED }
    }

    /// Moves the centre to this point; for a plane, any of its points.
    ///
    /// # Errors
    /// [`RangeError`] unless the coordinates are finite.
    pub fn at(self, centre: [f64; 3]) -> Result<Self, RangeError> {
        for value in centre {
            RangeError::finite("centre", value)?;
        }
        Ok(self.moved_to(centre.into()))
    }

    /// Sets the attitude.
    #[must_use]
    pub fn turned(self, attitude: Attitude) -> Self {
        Self { attitude, ..self }
    }

    /// The surface, in its own axes.
    #[must_use]
    pub const fn surface(&self) -> &Surface {
        &self.surface
    }

    /// The centre.
    #[must_use]
    pub const fn centre(&self) -> Vector3<f64> {
        self.centre
    }

    /// The attitude.
    #[must_use]
    pub const fn attitude(&self) -> &Attitude {
        &self.attitude
    }

    /// Normal, principal curvatures and directions at a point of the surface, in space.
    ///
    /// # Errors
    /// As [`Surface::local`].
    pub fn local(&self, in_space: &Vector3<f64>) -> Result<LocalSurface, SurfaceError> {
        let local = self.surface.local(&self.body_point(in_space))?;
        Ok(local.placed(&self.centre, &self.attitude))
    }

    /// The distance along `direction` from a point near the surface to the place where the line
    /// enters the body: the nearest crossing, which lies behind the point if the point is inside.
    /// `None` if the line does not meet the surface within twice the size of the body (for a plane:
    /// 1e6 times the distance of the point).
    ///
    /// ```
    /// use carom_geometry::{Placed, Surface};
    /// use nalgebra::Vector3;
    /// let ball = Placed::new(Surface::sphere(2.0)?).at([0.0, 0.0, 2.0])?;
    /// let rise = ball.entry(&Vector3::new(1.2, 0.0, 0.0), &Vector3::z()).ok_or("it is met")?;
    /// assert!((rise - 0.4).abs() < 1e-15);
    /// assert!(ball.entry(&Vector3::new(2.1, 0.0, 0.0), &Vector3::z()).is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn entry(&self, point: &Vector3<f64>, direction: &Vector3<f64>) -> Option<f64> {
        let (start, along) = (self.body_point(point), self.attitude.to_body(direction));
        let outside = |way: f64| self.surface.outside(&(start + way * along));
        let here = outside(0.0);
        if here == 0.0 {
            return Some(0.0);
        }
        let size = if self.surface.size() > 0.0 { self.surface.size() } else { 1e6 * here.abs() };
        let course = here.signum();
        // Steps that double from a very small one find the nearest crossing of a smooth surface.
        let (mut near, mut far) = (0.0, FIRST_STEP * size * course);
        while outside(far) * here > 0.0 {
            if far.abs() > 2.0 * size {
                return None;
            }
            (near, far) = (far, 2.0 * far);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (near + far);
            if middle == near || middle == far {
                break;
            }
            let same = outside(middle) * here > 0.0;
            (near, far) = if same { (middle, far) } else { (near, middle) };
        }
        let way = 0.5 * (near + far);
        way.is_finite().then_some(way)
    }

    pub(crate) fn moved_to(self, centre: Vector3<f64>) -> Self {
        Self { centre, ..self }
    }

    /// The same surface relative to another origin.
    pub(crate) fn seen_from(&self, origin: &Vector3<f64>) -> Self {
        self.clone().moved_to(self.centre - origin)
    }

    pub(crate) fn space_point(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.centre + self.attitude.to_space(in_body)
    }

    pub(crate) fn body_point(&self, in_space: &Vector3<f64>) -> Vector3<f64> {
        self.attitude.to_body(&(in_space - self.centre))
    }

    pub(crate) fn tensor(&self, in_body: &Matrix3<f64>) -> Matrix3<f64> {
        self.attitude.matrix() * in_body * self.attitude.matrix().transpose()
    }
}
