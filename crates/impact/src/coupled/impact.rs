//! The oblique impact of a full mobility matrix, from the velocities before to those after.

use carom_laws::friction::Friction;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use super::any_law::AnyLaw;
use super::bare_law::BareLaw;
use super::limits::Limits;
use super::log::Log;
use super::refine::{Failure, Problem, Settled};
use super::slip_lines::SlipLines;
use super::{ImpactLaw, LawFailure, Passage, Point, Stage, Staged};
use crate::mobility::Mobility;
use crate::normal::{self, NormalImpact};
use crate::oblique::{Event, Groups, ObliqueError, ObliqueImpact, Regime};
use crate::outcome::{LogEntry, Warning};

/// Default tolerances over |v_A|: the memory of one direction is exact and its runs converge fast,
/// those of the vector laws do not. Fifteen of a hundred everyday impacts with fixed directions end
/// short of 1e-8 after 2^24 steps.
const PLANAR: f64 = 1e-8;
const SPATIAL: f64 = 5e-6;
/// Force that the line of anchors may lose with one ring, over the greatest one: this over the cube
/// of the resolution.
const OFF_LINE: f64 = 0.6;

/// Why a coupled impact cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CoupledError<E: std::error::Error + 'static = RangeError> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The exact walk of an uncoupled impact failed.
    #[error(transparent)]
    Oblique(#[from] ObliqueError),
    /// A step of the contact law failed.
    #[error(transparent)]
    Law(LawFailure<E>),
    /// The bodies stay together for 2^14 times the steps of a free impact.
    #[error(
        "the bodies do not separate within 2^14 times the steps of a free impact of {duration:e}"
    )]
    NoSeparation {
        /// The duration of the free impact.
        duration: f64,
    },
    /// Ever finer runs did not agree to the tolerance before they became too long.
    #[error(
        "not settled: {steps} steps and {rings} rings leave an error of {error_estimate:e} of |v_A|, \
         asked for {tolerance:e}"
    )]
    NotSettled {
        /// How far the best velocity may be off, over |v_A|.
        error_estimate: f64,
        /// What was asked for.
        tolerance: f64,
        /// Steps of the finest run.
        steps: usize,
        /// Its rings, where the law has rings.
        rings: usize,
    },
}

/// The friction law where the direction of the tangential motion turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum VectorLaw {
    /// Coulomb: every ring slips along its traction in the physical plane.
    #[default]
    Coulomb,
    /// The thesis (8.51): every slip ring keeps the direction in which it formed, measured with
    /// c_x xi and c_y eta. Ten times cheaper. How far it leaves the former, as a part of |v_A|, in
    /// 1000 random impacts or more each (f from 0.05 to 1, slip up to 6 f times the speed of
    /// approach): half of them below, one in ten above, the most seen. Steel ellipsoids upright on a
    /// plane 0.2 %, 1.4 %, 6 %; tilted and spinning ones and crossed cylinders 0.8 %, 4 %, 13 %;
    /// random mobilities with couplings up to 0.6 sqrt(D_ii D_jj), c_x/c_y from 2/3 to 3/2 and f up
    /// to 1.5: 1.7 %, 6 %, 37 %.
    FixedDirection,
}

/// An impact by its matrices: mobility D, stiffness, friction, velocity of approach.
///
/// ```
/// use carom_impact::Mobility;
/// use carom_impact::coupled::{CoupledImpact, VectorLaw};
/// use carom_laws::friction::Friction;
/// use carom_laws::stiffness::ContactStiffness;
/// use nalgebra::{Matrix3, Vector3};
/// let d = Mobility::from_matrix(Matrix3::new(3.0, 0.0, 0.2, 0.0, 2.5, 0.4, 0.2, 0.4, 1.5))?;
/// let stiffness = ContactStiffness::new(0.9, 0.8, 1.1)?;
/// let velocity = Vector3::new(0.3, 0.5, 1.0);
/// let impact = CoupledImpact::new(d, stiffness, Friction::new(0.2)?, velocity)?;
/// let outcome = impact.solve(VectorLaw::Coulomb)?;
/// assert!(outcome.velocity.z < 0.0);
/// assert!(d.energy(&outcome.velocity) < d.energy(&velocity));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledImpact {
    mobility: Mobility,
    stiffness: ContactStiffness,
    friction: Friction,
    velocity: Vector3<f64>,
    normal: NormalImpact,
    tolerance: Option<f64>,
    unsettled: Unsettled,
}

/// What becomes of an impact that does not settle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unsettled {
    Refused,
    Accepted,
}

