//! A surface somewhere in space.

use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::attitude::Attitude;
use crate::nearest::{SearchError, nearest_points};
use crate::surface::{Kind, LocalSurface, Surface, SurfaceError, support_of_ellipsoid};

/// A surface with its place and attitude.
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
    /// At the origin, its axes along those of space.
    #[must_use]
    pub fn new(surface: Surface) -> Self {
        Self { surface, centre: Vector3::zeros(), attitude: Attitude::ALIGNED }
    }

    /// The same with its centre there; for a plane, any of its points.
    ///
    /// # Errors
    /// [`RangeError`] unless the components are finite.
    pub fn at(self, centre: [f64; 3]) -> Result<Self, RangeError> {
        for value in centre {
            RangeError::finite("centre", value)?;
        }
        Ok(self.moved_to(centre.into()))
    }

    /// The same in this attitude.
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

    /// Normal, principal curvatures and directions at a point of the surface, all in space.
    ///
    /// # Errors
    /// As [`Surface::local`].
    pub fn local(&self, in_space: &Vector3<f64>) -> Result<LocalSurface, SurfaceError> {
        let local = self.surface.local(&self.body_point(in_space))?;
        Ok(local.placed(&self.centre, &self.attitude))
    }

    /// The point farthest in a unit direction, in the surface's axes.
    fn farthest(&self, direction: &Vector3<f64>) -> Result<Vector3<f64>, SearchError> {
        let own = self.attitude.to_body(direction);
        match self.surface.kind() {
            Kind::Sphere { radius } => Ok(own * *radius),
            Kind::Ellipsoid { semi_axes } => Ok(support_of_ellipsoid(semi_axes, &own).point),
            Kind::Plane => Ok(Vector3::zeros()),
            _ => {
                // The nearest to a plane beyond.
                let beyond = self.centre + direction * (2.0 * self.surface.size());
                let attitude = Attitude::along(&-direction);
                let plane = Self { surface: Surface::plane(), centre: beyond, attitude };
                Ok(self.body_point(&nearest_points(self, &plane)?.points[0]))
            }
        }
    }

    /// Ready to touch with its outward normal along a unit vector: a plane is turned to face that
    /// way, any other surface stays. With the point that touches, in the surface's axes.
    pub(crate) fn facing(
        &self,
        outward: &Vector3<f64>,
    ) -> Result<(Self, Vector3<f64>), SearchError> {
        let turned = match self.surface.is_plane() {
            true => self.clone().turned(Attitude::along(outward)),
            false => self.clone(),
        };
        let point = turned.farthest(outward)?;
        Ok((turned, point))
    }

    pub(crate) fn moved_to(self, centre: Vector3<f64>) -> Self {
        Self { centre, ..self }
    }

    /// The same in space whose origin lies there.
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
