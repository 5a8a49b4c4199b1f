//! Impacts whose material loses energy like a Kelvin-Voigt body, solved by its row of springs.

use carom_laws::friction::Friction;
use carom_laws::law::ContactLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::viscous::{Viscosity, ViscousLaw};
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use super::direction::length_and_direction;
use super::impact::Unsettled;
use super::limits::Limits;
use super::refine::Settled;
use super::{
    CoupledError, CoupledImpact, CoupledOutcome, ImpactMethod, Sample, Stage, TurningLaw,
    is_coupled, springs,
};
use crate::mobility::Mobility;
use crate::viscoelastic::{Instant, NormalRebound, ViscoelasticImpact, ViscousLoss};

/// Default tolerance of R_x.
const TOLERANCE: f64 = 1e-4;
/// Shares of the contact radius within which all of it sticks, or slides.
const WHOLE: f64 = 1e-9;

/// An impact of a viscous material without couplings, whose solution is known, beside that by the step law
/// ([`ViscousLaw`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepError {
    /// What the step law has more of the velocity after the impact, contact axes; along the normal where the springs of the
    /// least restitution stand for less.
    pub velocity: Vector3<f64>,
    /// The energy that the material takes of the tangential motion.
    pub material_heat: f64,
}

/// Error of the law of viscous materials that keeps the slip of each place ([`carom_laws::slip_lag`]), in the tangential
/// velocity over f v_z: by coupling, where gamma/f is [`TURNED`] and more and at most half of the normal velocity is left, and
/// by a spin, where none is left. By full simulations of 24 drawn impacts; 47 of 48 others lie within.
const LOST_BY_COUPLING: f64 = 0.012;
const TURNED: f64 = 2.0;
const LOST_BY_SPIN: f64 = 0.03;
/// The same of like bodies, against the exact impact.
const LEFT_ALIKE: f64 = 6e-3;

/// That of the law of viscous materials which slides as a whole where the slip turns, where at most half of the normal
/// velocity is left: enough for 87 of 90 drawn impacts of spheres and ellipsoids with a plane.
const LEFT_TURNING: f64 = 0.1;

/// The error of the law of viscous materials that keeps the slip of each place, in the tangential velocity over f v_z.
/// `turned` is |gamma|/f, `spun` the velocity of the rim by the spin over f v_z.
#[must_use]
pub fn left_by_loss(loss: ViscousLoss, turned: f64, spun: f64) -> f64 {
    let lost = 1.0 - loss.restitution();
    let coupled = (turned / TURNED).min(1.0) * (2.0 * lost).min(1.0);
    LOST_BY_COUPLING * coupled + LOST_BY_SPIN * spun.min(1.0) * lost * lost
}

impl StepError {
    const NONE: Self = Self { velocity: Vector3::new(0.0, 0.0, 0.0), material_heat: 0.0 };

    /// The error of the tangential velocity, of which as much again may be left.
    #[must_use]
    pub fn of_law(&self) -> f64 {
        self.velocity.xy().norm()
    }
}

/// The units of [`crate::viscoelastic`]: m = K = v = 1.
struct Units {
    time: f64,
    length: f64,
    force: f64,
}

impl CoupledImpact {
    /// The same impact of a material with this loss.
    pub(crate) fn with_loss(self, loss: ViscousLoss) -> Self {
        Self { loss: (loss.restitution() < 1.0).then_some(loss), ..self }
    }

    /// The viscosity of the material, if it loses energy.
    ///
    /// # Errors
    /// [`RangeError`] if the relaxation time overflows.
    pub fn material_viscosity(&self) -> Result<Option<Viscosity>, RangeError> {
        let unit = self.viscous_units().time;
        self.loss.map(|loss| loss.viscosity(unit)).transpose()
    }

    /// The approach at which an elastic contact bears the greatest force of this impact without friction.
    #[must_use]
    pub fn deepest(&self) -> f64 {
        let force = |loss: ViscousLoss| libm::cbrt(loss.normal_rebound().maximal_force);
        let length = self.viscous_units().length;
        self.loss.map_or(self.normal.maximal_approach(), |loss| length * force(loss).powi(2))
    }

