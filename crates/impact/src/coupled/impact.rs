//! Oblique impact with a full mobility matrix.

use carom_laws::friction::Friction;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use super::any_law::AnyLaw;
use super::exact::{length_and_direction, log};
use super::limits::Limits;
use super::log::Log;
use super::refine::{Failure, Level, Problem, Settled};
use super::scaled::{Units, View};
use super::{
    CoupledError, CoupledOutcome, ImpactLaw, ImpactMethod, Point, Sample, Staged, TurningLaw,
};
use crate::mobility::Mobility;
use crate::normal::{self, NormalImpact};
use crate::oblique::{Event, ObliqueImpact, Regime};
use crate::outcome::LogEntry;

/// Default tolerances over |v_A|. In a plane the memory is exact and the runs converge fast; with
/// turning directions they do not. Of a hundred common impacts with fixed directions, fifteen do
/// not converge to 1e-8 after 2^24 steps.
const PLANAR_TOLERANCE: f64 = 1e-8;
const SPATIAL_TOLERANCE: f64 = 5e-6;
/// An impact given by mobility D, stiffness, friction and approach velocity, in contact axes.
///
/// ```
/// use carom_impact::Mobility;
/// use carom_impact::coupled::{CoupledImpact, TurningLaw};
/// use carom_laws::friction::Friction;
/// use carom_laws::stiffness::ContactStiffness;
/// use nalgebra::{Matrix3, Vector3};
/// let d = Mobility::from_matrix(Matrix3::new(3.0, 0.0, 0.2, 0.0, 2.5, 0.4, 0.2, 0.4, 1.5))?;
/// let stiffness = ContactStiffness::new(0.9, 0.8, 1.1)?;
/// let velocity = Vector3::new(0.3, 0.5, 1.0);
/// let impact = CoupledImpact::new(d, stiffness, Friction::new(0.2)?, velocity)?;
/// let outcome = impact.solve(TurningLaw::Coulomb)?;
/// assert!(outcome.velocity.z < 0.0);
/// assert!(d.energy(&outcome.velocity) < d.energy(&velocity));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledImpact {
    pub(super) mobility: Mobility,
    pub(super) stiffness: ContactStiffness,
    pub(super) friction: Friction,
    pub(super) velocity: Vector3<f64>,
    pub(super) normal: NormalImpact,
    pub(super) is_symmetric: bool,
    tolerance: Option<f64>,
    unsettled: Unsettled,
}

/// What to do with an impact that does not converge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unsettled {
    Refused,
    Accepted,
}

