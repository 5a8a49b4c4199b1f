//! An instant of a contact.

use nalgebra::Vector3;

/// An instant of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Time since first contact.
    pub time: f64,
    /// Shift of body 2 against body 1 since first contact: xi, eta, zeta.
    pub shift: Vector3<f64>,
    /// Its rate.
    pub velocity: Vector3<f64>,
    /// Force on body 1.
    pub force: Vector3<f64>,
    /// Impulse since first contact. It is summed, since a difference of velocities would lose the
    /// digits of a grazing impact.
    pub impulse: Vector3<f64>,
}
