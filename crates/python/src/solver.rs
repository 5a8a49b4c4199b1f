//! The numerical contact solver: gaps and drives in, fields out.

use carom::halfspace::operator::{OperatorError, PlateOperator, Threads};
use carom::halfspace::{Field, Point};
use carom::laws::law::Shift;
use carom::laws::validity::{Limit, PressureLimits};
use carom::prelude::{
    CellState, ContactProblem, ContactState, Drive, Driven, Friction, Frictional, Gap, Grid,
};
use carom::solver::{
    CellFriction, Frictionless, GridWarning, NestedError, NestedHistory, ProblemError, StepSummary,
    Subsurface, SurfaceFriction, gap_left,
};
use carom::special::RangeError;
use carom_cases::case::Border;
use carom_cases::solve::{Chosen, border, few_cells};
use numpy::{PyArray1, PyArray2, PyArrayMethods as _, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

use crate::arrays::{Numbers, map_by, same_length};
use crate::cases::{cells, fields, lines};
use crate::error::Fault;
use crate::influence;
use crate::materials::Pair;
use crate::plate::Plate;
use crate::records::arrays;
use crate::threads::{beside, without_python};
use crate::told::warn;

/// What drives one motion: true if its load is given, false if its shift is; and the value.
type Given = (bool, f64);

/// A state: its shift (zeta, xi, eta, omega), its fields and its cells, flat.
type Kept<'py> = ([f64; 4], [Bound<'py, PyArray1<f64>>; 5], Bound<'py, PyArray1<i8>>);

/// The same as it is read.
type Read<'py> = ([f64; 4], [Numbers<'py>; 5], PyReadonlyArray1<'py, i8>);

/// Two bodies on a grid, with the state after the last step.
#[pyclass(module = "carom")]
pub(crate) struct Solver {
    history: NestedHistory<Chosen>,
    /// What lies beyond the border of the window.
    border: Border,
    limits: PressureLimits,
    last: StepSummary,
    given: [Given; 4],
    /// What has been told of earlier steps.
    told: Vec<Doubt>,
}

/// A reason to distrust a step, which is told once.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Doubt {
    Few,
    Large,
    Exceeds(Limit),
}

#[pymethods]
impl Solver {
    #[new]
    #[allow(clippy::too_many_arguments)] // named ones, in Python
    fn new(
        py: Python<'_>,
        cells: [usize; 2],
        cell: [f64; 2],
        heights: Numbers<'_>,
        materials: Pair,
        friction: Numbers<'_>,
        tolerance: f64,
        ends: [bool; 2],
        plate: Option<Plate>,
        influence: influence::Given<'_>,
        estimates: bool,
    ) -> PyResult<Self> {
        let [cut, periodic] = ends;
        // The caller gave the size of the window.
        let sized = |error: RangeError| match ["dx", "dy"].iter().position(|d| *d == error.field) {
            Some(along) => {
                RangeError::new("size", error.value * cells[along] as f64, error.allowed)
            }
            None => error,
        };
        let grid = Grid::new(cells[0], cells[1], cell[0], cell[1]);
        let grid = grid.map_err(|error| Fault::from(sized(error)))?;
        let heights = Field::new(grid, heights.as_slice()?.to_vec()).map_err(Fault::from)?;
        let gap = Gap::new(heights).map_err(Fault::from)?;
        let coefficients = friction.as_slice()?;
        let friction = surface(grid, coefficients)?;
        if let Some(plate) = plate {
            let greatest = coefficients.iter().copied().fold(0.0, f64::max);
            let holds = greatest == 0.0;
            RangeError::check("friction", greatest, holds, "0 on a plate").map_err(Fault::from)?;
            plate.check(&gap, cut)?;
        }
        let border = match (cut, periodic) {
            (_, true) => Border::Periodic,
            (true, false) => Border::Cut,
            (false, false) => Border::Free,
        };
        let table = influence::operator(py, grid, &influence, &friction)?;
        let make = |grid: Grid| {
            let gap = gap.coarsened_to(grid).map_err(OperatorError::from)?;
            match (plate, &table) {
                (Some(plate), _) => plate.under(gap, materials, friction.clone()),
                (None, Some(table)) => {
                    let operator = Arc::new(table.coarsened_to(grid)?);
                    ContactProblem::new(gap, operator, friction.clone())
                }
                (None, None) if border == Border::Periodic => {
                    ContactProblem::of_periods_by_need(gap, materials.0, friction.clone())
                }
                (None, None) => {
                    ContactProblem::of_half_spaces_by_need(gap, materials.0, friction.clone())
                }
            }
        };
        let history = without_python(py, || {
            let own = plate.map(|_| Frictionless::default().within(tolerance)).transpose()?;
            let chosen = Chosen::main(Frictional::default().within(tolerance)?, own);
            let history = match estimates {
                true => NestedHistory::new(chosen, grid, make),
                false => {
                    NestedHistory::without_estimates(chosen, make(grid).map_err(Fault::other)?)
                }
            };
            history.map_err(|error| match error {
                NestedError::Problem(error) => Fault::other(error),
                NestedError::Method(error) => error.into(),
            })
        })??;
        let limits = PressureLimits::of(&materials.0);
        let half_spaces = plate.is_none() && table.is_none();
        let limits = if half_spaces { limits } else { limits.without_half_spaces() };
        let given = [(false, 0.0); 4];
        let (last, told) = (StepSummary::default(), Vec::new());
        Ok(Self { history, border, limits, last, given, told })
    }

