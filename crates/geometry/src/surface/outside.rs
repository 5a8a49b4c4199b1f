//! Decides on which side of a surface a point lies.

use nalgebra::Vector3;

use super::{Kind, Surface};

impl Surface {
    /// Positive outside the body, negative inside, zero on the surface; near the surface
    /// proportional to the distance. A surface given at one point is replaced by its paraboloid.
    pub(crate) fn outside(&self, point: &Vector3<f64>) -> f64 {
        let rim = || libm::hypot(point.x, point.y);
        match self.kind() {
            Kind::Sphere { radius } => point.norm() - radius,
            Kind::Ellipsoid { semi_axes } => point.component_div(semi_axes).norm() - 1.0,
            Kind::Plane => point.z,
            Kind::Cylinder { radius, half_length } => {
                (rim() - radius).max(point.z.abs() - half_length)
            }
            Kind::Capsule { radius, half_length } => {
                let along = point.z.clamp(-half_length, *half_length);
                libm::hypot(rim(), point.z - along) - radius
            }
            Kind::Torus { major, minor } => libm::hypot(rim() - major, point.z) - minor,
            Kind::Box { half } => (point.abs() - half).max(),
            Kind::Implicit { function, .. } => function.value(point),
            Kind::Explicit { function, side, .. } => {
                side.sign() * (function.value(point) - point.z)
            }
            Kind::Given { local } => {
                let away = point - local.point();
                away.dot(&local.normal()) + 0.5 * away.dot(&(local.shape_operator() * away))
            }
        }
    }
}