/// Where an impact leads.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledOutcome {
    /// Velocity of body 2 against body 1 after the impact, contact axes.
    pub velocity: Vector3<f64>,
    /// Duration from touch to separation.
    pub duration: f64,
    /// The greatest approach.
    pub maximal_approach: f64,
    /// The greatest normal force.
    pub maximal_force: f64,
    /// How often the approach grew: 2 or more if the bodies were pressed together again.
    pub compressions: u32,
    /// How it was solved.
    pub passage: Passage,
    /// How far the velocity may be off, over |v_A|: the change under the last refinements; 0 for
    /// exact passages.
    pub error_estimate: f64,
    /// That it did not settle, where [`CoupledImpact::accepting_unsettled`] asked for it all the
    /// same.
    pub warning: Option<Warning>,
}

/// One instant of the impact, contact axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time since touch.
    pub time: f64,
    /// Shift of body 2 against body 1 since touch: xi, eta, zeta.
    pub shift: Vector3<f64>,
    /// Its rate.
    pub velocity: Vector3<f64>,
    /// Force on body 1.
    pub force: Vector3<f64>,
    /// What slips.
    pub stage: Stage,
}

/// Units in which the law's numbers are of order one.
#[derive(Debug, Clone, Copy)]
struct Units {
    time: f64,
    length: f64,
    speed: f64,
    force: f64,
}

impl Units {
    /// Of a law in those of the data.
    const GIVEN: Self = Self { time: 1.0, length: 1.0, speed: 1.0, force: 1.0 };
}

/// From a run to the contact axes and the units of the data.
#[derive(Debug, Clone, Copy)]
struct View {
    units: Units,
    frame: Matrix3<f64>,
}

impl CoupledImpact {
    /// An impact with the velocity of body 2 against body 1 at the contact point, contact axes.
    ///
    /// # Errors
    /// [`RangeError`] unless the velocity is finite and its z component, the speed of approach,
    /// positive.
    pub fn new(
        mobility: Mobility,
        stiffness: ContactStiffness,
        friction: Friction,
        velocity: Vector3<f64>,
    ) -> Result<Self, RangeError> {
        RangeError::finite("velocity", velocity.x)?;
        RangeError::finite("velocity", velocity.y)?;
        let normal = NormalImpact::new(mobility.matrix().m33, stiffness.c_z, velocity.z)?;
        Ok(Self {
            mobility,
            stiffness,
            friction,
            velocity,
            normal,
            tolerance: None,
            unsettled: Unsettled::Refused,
        })
    }

    /// The same impact, settled to another tolerance than the default (1e-8 in a plane, 5e-6 with
    /// either law where the motion is spatial: fifteen of a hundred everyday impacts in space do not
    /// settle to 1e-8): how far its velocity may be off over |v_A|, judged by the change
    /// under the last refinements. The true error is mostly several times smaller, and seldom three
    /// times as large.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite and positive.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The same impact, with the best velocity found where it does not settle to the tolerance, and
    /// [`CoupledOutcome::warning`] that says so, instead of [`CoupledError::NotSettled`].
    #[must_use]
    pub const fn accepting_unsettled(self) -> Self {
        Self { unsettled: Unsettled::Accepted, ..self }
    }

    fn tolerance(&self) -> f64 {
        let spatial = matches!(self.passage(), Passage::Spatial { .. });
        self.tolerance.unwrap_or(if spatial { SPATIAL } else { PLANAR })
    }

    /// How this impact is solved.
    #[must_use]
    pub fn passage(&self) -> Passage {
        if self.friction.get() == 0.0 {
            return Passage::Frictionless;
        }
        match Passage::of(self.mobility.matrix(), &self.stiffness, &self.velocity) {
            // Beyond the range of the exact walk (chi) the memory is stepped.
            Passage::Uncoupled { direction } if self.groups(&direction).is_err() => {
                Passage::Planar { direction }
            }
            passage => passage,
        }
    }

    /// The velocity before the impact.
    #[must_use]
    pub const fn velocity(&self) -> Vector3<f64> {
        self.velocity
    }

