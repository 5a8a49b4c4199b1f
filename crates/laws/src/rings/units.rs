//! Units of the normalised contact of rings.

use crate::friction::Friction;

/// Units of the normalised contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    pub(super) c_z: f64,
    /// Normalised shift over shift: 1/f.
    pub(super) shift: f64,
    /// Normalised twist over twist, counter-clockwise.
    pub(super) twist: f64,
    pub(super) force: f64,
    pub(super) torque: f64,
    pub(super) energy: f64,
    pub(super) traction: f64,
}

impl Units {
    /// Units from `F_z = (2/3) c_z zeta^(3/2)` and the contact radius at unit approach.
    pub(super) fn new(c_z: f64, radius: f64, friction: Friction) -> Self {
        let f = friction.coefficient().unwrap_or(1.0);
        let over = |value: f64| if f > 0.0 { value / f } else { 0.0 };
        let force = 0.25 * c_z * f;
        Self {
            c_z,
            shift: over(1.0),
            twist: -over(radius),
            force,
            torque: -force * radius,
            energy: force * f,
            traction: force / (radius * radius),
        }
    }
}
