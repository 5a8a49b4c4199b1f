//! Cases from TOML files, the same as for the command `carom`.

mod contact;
mod scene;
mod shell;

pub(crate) use contact::{case_hertz, case_roll, case_stress};
pub(crate) use scene::case_scene;
pub(crate) use shell::case_shell;

use carom::halfspace::Field;
use carom::impact::Outcome;
use carom::solver::{CellState, ContactState};
use carom::special::WordError;
use carom_cases::case::CaseKind;
use carom_cases::history::{self, all_columns};
use carom_cases::impact::{self, Followed as Impacts};
use carom_cases::input::CaseFile;
use carom_cases::solve::{self, Followed as Solved};
use carom_cases::{Error, ErrorKind};
use numpy::PyArray1;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

use crate::error::{CaromError, Fault};
use crate::quantities::{Accuracy, In};
use crate::records::arrays;
use crate::threads::beside;
use crate::told::{Told, of_impacts, reported};

/// Name, unit and values of the field that a case sweeps over.
type Swept<'py> = (&'static str, &'static str, Bound<'py, PyArray1<f64>>);

/// The fields of a state and the states of its cells, flat.
pub(crate) type Lines<'py> = ([Bound<'py, PyArray1<f64>>; 5], Bound<'py, PyArray1<i8>>);

/// A case: the path of its file, or its text alone in a tuple.
#[derive(FromPyObject)]
pub(crate) enum Source {
    Path(PathBuf),
    Text((String,)),
}

impl Source {
    /// Reads the case.
    ///
    /// # Errors
    /// As [`CaseFile::read`].
    pub(crate) fn read(self) -> Result<CaseFile, Error> {
        match self {
            Self::Path(path) => CaseFile::read(&path),
            Self::Text((text,)) => Ok(CaseFile::of_text(text)),
        }
    }
}

/// A sentence for each plain number of a case that is unusual, probably in another unit. A case that cannot be read has
/// none: its reader says why.
#[pyfunction]
pub(crate) fn case_unusual(case: Source) -> Vec<String> {
    let Ok(file) = case.read() else { return Vec::new() };
    CaseKind::of(file.text()).map_or_else(|_| Vec::new(), |kind| kind.unusual(file.text()))
}

/// The impact of a case, or all impacts of its sweep, and warnings.
#[pyfunction]
pub(crate) fn case_impact<'py>(
    py: Python<'py>,
    case: Source,
) -> PyResult<(Option<Swept<'py>>, Bound<'py, PyDict>, Told)> {
    let followed = beside(py, || impact::followed(&case.read()?));
    let Impacts { swept, outcomes } = followed?.map_err(raised)?;
    let swept = swept.map(|(name, unit, values)| (name, unit, PyArray1::from_vec(py, values)));
    Ok((swept, arrays(py, Outcome::COLUMNS, &outcomes)?, of_impacts(&outcomes)))
}

/// The contact after each step of a history, and warnings.
#[pyfunction]
pub(crate) fn case_history(py: Python<'_>, case: Source) -> PyResult<(Bound<'_, PyDict>, Told)> {
    let followed = beside(py, || history::followed(&case.read()?));
    let followed = followed?.map_err(raised)?;
    let told = reported(followed.validity_report(), "steps");
    Ok((arrays(py, &all_columns(), &followed.steps)?, told))
}

/// A contact on a grid: its steps, the cell centres along x and y, the fields at the end in the format of a
/// solver's state, and warnings.
#[pyfunction]
#[allow(clippy::type_complexity)] // as Python has it: lines of numbers
pub(crate) fn case_solve<'py>(
    py: Python<'py>,
    case: Source,
    accuracy: Option<In<Accuracy>>,
) -> PyResult<(
    Bound<'py, PyDict>,
    [Bound<'py, PyArray1<f64>>; 2],
    [Bound<'py, PyArray1<f64>>; 5],
    Bound<'py, PyArray1<i8>>,
    Told,
)> {
    let accuracy = accuracy.map(|accuracy| accuracy.0);
    let solved = beside(py, || solve::solved(&case.read()?, accuracy));
    let (case, solved) = solved?.map_err(raised)?;
    let caution = solved.validity_report().told("steps").0;
    let texts = caution.into_iter().chain(solved.warnings(&case)).collect();
    let is_left = !solved.validity_report().validity().holds() || solved.too_large.is_some();
    let Solved { steps, state, window, .. } = solved;
    let axes = contact::centres(py, &window.grid(), window.middle());
    let (fields, cells) = lines(py, &state);
    let steps = arrays(py, &carom::solver::StepSummary::columns(), &steps)?;
    Ok((steps, axes, fields, cells, (texts, is_left)))
}

/// A commented case of the given kind with all its fields, ready to run.
#[pyfunction]
pub(crate) fn case_new(kind: &str) -> PyResult<String> {
    let kind: Result<CaseKind, WordError> = kind.parse();
    Ok(kind.map_err(|error| PyValueError::new_err(error.to_string()))?.template())
}

/// Fields and cell states as flat arrays: pressure, tractions, displacements.
pub(crate) fn lines<'py>(py: Python<'py>, state: &ContactState) -> Lines<'py> {
    (fields(state).map(|field| PyArray1::from_slice(py, field.values())), cells(py, state))
}

/// The fields in their order.
pub(crate) const fn fields(state: &ContactState) -> [&Field; 5] {
    [
        &state.pressure,
        &state.traction_x,
        &state.traction_y,
        &state.displacement_x,
        &state.displacement_y,
    ]
}

/// The state of each cell as a number.
pub(crate) fn cells<'py>(py: Python<'py>, state: &ContactState) -> Bound<'py, PyArray1<i8>> {
    let cells = state.cells.values().iter().map(|cell| match cell {
        CellState::Exterior => 0,
        CellState::Stick => 1,
        CellState::Slip => 2,
    });
    PyArray1::from_vec(py, cells.collect())
}

/// The text of a system error, without the error code.
fn reason(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or_default().to_owned()
}

/// Raises an error in a case as `ValueError`, a file that cannot be read as `OSError`.
pub(crate) fn raised(error: Error) -> PyErr {
    let path = error.path.as_ref().map(|path| path.display());
    match (&*error.kind, path) {
        (ErrorKind::Range(range), None) => Fault::from(*range).into(),
        (ErrorKind::Io { source, .. }, Some(path)) => match source.raw_os_error() {
            Some(code) => PyOSError::new_err((code, reason(source), path.to_string())),
            None => PyOSError::new_err(format!("{path}: {source}")),
        },
        _ if error.is_bad_input() => PyValueError::new_err(error.to_string()),
        _ => CaromError::new_err(error.to_string()),
    }
}
