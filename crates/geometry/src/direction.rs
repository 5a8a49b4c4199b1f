//! Directions perpendicular to a given one.

use nalgebra::Vector3;

/// A unit vector perpendicular to a given one.
#[must_use]
pub fn perpendicular(normal: &Vector3<f64>) -> Vector3<f64> {
    let axis = Vector3::ith(normal.iamin(), 1.0);
    (axis - normal * normal.dot(&axis)).normalize()
}
