//! What no impact exceeds: friction's share of the impulse, and the energy it began with.

use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};

/// Keeps the impulse of an impact within what friction and energy allow.
///
/// A run keeps |J_t| <= f J_z, since |F_t| <= f F_z at every instant; the limit of several runs may
/// leave it by its error, and the energy by the error of the motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    mobility: Matrix3<f64>,
    friction: f64,
    before: Vector3<f64>,
    /// Whether the normal motion is on its own, with its speed turned back.
    apart: bool,
}

impl Limits {
    /// Of a positive definite mobility and the velocity before impact.
    pub(super) fn new(
        mobility: &Matrix3<f64>,
        friction: Friction,
        before: &Vector3<f64>,
        apart: bool,
    ) -> Self {
        Self { mobility: *mobility, friction: friction.get(), before: *before, apart }
    }

    /// The nearest such impulse along it, or the same.
    pub(super) fn hold(&self, impulse: &Vector3<f64>) -> Vector3<f64> {
        let mut impulse = *impulse;
        if self.apart {
            impulse.z = 2.0 * self.before.z / self.mobility.m33;
        }
        self.rub(&mut impulse);
        self.spare(&mut impulse);
        impulse
    }

    // |J_t| <= f J_z.
    fn rub(&self, impulse: &mut Vector3<f64>) {
        let bound = self.friction * impulse.z;
        let tangential = libm::hypot(impulse.x, impulse.y);
        if bound >= 0.0 && tangential > bound {
            impulse.x *= bound / tangential;
            impulse.y *= bound / tangential;
        }
    }

    // E_E - E_A = J.D.J/2 - J.v_A <= 0; of a normal motion apart the energy is the same.
    fn spare(&self, impulse: &mut Vector3<f64>) {
        let free = if self.apart { Vector3::new(1.0, 1.0, 0.0) } else { Vector3::repeat(1.0) };
        let part = impulse.component_mul(&free);
        let (work, twice) = (part.dot(&self.before), part.dot(&(self.mobility * part)));
        if 0.5 * twice > work {
            let share = 2.0 * work.max(0.0) / twice;
            *impulse = impulse.zip_map(&free, |j, free| if free > 0.0 { j * share } else { j });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limits(friction: f64, apart: bool) -> Limits {
        let mut d = Matrix3::new(3.0, 0.2, 0.5, 0.2, 2.0, -0.3, 0.5, -0.3, 1.0);
        if apart {
            d = Matrix3::new(3.0, 0.2, 0.0, 0.2, 2.0, 0.0, 0.0, 0.0, 1.0);
        }
        let friction = Friction::new(friction).unwrap_or(Friction::INFINITE);
        Limits::new(&d, friction, &Vector3::new(0.4, -0.7, 1.0), apart)
    }

    #[test]
    fn impulse_and_energy_are_held() {
        for apart in [false, true] {
            let limits = limits(0.3, apart);
            for i in 0..50 {
                let angle = 0.2 * f64::from(i);
                let given = Vector3::new(0.8 * angle.cos(), angle.sin(), 2.0);
                let held = limits.hold(&given);
                let tangential = libm::hypot(held.x, held.y);
                assert!(tangential <= 0.3 * held.z * (1.0 + 1e-15), "{held:?}");
                let after = limits.before - limits.mobility * held;
                let inverse = limits.mobility.try_inverse().expect("positive definite");
                let energy = |v: &Vector3<f64>| v.dot(&(inverse * v));
                assert!(energy(&after) <= energy(&limits.before) * (1.0 + 1e-14));
                // What is held stays.
                assert!((limits.hold(&held) - held).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn what_may_be_is_left_as_it_is() {
        let limits = limits(0.3, false);
        let impulse = Vector3::new(0.1, -0.2, 1.1);
        assert_eq!(limits.hold(&impulse), impulse);
    }
}