    /// Whether the material loses energy.
    #[must_use]
    pub const fn loses(&self) -> bool {
        self.loss.is_some()
    }

    fn viscous_units(&self) -> Units {
        // zeta_max is (5/4)^(2/5) times the unit of length.
        let part = libm::pow(1.25, -0.4);
        let (time, length) =
            (part * self.normal.time_unit(), part * self.normal.maximal_approach());
        Units { time, length, force: self.velocity.z / (self.mobility.matrix().m33 * time) }
    }

    /// The largest error of R_x with which the velocity keeps its tolerance.
    fn tolerance_of_restitution(&self) -> f64 {
        let slip = length_and_direction(&self.velocity).0;
        self.tolerance.map_or(TOLERANCE, |whole| whole * self.velocity.norm() / slip)
    }

    /// An impact without friction, with a loss.
    pub(super) fn frictionless_with(&self, loss: &ViscousLoss) -> CoupledOutcome {
        let impulse = Vector3::z() * self.normal_impulse(loss);
        let mut velocity = self.after(&impulse);
        velocity.z = -loss.restitution() * self.velocity.z;
        let material_heat = 0.5 * impulse.z * (self.velocity.z + velocity.z);
        self.lossy((velocity, impulse), &loss.normal_rebound(), material_heat)
    }

    /// An uncoupled impact with a loss.
    pub(super) fn uncoupled_with(
        &self,
        loss: &ViscousLoss,
        direction: &Vector3<f64>,
    ) -> Result<CoupledOutcome, CoupledError> {
        let impact = ViscoelasticImpact::new(self.groups(direction)?, *loss);
        let rebound = impact.solve(self.tolerance_of_restitution());
        let (slip, (_, mobility)) =
            (length_and_direction(&self.velocity).0, self.tangential(direction));
        let mut velocity = direction * (-rebound.restitution * slip);
        velocity.z = -loss.restitution() * self.velocity.z;
        let mut impulse = Vector3::z() * self.normal_impulse(loss);
        let limit = self.friction.get() * impulse.z;
        impulse += direction * ((1.0 + rebound.restitution) * slip / mobility).min(limit);
        let lost = 0.5 * impulse.dot(&(self.velocity + velocity));
        let friction = self.friction_heat(rebound.friction_heat, impact.psi(), direction);
        let normal = NormalRebound {
            duration: rebound.duration,
            maximal_approach: rebound.maximal_approach,
            maximal_force: rebound.maximal_force,
            pressing: rebound.pressing,
        };
        let outcome = self.lossy((velocity, impulse), &normal, (lost - friction).max(0.0));
        let error_estimate = rebound.error_estimate * slip / self.velocity.norm();
        Ok(CoupledOutcome { error_estimate, ..outcome })
    }

    // f^2 kappa m v^2 times a number; f by psi, which is finite for all friction.
    fn friction_heat(&self, heat: f64, psi: f64, direction: &Vector3<f64>) -> f64 {
        let slip = length_and_direction(&self.velocity).0;
        let ratio = self.tangential(direction).0 / self.stiffness.c_z;
        let over = slip / psi;
        ratio * over * over / self.mobility.matrix().m33 * heat
    }

    /// Whether nothing couples the normal motion, so that it is that without friction.
    fn is_normal_known(&self) -> bool {
        self.is_symmetric || !is_coupled(self.mobility.matrix())
    }

    fn normal_impulse(&self, loss: &ViscousLoss) -> f64 {
        0.5 * (1.0 + loss.restitution()) * self.normal.impulse()
    }

    fn lossy(
        &self,
        (velocity, impulse): (Vector3<f64>, Vector3<f64>),
        normal: &NormalRebound,
        material_heat: f64,
    ) -> CoupledOutcome {
        let units = self.viscous_units();
        CoupledOutcome {
            duration: normal.duration * units.time,
            maximal_approach: normal.maximal_approach * units.length,
            maximal_force: normal.maximal_force * units.force,
            material_heat,
            ..self.exact(velocity, impulse)
        }
    }