    /// Follows the impact to separation; the vector law matters for [`Passage::Spatial`] only.
    ///
    /// The velocity keeps the friction limit of the impulse, |J_t| <= f J_z, and never gains energy,
    /// both to rounding.
    ///
    /// # Errors
    /// [`CoupledError`] if the walk fails or does not settle to the tolerance.
    pub fn solve(&self, law: VectorLaw) -> Result<CoupledOutcome, CoupledError> {
        match self.passage() {
            Passage::Frictionless => Ok(self.frictionless()),
            Passage::Uncoupled { direction } => {
                let oblique = ObliqueImpact::new(self.groups(&direction)?)?;
                Ok(self.exact(self.reversed(&oblique)))
            }
            _ => {
                let settled = self.settled(law)?;
                Ok(self.outcome(&settled))
            }
        }
    }

    /// The same with any contact law, in the units of the data. `make` gives a fresh law; it is
    /// told a resolution that doubles from run to run with the steps, 8, 16, .., for laws of rings; what
    /// such a run costs is counted by [`ImpactLaw::rings`].
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`]; [`CoupledError::Law`] with the law's own error if a step of it
    /// fails.
    pub fn solve_with<L: ImpactLaw>(
        &self,
        make: impl Fn(usize) -> L,
    ) -> Result<CoupledOutcome, CoupledError<L::Error>> {
        let settled = self.settled_with(make)?;
        Ok(self.outcome_in(&settled, &Units::GIVEN))
    }

    /// The same, and the regimes in order as in [`CoupledImpact::solve_with_log`].
    ///
    /// # Errors
    /// As [`CoupledImpact::solve_with`].
    pub fn solve_with_law_and_log<L: ImpactLaw + Staged>(
        &self,
        make: impl Fn(usize) -> L,
    ) -> Result<(CoupledOutcome, Vec<LogEntry>), CoupledError<L::Error>> {
        let settled = self.settled_with(&make)?;
        let mut log = Log::default();
        let view = View { units: Units::GIVEN, frame: Matrix3::identity() };
        self.replay(&settled, make, view, |sample| log.see(&sample, &self.velocity))?;
        Ok((self.outcome_in(&settled, &Units::GIVEN), log.entries))
    }

    /// Every instant of the finest run with any contact law, as [`CoupledImpact::history`].
    ///
    /// # Errors
    /// As [`CoupledImpact::solve_with`].
    pub fn history_with<L: ImpactLaw + Staged>(
        &self,
        make: impl Fn(usize) -> L,
    ) -> Result<Vec<Sample>, CoupledError<L::Error>> {
        let settled = self.settled_with(&make)?;
        let view = View { units: Units::GIVEN, frame: Matrix3::identity() };
        self.samples(&settled, make, view)
    }

    /// The outcome, and the regimes in order with the times at which they began, to within a step
    /// of the finest run. The sign of a regime is that of the traction on body 1 along the
    /// initial slip.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn solve_with_log(
        &self,
        law: VectorLaw,
    ) -> Result<(CoupledOutcome, Vec<LogEntry>), CoupledError> {
        match self.passage() {
            Passage::Frictionless => {
                let regime = Regime::SlideForward;
                let log = vec![LogEntry { time: 0.0, event: Event::Touch, regime }];
                Ok((self.frictionless(), log))
            }
            Passage::Uncoupled { direction } => {
                let oblique = ObliqueImpact::new(self.groups(&direction)?)?;
                let log = crate::collision::log(&self.normal, &oblique);
                Ok((self.exact(self.reversed(&oblique)), log))
            }
            _ => {
                let settled = self.settled(law)?;
                let mut log = Log::default();
                let make = |rings| self.law(law, rings);
                self.replay(&settled, make, self.view(), |sample| {
                    log.see(&sample, &self.velocity)
                })?;
                Ok((self.outcome(&settled), log.entries))
            }
        }
    }

    /// Every instant of the finest run in order, touch and separation included. Between two of
    /// them the law's path is straight. An uncoupled impact gives 201 instants of the exact walk.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn history(&self, law: VectorLaw) -> Result<Vec<Sample>, CoupledError> {
        if let Passage::Uncoupled { direction } = self.passage() {
            return self.traced(&direction);
        }
        let settled = self.settled(law)?;
        self.samples(&settled, |rings| self.law(law, rings), self.view())
    }
}

impl CoupledImpact {
    fn groups(&self, direction: &Vector3<f64>) -> Result<Groups, RangeError> {
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let along = c_x * direction.x * direction.x + c_y * direction.y * direction.y;
        let tangential = direction.dot(&(self.mobility.matrix() * direction));
        let chi = tangential / self.mobility.matrix().m33 * along / c_z;
        let slip = self.tangential().norm();
        let ratio = along / c_z * (slip / self.velocity.z);
        let psi = if slip == 0.0 { 0.0 } else { ratio / self.friction.get() };
        Groups::new(chi, psi)
    }

    fn tangential(&self) -> Vector3<f64> {
        Vector3::new(self.velocity.x, self.velocity.y, 0.0)
    }

    fn reversed(&self, oblique: &ObliqueImpact) -> Vector3<f64> {
        let tangential = self.tangential() * -oblique.restitution();
        Vector3::new(tangential.x, tangential.y, -self.velocity.z)
    }

    fn frictionless(&self) -> CoupledOutcome {
        let d = self.mobility.matrix();
        let impulse = 2.0 * self.velocity.z / d.m33;
        let mut velocity = self.velocity - d.column(2) * impulse;
        velocity.z = -self.velocity.z;
        self.exact(velocity)
    }

    fn exact(&self, velocity: Vector3<f64>) -> CoupledOutcome {
        CoupledOutcome {
            velocity,
            duration: self.normal.duration(),
            maximal_approach: self.normal.maximal_approach(),
            maximal_force: self.normal.maximal_force(),
            compressions: 1,
            passage: self.passage(),
            error_estimate: 0.0,
            warning: None,
        }
    }

    fn settled(&self, law: VectorLaw) -> Result<Settled, CoupledError> {
        let problem = self.problem();
        let apart = self.passage() == Passage::Spatial { coupled: false };
        let limits = Limits::new(&problem.mobility, self.friction, &problem.velocity, apart);
        let make = |rings| self.law(law, rings);
        let settled = problem
            .settle(self.tolerance(), make, |velocity| limits.hold(velocity))
            .map_err(|failure| self.failed(failure))?;
        self.checked(settled)
    }

    // With a law in the units of the data.
    fn settled_with<L: ImpactLaw>(
        &self,
        make: impl Fn(usize) -> L,
    ) -> Result<Settled, CoupledError<L::Error>> {
        let problem = Problem {
            mobility: *self.mobility.matrix(),
            velocity: self.velocity,
            stiffness: self.stiffness,
            expected: self.is_mild().then(|| self.normal.duration()),
        };
        let settled = problem
            .settle(self.tolerance(), make, |velocity| *velocity)
            .map_err(|failure| self.failed(failure))?;
        self.checked(settled)
    }

    // Settled, or accepted as it is.
    fn checked<E: std::error::Error>(&self, settled: Settled) -> Result<Settled, CoupledError<E>> {
        if settled.settled || self.unsettled == Unsettled::Accepted {
            return Ok(settled);
        }
        Err(CoupledError::NotSettled {
            error_estimate: settled.error,
            tolerance: self.tolerance(),
            steps: settled.run.steps,
            rings: settled.run.rings.unwrap_or(0),
        })
    }

    fn replay<L: ImpactLaw + Staged>(
        &self,
        settled: &Settled,
        make: impl Fn(usize) -> L,
        view: View,
        mut observe: impl FnMut(Sample),
    ) -> Result<(), CoupledError<L::Error>> {
        let View { units, frame } = view;
        let see = |point: &Point, law: &L| {
            observe(Sample {
                time: point.time * units.time,
                shift: frame * point.shift * units.length,
                velocity: frame * point.velocity * units.speed,
                force: frame * point.force * units.force,
                stage: law.stage(),
            });
        };
        Problem::replay(settled, make, see).map_err(|failure| self.failed(failure))?;
        Ok(())
    }

    fn samples<L: ImpactLaw + Staged>(
        &self,
        settled: &Settled,
        make: impl Fn(usize) -> L,
        view: View,
    ) -> Result<Vec<Sample>, CoupledError<L::Error>> {
        let mut samples = Vec::new();
        self.replay(settled, make, view, |sample| samples.push(sample))?;
        // At touch and separation no ring bears a load: what slips beside them does there.
        if let [first, second, .., last_but_one, last] = &mut samples[..] {
            (first.stage, last.stage) = (second.stage, last_but_one.stage);
        }
        Ok(samples)
    }

    fn view(&self) -> View {
        View { units: self.units(), frame: self.frame() }
    }

    fn traced(&self, direction: &Vector3<f64>) -> Result<Vec<Sample>, CoupledError> {
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

    fn units(&self) -> Units {
        Units {
            time: self.normal.time_unit(),
            length: self.normal.maximal_approach(),
            speed: self.velocity.z,
            force: self.normal.maximal_force(),
        }
    }

    // Columns: the tangent of a planar motion, the one across it, the normal.
    fn frame(&self) -> Matrix3<f64> {
        match self.passage() {
            Passage::Planar { direction } => {
                Matrix3::from_columns(&[direction, Vector3::z().cross(&direction), Vector3::z()])
            }
            _ => Matrix3::identity(),
        }
    }

    // In units of the uncoupled normal impact: dv/dt = -(5/4) D/D_zz F, F_z = zeta^(3/2).
    fn problem(&self) -> Problem {
        let frame = self.frame();
        let d = self.mobility.matrix();
        let mut mobility = frame.transpose() * (d * (1.25 / d.m33)) * frame;
        if matches!(self.passage(), Passage::Planar { .. }) {
            // What couples across the plane is round-off.
            for (i, j) in [(0, 1), (1, 2)] {
                (mobility[(i, j)], mobility[(j, i)]) = (0.0, 0.0);
            }
        }
        let mut velocity = frame.tr_mul(&(self.velocity / self.velocity.z));
        if matches!(self.passage(), Passage::Planar { .. }) {
            velocity.y = 0.0;
        }
        let stiffness = self.scaled();
        let expected = self.is_mild().then_some(normal::DURATION);
        Problem { mobility, velocity, stiffness, expected }
    }

    // Whether it passes much like a free impact: friction hardly drives the normal motion, and the
    // tangential one takes no less than a third of its time.
    fn is_mild(&self) -> bool {
        let d = self.mobility.matrix();
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let driven = self.friction.get() * libm::hypot(d.m13, d.m23);
        let stiff = (c_x * d.m11).max(c_y * d.m22);
        driven <= 0.5 * d.m33 && stiff <= 10.0 * c_z * d.m33
    }

    // As the problem is; in a plane c_x is that along its tangent.
    fn scaled(&self) -> ContactStiffness {
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let (c_x, c_y) = match self.passage() {
            Passage::Planar { direction: e } => {
                let along = c_x * e.x * e.x + c_y * e.y * e.y;
                (along, along)
            }
            _ => (c_x, c_y),
        };
        let unit = 1.5 / c_z;
        ContactStiffness { c_x: c_x * unit, c_y: c_y * unit, c_z: 1.5 }
    }

    fn law(&self, law: VectorLaw, rings: usize) -> AnyLaw {
        let (stiffness, friction) = (self.scaled(), self.friction);
        match (self.passage(), law) {
            (Passage::Planar { .. }, _) => {
                AnyLaw::Line(Box::new(BareLaw::new(stiffness, friction)))
            }
            (_, VectorLaw::Coulomb) => {
                let n = rings as f64;
                let off = OFF_LINE / (n * n * n);
                // Without a limit every direction is on its own, and without friction none acts.
                SlipLines::new(stiffness, friction.get(), off).map_or_else(
                    |_| AnyLaw::Plane(Box::new(BareLaw::new(stiffness, friction))),
                    |lines| AnyLaw::Lines(Box::new(lines)),
                )
            }
            (_, VectorLaw::FixedDirection) => {
                AnyLaw::Plane(Box::new(BareLaw::new(stiffness, friction)))
            }
        }
    }

    fn outcome(&self, settled: &Settled) -> CoupledOutcome {
        let mut outcome = self.outcome_in(settled, &self.units());
        outcome.velocity = self.frame() * outcome.velocity;
        if outcome.passage == (Passage::Spatial { coupled: false }) {
            // The normal motion is known in closed form.
            outcome.velocity.z = -self.velocity.z;
            outcome.duration = self.normal.duration();
            outcome.maximal_approach = self.normal.maximal_approach();
            outcome.maximal_force = self.normal.maximal_force();
        }
        outcome
    }

    fn outcome_in(&self, settled: &Settled, units: &Units) -> CoupledOutcome {
        let run = &settled.run;
        let peak = run.peak * units.length;
        CoupledOutcome {
            velocity: run.velocity * units.speed,
            duration: run.duration * units.time,
            maximal_approach: peak,
            maximal_force: 2.0 / 3.0 * self.stiffness.c_z * (peak * peak.sqrt()),
            compressions: run.compressions,
            passage: self.passage(),
            error_estimate: settled.error,
            warning: (!settled.settled).then(|| Warning::NotSettled {
                error_estimate: settled.error,
                tolerance: self.tolerance(),
            }),
        }
    }

    fn failed<E: std::error::Error>(&self, failure: Failure<E>) -> CoupledError<E> {
        match failure {
            Failure::NoSeparation => {
                CoupledError::NoSeparation { duration: self.normal.duration() }
            }
            Failure::Law(failure) => CoupledError::Law(failure),
        }
    }
}
