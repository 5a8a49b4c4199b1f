//! The outcome of a coupled impact, in the units and axes of its data.

use nalgebra::Vector3;

use super::refine::Settled;
use super::scaled::Units;
use super::{CoupledImpact, ImpactMethod, Stage};
use crate::warning::Warning;

/// The outcome of a coupled impact.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledOutcome {
    /// Velocity of body 2 against body 1 after the impact, contact axes.
    pub velocity: Vector3<f64>,
    /// The impulse that body 2 gave body 1, contact axes.
    pub impulse: Vector3<f64>,
    /// Duration from first contact to separation.
    pub duration: f64,
    /// The greatest approach.
    pub maximal_approach: f64,
    /// The greatest normal force.
    pub maximal_force: f64,
    /// Number of compressions: 2 or more if the bodies were compressed again before separation.
    pub compressions: u32,
    /// The energy that the material lost, without that of friction.
    pub material_heat: f64,
    /// The method of solution.
    pub method: ImpactMethod,
    /// Estimated error of the velocity over |v_A|: the change by the last refinements; 0 for exact
    /// methods.
    pub error_estimate: f64,
    /// The warning that it did not converge, if [`CoupledImpact::accepting_unsettled`] allowed
    /// this.
    pub warning: Option<Warning>,
}

/// One instant of the impact, in contact axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time since first contact.
    pub time: f64,
    /// Shift of body 2 against body 1 since first contact: xi, eta, zeta.
    pub shift: Vector3<f64>,
    /// Its rate.
    pub velocity: Vector3<f64>,
    /// Force on body 1.
    pub force: Vector3<f64>,
    /// Stage: how much of the contact slips.
    pub stage: Stage,
}

impl CoupledImpact {
    pub(super) fn outcome(&self, settled: &Settled) -> CoupledOutcome {
        let mut outcome = self.outcome_in(settled, &self.units());
        outcome.impulse = self.frame() * outcome.impulse;
        outcome.velocity = self.after(&outcome.impulse);
        if outcome.method == (ImpactMethod::Spatial { coupled: false }) {
            // The normal motion is known in closed form.
            let known =
                self.loss.map_or_else(|| self.frictionless(), |loss| self.frictionless_with(&loss));
            outcome.velocity.z = known.velocity.z;
            outcome.duration = known.duration;
            outcome.maximal_approach = known.maximal_approach;
            outcome.maximal_force = known.maximal_force;
        }
        outcome
    }

    pub(super) fn outcome_in(&self, settled: &Settled, units: &Units) -> CoupledOutcome {
        let run = &settled.run;
        let peak = run.peak * units.length;
        let impulse = run.impulse * units.impulse;
        CoupledOutcome {
            velocity: self.after(&impulse),
            impulse,
            duration: run.duration * units.time,
            maximal_approach: peak,
            maximal_force: match self.loss {
                None => 2.0 / 3.0 * self.stiffness.c_z * (peak * peak.sqrt()),
                Some(_) => run.strongest * units.force,
            },
            compressions: run.compressions,
            material_heat: 0.0,
            method: self.method(),
            error_estimate: settled.error,
            warning: (!settled.settled).then(|| Warning::NotSettled {
                error_estimate: settled.error,
                tolerance: self.tolerance(),
            }),
        }
    }

    pub(super) fn after(&self, impulse: &Vector3<f64>) -> Vector3<f64> {
        self.velocity - self.mobility.matrix() * impulse
    }
}
