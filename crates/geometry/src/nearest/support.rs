//! The point of a body that lies farthest in a direction.

use nalgebra::Vector3;

use super::{SearchError, nearest_points};
use crate::attitude::Attitude;
use crate::placed::Placed;
use crate::surface::{Kind, Surface, support_of_ellipsoid};

impl Placed {
    /// The support point in a unit direction, in the axes of the surface.
    fn farthest(&self, direction: &Vector3<f64>) -> Result<Vector3<f64>, SearchError> {
        let own = self.attitude().to_body(direction);
        match self.surface().kind() {
            Kind::Sphere { radius } => Ok(own * *radius),
            Kind::Ellipsoid { semi_axes } => Ok(support_of_ellipsoid(semi_axes, &own).point),
            Kind::Plane => Ok(Vector3::zeros()),
            _ => {
                // The point nearest to a plane beyond the body.
                let beyond = self.centre() + direction * (2.0 * self.surface().size());
                let plane = Placed::new(Surface::plane())
                    .moved_to(beyond)
                    .turned(Attitude::along(&-direction));
                Ok(self.body_point(&nearest_points(self, &plane)?.points[0]))
            }
        }
    }

    /// Orients the surface for contact with its outward normal along a unit vector: a plane is
    /// rotated, any other surface stays. Returns also the point that touches, in the axes of the
    /// surface.
    pub(crate) fn facing(
        &self,
        outward: &Vector3<f64>,
    ) -> Result<(Self, Vector3<f64>), SearchError> {
        let turned = match self.surface().is_plane() {
            true => self.clone().turned(Attitude::along(outward)),
            false => self.clone(),
        };
        let point = turned.farthest(outward)?;
        Ok((turned, point))
    }
}
