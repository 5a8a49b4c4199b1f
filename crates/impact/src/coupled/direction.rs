//! Length and direction of the tangential velocity.

use nalgebra::Vector3;

/// Length and direction of the tangential part, without under- or overflow of the squares. If it is
/// zero, any direction.
pub(super) fn length_and_direction(velocity: &Vector3<f64>) -> (f64, Vector3<f64>) {
    let tangential = Vector3::new(velocity.x, velocity.y, 0.0);
    let largest = tangential.amax();
    if largest == 0.0 {
        return (0.0, Vector3::x());
    }
    let scaled = tangential / largest;
    let length = scaled.norm();
    (largest * length, scaled / length)
}
