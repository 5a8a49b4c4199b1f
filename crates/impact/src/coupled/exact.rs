//! Impacts that need no steps: without friction, and uncoupled ones.

use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::Vector3;

use super::{CoupledError, CoupledImpact, CoupledOutcome, Sample, Stage};
use crate::normal;
use crate::oblique::{Groups, ObliqueImpact};

impl CoupledImpact {
    pub(super) fn groups(&self, direction: &Vector3<f64>) -> Result<Groups, RangeError> {
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let along = c_x * direction.x * direction.x + c_y * direction.y * direction.y;
        let tangential = direction.dot(&(self.mobility.matrix() * direction));
        let chi = tangential / self.mobility.matrix().m33 * along / c_z;
        let slip = self.tangential().norm();
        let ratio = along / c_z * (slip / self.velocity.z);
        let psi = if slip == 0.0 { 0.0 } else { ratio / self.friction.get() };
        Groups::new(chi, psi)
    }

    pub(super) fn tangential(&self) -> Vector3<f64> {
        Vector3::new(self.velocity.x, self.velocity.y, 0.0)
    }

    pub(super) fn uncoupled(
        &self,
        oblique: &ObliqueImpact,
        direction: &Vector3<f64>,
    ) -> CoupledOutcome {
        let mut velocity = self.tangential() * -oblique.restitution();
        velocity.z = -self.velocity.z;
        let mobility = direction.dot(&(self.mobility.matrix() * direction));
        let limit = self.friction.get() * self.normal.impulse();
        let mut impulse = direction * oblique.drag(self.tangential().norm(), mobility, limit);
        impulse.z = self.normal.impulse();
        self.exact(velocity, impulse)
    }

    pub(super) fn frictionless(&self) -> CoupledOutcome {
        let impulse = Vector3::z() * self.normal.impulse();
        let mut velocity = self.after(&impulse);
        velocity.z = -self.velocity.z;
        self.exact(velocity, impulse)
    }

    fn exact(&self, velocity: Vector3<f64>, impulse: Vector3<f64>) -> CoupledOutcome {
        CoupledOutcome {
            velocity,
            impulse,
            duration: self.normal.duration(),
            maximal_approach: self.normal.maximal_approach(),
            maximal_force: self.normal.maximal_force(),
            compressions: 1,
            method: self.method(),
            error_estimate: 0.0,
            warning: None,
        }
    }

    pub(super) fn traced(&self, direction: &Vector3<f64>) -> Result<Vec<Sample>, CoupledError> {
        const COUNT: usize = 200;
        let step = normal::DURATION / COUNT as f64;
        let states: Vec<_> = (0..=COUNT).map(|i| normal::state_at(step * i as f64)).collect();
        let velocities: Vec<f64> = states.iter().map(|state| state.velocity).collect();
        let trace = ObliqueImpact::trace(self.groups(direction)?, &velocities)?;
        let (units, slip) = (self.units(), self.tangential().norm());
        let along = direction.component_mul(direction);
        let stiffness = self.stiffness.c_x * along.x + self.stiffness.c_y * along.y;
        let tangential = units.force * stiffness / self.stiffness.c_z * slip / units.speed;
        let samples = trace.iter().zip(&states).enumerate().map(|(i, (point, state))| {
            let zeta = state.compression;
            let drag = if slip > 0.0 { tangential * point.force } else { 0.0 };
            Sample {
                time: units.time * step * i as f64,
                shift: direction * (slip * units.time * point.shift)
                    + Vector3::z() * (units.length * zeta),
                velocity: direction * (slip * point.velocity)
                    + Vector3::z() * (units.speed * state.velocity),
                force: direction * drag + Vector3::z() * (units.force * zeta * zeta.sqrt()),
                stage: Stage::of(point.regime),
            }
        });
        Ok(samples.collect())
    }
}
