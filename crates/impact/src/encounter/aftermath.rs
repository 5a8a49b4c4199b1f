//! What an encounter leaves: motions, energy, torsion, warnings.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::{Encounter, EncounterError};
use crate::body::Motion;
use crate::closed_form::NOTICEABLE;
use crate::contact_point::Certainty;
use crate::coupled::{CoupledImpact, CoupledOutcome};
use crate::normal::NormalImpact;
use crate::normal_spin::{NormalSpin, NormalSpinError, Pivot};
use crate::outcome::{EnergyBudget, Rebound, Torsion, TorsionMode, Warning};
use crate::wave_share::wave_share;

/// Couplings of the normal motion below this part of D_zz are round-off.
const UNCOUPLED: f64 = 1e-9;

impl Encounter {
    pub(super) fn rebound(
        &self,
        impact: &CoupledImpact,
        outcome: &CoupledOutcome,
    ) -> Result<Rebound, EncounterError> {
        let (before, after) = (impact.velocity(), outcome.velocity);
        let impulse = self.mobility.impulse(&before, &after);
        let mut motions = self.after(&self.frame.to_space(&impulse));
        // E_A - E_E of the relative motion, without its cancellation.
        let mut dissipated = 0.5 * impulse.dot(&(before + after));
        let torsion = self.torsion(before.z)?;
        if let Some(torsion) = &torsion {
            let spin = self.normal_spin(before.z);
            motions.iter_mut().enumerate().for_each(|(i, m)| m.spin += spin.turn(i, torsion));
            dissipated += torsion.dissipated;
        }
        let kinetic = |motions: [Motion; 2]| {
            self.bodies[0].kinetic_energy(&motions[0]) + self.bodies[1].kinetic_energy(&motions[1])
        };
        let energy = EnergyBudget {
            before: kinetic([self.bodies[0].motion, self.bodies[1].motion]),
            after: kinetic(motions),
            dissipated,
        };
        let maximal_radius = self.hertz.ellipse(outcome.maximal_approach)?.semi_axis_b();
        Ok(Rebound {
            motions,
            impulse: self.frame.to_space(&impulse),
            velocity_before: self.frame.to_space(&before),
            velocity_after: self.frame.to_space(&after),
            tangential_restitution: tangential_restitution(&before, &after),
            duration: outcome.duration,
            maximal_force: outcome.maximal_force,
            maximal_approach: outcome.maximal_approach,
            maximal_radius,
            energy,
            torsion,
            compressions: outcome.compressions,
            error_estimate: outcome.error_estimate,
            log: Vec::new(),
            warnings: self.warnings(maximal_radius, before.z)?,
        })
    }

    fn torsion(&self, velocity: f64) -> Result<Option<Torsion>, NormalSpinError> {
        if self.torsion == TorsionMode::LeftOut {
            return Ok(None);
        }
        let d = self.mobility.matrix();
        if libm::hypot(d.m13, d.m23) > UNCOUPLED * d.m33 {
            return Err(NormalSpinError::NormalCoupled);
        }
        self.normal_spin(velocity).solve().map(Some)
    }

    fn normal_spin(&self, velocity: f64) -> NormalSpin<'_> {
        let pivot = |i: usize| Pivot {
            arm: self.levers[i].arm(),
            inverse_tensor: *self.levers[i].inverse_tensor(),
            spin: self.bodies[i].motion.spin,
        };
        NormalSpin {
            hertz: &self.hertz,
            friction: self.friction,
            normal: self.frame.z(),
            pivots: [pivot(0), pivot(1)],
            normal_mobility: self.mobility.matrix().m33,
            velocity,
        }
    }

    fn after(&self, impulse: &Vector3<f64>) -> [Motion; 2] {
        [0, 1].map(|i| {
            let push = if i == 0 { *impulse } else { -impulse };
            let (body, lever) = (&self.bodies[i], &self.levers[i]);
            Motion {
                velocity: body.motion.velocity + push * body.inertia.inverse_mass(),
                spin: body.motion.spin + lever.inverse_tensor() * lever.arm().cross(&push),
            }
        })
    }

    fn warnings(&self, maximal_radius: f64, velocity: f64) -> Result<Vec<Warning>, RangeError> {
        let mut warnings = Vec::new();
        if self.certainty == Certainty::Sampled {
            warnings.push(Warning::PointSampled);
        }
        if !self.materials.is_uncoupled() {
            let gamma = self.materials.gamma();
            let friction_over_gamma = self.friction.get() / gamma.abs();
            warnings.push(Warning::Coupling { gamma, friction_over_gamma });
        }
        let ratio = maximal_radius / self.smallest_radius;
        if ratio > 0.1 {
            warnings.push(Warning::LargeContact { ratio });
        }
        let d_zz = self.mobility.matrix().m33;
        let pulse = NormalImpact::new(d_zz, self.hertz.stiffness().c_z, velocity)?;
        let share = self.bodies.iter().filter_map(|body| {
            let density = body.inertia.mass() / body.surface.volume()?;
            wave_share(body.material, density, &pulse)
        });
        let share = share.fold(0.0, f64::max);
        if share > NOTICEABLE {
            warnings.push(Warning::WaveLoss { share });
        }
        if self.torsion == TorsionMode::LeftOut {
            warnings.extend(self.normal_spin(velocity).left_alone());
        }
        Ok(warnings)
    }
}

// Along the tangential motion before; 0 where there was none.
fn tangential_restitution(before: &Vector3<f64>, after: &Vector3<f64>) -> f64 {
    let squared = before.x * before.x + before.y * before.y;
    if squared == 0.0 {
        return 0.0;
    }
    -(after.x * before.x + after.y * before.y) / squared
}