    /// The instants of an uncoupled impact with a loss, first contact and separation among them.
    pub(super) fn exact_samples_with(
        &self,
        direction: &Vector3<f64>,
    ) -> Result<Vec<Sample>, CoupledError> {
        let loss = &self.loss.unwrap_or(ViscousLoss::NONE);
        let outcome = match self.friction.get() == 0.0 {
            true => self.frictionless_with(loss),
            false => self.uncoupled_with(loss, direction)?,
        };
        let impact = ViscoelasticImpact::new(self.groups(direction)?, *loss);
        let (instants, psi) = impact.instants(self.tolerance_of_restitution());
        let (units, slip) = (self.viscous_units(), length_and_direction(&self.velocity).0);
        let ratio = self.tangential(direction).0 / self.stiffness.c_z;
        let over = slip / psi;
        let pull = ratio * over / self.velocity.z * units.force;
        let along = |x: f64, z: f64| direction * x + Vector3::z() * z;
        let sample = |at: &Instant| Sample {
            time: units.time * at.time,
            shift: along(over * units.time * at.shift, units.length * at.approach),
            velocity: along(over * at.rate, self.velocity.z * at.speed),
            force: along(pull * at.force, units.force * at.normal_force),
            stage: stage(at.sticks),
        };
        Ok(self.with_ends(instants.iter().map(sample).collect(), &outcome))
    }
}

impl CoupledImpact {
    /// The relaxation time in the units of the problem.
    pub(super) fn viscosity(&self) -> Result<Option<Viscosity>, RangeError> {
        let unit = libm::pow(1.25, -0.4);
        self.loss.map(|loss| loss.viscosity(unit)).transpose()
    }

    pub(super) fn viscous_law<L: ContactLaw>(&self, law: L, viscosity: Viscosity) -> ViscousLaw<L> {
        let sliding = self.static_friction.map_or(self.friction, StaticFriction::kinetic);
        ViscousLaw::new(law, viscosity, sliding.get(), self.scaled())
    }

    /// The outcome of a stepped impact with a loss, less the error of the step law ([`ViscousLaw`]) in the same impact
    /// without couplings, whose solution is known. As much again is the estimate of what remains, and more where slip turns by
    /// Coulomb's law: springs, which are right there, were refused.
    pub(super) fn corrected(
        &self,
        settled: &Settled,
        law: TurningLaw,
        loss: &ViscousLoss,
    ) -> Result<CoupledOutcome, CoupledError> {
        let outcome = self.outcome(settled);
        let error = self.viscous_step_error()?;
        let mut velocity = outcome.velocity - error.velocity;
        velocity.z = velocity.z.min(0.0);
        let (velocity, impulse) = self.within_limits(&velocity, loss);
        let material_heat = self.material_heat(&error, &impulse, &velocity);
        let turns = match (outcome.method, law) {
            (ImpactMethod::Spatial { .. }, TurningLaw::Coulomb) => {
                LEFT_TURNING * self.friction.get().min(1.0) * self.velocity.z
            }
            _ => 0.0,
        };
        let left = error.of_law() + turns * (2.0 * (1.0 - loss.restitution())).min(1.0);
        let error_estimate = outcome.error_estimate + left / self.velocity.norm();
        Ok(CoupledOutcome { velocity, impulse, material_heat, error_estimate, ..outcome })
    }

    /// Velocity and impulse after an impact with a loss, within the limit of friction; the normal motion is known unless it is
    /// coupled.
    fn within_limits(
        &self,
        velocity: &Vector3<f64>,
        loss: &ViscousLoss,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let impulse = self.mobility.impulse(&self.velocity, velocity);
        let normal = self.is_normal_known().then(|| self.normal_impulse(loss));
        let limits = Limits::new(self.mobility.matrix(), self.friction, &self.velocity, normal);
        let impulse = limits.restrict(&impulse);
        let mut velocity = self.after(&impulse);
        if normal.is_some() {
            velocity.z = -loss.restitution() * self.velocity.z;
        }
        (velocity, impulse)
    }

