//! The result of a collision: motions, energy, torsion, warnings.

use carom_geometry::Certainty;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::validity::Validity;
use carom_special::RangeError;
use nalgebra::Vector3;

use super::{Collision, CollisionError};
use crate::body::Body;
use crate::closed_form::restitution_without_slip;
use crate::coupled::{CoupledOutcome, is_coupled};
use crate::motion::Motion;
use crate::normal::NormalImpact;
use crate::normal_spin::{NormalSpin, NormalSpinError, Pivot};
use crate::oblique::Groups;
use crate::outcome::{EnergyBudget, LogEntry, Rebound, Torsion, TorsionMode};
use crate::viscoelastic::{ViscoelasticImpact, ViscousLoss};
use crate::warning::Warning;
use crate::wave_share::wave_share;

/// Couplings of the normal motion below this fraction of D_zz are round-off.
const UNCOUPLED: f64 = 1e-9;

/// Tolerance of R_x without tangential velocity.
const LIMIT: f64 = 1e-4;

/// Relative differences of chi between directions below this value are round-off.
const EVEN: f64 = 1e-12;

/// Results that a method gives beyond velocities and impulse.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Known {
    /// R_x of an elastic impact.
    pub(crate) r_x: Option<f64>,
    /// The change of the spin about the normal.
    pub(crate) torsion: Option<Torsion>,
}

impl Collision {
    /// The rebound of the bodies from an impact that was computed in contact axes, here or elsewhere:
    /// motions, energies, torsion and warnings.
    ///
    /// # Errors
    /// [`CollisionError::Range`] if impulse or energy overflow; [`CollisionError::NormalSpin`] for torsion
    /// that cannot be computed.
    pub fn rebound_of(
        &self,
        outcome: CoupledOutcome,
        log: Vec<LogEntry>,
    ) -> Result<Rebound, CollisionError> {
        self.rebound_with(outcome, log, Known::default())
    }

    /// As [`Collision::rebound_of`], for methods that give further results.
    pub(crate) fn rebound_with(
        &self,
        outcome: CoupledOutcome,
        log: Vec<LogEntry>,
        known: Known,
    ) -> Result<Rebound, CollisionError> {
        let (before, elastic, whole) = (self.velocity(), outcome.velocity, outcome.impulse);
        let pulse = self.pulse(before.z)?;
        let share = self.wave_share(&pulse);
        let damped = self.normal_restitution.damped([before.z, elastic.z]);
        let [impulse, after] = damped.motion(whole, [&before, &elastic]);
        let mut motions = self.pushed(&impulse);
        // E_A - E_E of the relative motion, without its cancellation.
        let whole_loss = 0.5 * whole.dot(&(before + elastic));
        let mut dissipated = damped.part * (whole_loss - outcome.material_heat);
        let mut lost = damped.lost(0.5 * whole.dot(&(before - elastic))) + outcome.material_heat;
        let mut torsion = match known.torsion {
            None => self.torsion(before.z)?,
            torsion => torsion,
        };
        if let Some(torsion) = &mut torsion {
            let spin = self.normal_spin(before.z);
            lost += damped.lost(spin.exchanged(torsion));
            torsion.damp(damped);
            motions.iter_mut().enumerate().for_each(|(i, m)| m.spin += spin.turn(i, torsion));
            dissipated += torsion.dissipated;
        }
        let kinetic = |motions: [Motion; 2]| {
            self.bodies[0].kinetic_energy(&motions[0]) + self.bodies[1].kinetic_energy(&motions[1])
        };
        let energy = EnergyBudget {
            before: kinetic(self.bodies.each_ref().map(Body::motion)),
            after: kinetic(motions),
            dissipated,
            lost,
        };
        // For masses near the largest number.
        RangeError::finite("impulse", impulse.abs().sum())?;
        RangeError::finite("kinetic energy", energy.before + energy.after)?;
        let maximal_contact = self.hertz.ellipse(outcome.maximal_approach)?;
        let pressing = self.viscous_loss(before.z)?.map_or(1.0, |loss| loss.pressing());
        let peak_pressure = maximal_contact.peak_pressure(pressing * outcome.maximal_force);
        let spin_share = match torsion {
            Some(_) => 0.0,
            None => self.normal_spin(before.z).greatest_loss().unwrap_or(0.0),
        };
        let [coupling, spin_on_shift] = self.left_out(outcome.method);
        let slip = libm::hypot(before.x, before.y);
        let left_out = (coupling + spin_on_shift) * slip / libm::hypot(slip, before.z);
        let error_estimate = outcome.error_estimate + left_out;
        if let Some(torsion) = torsion.as_mut().filter(|_| known.torsion.is_none()) {
            // It is computed as if there were no tangential motion.
            torsion.error_estimate +=
                if self.is_tangential() { self.twist_bound().spin } else { 0.0 };
        }
        let validity = Validity {
            spin_share,
            spin_on_shift,
            coupling,
            ..self.validity(&outcome, (&maximal_contact, peak_pressure), share)
        };
        let r_x = match known.r_x {
            Some(elastic) => Some(elastic),
            None => self.restitution(&before, &elastic)?,
        };
        let r_x = r_x.map(|elastic| damped.restitution(elastic));
        let model_uncertainty = self.model_uncertainty(&before, r_x)?;
        let warnings =
            self.warnings(validity).chain(Self::unknown_cause(&before, model_uncertainty));
        let warnings = warnings.chain(outcome.warning.or(self.missed_tolerance(error_estimate)));
        let warnings = warnings.collect();
        self.with_turning_centres(Rebound {
            motions,
            normal: self.frame().z(),
            impulse: self.frame().to_space(&impulse),
            contact_velocity_before: self.frame().to_space(&before),
            contact_velocity_after: self.frame().to_space(&after),
            r_x,
            duration: outcome.duration,
            maximal_force: outcome.maximal_force,
            maximal_approach: outcome.maximal_approach,
            maximal_contact,
            peak_pressure,
            energy,
            torsion,
            friction: self.friction,
            method: outcome.method,
            compressions: outcome.compressions,
            error_estimate,
            model_uncertainty,
            log,
            validity,
            warnings,
        })
    }

