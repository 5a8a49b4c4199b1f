//! Cases of rings and shells: a bellows, a flange.

use carom_cases::shell::{
    self, BellowsRow, FlangeSummary, RESPONSE_COLUMNS, RingPlace, Solved, WALL_COLUMNS,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{Source, raised};
use crate::records::arrays;
use crate::threads::beside;

/// `bellows` or `flange`, its summary, its loads (of a bellows), its places, and warnings.
#[pyfunction]
#[allow(clippy::type_complexity)] // as Python has it: lines of numbers
pub(crate) fn case_shell<'py>(
    py: Python<'py>,
    case: Source,
) -> PyResult<(
    &'static str,
    Bound<'py, PyDict>,
    Option<Bound<'py, PyDict>>,
    Bound<'py, PyDict>,
    Vec<String>,
)> {
    let solved = beside(py, || shell::solved(&case.read()?))?.map_err(raised)?;
    let warnings = solved.warnings();
    Ok(match solved {
        Solved::Bellows(bellows) => {
            let summary = arrays(py, RESPONSE_COLUMNS, &[bellows.response])?;
            let loads = arrays(py, BellowsRow::COLUMNS, &bellows.rows)?;
            let places = bellows.rows.last().map_or(&[][..], |row| row.state.profile());
            ("bellows", summary, Some(loads), arrays(py, WALL_COLUMNS, places)?, warnings)
        }
        Solved::Flange(flange) => {
            let summary = arrays(py, FlangeSummary::COLUMNS, &[flange.summary])?;
            let places = arrays(py, RingPlace::COLUMNS, &flange.places)?;
            ("flange", summary, None, places, warnings)
        }
    })
}
