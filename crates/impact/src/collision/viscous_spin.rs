//! What a viscous loss changes of the torsional impact.
//!
//! The torsional impact of elastic bodies is exact. A viscous material presses with less impulse, (1 + e)/2 times as much,
//! and resists the twist itself where little slips. Both are in the law of rings, which knows spheres: a ball on a plane of the two
//! materials, with the same stiffness, inertia, spin and friction, is followed by rings with the loss and without it, and the
//! elastic loss of spin is multiplied by the ratio of theirs.

use carom_geometry::{Inertia, Surface};
use carom_laws::friction::Friction;

use super::{Collision, CollisionError};
use crate::body::Body;
use crate::motion::Motion;
use crate::normal_restitution::NormalRestitution;
use crate::outcome::Torsion;
use crate::rings::RingImpact;
use crate::viscoelastic::ViscousLoss;

/// a Omega/(f v_z) below which the ratio no longer changes: nearly all sticks.
const SLOW: f64 = 1e-3;

/// With more friction nothing slips.
const AS_INFINITE: f64 = 1e6;

/// The relative spin and the mobility of spin about the normal.
type Spin = [f64; 2];

impl Collision {
    /// The torsional impact with a viscous loss, from that of elastic bodies.
    pub(super) fn viscous_torsion(
        &self,
        elastic: Torsion,
        loss: ViscousLoss,
    ) -> Result<Torsion, CollisionError> {
        if elastic.spin_ratio == 1.0 {
            return Ok(elastic);
        }
        let z = self.frame().z();
        let about = |i: usize| z.dot(&(self.levers[i].inverse_tensor() * z));
        let spin = [self.relative_spin(), about(0) + about(1)];
        let [without, with] = [ViscousLoss::NONE, loss].map(|loss| self.by_rings(spin, loss));
        let (Some([lost, _]), Some([left, off])) = (without?, with?) else { return Ok(elastic) };
        let part = left / lost;
        let loss = part * (1.0 - elastic.spin_ratio);
        let torque_impulse = part * elastic.torque_impulse;
        Ok(Torsion {
            spin_ratio: 1.0 - loss,
            torque_impulse,
            dissipated: -0.5 * torque_impulse * spin[0] * (2.0 - loss),
            error_estimate: part * elastic.error_estimate + off,
        })
    }

    /// The loss of spin over that before, and its error, of a ball on a plane by rings.
    fn by_rings(
        &self,
        [omega, mobility]: Spin,
        loss: ViscousLoss,
    ) -> Result<Option<[f64; 2]>, CollisionError> {
        let (d_zz, speed) = (self.mobility.matrix().m33, self.velocity().z);
        let deepest = self.pulse(speed)?.maximal_approach();
        let friction = self.friction.get().min(AS_INFINITE);
        let [one, two] = [self.materials.body_1(), self.materials.body_2()];
        // c_z = 2 E* sqrt(R).
        let root = self.hertz.stiffness().c_z / (2.0 * self.materials.contact_modulus());
        let rim = root * deepest.sqrt();
        let slow = SLOW * friction.min(1.0) * speed / rim;
        let inertia = Inertia::new(1.0 / d_zz, [1.0 / mobility; 3])?;
        let spin = [0.0, 0.0, omega.abs().max(slow)];
        let ball = Body::new(Surface::sphere(root * root)?, one, inertia)
            .moving(Motion::new([0.0, 0.0, -speed], spin)?);
        let restitution = NormalRestitution::new(loss.restitution())?;
        let impact = Self::new(ball, Body::plane(two), Friction::new(friction)?)?
            .with_normal_restitution(restitution)
            .with_torsion();
        let outcome = RingImpact::new(&impact).solve()?;
        let torsion = outcome.rebound().and_then(|rebound| rebound.torsion);
        Ok(torsion.map(|torsion| [1.0 - torsion.spin_ratio, torsion.error_estimate]))
    }
}
