//! The mobility D of a contact point: relative acceleration per force (8.29) to (8.32).

use nalgebra::{Matrix3, Vector3};

use crate::body::Inertia;

/// A body's share of D = sum of [R]^T theta^-1 [R] + 1/m, for the arm R from its centre of mass
/// to the contact point and the inverse inertia tensor in the same axes (8.31), (8.43).
#[must_use]
pub(crate) fn share(
    inertia: &Inertia,
    inverse_tensor: &Matrix3<f64>,
    arm: &Vector3<f64>,
) -> Matrix3<f64> {
    let cross = arm.cross_matrix();
    cross.transpose() * inverse_tensor * cross + Matrix3::identity() * inertia.inverse_mass()
}

/// Velocity of a body's contact point.
#[must_use]
pub(crate) fn point_velocity(
    velocity: &Vector3<f64>,
    spin: &Vector3<f64>,
    arm: &Vector3<f64>,
) -> Vector3<f64> {
    velocity + spin.cross(arm)
}