    /// One step with given approach, shifts along x and y, and twist, or their loads; None keeps what was given before.
    /// Warns of what has not been told. If that or the step fails, nothing has changed.
    fn step<'py>(
        &mut self,
        py: Python<'py>,
        changed: [Option<Given>; 4],
    ) -> PyResult<Bound<'py, PyDict>> {
        let mut given = self.given;
        given.iter_mut().zip(changed).for_each(|(old, new)| *old = new.unwrap_or(*old));
        let [normal, x, y, twist] = given.map(|(is_load, value)| match is_load {
            true => Driven::Load(value),
            false => Driven::Shift(value),
        });
        let drive = Drive { normal, x, y, twist };
        let Self { history, border: beyond, last, .. } = self;
        let threads = Threads::for_grid(finest(history));
        let solve = || {
            let trial = history.trial(&drive, &mut ())?;
            let (problem, states) = (history.problem(), [history.state(), trial.state()]);
            if *beyond == Border::Free && border(states[1]).is_some() {
                let text = "the contact reaches the border of the grid: size must be larger, or cut=True if \
                            the bodies end there, or periodic=True if they repeat themselves";
                return Err(Fault::other(text));
            }
            let next = last.next(problem, states, trial.convergence()).map_err(Fault::other)?;
            let warnings = problem.warnings(states[1]).map_err(Fault::other)?;
            Ok((next.with_estimates(trial.estimates().as_ref()), warnings, trial))
        };
        let (next, warnings, trial) = match threads {
            Threads::One => without_python(py, solve)??,
            Threads::Pool => beside(py, solve)??,
        };
        let doubts = self.tell(py, &next, &warnings, trial.state())?;
        self.told.extend(doubts);
        self.history.take(trial);
        (self.last, self.given) = (next, given);
        self.summary(py)
    }

    /// The distance of the deformed surfaces after the last step.
    fn gap_left<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (problem, state) = (self.history.problem(), self.history.state());
        let gap = without_python(py, || gap_left(problem, state).map_err(Fault::other))??;
        Ok(PyArray1::from_slice(py, gap.values()))
    }

    /// The gap of the undeformed surfaces.
    fn gap<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.history.problem().gap().heights().values())
    }

    /// A field after the last step, by its place among them.
    fn field<'py>(&self, py: Python<'py>, place: usize) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, fields(self.history.state())[place].values())
    }

    /// The state of each cell after the last step.
    fn cells<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i8>> {
        cells(py, self.history.state())
    }

    /// The numbers of the last step, what drives the motions, and the states on all grids: fields are pressure,
    /// tractions and displacements.
    fn state<'py>(
        &self,
        py: Python<'py>,
    ) -> (Vec<f64>, [Given; 4], Kept<'py>, [Option<Kept<'py>>; 2]) {
        let coarse = self.history.coarse_states().map(|state| Some(kept(py, state?)));
        (self.last.numbers().to_vec(), self.given, kept(py, self.history.state()), coarse)
    }

    /// Restores a stored state.
    fn restore(
        &mut self,
        numbers: [f64; StepSummary::NUMBERS],
        given: [Given; 4],
        state: Read<'_>,
        coarse: [Option<Read<'_>>; 2],
    ) -> PyResult<()> {
        let grid = finest(&self.history);
        let grids = [grid.coarser().ok(), grid.coarser().and_then(Grid::coarser).ok()];
        let mut read = [None, None];
        for ((to, fields), grid) in read.iter_mut().zip(&coarse).zip(grids) {
            if let (Some(fields), Some(grid)) = (fields, grid) {
                *to = Some(restored(grid, fields)?);
            }
        }
        self.history.restore(restored(grid, &state)?, read).map_err(Fault::from)?;
        (self.last, self.given) = (StepSummary::from_numbers(&numbers), given);
        Ok(())
    }

    /// Reasons to distrust the state, as texts.
    fn warnings(&self) -> PyResult<Vec<String>> {
        let state = self.history.state();
        let warnings = self.history.problem().warnings(state).map_err(Fault::other)?;
        Ok(self.doubts(&self.last, &warnings, state).into_iter().map(|(_, text)| text).collect())
    }

    /// Summary of the last step.
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        arrays(py, &StepSummary::columns(), &[self.last])
    }

    /// Stresses (xx, yy, zz, xy, yz, zx) at points of body 1 or 2, an array (n, 6).
    fn stress<'py>(
        &self,
        py: Python<'py>,
        material: crate::materials::Material,
        body: u8,
        x: Numbers<'py>,
        y: Numbers<'py>,
        z: Numbers<'py>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let below = match body {
            1 => Subsurface::of_body_1(self.history.state(), material.0),
            2 => Subsurface::of_body_2(self.history.state(), material.0),
            _ => return Err(PyValueError::new_err(format!("body = {body}: must be 1 or 2"))),
        };
        let below = below.map_err(Fault::from)?;
        let (x, y, z) = (x.as_slice()?, y.as_slice()?, z.as_slice()?);
        same_length("y", y.len(), x.len())?;
        same_length("z", z.len(), x.len())?;
        let share = (1 << 20) / finest(&self.history).cells();
        let stresses = map_by(share.clamp(1, 1 << 9), py, x.len(), |i| {
            let s = below.stress(Point { x: x[i], y: y[i], z: z[i] })?;
            Ok([s.xx, s.yy, s.zz, s.xy, s.yz, s.zx])
        })?;
        PyArray1::from_vec(py, stresses.into_iter().flatten().collect()).reshape([x.len(), 6])
    }
}

