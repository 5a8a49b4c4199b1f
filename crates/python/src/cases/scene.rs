//! Cases of a ball between walls.

use carom::impact::Rebound;
use carom::impact::scene::{Bounce, PathPoint};
use carom_cases::input::CaseFile;
use carom_cases::scene::{self, Followed, add_bounce, rebound_columns};
use carom_cases::theory::ValidityReport;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

use super::raised;
use crate::records::{add, arrays};
use crate::threads::beside;
use crate::told::{Told, reported};

/// The bounces of a ball with the names of the walls, why the path ends, its end, instants of every flight, and warnings.
#[pyfunction]
#[allow(clippy::type_complexity)] // as Python has it: lines of numbers
pub(crate) fn case_scene<'py>(
    py: Python<'py>,
    path: PathBuf,
    points: usize,
) -> PyResult<(Bound<'py, PyDict>, String, Bound<'py, PyDict>, Bound<'py, PyDict>, Told)> {
    let followed = beside(py, || scene::followed(&CaseFile::read(&path)?, points));
    let Followed { case, bounces, points, end } = followed?.map_err(raised)?;
    let mut report = ValidityReport::default();
    bounces.iter().for_each(|bounce| add_bounce(&mut report, bounce));
    let walls: Vec<&str> = bounces.iter().map(|bounce| case.names[bounce.wall].as_str()).collect();
    let table = arrays(py, Bounce::COLUMNS, &bounces)?;
    table.set_item("wall", walls)?;
    let rebounds: Vec<Rebound> = bounces.into_iter().map(|bounce| bounce.rebound).collect();
    add(&table, &rebound_columns(), &rebounds)?;
    let last = arrays(py, PathPoint::COLUMNS, &[end.last])?;
    let points = arrays(py, PathPoint::COLUMNS, &points)?;
    Ok((table, end.reason(&case), last, points, reported(report, "bounces")))
}
