//! Cases of a contact: under loads, the stresses below it, and rolling.

use carom::halfspace::Grid;
use carom::laws::hertz::HertzState;
use carom::laws::line::LineState;
use carom_cases::Pressed;
use carom_cases::case::RollCase;
use carom_cases::hertz;
use carom_cases::roll::{self, Rolled, Wanted};
use carom_cases::stress::{self, Solved};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{Lines, Source, lines, raised};
use crate::records::arrays;
use crate::threads::beside;
use crate::told::{Told, of_contact, reported};

/// The contact under each of its loads, and warnings.
#[pyfunction]
pub(crate) fn case_hertz(py: Python<'_>, case: Source) -> PyResult<(Bound<'_, PyDict>, Told)> {
    let followed = beside(py, || hertz::followed(&case.read()?));
    let followed = followed?.map_err(raised)?;
    let told = reported(followed.validity_report(), "loads");
    Ok((pressed(py, &followed.states)?, told))
}

/// The states of a contact at a point, or along a line: all of one kind.
fn pressed<'py>(py: Python<'py>, states: &[Pressed]) -> PyResult<Bound<'py, PyDict>> {
    let point = |state: &Pressed| match state {
        Pressed::Point(state) => Some(*state),
        Pressed::Line(_) => None,
    };
    let points: Option<Vec<HertzState>> = states.iter().map(point).collect();
    if let Some(points) = points {
        return arrays(py, HertzState::COLUMNS, &points);
    }
    let lines: Vec<LineState> = states
        .iter()
        .filter_map(|state| match state {
            Pressed::Line(state) => Some(*state),
            Pressed::Point(_) => None,
        })
        .collect();
    arrays(py, LineState::COLUMNS, &lines)
}

/// The contact, its relative stick radius, the places along x, y and depth, the stresses (xx, yy, zz, xy, yz, zx) at all
/// points, von Mises' and the maximum shear stress there, and warnings.
#[pyfunction]
#[allow(clippy::type_complexity)] // as Python has it: lines of numbers
pub(crate) fn case_stress<'py>(
    py: Python<'py>,
    case: Source,
) -> PyResult<(
    Bound<'py, PyDict>,
    f64,
    [Bound<'py, PyArray1<f64>>; 3],
    [Bound<'py, PyArray1<f64>>; 3],
    Told,
)> {
    let solved = beside(py, || stress::solved(&case.read()?))?.map_err(raised)?;
    let told = of_contact(solved.validity());
    let Solved { case, state, stick_radius, points, .. } = solved;
    let parts = points.iter().map(|point| point.stress);
    let values = [
        parts.clone().flat_map(|s| [s.xx, s.yy, s.zz, s.xy, s.yz, s.zx]).collect(),
        parts.clone().map(|stress| stress.von_mises()).collect(),
        parts.map(|stress| stress.maximum_shear()).collect::<Vec<_>>(),
    ];
    let array = |values| PyArray1::from_vec(py, values);
    let contact = pressed(py, &[state])?;
    Ok((contact, stick_radius, case.places.map(array), values.map(array), told))
}

/// A rolling contact: its rows, the creep coefficients if wanted, the cell centres and the fields of the last contact in
/// the format of a solver's state, what exceeds the theory, and other warnings.
#[pyfunction]
#[allow(clippy::type_complexity)] // as Python has it: lines of numbers
pub(crate) fn case_roll<'py>(
    py: Python<'py>,
    case: Source,
    coefficients: bool,
    fastsim: bool,
    table: bool,
) -> PyResult<(
    Bound<'py, PyDict>,
    Option<Bound<'py, PyDict>>,
    [Bound<'py, PyArray1<f64>>; 2],
    Lines<'py>,
    Told,
    Vec<String>,
)> {
    let wanted = Wanted { coefficients, springs: fastsim, table };
    let file = case.read().map_err(raised)?;
    let case = file.parse::<RollCase>().map_err(raised)?;
    if (fastsim || table) && case.distance.is_some() {
        let text =
            "fastsim and table: support the steady state only: the case must have no `distance`";
        return Err(PyValueError::new_err(text));
    }
    let rolled = beside(py, || roll::rolled(&file, &case, wanted, &mut |_| ()));
    let rolled = rolled?.map_err(raised)?;
    let warnings = roll::warnings(&case, &rolled, wanted);
    let exceeded = of_contact(roll::validity(&case, &rolled.rows));
    let Rolled { rows, state, window, creep, .. } = rolled;
    let creep = creep.map(|creep| arrays(py, roll::CREEP, &[creep])).transpose()?;
    let rows = arrays(py, roll::COLUMNS, &rows)?;
    Ok((
        rows,
        creep,
        centres(py, &state.pressure.grid(), window.middle()),
        lines(py, &state),
        exceeded,
        warnings,
    ))
}

/// The cell centres along x and y of a grid about its middle.
pub(super) fn centres<'py>(
    py: Python<'py>,
    grid: &Grid,
    [x, y]: [f64; 2],
) -> [Bound<'py, PyArray1<f64>>; 2] {
    let axes = [
        (0..grid.nx()).map(|i| x + grid.centred_x(i)).collect::<Vec<_>>(),
        (0..grid.ny()).map(|j| y + grid.centred_y(j)).collect(),
    ];
    axes.map(|axis| PyArray1::from_vec(py, axis))
}
