//! The numerical contact solver: gaps and drives in, fields out.

use carom::halfspace::operator::{Blocks, HalfSpaceOperator, PlateOperator, Threads};
use carom::halfspace::{Field, Point};
use carom::prelude::{
    CellState, ContactProblem, ContactState, Drive, Driven, Friction, Frictional, Gap, Grid,
    Method as _,
};
use carom::solver::{
    CellFriction, Convergence, FrictionalScratch, Frictionless, GridWarning, NormalScratch,
    StepSummary, Subsurface, SurfaceFriction,
};
use carom::special::RangeError;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

use crate::arrays::{Numbers, map, same_length};
use crate::cases::lines;
use crate::error::Fault;
use crate::influence;
use crate::materials::MaterialPair;
use crate::plate::Plate;
use crate::records::arrays;
use crate::threads::without_python;

/// What drives one motion: true if its load is given, false if its shift is; and the value.
type Given = (bool, f64);

/// Two bodies on a grid, with the state after the last step.
#[pyclass(module = "carom")]
pub(crate) struct Solver {
    problem: ContactProblem,
    method: Chosen,
    /// Whether the bodies end at the border of the window, so that the contact may reach it.
    cut: bool,
    state: ContactState,
    next: ContactState,
    last: StepSummary,
}

/// The method with its working memory: with friction, or without it for a plate.
enum Chosen {
    Frictional(Frictional, Box<FrictionalScratch>),
    Frictionless(Frictionless, Box<NormalScratch>),
}

impl Chosen {
    fn new(problem: &ContactProblem, tolerance: f64, is_plate: bool) -> Result<Self, Fault> {
        if is_plate {
            let method = Frictionless::default().within(tolerance)?;
            let scratch = method.scratch(problem)?;
            return Ok(Self::Frictionless(method, Box::new(scratch)));
        }
        let method = Frictional::default().within(tolerance)?;
        let scratch = method.scratch(problem).map_err(Fault::other)?;
        Ok(Self::Frictional(method, Box::new(scratch)))
    }

