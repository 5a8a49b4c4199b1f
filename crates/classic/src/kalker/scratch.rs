//! The working memory of Kalker's processes, and the beginning and end of their steps.

use carom_special::RangeError;

use super::charts::{KombiStep, ProcessStep};
use super::norm::NormStep;
use super::sets::Sets;
use super::tang::TangStep;
use crate::chart::Trace;
use crate::direct::{Demand, DirectError, End, Influence, Outcome, apart, check_tolerance};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Observer, Products, Progress, Stop,
};

/// Stopping criteria of the loops.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameters {
    pub(super) tolerance: f64,
    /// Greatest number of passes of each loop.
    pub(super) rounds: usize,
    /// Rotation of a direction, in radians, below which the friction law counts as linear.
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

/// The records of the processes in the last step.
#[derive(Debug, Clone, Default)]
pub struct Traces {
    /// Johnson's or Panagiotopoulos's process.
    pub process: Trace<ProcessStep>,
    /// NORM, each time it ran.
    pub norm: Vec<Trace<NormStep>>,
    /// TANG, each time it ran.
    pub tang: Vec<Trace<TangStep>>,
    /// KOMBI.
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
        Self::with_influence(problem, Influence::new(problem.operator())?)
    }

    /// For steady rolling: with the coefficients of u(x) - u(x + columns dx), for a contact that
    /// moves by this number of columns of cells in a step.
    ///
    /// # Errors
    /// [`DirectError`] for a problem that these processes cannot solve.
    pub fn rolling(problem: &ContactProblem, columns: f64) -> Result<Self, DirectError> {
        Self::with_influence(problem, Influence::rolled(problem.operator(), columns)?)
    }

    fn with_influence(problem: &ContactProblem, influence: Influence) -> Result<Self, DirectError> {
        Demand::check(problem)?;
        let outcome = Outcome::new(problem.grid().cells());
        Ok(Self { influence, demand: None, outcome, traces: Traces::default() })
    }

    /// The records of the processes in the last step.
    #[must_use]
    pub const fn traces(&self) -> &Traces {
        &self.traces
    }

    /// Starts from the last areas. A step that leaves the bodies separated ends here.
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

    /// The data of the present step.
    pub(super) fn work(&mut self) -> Result<(Sets<'_>, &mut Traces), DirectError> {
        let Self { influence, demand, outcome, traces } = self;
        let none = RangeError::new("step", f64::NAN, "a step that was begun");
        let demand = demand.as_ref().ok_or(none)?;
        Ok((Sets { influence, demand, outcome, solved: 0 }, traces))
    }

    /// The convergence of the step, with all displacements computed anew.
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
