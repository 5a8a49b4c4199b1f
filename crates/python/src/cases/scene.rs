//! Cases of a ball between walls.

use carom::impact::Rebound;
use carom::impact::scene::{Bounce, Event, PathPoint};
use carom_cases::scene::{self, Followed, add_bounce, rebound_columns, wall_name};
use carom_cases::theory::ValidityReport;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{Source, raised};
use crate::records::{add, arrays};
use crate::threads::beside;
use crate::told::{Told, reported};

/// Bounces and events with the names of the walls, why the path ends, its end and instants of every flight.
type Parts<'py> =
    (Bound<'py, PyDict>, Bound<'py, PyDict>, String, Bound<'py, PyDict>, Bound<'py, PyDict>);

/// The path of a ball, and warnings.
#[pyfunction]
pub(crate) fn case_scene<'py>(
    py: Python<'py>,
    case: Source,
    points: usize,
) -> PyResult<(Parts<'py>, Told)> {
    let followed = beside(py, || scene::followed(&case.read()?, points));
    let Followed { case, bounces, events, points, end } = followed?.map_err(raised)?;
    let mut report = ValidityReport::default();
    bounces.iter().for_each(|bounce| add_bounce(&mut report, bounce));
    let walls: Vec<&str> = bounces.iter().map(|bounce| case.names[bounce.wall].as_str()).collect();
    let table = arrays(py, Bounce::COLUMNS, &bounces)?;
    table.set_item("wall", walls)?;
    let rebounds: Vec<Rebound> = bounces.into_iter().map(|bounce| bounce.rebound).collect();
    add(&table, &rebound_columns(), &rebounds)?;
    let happened = arrays(py, Event::COLUMNS, &events)?;
    let walls: Vec<String> = events.iter().map(|event| wall_name(&case, event)).collect();
    happened.set_item("wall", walls)?;
    let last = arrays(py, PathPoint::COLUMNS, &[end.last])?;
    let points = arrays(py, PathPoint::COLUMNS, &points)?;
    Ok(((table, happened, end.reason(&case), last, points), reported(report, "bounces")))
}
