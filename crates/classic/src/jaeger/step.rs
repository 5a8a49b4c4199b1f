//! A step of the Gauss-Seidel program of the thesis.

use super::chart::{PROGRAM, ProgramStep};
use super::directions::Directions;
use super::gauss_seidel::GaussSeidel;
use super::program::Program;
use crate::chart::{self, Trace};
use crate::direct::{Demand, DirectError, End, Influence, Outcome, apart};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Method, Observer, Products, Residuals, Stop,
};

/// The working memory of [`GaussSeidel`].
#[derive(Clone)]
pub struct GaussSeidelScratch {
    influence: Influence,
    outcome: Outcome,
    directions: Directions,
    trace: Trace<ProgramStep>,
}

impl GaussSeidelScratch {
    /// The record of the program in the last step.
    #[must_use]
    pub const fn trace(&self) -> &Trace<ProgramStep> {
        &self.trace
    }
}

impl Method for GaussSeidel {
    type Error = DirectError;
    type Scratch = GaussSeidelScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<GaussSeidelScratch, DirectError> {
        Demand::check(problem)?;
        let cells = problem.grid().cells();
        Ok(GaussSeidelScratch {
            influence: Influence::new(problem.operator())?,
            outcome: Outcome::new(cells),
            directions: Directions::new(cells),
            trace: Trace::default(),
        })
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut GaussSeidelScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, DirectError> {
        let GaussSeidelScratch { influence, outcome, directions, trace } = scratch;
        let demand = Demand::new(problem, influence.own(), from, drive)?;
        trace.clear();
        if let Some(convergence) = apart(problem, drive, from, to) {
            return Ok(convergence);
        }
        outcome.start(from);
        if outcome.touching().next().is_none() {
            outcome.touch_where(|cell| demand.target[2][cell] > 0.0);
        }
        directions.start(|cell| outcome.direction(cell));
        let mut program = Program {
            method: self,
            influence,
            demand: &demand,
            outcome,
            directions,
            observer,
            sweeps: 0,
            residuals: Residuals::default(),
            stopped: false,
            amount: 0.0,
            moved: 0.0,
        };
        chart::run(&mut program, PROGRAM, trace)?;
        let (iterations, residuals) = (program.sweeps, program.residuals);
        let stop = if program.stopped { Stop::Observer } else { Stop::Exhausted };
        let reached = Convergence { iterations, products: Products::default(), residuals, stop };
        outcome.end(End { tolerance: self.tolerance(), reached, from, drive }, to)
    }
}
