//! The rows of a contact that rolls on a given grid.

use super::{Progress, Row};
use carom_halfspace::Grid;
use carom_halfspace::operator::OperatorError;
use carom_laws::law::Shift;
use carom_rolling::{Creepage, RollingContact, RollingDrive, RollingError, SteadyMethod};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Frictional, GridWarning, Method as _,
    NestedError, NestedHistory, ProblemError,
};
use carom_special::RangeError;

/// The greatest number of steps from rest.
const MOST_STEPS: f64 = 1e5;

/// How a contact rolls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// The grid.
    pub grid: Grid,
    /// Direction of rolling, length of a step, place of the spin and tolerance.
    pub method: SteadyMethod,
    /// Rolling speed, m/s.
    pub speed: f64,
    /// Whether the bodies end at the border of the grid, so that the contact may reach it.
    pub cut: bool,
}

/// Rows, the last contact, and the first row in which a displacement is too large for the theory.
#[derive(Debug, Clone)]
pub struct Rows {
    /// A row for each drive, or from rest for each step.
    pub rows: Vec<Row>,
    /// The last contact.
    pub state: ContactState,
    /// The row, from 1, and how large the displacement is.
    pub too_large: Option<(usize, GridWarning)>,
}

/// Why a row could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The contact problem could not be set up.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// A row failed.
    #[error("row {row}: {source}")]
    Row {
        /// Its number, from 1.
        row: usize,
        /// Why.
        source: Box<RollingError>,
    },
    /// The contact reaches the border of the grid.
    #[error("row {row}: the contact reaches the {side} border of the grid")]
    Border {
        /// The number of the row, from 1.
        row: usize,
        /// The border.
        side: &'static str,
    },
}

fn failed<E: Into<RollingError>>(row: usize) -> impl FnOnce(E) -> RunError {
    move |source| RunError::Row { row, source: Box::new(source.into()) }
}

impl Run {
    /// Steady rolling, a row for each drive, with errors estimated on two coarser grids. `make` builds the
    /// problem on a grid with the same middle.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn steadily(
        &self,
        make: impl Fn(Grid) -> Result<ContactProblem, ProblemError>,
        drives: &[RollingDrive],
        observer: &mut dyn FnMut(Progress),
    ) -> Result<Rows, RunError> {
        let make = |grid: Grid| {
            let grid = of_one_line(self.grid, grid).map_err(OperatorError::from);
            make(grid.map_err(ProblemError::from)?)
        };
        let history = NestedHistory::new(self.method, self.grid, make);
        let mut history = history.map_err(|error| match error {
            NestedError::Problem(source) => source.into(),
            NestedError::Method(source) => failed(1)(source),
        })?;
        let (mut rows, mut too_large) = (Vec::with_capacity(drives.len()), None);
        for (drive, number) in drives.iter().zip(1..) {
            let convergence = history.step(&(*drive).into(), &mut ()).map_err(failed(number))?;
            let (problem, state) = (history.problem(), history.state());
            self.check_border(number, state)?;
            rows.push(Row {
                estimates: history.estimates(),
                heat: Some(history.scratch().heat()),
                ..Row::of(problem, state, convergence, self.speed, creepage(state))
            });
            if too_large.is_none() {
                too_large = large(problem, state)?.map(|warning| (number, warning));
            }
            observer(Progress::Row);
        }
        Ok(Rows { rows, state: history.state().clone(), too_large })
    }

    /// The number of steps of a distance.
    ///
    /// # Errors
    /// [`RangeError`] unless the distance is positive and has at most 100 000 steps.
    pub fn steps(&self, distance: f64) -> Result<usize, RangeError> {
        RangeError::positive("distance", distance)?;
        let length = self.method.way(self.grid)?.length();
        let few = distance / length <= MOST_STEPS;
        RangeError::check("distance", distance, few, "at most 100000 steps")?;
        // A whole number of steps, up to round-off.
        Ok((distance / length * (1.0 - 1e-9)).ceil() as usize)
    }

    /// Rolling from rest over a distance: a row at rest, and one for each step.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn from_rest(
        &self,
        problem: &ContactProblem,
        drive: &RollingDrive,
        distance: f64,
        observer: &mut dyn FnMut(Progress),
    ) -> Result<Rows, RunError> {
        let (way, count) = (self.method.way(self.grid)?, self.steps(distance)?);
        let (mut method, mut contact) =
            (Frictional::default(), RollingContact::new(problem, way).map_err(failed(1))?);
        if let Some(tolerance) = self.method.tolerance() {
            method = method.within(tolerance)?;
            contact = contact.within(tolerance).map_err(failed(1))?;
        }
        let apart = ContactState::apart(problem.grid());
        let mut state = apart.clone();
        let pressed = Drive { normal: drive.normal, ..Drive::default() };
        let mut scratch = method.scratch(problem).map_err(failed(1))?;
        let convergence = method
            .step(problem, &apart, &pressed, &mut state, &mut scratch, &mut ())
            .map_err(failed(1))?;
        let row = |state: &ContactState, convergence: Convergence, creepage, steps: usize| Row {
            distance: Some(steps as f64 * way.length()),
            ..Row::of(problem, state, convergence, self.speed, creepage)
        };
        self.check_border(1, &state)?;
        let mut rows = vec![row(&state, convergence, drive.creepage(), 0)];
        observer(Progress::Row);
        for steps in 1..=count {
            let before = state.clone();
            let convergence =
                contact.step(drive, &before, &mut state, &mut ()).map_err(failed(steps + 1))?;
            self.check_border(steps + 1, &state)?;
            let creepage = way.creepage(between(before.shift, state.shift));
            rows.push(row(&state, convergence, creepage, steps));
            observer(Progress::Row);
        }
        let too_large = large(problem, &state)?.map(|warning| (rows.len(), warning));
        Ok(Rows { rows, state, too_large })
    }

    /// Checks that a contact between bodies without an end does not reach the border of the grid.
    fn check_border(&self, row: usize, state: &ContactState) -> Result<(), RunError> {
        let side = if self.cut { None } else { crate::solve::border(state) };
        side.map_or(Ok(()), |side| Err(RunError::Border { row, side }))
    }
}

/// A coarser grid than `own`; a single line of cells keeps its width.
pub(crate) fn of_one_line(own: Grid, coarser: Grid) -> Result<Grid, RangeError> {
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

/// The shift from one state to the next.
fn between(before: Shift, after: Shift) -> Shift {
    Shift {
        zeta: after.zeta - before.zeta,
        xi: after.xi - before.xi,
        eta: after.eta - before.eta,
        omega: after.omega - before.omega,
    }
}

/// The warning of a displacement beyond the theory.
fn large(
    problem: &ContactProblem,
    state: &ContactState,
) -> Result<Option<GridWarning>, ProblemError> {
    let is_large = |warning: &GridWarning| matches!(warning, GridWarning::LargeDisplacement { .. });
    Ok(problem.warnings(state).map_err(ProblemError::from)?.into_iter().find(is_large))
}