impl Solver {
    /// Reasons to distrust a step.
    fn doubts(
        &self,
        step: &StepSummary,
        warnings: &[GridWarning],
        state: &ContactState,
    ) -> Vec<(Doubt, String)> {
        let few = few_cells(state, step.estimates).map(|text| (Doubt::Few, text));
        let large =
            |warning: &&GridWarning| matches!(warning, GridWarning::LargeDisplacement { .. });
        let large = warnings.iter().find(large).map(|text| (Doubt::Large, text.to_string()));
        let exceeded = self.limits.validity(step.greatest_pressure).exceeded();
        let exceeded = exceeded.map(|excess| (Doubt::Exceeds(excess.limit), excess.to_string()));
        few.into_iter().chain(large).chain(exceeded).collect()
    }

    /// Warns of the reasons that have not been told, and gives them.
    fn tell(
        &self,
        py: Python<'_>,
        step: &StepSummary,
        warnings: &[GridWarning],
        state: &ContactState,
    ) -> PyResult<Vec<Doubt>> {
        let mut doubts = self.doubts(step, warnings, state);
        doubts.retain(|(doubt, _)| !self.told.contains(doubt));
        let (kinds, texts): (Vec<_>, Vec<_>) = doubts.into_iter().unzip();
        let is_outside = kinds.iter().any(|doubt| *doubt != Doubt::Few);
        warn(py, (texts, is_outside))?;
        Ok(kinds)
    }
}

