//! Impacts solved without time steps: frictionless and uncoupled ones.

use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::Vector3;

use super::direction::length_and_direction;
use super::{CoupledError, CoupledImpact, CoupledOutcome, ImpactMethod, Sample, Stage};
use crate::normal::{self, NormalImpact};
use crate::oblique::{Groups, ObliqueImpact, Regime};
use crate::outcome::LogEntry;

/// One instant of the exact solution.
pub(crate) struct Traced {
    pub(crate) sample: Sample,
    pub(crate) regime: Regime,
    /// Stick depth: the approach at which the present stick area was the whole contact.
    pub(crate) stick_depth: f64,
}

impl CoupledImpact {
    /// The direction of the tangential motion if it is uncoupled from the normal motion, so that
    /// the solution is exact.
    pub(crate) fn exact_direction(&self) -> Option<Vector3<f64>> {
        match self.method() {
            ImpactMethod::Uncoupled { direction } => Some(direction),
            ImpactMethod::Frictionless => {
                let direction = length_and_direction(&self.velocity).1;
                let exact = self.is_symmetric || !super::is_coupled(self.mobility.matrix());
                (exact && self.groups(&direction).is_ok()).then_some(direction)
            }
            _ => None,
        }
    }

    /// c_t, the stiffness, and D_tt, the mobility along a direction.
    pub(super) fn tangential(&self, direction: &Vector3<f64>) -> (f64, f64) {
        let (ContactStiffness { c_x, c_y, .. }, d) = (self.stiffness, self.mobility.matrix());
        if self.is_symmetric {
            return (c_x, d.m11);
        }
        let stiffness = c_x * direction.x * direction.x + c_y * direction.y * direction.y;
        (stiffness, direction.dot(&(d * direction)))
    }

    pub(super) fn groups(&self, direction: &Vector3<f64>) -> Result<Groups, RangeError> {
        let (stiffness, mobility) = self.tangential(direction);
        let ratio = stiffness / self.stiffness.c_z;
        let chi = mobility * stiffness / (self.mobility.matrix().m33 * self.stiffness.c_z);
        let slip = length_and_direction(&self.velocity).0;
        let psi = match self.friction.coefficient() {
            None => 0.0,
            Some(0.0) => f64::INFINITY,
            Some(f) => ratio * slip / self.velocity.z / f,
        };
        Groups::new(chi, psi)
    }

    pub(super) fn uncoupled(
        &self,
        oblique: &ObliqueImpact,
        direction: &Vector3<f64>,
    ) -> CoupledOutcome {
        let (slip, mobility) =
            (length_and_direction(&self.velocity).0, self.tangential(direction).1);
        let mut velocity = direction * (-oblique.restitution() * slip);
        velocity.z = -self.velocity.z;
        let limit = self.friction.get() * self.normal.impulse();
        let mut impulse = direction * oblique.drag(slip, mobility, limit);
        impulse.z = self.normal.impulse();
        self.exact(velocity, impulse)
    }

    pub(super) fn frictionless(&self) -> CoupledOutcome {
        let impulse = Vector3::z() * self.normal.impulse();
        let mut velocity = self.after(&impulse);
        velocity.z = -self.velocity.z;
        self.exact(velocity, impulse)
    }

    pub(super) fn exact(&self, velocity: Vector3<f64>, impulse: Vector3<f64>) -> CoupledOutcome {
        CoupledOutcome {
            velocity,
            impulse,
            duration: self.normal.duration(),
            maximal_approach: self.normal.maximal_approach(),
            maximal_force: self.normal.maximal_force(),
            compressions: 1,
            material_heat: 0.0,
            method: self.method(),
            error_estimate: 0.0,
            warning: None,
        }
    }

    /// The exact solution at these times since first contact, in units of the normal impact.
    pub(crate) fn traced(
        &self,
        direction: &Vector3<f64>,
        times: &[f64],
    ) -> Result<Vec<Traced>, CoupledError> {
        // The normal motion is found by time: the velocity alone does not resolve the first
        // instants.
        let states: Vec<_> = times.iter().map(|time| normal::state_at(*time)).collect();
        let velocities: Vec<f64> = states.iter().map(|state| state.velocity).collect();
        let trace = ObliqueImpact::trace(self.groups(direction)?, &velocities)?;
        let (units, slip) = (self.units(), length_and_direction(&self.velocity).0);
        let stiffness = self.tangential(direction).0;
        let tangential = units.force * stiffness / self.stiffness.c_z * slip / units.speed;
        let along = |tangential: f64, normal: f64| {
            Vector3::new(direction.x * tangential, direction.y * tangential, normal)
        };
        let instants = trace.iter().zip(times).zip(&states).map(|((point, time), state)| {
            let zeta = state.compression;
            let pull = if slip > 0.0 { tangential * point.force } else { 0.0 };
            let sample = Sample {
                time: units.time * time,
                shift: along(slip * units.time * point.shift, units.length * zeta),
                velocity: along(slip * point.velocity, units.speed * state.velocity),
                force: along(pull, units.force * zeta * zeta.sqrt()),
                stage: Stage::of(point.regime),
            };
            let stick_depth = units.length * point.stick_depth.min(zeta);
            Traced { sample, regime: point.regime, stick_depth }
        });
        Ok(instants.collect())
    }
}

pub(super) fn log(normal: &NormalImpact, oblique: &ObliqueImpact) -> Vec<LogEntry> {
    let unit = normal.time_unit();
    oblique
        .phases()
        .iter()
        .map(|phase| LogEntry {
            time: unit * normal::time(phase.start),
            event: phase.began_by,
            regime: phase.regime,
        })
        .collect()
}