    fn step(
        &mut self,
        problem: &ContactProblem,
        drive: &Drive,
        [from, to]: [&mut ContactState; 2],
    ) -> Result<Convergence, Fault> {
        Ok(match self {
            Self::Frictional(method, scratch) => {
                method.step(problem, from, drive, to, scratch, &mut ())?
            }
            Self::Frictionless(method, scratch) => {
                method.step(problem, from, drive, to, scratch, &mut ())?
            }
        })
    }
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
        materials: MaterialPair,
        friction: Numbers<'_>,
        tolerance: f64,
        cut: bool,
        plate: Option<Plate>,
        influence: influence::Given<'_>,
    ) -> PyResult<Self> {
        let grid = Grid::new(cells[0], cells[1], cell[0], cell[1]).map_err(Fault::from)?;
        let heights = Field::new(grid, heights.as_slice()?.to_vec()).map_err(Fault::from)?;
        let gap = Gap::new(heights).map_err(Fault::from)?;
        let coefficients = friction.as_slice()?;
        let friction = surface(grid, coefficients)?;
        if plate.is_some() {
            let greatest = coefficients.iter().copied().fold(0.0, f64::max);
            let holds = greatest == 0.0;
            RangeError::check("friction", greatest, holds, "0 on a plate").map_err(Fault::from)?;
        }
        let table = influence::operator(py, grid, &influence, &friction)?;
        let (problem, method) = without_python(py, || {
            let problem = match (plate, table) {
                (Some(plate), _) => on_plate(gap, materials, friction, cut, plate)?,
                (None, Some(table)) => {
                    ContactProblem::new(gap, Arc::new(table), friction).map_err(Fault::other)?
                }
                (None, None) => half_spaces(gap, materials, friction)?,
            };
            let method = Chosen::new(&problem, tolerance, plate.is_some())?;
            Ok::<_, Fault>((problem, method))
        })?;
        // Fields of zeros take no memory until they are written; copies do.
        let [state, next] = [(); 2].map(|()| ContactState::apart(grid));
        Ok(Self { problem, method, cut, next, state, last: StepSummary::default() })
    }

    /// One step with given approach, shifts along x and y, and twist, or their loads.
    fn step<'py>(&mut self, py: Python<'py>, given: [Given; 4]) -> PyResult<Bound<'py, PyDict>> {
        let [normal, x, y, twist] = given.map(|(is_load, value)| match is_load {
            true => Driven::Load(value),
            false => Driven::Shift(value),
        });
        let drive = Drive { normal, x, y, twist };
        let Self { problem, method, cut, state, next, last } = self;
        let stepped = without_python(py, || {
            let went = method.step(problem, &drive, [state, next])?;
            if !*cut && reaches_border(next) {
                return Err(Fault::other("the contact reaches the border of the grid"));
            }
            last.next(problem, [state, next], &went).map_err(Fault::other)
        })?;
        std::mem::swap(&mut self.state, &mut self.next);
        self.last = stepped;
        self.summary(py)
    }

    /// The numbers of the last step and the fields of the state: pressure, tractions, displacements, cell
    /// states.
    #[allow(clippy::type_complexity)] // as Python has it: lines of numbers
    fn state<'py>(
        &self,
        py: Python<'py>,
    ) -> (Vec<f64>, [Bound<'py, PyArray1<f64>>; 5], Bound<'py, PyArray1<i8>>) {
        let (fields, cells) = lines(py, &self.state);
        (self.last.numbers().to_vec(), fields, cells)
    }

    /// Restores a stored state.
    fn restore(
        &mut self,
        numbers: [f64; StepSummary::NUMBERS],
        fields: [Numbers<'_>; 5],
        cells: numpy::PyReadonlyArray1<'_, i8>,
    ) -> PyResult<()> {
        let grid = self.problem.grid();
        let mut read = [const { None }; 5];
        for (to, field) in read.iter_mut().zip(&fields) {
            let field = Field::new(grid, field.as_slice()?.to_vec()).map_err(Fault::from)?;
            *to = Some(field);
        }
        let cells = cells.as_slice()?;
        same_length("state", cells.len(), grid.cells())?;
        let cell = |code: &i8| match code {
            0 => Ok(CellState::Exterior),
            1 => Ok(CellState::Stick),
            2 => Ok(CellState::Slip),
            _ => Err(PyValueError::new_err(format!("state = {code}: must be 0, 1 or 2"))),
        };
        let cells = cells.iter().map(cell).collect::<PyResult<Vec<_>>>()?;
        let [
            Some(pressure),
            Some(traction_x),
            Some(traction_y),
            Some(displacement_x),
            Some(displacement_y),
        ] = read
        else {
            return Err(PyValueError::new_err("fields: one is missing"));
        };
        self.last = StepSummary::from_numbers(&numbers);
        self.state = ContactState {
            shift: self.last.shift,
            pressure,
            traction_x,
            traction_y,
            displacement_x,
            displacement_y,
            cells: Field::new(grid, cells).map_err(Fault::from)?,
        };
        Ok(())
    }

    /// Reasons to distrust the state, as texts.
    fn warnings(&self) -> PyResult<Vec<String>> {
        let warnings = self.problem.warnings(&self.state).map_err(Fault::other)?;
        // Where the bodies end at the border, the contact may reach it.
        let counts =
            |warning: &&GridWarning| !self.cut || !matches!(warning, GridWarning::Border { .. });
        Ok(warnings.iter().filter(counts).map(ToString::to_string).collect())
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
            1 => Subsurface::of_body_1(&self.state, material.0),
            2 => Subsurface::of_body_2(&self.state, material.0),
            _ => return Err(PyValueError::new_err(format!("body = {body}: must be 1 or 2"))),
        };
        let below = below.map_err(Fault::from)?;
        let (x, y, z) = (x.as_slice()?, y.as_slice()?, z.as_slice()?);
        same_length("y", y.len(), x.len())?;
        same_length("z", z.len(), x.len())?;
        let stresses = map(py, x.len(), |i| {
            let s = below.stress(Point { x: x[i], y: y[i], z: z[i] })?;
            Ok([s.xx, s.yy, s.zz, s.xy, s.yz, s.zx])
        })?;
        PyArray1::from_vec(py, stresses.into_iter().flatten().collect()).reshape([x.len(), 6])
    }
}

/// The problem of two half-spaces, with the influence of pressures alone if nothing else matters.
fn half_spaces(
    gap: Gap,
    materials: MaterialPair,
    friction: SurfaceFriction,
) -> Result<ContactProblem, Fault> {
    if !friction.is_none() || !materials.0.is_uncoupled() {
        return ContactProblem::of_half_spaces(gap, materials.0, friction).map_err(Fault::other);
    }
    let (grid, threads) = (gap.grid(), Threads::for_grid(gap.grid()));
    let operator = HalfSpaceOperator::with_blocks(materials.0, grid, Blocks::Normal, threads)?;
    ContactProblem::new(gap, Arc::new(operator), friction).map_err(Fault::other)
}

/// The problem of a plate, which has no friction and whose edges no contact reaches.
fn on_plate(
    gap: Gap,
    materials: MaterialPair,
    friction: SurfaceFriction,
    cut: bool,
    Plate { plate, theory }: Plate,
) -> Result<ContactProblem, Fault> {
    RangeError::check("cut", 1.0, !cut, "False on a plate: no contact may reach its edges")?;
    let allowed = "a side of the plate: the cells cover it, no more and no less";
    plate.check_cover(gap.grid()).map_err(|error| RangeError::new("size", error.value, allowed))?;
    let (grid, threads) = (gap.grid(), Threads::for_grid(gap.grid()));
    let operator = PlateOperator::new(materials.0, plate, grid, theory, threads)?;
    ContactProblem::new(gap, Arc::new(operator), friction).map_err(Fault::other)
}

fn reaches_border(state: &ContactState) -> bool {
    let grid = state.cells.grid();
    let (right, upper) = (grid.nx() - 1, grid.ny() - 1);
    let touches = |i, j| state.cells.get(i, j).is_some_and(|cell| *cell != CellState::Exterior);
    (0..grid.nx()).any(|i| touches(i, 0) || touches(i, upper))
        || (0..grid.ny()).any(|j| touches(0, j) || touches(right, j))
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