impl CoupledImpact {
    /// An impact with this velocity of body 2 against body 1 at the contact point, in contact axes.
    ///
    /// # Errors
    /// [`RangeError`] if the velocity is not finite or its z component, the approach velocity, is
    /// not positive.
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
            is_symmetric: false,
            tolerance: None,
            unsettled: Unsettled::Refused,
        })
    }

    /// The same impact with this tolerance instead of the default: the error of the velocity over
    /// |v_A|.
    ///
    /// Defaults are 1e-8 in a plane and 5e-6 with either law in space, where fifteen of a hundred
    /// common impacts do not converge to 1e-8. The error is estimated by the change in the last
    /// refinements. The true error is mostly several times smaller, and seldom three times as
    /// large.
    ///
    /// # Errors
    /// [`RangeError`] if it is not finite and positive.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The same impact, but if it does not converge, the best velocity and a
    /// [`CoupledOutcome::warning`] instead of [`CoupledError::NotSettled`].
    #[must_use]
    pub const fn accepting_unsettled(self) -> Self {
        Self { unsettled: Unsettled::Accepted, ..self }
    }

    /// The same impact of bodies whose shapes make D and the stiffness isotropic in the tangential
    /// plane and uncouple normal and tangential motion: round-off of both is removed.
    pub(crate) const fn of_symmetric_bodies(self) -> Self {
        Self { is_symmetric: true, ..self }
    }

    pub(super) fn tolerance(&self) -> f64 {
        let spatial = matches!(self.method(), ImpactMethod::Spatial { .. });
        self.tolerance.unwrap_or(if spatial { SPATIAL_TOLERANCE } else { PLANAR_TOLERANCE })
    }

    /// The method by which this impact is solved.
    #[must_use]
    pub fn method(&self) -> ImpactMethod {
        if self.friction.get() == 0.0 {
            return ImpactMethod::Frictionless;
        }
        let method = match self.is_symmetric {
            true => ImpactMethod::Uncoupled { direction: length_and_direction(&self.velocity).1 },
            false => ImpactMethod::of(self.mobility.matrix(), &self.stiffness, &self.velocity),
        };
        match method {
            // chi is outside the range of the exact solution: the memory is integrated in steps.
            ImpactMethod::Uncoupled { direction } if self.groups(&direction).is_err() => {
                ImpactMethod::Planar { direction }
            }
            method => method,
        }
    }

    /// The velocity before the impact.
    #[must_use]
    pub const fn velocity(&self) -> Vector3<f64> {
        self.velocity
    }

    /// Solves the impact up to separation. `law` matters for [`ImpactMethod::Spatial`] only.
    ///
    /// The result obeys the friction limit of the impulse, |J_t| <= f J_z, and never gains energy,
    /// both to round-off.
    ///
    /// # Errors
    /// [`CoupledError`] if the integration fails or does not converge to the tolerance.
    pub fn solve(&self, law: TurningLaw) -> Result<CoupledOutcome, CoupledError> {
        match self.method() {
            ImpactMethod::Frictionless => Ok(self.frictionless()),
            ImpactMethod::Uncoupled { direction } => {
                let oblique = ObliqueImpact::new(self.groups(&direction)?)?;
                Ok(self.uncoupled(&oblique, &direction))
            }
            _ => {
                let settled = self.settled(law)?;
                Ok(self.outcome(&settled))
            }
        }
    }

    /// The same with any contact law, in the units of the data.
    ///
    /// `make` returns a fresh law. Its argument is a resolution that doubles from run to run with
    /// the steps, 8, 16, .., for laws with annuli. [`ImpactLaw::rings`] counts the cost of such a
    /// run.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`]; [`CoupledError::Law`] with the law's own error if a step of it
    /// fails.
    pub fn solve_with<L: ImpactLaw>(
        &self,
        make: impl Fn(usize) -> L,
    ) -> Result<CoupledOutcome, CoupledError<L::Error>> {
        let settled = self.settled_with(|level| make(level.rings))?;
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
        let make = |level: Level| make(level.rings);
        let settled = self.settled_with(make)?;
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
        let make = |level: Level| make(level.rings);
        let settled = self.settled_with(make)?;
        let view = View { units: Units::GIVEN, frame: Matrix3::identity() };
        self.samples(&settled, make, view)
    }

    /// The outcome, and the regimes in order with the times at which they begin, to within a step
    /// of the finest run. The sign of a regime is that of the traction on body 1 along the initial
    /// slip.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn solve_with_log(
        &self,
        law: TurningLaw,
    ) -> Result<(CoupledOutcome, Vec<LogEntry>), CoupledError> {
        match self.method() {
            ImpactMethod::Frictionless => {
                let regime = Regime::SlideForward;
                let log = vec![LogEntry { time: 0.0, event: Event::Touch, regime }];
                Ok((self.frictionless(), log))
            }
            ImpactMethod::Uncoupled { direction } => {
                let oblique = ObliqueImpact::new(self.groups(&direction)?)?;
                let log = log(&self.normal, &oblique);
                Ok((self.uncoupled(&oblique, &direction), log))
            }
            _ => {
                let settled = self.settled(law)?;
                let mut log = Log::default();
                let make = |level| self.law(law, level);
                self.replay(&settled, make, self.view(), |sample| {
                    log.see(&sample, &self.velocity)
                })?;
                Ok((self.outcome(&settled), log.entries))
            }
        }
    }

    /// All instants of the finest run in order, including first contact and separation. Between two
    /// instants the path of the law is straight. An exact impact gives 201 instants.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn history(&self, law: TurningLaw) -> Result<Vec<Sample>, CoupledError> {
        const COUNT: usize = 200;
        if let Some(direction) = self.exact_direction() {
            let step = normal::DURATION / COUNT as f64;
            let times: Vec<f64> = (0..=COUNT).map(|i| step * i as f64).collect();
            let traced = self.traced(&direction, &times)?;
            return Ok(traced.into_iter().map(|instant| instant.sample).collect());
        }
        let settled = self.settled(law)?;
        self.samples(&settled, |level| self.law(law, level), self.view())
    }
}

impl CoupledImpact {
    fn settled(&self, law: TurningLaw) -> Result<Settled, CoupledError> {
        let problem = self.problem();
        let is_normal_uncoupled = self.method() == ImpactMethod::Spatial { coupled: false };
        let limits =
            Limits::new(&problem.mobility, self.friction, &problem.velocity, is_normal_uncoupled);
        let make = |level| self.law(law, level);
        let settled = problem
            .settle(self.tolerance(), make, |impulse| limits.restrict(impulse))
            .map_err(|failure| self.failed(failure))?;
        self.checked(settled)
    }

    // Converged solution with a law in the units of the data.
    fn settled_with<L: ImpactLaw>(
        &self,
        make: impl Fn(Level) -> L,
    ) -> Result<Settled, CoupledError<L::Error>> {
        let problem = Problem {
            mobility: *self.mobility.matrix(),
            velocity: self.velocity,
            stiffness: self.stiffness,
            expected: self.is_mild().then(|| self.normal.duration()),
        };
        let settled = problem
            .settle(self.tolerance(), make, |impulse| *impulse)
            .map_err(|failure| self.failed(failure))?;
        self.checked(settled)
    }

    // The solution if it converged or is accepted without convergence.
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
        make: impl Fn(Level) -> L,
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
        make: impl Fn(Level) -> L,
        view: View,
    ) -> Result<Vec<Sample>, CoupledError<L::Error>> {
        let mut samples = Vec::new();
        self.replay(settled, make, view, |sample| samples.push(sample))?;
        // At first contact and separation no annulus carries a load; the regime is that of the
        // neighbouring instant.
        if let [first, second, .., last_but_one, last] = &mut samples[..] {
            (first.stage, last.stage) = (second.stage, last_but_one.stage);
        }
        Ok(samples)
    }

    fn law(&self, law: TurningLaw, level: Level) -> AnyLaw {
        let (stiffness, friction) = (self.scaled(), self.friction);
        match self.method() {
            ImpactMethod::Planar { .. } => AnyLaw::in_line(stiffness, friction),
            _ => AnyLaw::in_space(law, stiffness, friction, (level, self.is_mild())),
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
