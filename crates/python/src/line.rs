//! The contact of cylinders along a line.

use carom::laws::line::{LineContact, LineState};
use carom_cases::{PointOrLine, Pressed};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, map};
use crate::error::Fault;
use crate::materials::Pair;
use crate::records::arrays;
use crate::told::{Told, reported};
use carom_cases::theory::ValidityReport;

/// The loaded contact, and warnings, for given values of "force", "approach", "half_width" or "peak_pressure".
#[pyfunction]
pub(crate) fn line_state<'py>(
    py: Python<'py>,
    materials: Pair,
    radius: f64,
    length: f64,
    given: &str,
    values: Numbers<'py>,
) -> PyResult<(Bound<'py, PyDict>, Told)> {
    let line = LineContact::new(radius, length, materials.0).map_err(Fault::from)?;
    let at = match given {
        "force" => LineContact::at_force,
        "approach" => LineContact::at_approach,
        "half_width" => LineContact::at_half_width,
        "peak_pressure" => LineContact::at_peak_pressure,
        _ => {
            let text = format!("unknown quantity `{given}` of a line contact");
            return Err(PyValueError::new_err(text));
        }
    };
    let values = values.as_slice()?;
    let states: Vec<LineState> = map(py, values.len(), |i| Ok(at(&line, values[i])?))?;
    let mut report = ValidityReport::default();
    for state in &states {
        let validity = Pressed::Line(*state).validity(&PointOrLine::Line(line), radius);
        report.add(|| format!("at {} N", state.force), validity);
    }
    Ok((arrays(py, LineState::COLUMNS, &states)?, reported(report, "loads")))
}
