//! The length of the steps of an impact, from the state.

use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::Point;
use crate::normal::DURATION;

/// Steps that depend on the state alone, so that runs of any fineness place them alike.
///
/// With `lambda` the stiffness of the normal motion, `zeta'' = -(2/3) lambda zeta^(3/2)`, the
/// maximum approach expected from the present state is
/// `A^(5/2) = zeta^(5/2) + (15/8) zeta'^2/lambda`. The steps are those of a free impact of that
/// size, proportional to sqrt(zeta/A): fine at both ends, where the force varies as the power 3/2
/// of time. If friction drives the normal motion, lambda includes its effect. If the tangential
/// motion is stiff, its fastest oscillation in adhesion bounds the step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    /// Coupling of friction to the normal motion: (D_zx, D_zy) c_z.
    drive: [f64; 2],
    /// c_z D_zz.
    lambda: f64,
    /// 1/`A^(5/2)` at first contact.
    scale: f64,
    /// Step over sqrt(zeta) `A^(-3/4) lambda^(-1/2)`, with A in units of that at first contact.
    unit: f64,
    /// Largest value of the squared step times sqrt(zeta).
    bound: f64,
    first: f64,
}

/// The mean of dt/du over T sqrt(zeta/A) for t = T u^2 (3 - 2 u), approximately.
const MEAN_STEP_SHAPE: f64 = 1.75;
/// Largest phase (rad) of the fastest oscillation in a step of 1/32 of an impact.
const MAX_PHASE_PER_STEP: f64 = 0.8;

impl Pace {
    /// Steps for about this number within a free impact.
    pub(super) fn new(
        mobility: &Matrix3<f64>,
        stiffness: &ContactStiffness,
        velocity: f64,
        steps: usize,
    ) -> Self {
        let ContactStiffness { c_x, c_y, c_z } = *stiffness;
        let fineness = 1.0 / steps as f64;
        // The duration of a free impact is this times A^(-1/4) lambda^(-1/2).
        let duration = DURATION * (15.0_f64 / 8.0).sqrt();
        let root = Matrix3::from_diagonal(&Vector3::new(c_x.sqrt(), c_y.sqrt(), c_z.sqrt()));
        let fastest = (root * mobility * root).symmetric_eigenvalues().max();
        let phase = 32.0 * MAX_PHASE_PER_STEP * fineness;
        let lambda = mobility.m33 * c_z;
        let size = 15.0 / 8.0 * velocity * velocity / lambda;
        // t = (k s/2)^2 where dt/ds = k sqrt(t).
        let first =
            0.25 * MEAN_STEP_SHAPE * MEAN_STEP_SHAPE * DURATION * fineness * fineness * duration
                / (libm::pow(size, 0.1) * lambda.sqrt());
        Self {
            drive: [mobility.m13 * c_z, mobility.m23 * c_z],
            lambda,
            scale: 1.0 / size,
            unit: MEAN_STEP_SHAPE * duration * fineness / libm::pow(size, 0.3),
            bound: phase * phase / fastest,
            first,
        }
    }

    /// The step from an instant.
    pub(super) fn step(&self, now: &Point) -> f64 {
        let zeta = now.shift.z;
        if zeta <= 0.0 {
            return self.first;
        }
        let driven = (self.drive[0] * now.force.x + self.drive[1] * now.force.y).abs();
        let lambda = self.lambda.max(driven / now.force.z);
        let root = zeta.sqrt();
        let size = zeta * zeta * root + 15.0 / 8.0 * now.velocity.z * now.velocity.z / lambda;
        let step = self.unit * root * inverse_power(size * self.scale) / lambda.sqrt();
        if step * step * root > self.bound { (self.bound / root).sqrt() } else { step }
    }
}

// x^(-3/10), up to 8 % more, continuous: linear between powers of two.
fn inverse_power(x: f64) -> f64 {
    const ONE: f64 = 0x3ff0_0000_0000_0000_u64 as f64;
    f64::from_bits((1.3 * ONE - 0.3 * x.to_bits() as f64) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_power_is_near_and_continuous() {
        for i in -4000..4000 {
            let x = libm::exp2(0.1 * f64::from(i));
            let near = inverse_power(x) * libm::pow(x, 0.3);
            assert!((0.9999..1.081).contains(&near), "{x:e} {near}");
        }
        for x in [2.0, 8.0, 0.5] {
            let below = f64::from_bits(f64::to_bits(x) - 1);
            assert!((inverse_power(x) / inverse_power(below) - 1.0).abs() < 1e-12);
        }
    }
}