    /// An impact with a loss whose motions couple or whose slip turns, by a row of springs, and its instants; none if that
    /// cannot be, or if the law keeps directions where the slip turns.
    pub(super) fn by_viscous_springs(
        &self,
        law: TurningLaw,
        loss: &ViscousLoss,
    ) -> Option<(CoupledOutcome, Vec<Sample>)> {
        match (self.method(), law) {
            (ImpactMethod::Spatial { .. }, TurningLaw::Coulomb)
            | (ImpactMethod::Planar { .. }, _) => {}
            _ => return None,
        }
        let units = self.viscous_units();
        let (depth, speed) = (self.normal.maximal_approach(), self.velocity.z);
        let relaxation = loss.viscosity(units.time).ok()?.relaxation() * speed / depth;
        let found = self.by_springs(relaxation)?;
        // The springs of the least restitution stand for less: a coupled impulse is the smaller part of theirs.
        let ended = speed * found.velocity;
        let rest = (loss.restitution() / loss.of_springs()) * ended.z;
        let part = match self.is_normal_known() {
            true => 1.0,
            false => (speed - rest) / (speed - ended.z),
        };
        let ended = self.velocity - part * (self.velocity - ended);
        let (velocity, impulse) = self.within_limits(&ended, loss);
        let energy = speed * speed / self.mobility.matrix().m33;
        let lost = 0.5 * impulse.dot(&(self.velocity + velocity));
        let of_springs = self.mobility.impulse(&self.velocity, &(speed * found.velocity));
        let friction = energy * found.friction_heat * (impulse.z / of_springs.z);
        let material_heat = (lost - friction).max(0.0);
        let mut outcome = self.lossy((velocity, impulse), &loss.normal_rebound(), material_heat);
        let left_out = (1.0 - part) * self.friction.get().min(1.0);
        outcome.error_estimate = (found.error + left_out) * speed / self.velocity.norm();
        if !self.is_normal_known() {
            outcome.duration = found.duration * depth / speed;
            outcome.maximal_approach = found.maximal_approach * depth;
            outcome.maximal_force = found.maximal_force * energy / depth;
            outcome.compressions = found.compressions;
        }
        let sample = |at: &springs::Instant| Sample {
            time: at.time * depth / speed,
            shift: at.shift * depth,
            velocity: at.velocity * speed,
            force: at.force * (energy / depth),
            stage: at.stage,
        };
        let within = found.instants.iter().map(sample).filter(|at| at.time < outcome.duration);
        let samples = self.with_ends(within.collect(), &outcome);
        Some((outcome, samples))
    }

    /// The instants of an impact, with its first contact and its separation.
    fn with_ends(&self, mut samples: Vec<Sample>, outcome: &CoupledOutcome) -> Vec<Sample> {
        let (Some(first), Some(last)) = (samples.first().copied(), samples.last().copied()) else {
            return samples;
        };
        let none = Vector3::zeros();
        samples.insert(
            0,
            Sample { time: 0.0, shift: none, velocity: self.velocity, force: none, ..first },
        );
        let rest = outcome.duration - last.time;
        let shift = last.shift + 0.5 * rest * (last.velocity + outcome.velocity);
        let (time, velocity) = (outcome.duration, outcome.velocity);
        samples.push(Sample { time, shift, velocity, force: none, ..last });
        samples
    }

    /// The energy that a viscous material takes: the part of all that is lost which it takes of a row of springs. Where nothing
    /// couples or turns along one line it is all that the normal motion loses, and what it takes of the tangential motion
    /// alone. What friction does on the path of a viscous law is no measure, as that path begins with a jump.
    #[must_use]
    pub fn material_heat(
        &self,
        without_couplings: &StepError,
        impulse: &Vector3<f64>,
        after: &Vector3<f64>,
    ) -> f64 {
        let Some(loss) = &self.loss else { return 0.0 };
        let lost_by = |impulse: &Vector3<f64>, after: &Vector3<f64>| {
            0.5 * impulse.component_mul(&(self.velocity + after))
        };
        let parts = lost_by(impulse, after);
        let lost = parts.sum().max(0.0);
        if let Some((springs, _)) = self.by_viscous_springs(TurningLaw::Coulomb, loss) {
            let whole = lost_by(&springs.impulse, &springs.velocity).sum();
            return lost * (springs.material_heat / whole).min(1.0);
        }
        lost - (parts.x + parts.y - without_couplings.material_heat).clamp(0.0, lost)
    }

