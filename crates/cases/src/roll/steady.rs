//! Steady rolling: a row for each drive.

use super::creep::{self, Creep};
use super::{Progress, Rolled, Rolling, Row, too_large};
use crate::Error;
use crate::case::GridCase;
use carom_halfspace::Grid;
use carom_halfspace::operator::OperatorError;
use carom_rolling::{Creepage, SteadyMethod};
use carom_solver::{
    Accuracy, ContactProblem, ContactState, NestedError, NestedHistory, ProblemError, Window,
};

/// Cells of the finest grid that an accuracy may choose. The error falls with the width of a cell.
const MOST_CELLS: usize = 512 * 512;

impl Rolling<'_> {
    /// A row for each drive, and the state of the last one.
    pub(super) fn steadily(
        &self,
        springs: Option<&Creep>,
        observer: &mut dyn FnMut(Progress),
    ) -> Result<Rolled, Error> {
        let drives = &self.case.drives;
        observer(Progress::Begun(drives.len()));
        let window = self.window()?;
        let mut history = self.history(&window)?;
        let (mut rows, mut large) = (Vec::with_capacity(drives.len()), None);
        for (drive, number) in drives.iter().zip(1..) {
            let convergence = history
                .step(&(*drive).into(), &mut ())
                .map_err(|source| self.failed(number, source))?;
            let state = history.state();
            self.check_border(number, state)?;
            let creepage = creepage(state);
            let mut row = Row::of(history.problem(), state, convergence, self.case.speed, creepage)
                .about(window.middle());
            row.estimates = history.estimates();
            row.heat = Some(history.scratch().heat());
            if let Some(creep) = springs {
                let forces = creep::springs(self.path, self.case, creep.coefficients, creepage)?;
                row.springs = Some(forces);
            }
            rows.push(row);
            if large.is_none() {
                let warnings = self.warnings(history.problem(), state)?;
                large = too_large(warnings).map(|warning| (number, warning));
            }
            observer(Progress::Row);
        }
        let state = history.state().clone();
        Ok(Rolled { rows, state, window, too_large: large, creep: None })
    }

    /// The window of the case, or one chosen for its accuracy.
    pub(super) fn window(&self) -> Result<Window, Error> {
        let range = |source| self.range(source);
        match self.case.grid {
            GridCase::Cells { grid, .. } => Window::about([0.0; 2], grid).map_err(range),
            GridCase::Accuracy(accuracy) => {
                let drives: Vec<_> = self.case.drives.iter().map(|drive| (*drive).into()).collect();
                let make = |window: &Window| self.bodies.problem(window);
                let fit = Accuracy::new(accuracy).map_err(range)?.at_most(MOST_CELLS).fit(
                    self.case.method,
                    make,
                    self.bodies.sides(),
                    &drives,
                );
                let path = || self.path.to_owned();
                Ok(fit
                    .map_err(|source| Error::RollingFit { path: path(), source: source.into() })?
                    .window)
            }
        }
    }

    /// The problem on a window and on two coarser grids.
    fn history(&self, window: &Window) -> Result<NestedHistory<SteadyMethod>, Error> {
        let make = |grid: Grid| {
            let grid = of_one_line(window.grid(), grid).map_err(OperatorError::from)?;
            self.bodies.problem(&window.with(grid))
        };
        NestedHistory::new(self.case.method, window.grid(), make).map_err(|error| match error {
            NestedError::Problem(source) => self.problem_error(source),
            NestedError::Method(source) => self.failed(1, source),
        })
    }

    pub(super) fn problem_error(&self, source: ProblemError) -> Error {
        Error::Problem { path: self.path.to_owned(), source: source.into() }
    }

    fn warnings(
        &self,
        problem: &ContactProblem,
        state: &ContactState,
    ) -> Result<Vec<carom_solver::GridWarning>, Error> {
        problem.warnings(state).map_err(|source| self.problem_error(source.into()))
    }
}

/// A coarser grid; a line of cells keeps its width.
fn of_one_line(own: Grid, coarser: Grid) -> Result<Grid, carom_special::RangeError> {
    let keep = |count: usize, width: f64, own: f64| if count == 1 { own } else { width };
    let dx = keep(own.nx(), coarser.dx(), own.dx());
    let dy = keep(own.ny(), coarser.dy(), own.dy());
    Grid::new(coarser.nx(), coarser.ny(), dx, dy)
}

/// The creepages of a steady state, which takes them for its shifts.
const fn creepage(state: &ContactState) -> Creepage {
    let shift = state.shift;
    Creepage { along: shift.xi, across: shift.eta, spin: shift.omega }
}
