//! Computes the steps of a case in turn.

use super::bodies::Bodies;
use super::classic::{Chosen, ChosenError};
use crate::case::{Border, GridCase, Leg, SolveCase, SolveMethod, Target};
use crate::theory::ValidityReport;
use crate::{Error, ErrorKind};
use carom_halfspace::operator::OperatorError;
use carom_halfspace::{Grid, room};
use carom_laws::law::{ContactLoad, Shift};
use carom_laws::validity::PressureLimits;
use carom_solver::{
    Accuracy, CellState, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalError,
    Frictionless, GridWarning, NestedError, NestedHistory, ProblemError, StepSummary, Window,
};
use carom_special::RangeError;

/// The result of a run.
#[derive(Debug)]
pub struct Followed {
    /// One row for each step.
    pub steps: Vec<StepSummary>,
    /// The contact after the last step.
    pub state: ContactState,
    /// The window and its cells.
    pub window: Window,
    /// The first step in which a displacement is too large for the theory, and how large it is.
    pub too_large: Option<(usize, GridWarning)>,
    /// What the bodies bear.
    pub limits: PressureLimits,
    /// Number of steps that an earlier run had computed.
    pub found: usize,
    /// What is told about the heights of a file.
    pub told: Vec<String>,
}

impl Followed {
    /// Where the pressures exceed what the bodies bear.
    #[must_use]
    pub fn validity_report(&self) -> ValidityReport {
        let mut report = ValidityReport::default();
        for step in &self.steps {
            let validity = self.limits.validity(step.greatest_pressure);
            report.add(|| format!("at step {}", step.step), validity);
        }
        report
    }

    /// The warning on a displacement that is too large.
    #[must_use]
    pub fn large(&self) -> Option<String> {
        self.too_large.map(|(step, warning)| format!("step {step}: {warning}"))
    }
}

/// Steps of an earlier run, and the state after the last one.
#[derive(Debug, Default)]
pub struct Found {
    /// One row for each step.
    pub steps: Vec<StepSummary>,
    /// The saved state; none before the first step.
    pub saved: Option<Saved>,
}

/// A state, and those on up to two coarser grids.
#[derive(Debug)]
pub struct Saved {
    /// The state on the grid itself.
    pub state: ContactState,
    /// The states on coarser grids.
    pub coarse: [Option<ContactState>; 2],
}

/// A contact on its grid, before its steps.
#[allow(missing_debug_implementations)] // memory of any method
pub struct Run<'a> {
    case: &'a SolveCase,
    window: Window,
    method: Frictional,
    history: NestedHistory<Chosen>,
    told: Vec<String>,
}

impl<'a> Run<'a> {
    /// Sets up the grid of the case, or chooses one for its accuracy.
    ///
    /// # Errors
    /// [`Error`] if the grid is too large for the memory, a value is out of range, or no grid fits.
    pub fn new(case: &'a SolveCase, bodies: &Bodies) -> Result<Self, Error> {
        let method = Frictional::default();
        let method = match case.tolerance {
            Some(tolerance) => method.within(tolerance)?,
            None => method,
        };
        let chosen = Chosen {
            main: method,
            plate: case.plate.map(|_| frictionless(case.tolerance)).transpose()?,
            method: case.method,
            tolerance: case.tolerance,
        };
        let window = match (bodies.grid(), case.grid) {
            (Some(grid), _) => Window::about([0.0; 2], grid)?,
            (None, GridCase::Cells { .. } | GridCase::OfFile { .. }) => {
                return Err(Error::input("no grid is given"));
            }
            (None, GridCase::Accuracy(accuracy)) => {
                let (drives, sides) = (ends(&case.legs), bodies.sides());
                let make = |window: &Window| bodies.problem(window);
                let accuracy = Accuracy::new(accuracy)?;
                let fit = match case.plate {
                    Some(_) => accuracy.fit_cells(chosen, make, sides, &drives),
                    None => {
                        let main = Chosen { method: SolveMethod::Newton, ..chosen };
                        accuracy.fit(main, make, sides, &drives)
                    }
                };
                fit?.window
            }
        };
        let make = |grid| bodies.problem(&window.with(grid));
        check_room(window.grid()).map_err(ProblemError::from)?;
        let history = NestedHistory::new(chosen, window.grid(), make);
        let history = history.map_err(|error| match error {
            NestedError::Problem(source) => source.into(),
            NestedError::Method(source) => Error::from(source).at("step", 0),
        })?;
        Ok(Self { case, window, method, history, told: bodies.warnings().to_vec() })
    }

    /// The contact problem.
    #[must_use]
    pub const fn problem(&self) -> &ContactProblem {
        self.history.problem()
    }

    /// The window.
    #[must_use]
    pub const fn window(&self) -> &Window {
        &self.window
    }

    /// The main method.
    #[must_use]
    pub const fn method(&self) -> Frictional {
        self.method
    }

    /// The number of steps.
    #[must_use]
    pub fn count(&self) -> usize {
        self.case.legs.iter().map(|leg| leg.count).sum()
    }