    /// The motions after an impulse on body 1, in contact axes.
    pub(super) fn pushed(&self, impulse: &Vector3<f64>) -> [Motion; 2] {
        [0, 1].map(|i| {
            let push = if i == 0 { *impulse } else { -impulse };
            self.levers[i].pushed(self.frame().axes(), &self.bodies[i].motion(), &push)
        })
    }

    pub(super) fn missed_tolerance(&self, error_estimate: f64) -> Option<Warning> {
        let tolerance = self.tolerance.filter(|tolerance| error_estimate > *tolerance)?;
        Some(Warning::NotSettled { error_estimate, tolerance })
    }

    fn torsion(&self, velocity: f64) -> Result<Option<Torsion>, CollisionError> {
        if self.torsion != TorsionMode::Included {
            return Ok(None);
        }
        let d = self.mobility.matrix();
        if libm::hypot(d.m13, d.m23) > UNCOUPLED * d.m33 {
            return Err(NormalSpinError::NormalCoupled.into());
        }
        let elastic = self.normal_spin(velocity).solve()?;
        Ok(Some(match self.viscous_loss(velocity)? {
            None => elastic,
            Some(loss) => self.viscous_torsion(elastic, loss)?,
        }))
    }

    pub(super) fn normal_spin(&self, velocity: f64) -> NormalSpin<'_> {
        let pivot = |i: usize| Pivot {
            arm: self.levers[i].arm(),
            inverse_tensor: *self.levers[i].inverse_tensor(),
            spin: self.bodies[i].motion().spin,
        };
        NormalSpin {
            hertz: &self.hertz,
            friction: self.friction,
            normal: self.frame().z(),
            pivots: [pivot(0), pivot(1)],
            normal_mobility: self.mobility.matrix().m33,
            velocity,
            restitution: self
                .viscous_loss(velocity)
                .ok()
                .flatten()
                .map_or(1.0, |loss| loss.restitution()),
        }
    }

    // If the limit depends on the direction, a tangential velocity within the round-off of the velocities
    // that it is the difference of has no R_x.
    fn restitution(
        &self,
        before: &Vector3<f64>,
        after: &Vector3<f64>,
    ) -> Result<Option<f64>, RangeError> {
        let chi = self.chi_of_all_directions();
        if !self.is_tangential() && chi.is_none() {
            return Ok(None);
        }
        match (along(before, after), chi) {
            (None, Some(chi)) => self.limit(chi, before.z).map(Some),
            (r_x, _) => Ok(r_x),
        }
    }

    // chi if R_x for vanishing tangential velocities is the same in all directions; 0 without friction.
    fn chi_of_all_directions(&self) -> Option<f64> {
        let d = self.mobility.matrix();
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness();
        if is_coupled(d) {
            return None;
        }
        if self.friction.get() == 0.0 && self.static_friction.is_none() {
            return Some(0.0);
        }
        // The matrix of chi; c_x and c_y of a circle may differ by round-off.
        let chi = [d.m11 * c_x, d.m22 * c_y].map(|product| product / (d.m33 * c_z));
        let turning = d.m12 * (c_x * c_y).sqrt() / (d.m33 * c_z);
        let even = (chi[0] - chi[1]).abs().max(2.0 * turning.abs()) <= EVEN * chi[0];
        even.then_some(chi[0])
    }

    // R_x for vanishing tangential velocities.
    fn limit(&self, chi: f64, velocity: f64) -> Result<f64, RangeError> {
        if chi == 0.0 {
            return Ok(-1.0);
        }
        Ok(match self.viscous_loss(velocity)? {
            None => restitution_without_slip(chi).clamp(-1.0, 1.0),
            Some(loss) => {
                let impact = ViscoelasticImpact::new(Groups::new(chi, 0.0)?, loss);
                impact.solve(LIMIT).restitution
            }
        })
    }

    /// The loss of a viscous material at this speed of approach.
    pub(crate) fn viscous_loss(&self, velocity: f64) -> Result<Option<ViscousLoss>, RangeError> {
        let pulse = self.pulse(velocity)?;
        self.normal_restitution.viscous(|| self.wave_share(&pulse), &pulse)
    }

    // The largest share of the normal energy that waves carry away.
    pub(super) fn wave_share(&self, pulse: &NormalImpact) -> f64 {
        let share = self.bodies.iter().filter_map(|body| {
            let density = body.inertia().mass() / body.placed().surface().volume()?;
            wave_share(body.material(), density, pulse)
        });
        share.fold(0.0, f64::max)
    }

    // The elastic impact without friction.
    pub(super) fn pulse(&self, velocity: f64) -> Result<NormalImpact, RangeError> {
        let d_zz = self.mobility.matrix().m33;
        NormalImpact::new(d_zz, self.hertz.stiffness().c_z, velocity)
    }

    fn validity(
        &self,
        outcome: &CoupledOutcome,
        (contact, pressure): (&ContactEllipse, f64),
        wave_share: f64,
    ) -> Validity {
        let largest = [contact.semi_axis_b(), outcome.maximal_approach, pressure];
        let radius = self.contact.smallest_radius();
        let wave_share = if self.normal_restitution.is_elastic() { wave_share } else { 0.0 };
        Validity {
            wave_share,
            ..Validity::of_contact(largest, self.materials.yield_stress(), radius)
        }
    }

    fn warnings(&self, validity: Validity) -> impl Iterator<Item = Warning> {
        let sampled = self.contact.certainty() == Certainty::Sampled;
        sampled.then_some(Warning::PointSampled).into_iter().chain(Warning::of(validity))
    }
}

// -(after)/(before) along the tangential velocity before, scaled so that no square underflows.
pub(super) fn along(before: &Vector3<f64>, after: &Vector3<f64>) -> Option<f64> {
    let largest = before.x.abs().max(before.y.abs());
    if largest == 0.0 {
        return None;
    }
    let (x, y) = (before.x / largest, before.y / largest);
    Some(-(after.x / largest * x + after.y / largest * y) / (x * x + y * y))
}
