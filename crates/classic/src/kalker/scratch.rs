//! The working memory of Kalker's processes, and how their steps begin and end.

use carom_special::RangeError;

use super::kombi::KombiStep;
use super::norm::NormStep;
use super::process::ProcessStep;
use super::sets::Sets;
use super::tang::TangStep;
use crate::chart::Trace;
use crate::direct::{Demand, DirectError, End, Influence, Outcome, apart, check_tolerance};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Observer, Products, Progress, Stop,
};

/// When loops end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameters {
    pub(super) tolerance: f64,
    /// The most rounds of each loop.
    pub(super) rounds: usize,
    /// The turn of a direction, in radians, below which the friction law counts as linear.
    pub(super) turn: f64,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { tolerance: 1e-10, rounds: 40, turn: 1e-11 }
    }
}

impl Parameters {
    pub(super) fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        check_tolerance(tolerance)?;
        Ok(Self { tolerance, turn: 0.1 * tolerance, ..self })
    }
}

/// What the processes did in the last step.
#[derive(Debug, Clone, Default)]
pub struct Traces {
    /// Of Johnson's or Panagiotopoulos's process.
    pub process: Trace<ProcessStep>,
    /// Of NORM, each time it ran.
    pub norm: Vec<Trace<NormStep>>,
    /// Of TANG, each time it ran.
    pub tang: Vec<Trace<TangStep>>,
    /// Of KOMBI.
    pub kombi: Trace<KombiStep>,
}

/// The working memory of Kalker's processes.
#[derive(Clone)]
pub struct KalkerScratch {
    influence: Influence,
    demand: Option<Demand>,
    pub(super) outcome: Outcome,
    pub(super) traces: Traces,
}

impl KalkerScratch {
    pub(super) fn new(problem: &ContactProblem) -> Result<Self, DirectError> {
        Self::with_influence(problem, Influence::new(problem.operator()))
    }

    /// For steady rolling: with the coefficients of u(x) - u(x + columns dx), of a contact that moves by so
    /// many columns of cells a step.
    ///
    /// # Errors
    /// [`DirectError`] for a problem that these processes do not solve.
    pub fn rolling(problem: &ContactProblem, columns: f64) -> Result<Self, DirectError> {
        Self::with_influence(problem, Influence::rolled(problem.operator(), columns))
    }

    fn with_influence(problem: &ContactProblem, influence: Influence) -> Result<Self, DirectError> {
        Demand::check(problem)?;
        let outcome = Outcome::new(problem.grid().cells());
        Ok(Self { influence, demand: None, outcome, traces: Traces::default() })
    }

    /// What the processes did in the last step.
    #[must_use]
    pub const fn traces(&self) -> &Traces {
        &self.traces
    }

    /// Starts from the last areas; a step that leaves the bodies apart ends here.
    pub(super) fn begin(
        &mut self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
    ) -> Result<Option<Convergence>, DirectError> {
        let demand = Demand::new(problem, self.influence.own(), from, drive)?;
        self.traces = Traces::default();
        if let Some(convergence) = apart(problem, drive, from, to) {
            return Ok(Some(convergence));
        }
        self.outcome.start(from);
        if self.outcome.touching().next().is_none() {
            self.outcome.touch_where(|cell| demand.target[2][cell] > 0.0);
        }
        self.demand = Some(demand);
        Ok(None)
    }

    /// The step at work.
    pub(super) fn work(&mut self) -> Result<(Sets<'_>, &mut Traces), DirectError> {
        let Self { influence, demand, outcome, traces } = self;
        let none = RangeError::new("step", f64::NAN, "one that has begun");
        let demand = demand.as_ref().ok_or(none)?;
        Ok((Sets { influence, demand, outcome, solved: 0 }, traces))
    }

    /// How far the step got, all displacements found anew.
    pub(super) fn reached(
        &mut self,
        solved: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, DirectError> {
        let (mut sets, _) = self.work()?;
        sets.displace();
        let residuals = sets.demand.residuals(&sets.outcome.traction, &sets.outcome.displacement);
        let touching = sets.outcome.touching().count();
        let cells = sets.outcome.cells.len();
        let progress = Progress { iteration: solved, cells, touching, residuals };
        let stopped = observer.see(&progress).is_break();
        let stop = if stopped { Stop::Observer } else { Stop::Exhausted };
        Ok(Convergence { iterations: solved, products: Products::default(), residuals, stop })
    }

    /// Writes the state at the end of the step, if it has converged.
    pub(super) fn end(
        &self,
        end: End<'_>,
        to: &mut ContactState,
    ) -> Result<Convergence, DirectError> {
        self.outcome.end(end, to)
    }
}
