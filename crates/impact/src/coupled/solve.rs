//! Solves an impact: in closed form, exactly, or step by step until it converges.

use nalgebra::Matrix3;

use super::any_law::AnyLaw;
use super::exact::log as log_of;
use super::impact::Unsettled;
use super::limits::Limits;
use super::log::Log;
use super::refine::{Failure, Level, Problem, Settled};
use super::scaled::{Units, View};
use super::{
    CoupledError, CoupledImpact, CoupledOutcome, ImpactLaw, ImpactMethod, Point, Sample, Staged,
    TurningLaw,
};
use crate::normal;
use crate::oblique::{Event, ObliqueImpact, Regime};
use crate::outcome::LogEntry;
use crate::viscoelastic::ViscousLoss;

impl CoupledImpact {
    /// Solves the impact up to separation. `law` matters for [`ImpactMethod::Spatial`] only.
    ///
    /// The result obeys the friction limit of the impulse, |J_t| <= f J_z, and never gains energy,
    /// both to round-off.
    ///
    /// # Errors
    /// [`CoupledError`] if the integration fails or does not converge to the tolerance.
    pub fn solve(&self, law: TurningLaw) -> Result<CoupledOutcome, CoupledError> {
        match (self.method(), &self.loss) {
            (ImpactMethod::Frictionless, None) => Ok(self.frictionless()),
            (ImpactMethod::Frictionless, Some(loss)) => Ok(self.frictionless_with(loss)),
            (ImpactMethod::Uncoupled { direction }, None) => {
                let oblique = ObliqueImpact::new(self.groups(&direction)?)?;
                Ok(self.uncoupled(&oblique, &direction))
            }
            (ImpactMethod::Uncoupled { direction }, Some(loss)) => {
                self.uncoupled_with(loss, &direction)
            }
            (_, None) => Ok(self.outcome(&self.settled(law)?)),
            (_, Some(loss)) => match self.by_viscous_springs(law, loss) {
                Some((outcome, _)) => Ok(outcome),
                None => self.corrected(&self.settled(law)?, law, loss),
            },
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
        let mut log = Log::default();
        if let Some(loss) = &self.loss {
            let (outcome, samples) = self.lossy_with_samples(law, loss)?;
            samples.iter().for_each(|sample| log.see(sample, &self.velocity));
            return Ok((outcome, log.entries));
        }
        match self.method() {
            ImpactMethod::Frictionless => {
                let regime = Regime::SlideForward;
                let log = vec![LogEntry { time: 0.0, event: Event::Touch, regime }];
                Ok((self.frictionless(), log))
            }
            ImpactMethod::Uncoupled { direction } => {
                let oblique = ObliqueImpact::new(self.groups(&direction)?)?;
                Ok((self.uncoupled(&oblique, &direction), log_of(&self.normal, &oblique)))
            }
            _ => {
                let settled = self.settled(law)?;
                self.replayed(&settled, law, |sample| log.see(&sample, &self.velocity))?;
                Ok((self.outcome(&settled), log.entries))
            }
        }
    }

    /// The outcome of an impact with a loss, and its instants.
    fn lossy_with_samples(
        &self,
        law: TurningLaw,
        loss: &ViscousLoss,
    ) -> Result<(CoupledOutcome, Vec<Sample>), CoupledError> {
        if let Some(direction) = self.exact_direction() {
            return Ok((self.solve(law)?, self.exact_samples_with(&direction)?));
        }
        if let Some(both) = self.by_viscous_springs(law, loss) {
            return Ok(both);
        }
        let settled = self.settled(law)?;
        let mut samples = Vec::new();
        self.replayed(&settled, law, |sample| samples.push(sample))?;
        let outcome = match self.method() {
            ImpactMethod::Frictionless => self.frictionless_with(loss),
            _ => self.corrected(&settled, law, loss)?,
        };
        Ok((outcome, with_ends_like_their_neighbours(samples)))
    }

    /// All instants of the finest run in order, including first contact and separation. Between two
    /// instants the path of the law is straight. An exact impact gives 201 instants.
    ///
    /// # Errors
    /// As [`CoupledImpact::solve`].
    pub fn history(&self, law: TurningLaw) -> Result<Vec<Sample>, CoupledError> {
        const COUNT: usize = 200;
        if let Some(loss) = &self.loss {
            return Ok(self.lossy_with_samples(law, loss)?.1);
        }
        if let Some(direction) = self.exact_direction() {
            let step = normal::DURATION / COUNT as f64;
            let times: Vec<f64> = (0..=COUNT).map(|i| step * i as f64).collect();
            let traced = self.traced(&direction, &times)?;
            return Ok(traced.into_iter().map(|instant| instant.sample).collect());
        }
        let settled = self.settled(law)?;
        let mut samples = Vec::new();
        self.replayed(&settled, law, |sample| samples.push(sample))?;
        Ok(with_ends_like_their_neighbours(samples))
    }
}

impl CoupledImpact {
    pub(super) fn settled(&self, law: TurningLaw) -> Result<Settled, CoupledError> {
        let problem = self.problem();
        let is_normal_uncoupled = self.method() == ImpactMethod::Spatial { coupled: false };
        // That of the springs, so that steps find it.
        let e = self.loss.map_or(1.0, |loss| loss.of_springs());
        let normal_impulse = (1.0 + e) * problem.velocity.z / problem.mobility.m33;
        let normal_impulse = is_normal_uncoupled.then_some(normal_impulse);
        let limits =
            Limits::new(&problem.mobility, self.friction, &problem.velocity, normal_impulse);
        let restrict = |impulse: &_| limits.restrict(impulse);
        let make = |level| self.law(law, level);
        let settled = match self.viscosity()? {
            None => problem.settle(self.tolerance(), make, restrict),
            Some(viscosity) => {
                let make = |level| self.viscous_law(make(level), viscosity);
                problem.settle(self.tolerance(), make, restrict)
            }
        };
        self.checked(settled.map_err(|failure| self.failed(failure))?)
    }

    // The finest run of `settled` once more.
    fn replayed(
        &self,
        settled: &Settled,
        law: TurningLaw,
        observe: impl FnMut(Sample),
    ) -> Result<(), CoupledError> {
        let make = |level| self.law(law, level);
        match self.viscosity()? {
            None => self.replay(settled, make, self.view(), observe),
            Some(viscosity) => {
                let make = |level| self.viscous_law(make(level), viscosity);
                self.replay(settled, make, self.view(), observe)
            }
        }
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
        Ok(with_ends_like_their_neighbours(samples))
    }

    fn law(&self, law: TurningLaw, level: Level) -> AnyLaw {
        let (stiffness, friction) = (self.scaled(), self.friction);
        match (self.method(), self.static_friction) {
            (ImpactMethod::Planar { .. }, Some(friction)) => {
                AnyLaw::with_static(stiffness, friction)
            }
            (_, Some(friction)) => AnyLaw::in_space_with_static(law, stiffness, friction, level),
            (ImpactMethod::Planar { .. }, None) => AnyLaw::in_line(stiffness, friction),
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

// At first contact and separation no annulus carries a load; the regime is that of the neighbouring instant.
fn with_ends_like_their_neighbours(mut samples: Vec<Sample>) -> Vec<Sample> {
    if let [first, second, .., last_but_one, last] = &mut samples[..] {
        (first.stage, last.stage) = (second.stage, last_but_one.stage);
    }
    samples
}
