//! Bounds of every impact: the friction limit of the impulse, and the energy before.

use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};

use super::CoupledImpact;

/// Keeps the impulse of an impact within the friction limit and the energy balance.
///
/// A run obeys |J_t| <= f J_z, since |F_t| <= f F_z at every instant. The limit of several runs may
/// violate it by its error, and the energy balance by the error of the motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    mobility: Matrix3<f64>,
    friction: f64,
    before: Vector3<f64>,
    /// The normal impulse, if the normal motion is uncoupled: its velocity after is then known.
    normal_impulse: Option<f64>,
}

impl Limits {
    /// The bounds for a positive definite mobility and the velocity before the impact.
    pub(super) fn new(
        mobility: &Matrix3<f64>,
        friction: Friction,
        before: &Vector3<f64>,
        normal_impulse: Option<f64>,
    ) -> Self {
        Self { mobility: *mobility, friction: friction.get(), before: *before, normal_impulse }
    }

    /// The impulse reduced along its direction to within both bounds.
    pub(super) fn restrict(&self, impulse: &Vector3<f64>) -> Vector3<f64> {
        let mut impulse = *impulse;
        if let Some(normal_impulse) = self.normal_impulse {
            impulse.z = normal_impulse;
        }
        self.apply_friction_limit(&mut impulse);
        self.apply_energy_bound(&mut impulse);
        impulse
    }

    // Friction limit: |J_t| <= f J_z.
    fn apply_friction_limit(&self, impulse: &mut Vector3<f64>) {
        let bound = self.friction * impulse.z;
        let tangential = libm::hypot(impulse.x, impulse.y);
        if bound >= 0.0 && tangential > bound {
            impulse.x *= bound / tangential;
            impulse.y *= bound / tangential;
        }
    }

    // Energy: E_E - E_A = J.D.J/2 - J.v_A <= 0. Uncoupled normal motion keeps its energy.
    fn apply_energy_bound(&self, impulse: &mut Vector3<f64>) {
        let free = if self.normal_impulse.is_some() {
            Vector3::new(1.0, 1.0, 0.0)
        } else {
            Vector3::repeat(1.0)
        };
        let part = impulse.component_mul(&free);
        let (work, twice) = (part.dot(&self.before), part.dot(&(self.mobility * part)));
        if 0.5 * twice > work {
            let share = 2.0 * work.max(0.0) / twice;
            *impulse = impulse.zip_map(&free, |j, free| if free > 0.0 { j * share } else { j });
        }
    }
}

impl CoupledImpact {
    /// An impulse that was extrapolated from several runs, reduced along its direction to within the friction
    /// limit and the energy before the impact.
    #[must_use]
    pub fn restricted(&self, impulse: &Vector3<f64>) -> Vector3<f64> {
        let mobility = self.mobility.matrix();
        Limits::new(mobility, self.friction, &self.velocity, None).restrict(impulse)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limits(friction: f64, is_normal_uncoupled: bool) -> Limits {
        let mut d = Matrix3::new(3.0, 0.2, 0.5, 0.2, 2.0, -0.3, 0.5, -0.3, 1.0);
        if is_normal_uncoupled {
            d = Matrix3::new(3.0, 0.2, 0.0, 0.2, 2.0, 0.0, 0.0, 0.0, 1.0);
        }
        let friction = Friction::new(friction).unwrap_or(Friction::INFINITE);
        let normal_impulse = is_normal_uncoupled.then_some(2.0);
        Limits::new(&d, friction, &Vector3::new(0.4, -0.7, 1.0), normal_impulse)
    }

    #[test]
    fn impulse_and_energy_are_held() {
        for is_normal_uncoupled in [false, true] {
            let limits = limits(0.3, is_normal_uncoupled);
            for i in 0..50 {
                let angle = 0.2 * f64::from(i);
                let given = Vector3::new(0.8 * angle.cos(), angle.sin(), 2.0);
                let restricted = limits.restrict(&given);
                let tangential = libm::hypot(restricted.x, restricted.y);
                assert!(tangential <= 0.3 * restricted.z * (1.0 + 1e-15), "{restricted:?}");
                let after = limits.before - limits.mobility * restricted;
                let inverse = limits.mobility.try_inverse().expect("positive definite");
                let energy = |v: &Vector3<f64>| v.dot(&(inverse * v));
                assert!(energy(&after) <= energy(&limits.before) * (1.0 + 1e-14));
                // An allowed impulse does not change.
                assert!((limits.restrict(&restricted) - restricted).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn what_may_be_is_left_as_it_is() {
        let limits = limits(0.3, false);
        let impulse = Vector3::new(0.1, -0.2, 1.1);
        assert_eq!(limits.restrict(&impulse), impulse);
    }
}