    /// The same of a law that keeps the slip of each place: it errs along the normal only.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn error_of_places(&self) -> Result<StepError, CoupledError> {
        let error = self.viscous_step_error()?;
        let velocity = Vector3::new(0.0, 0.0, error.velocity.z);
        Ok(StepError { velocity, ..error })
    }

    /// The error of such a law in the tangential velocity where that of like bodies is not taken off.
    #[must_use]
    pub fn left_by_loss(&self, turned: f64) -> f64 {
        let scale = self.friction.get().min(1.0) * self.velocity.z;
        self.loss.map_or(0.0, |loss| {
            let alike = LEFT_ALIKE * (2.0 * (1.0 - loss.restitution())).min(1.0);
            scale * (alike + left_by_loss(loss, turned, 0.0))
        })
    }

    /// By how much the step law errs in this impact if nothing coupled or turned, and what the material then takes; nothing
    /// in an elastic material.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn viscous_step_error(&self) -> Result<StepError, CoupledError> {
        let Some(loss) = &self.loss else { return Ok(StepError::NONE) };
        let (slip, direction) = length_and_direction(&self.velocity);
        let friction = self.friction_at_first();
        let own = Self { friction, tolerance: None, ..*self };
        let faster = Vector3::z() * ((loss.restitution() - loss.of_springs()) * self.velocity.z);
        if slip == 0.0 || friction.get() == 0.0 || own.groups(&direction).is_err() {
            return Ok(StepError { velocity: faster, ..StepError::NONE });
        }
        let known = own.uncoupled_with(loss, &direction)?;
        let twin = self.twin(&direction)?;
        let settled = twin.settled(TurningLaw::FixedDirection)?;
        let stepped = settled.run.velocity.x * self.velocity.z;
        Ok(StepError {
            velocity: faster + direction * (stepped - known.velocity.dot(&direction)),
            material_heat: known.material_heat - self.frictionless_with(loss).material_heat,
        })
    }

    /// That of static friction where the first touch sticks at its edge, or else that of kinetic friction.
    fn friction_at_first(&self) -> Friction {
        let Some(both) = self.static_friction else { return self.friction };
        let (slip, direction) = length_and_direction(&self.velocity);
        let shift = self.tangential(&direction).0 * slip;
        let sticks = shift <= both.threshold().get() * self.stiffness.c_z * self.velocity.z;
        if sticks { both.threshold() } else { both.kinetic() }
    }

    // The same impact along its slip, solved in steps though nothing couples.
    fn twin(&self, direction: &Vector3<f64>) -> Result<Self, RangeError> {
        let (stiffness, across) = self.tangential(direction);
        let along = self.mobility.matrix().m33;
        let mobility =
            Mobility::from_matrix(Matrix3::from_diagonal(&Vector3::new(across, across, along)))?;
        let slip = length_and_direction(&self.velocity).0;
        let velocity = Vector3::new(slip, 0.0, self.velocity.z);
        let stiffness = ContactStiffness { c_x: stiffness, c_y: stiffness, ..self.stiffness };
        Ok(Self {
            mobility,
            stiffness,
            friction: self.friction_at_first(),
            static_friction: None,
            velocity,
            unsettled: Unsettled::Accepted,
            ..*self
        })
    }
}

fn stage(sticks: f64) -> Stage {
    match sticks {
        sticks if sticks >= 1.0 - WHOLE => Stage::Adhesion,
        sticks if sticks <= WHOLE => Stage::Slide,
        _ => Stage::Slip,
    }
}