/// The finest grid.
fn finest(history: &NestedHistory<Chosen>) -> Grid {
    history.problem().grid()
}

/// A state as Python keeps it.
fn kept<'py>(py: Python<'py>, state: &ContactState) -> Kept<'py> {
    let Shift { zeta, xi, eta, omega } = state.shift;
    let (fields, cells) = lines(py, state);
    ([zeta, xi, eta, omega], fields, cells)
}

/// A stored state on a grid.
fn restored(grid: Grid, (shift, fields, cells): &Read<'_>) -> PyResult<ContactState> {
    let [zeta, xi, eta, omega] = *shift;
    let field = |i: usize| -> PyResult<Field> {
        Ok(Field::new(grid, fields[i].as_slice()?.to_vec()).map_err(Fault::from)?)
    };
    let cell = |code: &i8| match code {
        0 => Ok(CellState::Exterior),
        1 => Ok(CellState::Stick),
        2 => Ok(CellState::Slip),
        _ => Err(PyValueError::new_err(format!("state = {code}: must be 0, 1 or 2"))),
    };
    let cells = cells.as_slice()?.iter().map(cell).collect::<PyResult<Vec<_>>>()?;
    Ok(ContactState {
        shift: Shift { zeta, xi, eta, omega },
        pressure: field(0)?,
        traction_x: field(1)?,
        traction_y: field(2)?,
        displacement_x: field(3)?,
        displacement_y: field(4)?,
        cells: Field::new(grid, cells).map_err(Fault::from)?,
    })
}

impl Plate {
    /// Checks that the cells cover the plate, whose edges no contact reaches.
    fn check(&self, gap: &Gap, cut: bool) -> Result<(), Fault> {
        RangeError::check("cut", 1.0, !cut, "False on a plate: no contact may reach its edges")?;
        let allowed = "a side of the plate: the cells cover it, no more and no less";
        let named = |error: RangeError| RangeError::new("size", error.value, allowed);
        Ok(self.plate.check_cover(gap.grid()).map_err(named)?)
    }

    /// The problem of this plate below a body.
    fn under(
        self,
        gap: Gap,
        materials: Pair,
        friction: SurfaceFriction,
    ) -> Result<ContactProblem, ProblemError> {
        let (grid, threads) = (gap.grid(), Threads::for_grid(gap.grid()));
        let operator = PlateOperator::new(materials.0, self.plate, grid, self.theory, threads)?;
        ContactProblem::new(gap, Arc::new(operator), friction)
    }
}

/// Friction with one coefficient for all cells, or one for each cell.
pub(crate) fn surface(grid: Grid, friction: &[f64]) -> PyResult<SurfaceFriction> {
    let of = |value: &f64| Friction::new(*value).map_err(Fault::from);
    if let [value] = friction {
        return Ok(of(value)?.into());
    }
    let cells = friction
        .iter()
        .enumerate()
        .map(|(i, value)| of(value).map(CellFriction::from).map_err(|fault| fault.at(i)));
    let cells = cells.collect::<Result<Vec<_>, _>>()?;
    Ok(Field::new(grid, cells).map_err(Fault::from)?.into())
}