    /// Computes the steps after those found. After each step `done` receives all steps and the present state.
    ///
    /// # Errors
    /// [`ErrorKind::Step`], [`ErrorKind::Border`], or the error of `done`.
    pub fn follow<E: From<Error>>(
        mut self,
        found: Found,
        mut done: impl FnMut(&[StepSummary], &NestedHistory<Chosen>, &Window) -> Result<(), E>,
    ) -> Result<Followed, E> {
        let Found { mut steps, saved } = found;
        if let Some(Saved { state, coarse }) = saved {
            self.history.restore(state, coarse).map_err(Error::from)?;
        }
        let count = steps.len();
        let (mut first, mut held) = (0, HELD);
        let mut too_large = self.too_large(count)?;
        for leg in &self.case.legs {
            for number in first + 1..=first + leg.count {
                let begin = if first == 0 { StepSummary::default() } else { steps[first - 1] };
                let drive = drive(leg, number - first, &begin, held);
                if number > count {
                    let step = self.step(number, &drive, steps.last())?;
                    steps.push(step);
                    if too_large.is_none() {
                        too_large = self.too_large(number)?;
                    }
                    done(&steps, &self.history, &self.window)?;
                }
            }
            first += leg.count;
            held = kept(leg, held);
        }
        let state = self.history.state().clone();
        let limits = self.case.pressure_limits();
        let (window, told) = (self.window, self.told);
        Ok(Followed { steps, state, window, too_large, limits, found: count, told })
    }

    fn step(
        &mut self,
        number: usize,
        drive: &Drive,
        last: Option<&StepSummary>,
    ) -> Result<StepSummary, Error> {
        let before = self.history.state().clone();
        let went = self
            .history
            .step(drive, &mut ())
            .map_err(|error| Error::from(error).at("step", number))?;
        let state = self.history.state();
        if let Some(side) = border(state).filter(|_| self.is_free()) {
            return Err(Error::from(ErrorKind::Border(side)).at("step", number));
        }
        let estimates = self.history.estimates();
        let begin = last.copied().unwrap_or_default();
        let step = begin.next(self.problem(), [&before, state], &went).map_err(|error| {
            Error::from(ChosenError::from(FrictionalError::from(error))).at("step", number)
        })?;
        Ok(step.with_middle_at(self.window.middle()).with_estimates(estimates.as_ref()))
    }

    /// The warning of a displacement beyond the theory of the operator in this step, the present one.
    fn too_large(&self, step: usize) -> Result<Option<(usize, GridWarning)>, Error> {
        let warnings = self.problem().warnings(self.history.state());
        let warnings = warnings.map_err(ProblemError::from)?;
        let large =
            |warning: &GridWarning| matches!(warning, GridWarning::LargeDisplacement { .. });
        Ok(warnings.into_iter().find(large).map(|warning| (step, warning)))
    }

    /// Whether the contact must not reach the border.
    fn is_free(&self) -> bool {
        self.case.grid.border() == Border::Free
    }
}

/// Least memory of a run, in bytes per cell: the operator, and the fields on all grids. Measured as resident
/// memory with 512 x 512 to 2048 x 2048 cells: from 480 without friction to 1140 if dissimilar bodies touch
/// everywhere.
const LEAST_BYTES: u128 = 450;

/// Checks that the least memory of a run on this grid is available.
fn check_room(grid: Grid) -> Result<(), OperatorError> {
    let (needed, available) = (LEAST_BYTES * grid.cells() as u128, room::available());
    match needed > available {
        true => Err(OperatorError::TooLarge { needed, available }),
        false => Ok(()),
    }
}

/// The method without friction.
fn frictionless(tolerance: Option<f64>) -> Result<Frictionless, RangeError> {
    let method = Frictionless::default();
    tolerance.map_or(Ok(method), |tolerance| method.within(tolerance))
}

/// The drives before the first leg.
const HELD: [Driven; 4] = [Driven::Shift(0.0); 4];

/// The drives at the end of each leg.
fn ends(legs: &[Leg]) -> Vec<Drive> {
    let mut held = HELD;
    let end = |leg| {
        held = kept(leg, held);
        let [normal, x, y, twist] = held;
        Drive { normal, x, y, twist }
    };
    legs.iter().map(end).collect()
}

/// The drive of one step of a leg that began at `begin`.
fn drive(leg: &Leg, number: usize, begin: &StepSummary, held: [Driven; 4]) -> Drive {
    let part = number as f64 / leg.count as f64;
    let mix = |from: f64, to: f64| if number == leg.count { to } else { from + part * (to - from) };
    let Shift { zeta, xi, eta, omega } = begin.shift;
    let ContactLoad { f_x, f_y, f_z, m_z } = begin.load;
    let at = |i: usize, shift: f64, load: f64| match leg.targets[i] {
        Target::Kept => held[i],
        Target::Shift(to) => Driven::Shift(mix(shift, to)),
        Target::Load(to) => Driven::Load(mix(load, to)),
    };
    Drive {
        normal: at(0, zeta, f_z),
        x: at(1, xi, f_x),
        y: at(2, eta, f_y),
        twist: at(3, omega, m_z),
    }
}

/// The drives that stay in force unless a leg changes them.
fn kept(leg: &Leg, held: [Driven; 4]) -> [Driven; 4] {
    std::array::from_fn(|i| match leg.targets[i] {
        Target::Kept => held[i],
        Target::Shift(to) => Driven::Shift(to),
        Target::Load(to) => Driven::Load(to),
    })
}

/// The border that the contact reaches, if any.
#[must_use]
pub fn border(state: &ContactState) -> Option<&'static str> {
    let grid = state.cells.grid();
    let touches = |i: usize, j: usize| state.cells.get(i, j) != Some(&CellState::Exterior);
    let (right, upper) = (grid.nx() - 1, grid.ny() - 1);
    let (mut rows, mut columns) = (0..grid.ny(), 0..grid.nx());
    match () {
        () if rows.clone().any(|j| touches(0, j)) => Some("left"),
        () if rows.any(|j| touches(right, j)) => Some("right"),
        () if columns.clone().any(|i| touches(i, 0)) => Some("lower"),
        () if columns.any(|i| touches(i, upper)) => Some("upper"),
        () => None,
    }
}
