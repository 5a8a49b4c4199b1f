//! Rolling contact on a grid: gaps and drives in, forces, creepages and fields out.

use carom::halfspace::Field;
use carom::laws::slip_speed::SlipSpeedFriction;
use carom::laws::validity::PressureLimits;
use carom::prelude::{ContactProblem, Driven, Gap, Grid};
use carom::rolling::{RollingDrive, RollingFriction, SteadyMethod};
use carom::special::RangeError;
use carom_cases::roll::{COLUMNS, Rows, Run};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

use crate::arrays::{Numbers, same_length};
use crate::cases::{Lines, lines};
use crate::error::Fault;
use crate::influence;
use crate::materials::Pair;
use crate::records::arrays;
use crate::solver::surface;
use crate::threads::beside;
use crate::told::{Told, of_contact};

/// The values of one motion in all rows, and whether they are loads.
type Given<'py> = (bool, Numbers<'py>);

/// A rolling contact: its rows, the fields of the last one in the format of a solver's state, what exceeds the
/// theory, and other warnings.
#[pyfunction]
#[allow(clippy::too_many_arguments, clippy::type_complexity)] // named ones, in Python
pub(crate) fn roll<'py>(
    py: Python<'py>,
    cells: [usize; 2],
    cell: [f64; 2],
    heights: Numbers<'py>,
    materials: Pair,
    friction: Numbers<'py>,
    by_slip: Option<[f64; 3]>,
    given: [Given<'py>; 4],
    direction: f64,
    spin_offset: f64,
    step: Option<f64>,
    distance: Option<f64>,
    speed: f64,
    tolerance: f64,
    cut: bool,
    influence: influence::Given<'_>,
) -> PyResult<(Bound<'py, PyDict>, Lines<'py>, Told, Vec<String>)> {
    RangeError::positive("speed", speed).map_err(Fault::from)?;
    let grid = Grid::new(cells[0], cells[1], cell[0], cell[1]).map_err(Fault::from)?;
    let heights = Field::new(grid, heights.as_slice()?.to_vec()).map_err(Fault::from)?;
    let gap = Gap::new(heights).map_err(Fault::from)?;
    let friction = surface(grid, friction.as_slice()?)?;
    let drives = drives(&given)?;
    let mut method = method(direction, spin_offset, step, tolerance)?;
    if let Some([a, b, c]) = by_slip {
        if distance.is_some() {
            let text =
                "distance: friction that falls with the slip speed supports the steady state only";
            return Err(PyValueError::new_err(text));
        }
        let law = SlipSpeedFriction::new(a, b, c).map_err(Fault::from)?;
        let friction = RollingFriction::new(law, speed).map_err(Fault::from)?;
        method = method.with_friction_by_slip(friction);
    }
    let run = Run { grid, method, speed, cut };
    let table = influence::operator(py, grid, &influence, &friction)?;
    let make = |grid: Grid| {
        let gap =
            gap.coarsened_to(grid).map_err(carom::halfspace::operator::OperatorError::from)?;
        match &table {
            Some(table) => {
                let operator = Arc::new(table.coarsened_to(grid)?);
                ContactProblem::new(gap, operator, friction.clone())
            }
            None => ContactProblem::of_half_spaces(gap, materials.0, friction.clone()),
        }
    };
    let rolled = beside(py, || match (distance, drives.first()) {
        (Some(distance), Some(drive)) => run.from_rest(&make(grid)?, drive, distance, &mut |_| ()),
        _ => run.steadily(make, &drives, &mut |_| ()),
    })?;
    let Rows { rows, state, too_large } = rolled.map_err(Fault::other)?;
    let peak = rows.iter().map(|row| row.greatest_pressure).fold(0.0, f64::max);
    let limits = PressureLimits::of(&materials.0);
    let limits = if table.is_some() { limits.without_half_spaces() } else { limits };
    let told = of_contact(limits.validity(peak));
    let warnings = too_large.map(|(row, warning)| format!("row {row}: {warning}"));
    Ok((arrays(py, COLUMNS, &rows)?, lines(py, &state), told, warnings.into_iter().collect()))
}

/// What drives each row.
fn drives(given: &[Given<'_>; 4]) -> PyResult<Vec<RollingDrive>> {
    let count = given[0].1.as_slice()?.len();
    for ((_, values), name) in given.iter().zip(["normal", "along", "across", "spin"]) {
        same_length(name, values.as_slice()?.len(), count)?;
    }
    let driven = |motion: usize, row: usize| -> PyResult<Driven> {
        let (is_load, values) = &given[motion];
        let value = values.as_slice()?[row];
        Ok(if *is_load { Driven::Load(value) } else { Driven::Shift(value) })
    };
    let row = |i| -> PyResult<RollingDrive> {
        let drive = RollingDrive {
            normal: driven(0, i)?,
            along: driven(1, i)?,
            across: driven(2, i)?,
            spin: driven(3, i)?,
        };
        drive.check().map_err(|error| Fault::from(error).at(i))?;
        Ok(drive)
    };
    (0..count).map(row).collect()
}

fn method(
    direction: f64,
    spin_offset: f64,
    step: Option<f64>,
    tolerance: f64,
) -> Result<SteadyMethod, Fault> {
    let method =
        SteadyMethod::default().towards(direction)?.with_spin_at(spin_offset)?.within(tolerance)?;
    Ok(match step {
        Some(step) => method.in_steps_of(step)?,
        None => method,
    })
}
