//! Results as columns; their names, units and meanings come from the tables beside the Rust results.

use carom::impact::restitution::DissimilarRestitution;
use carom::impact::scene::{Bounce, Event, PathPoint};
use carom::impact::{HistoryPoint, Outcome};
use carom::laws::creep::CreepCoefficients;
use carom::laws::hertz::HertzState;
use carom::rolling::FastsimForces;
use carom::table::{Column, Kind, Quantity, Value};
use carom_cases::history::all_columns as history_columns;
use carom_cases::roll;
use carom_cases::scene::rebound_columns;
use carom_cases::shell::{BellowsRow, FlangeSummary, RESPONSE_COLUMNS, RingPlace, WALL_COLUMNS};
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Its name in Python.
fn kind_name(column: &impl Quantity) -> &'static str {
    match column.kind() {
        Kind::Number => "number",
        Kind::Count => "count",
        Kind::Flag => "flag",
        Kind::Text => "text",
        Kind::Vector => "vector",
    }
}

/// Name, unit, meaning and kind of each column of a result: vector, text, count, flag or number.
#[pyfunction]
pub(crate) fn columns(
    record: &str,
) -> PyResult<Vec<(&'static str, &'static str, &'static str, &'static str)>> {
    match record {
        "Bounce" => {
            let mut all = about(Bounce::COLUMNS);
            all.push(("wall", "", "name of the wall", "text"));
            all.extend(about(&rebound_columns()));
            Ok(all)
        }
        "BellowsResponse" => Ok(about(RESPONSE_COLUMNS)),
        "BellowsState" => Ok(about(BellowsRow::COLUMNS)),
        "CreepCoefficients" => Ok(about(roll::CREEP)),
        "CreepForce" => Ok(about(carom::laws::creep::force::CreepForce::COLUMNS)),
        "DissimilarRestitution" => Ok(about(DissimilarRestitution::COLUMNS)),
        "FastsimForce" => Ok(about(FastsimForces::COLUMNS)),
        "FitCorrelation" => Ok(about(carom_fit::Correlation::COLUMNS)),
        "FitParameter" => Ok(about(carom_fit::Determined::COLUMNS)),
        "FitPoint" => Ok(about(carom_fit::Point::COLUMNS)),
        "FitPrediction" => Ok(about(carom_fit::Prediction::COLUMNS)),
        "FitQuality" => Ok(about(carom_fit::Quality::COLUMNS)),
        "FlangeSummary" => Ok(about(FlangeSummary::COLUMNS)),
        "HertzState" => Ok(about(HertzState::COLUMNS)),
        "HistoryPoint" => Ok(about(HistoryPoint::COLUMNS)),
        "HistoryStep" => Ok(about(&history_columns())),
        "LinearCreep" => Ok(about(CreepCoefficients::COLUMNS)),
        "LineState" => Ok(about(carom::laws::line::LineState::COLUMNS)),
        "PathPoint" => Ok(about(PathPoint::COLUMNS)),
        "PathEvent" => {
            let mut all = about(Event::COLUMNS);
            all.push(("wall", "", "name of the wall; empty in flight", "text"));
            Ok(all)
        }
        "Rebound" => Ok(about(Outcome::COLUMNS)),
        "RingPlace" => Ok(about(RingPlace::COLUMNS)),
        "RollState" => Ok(about(roll::COLUMNS)),
        "SolverStep" => Ok(about(&carom::solver::StepSummary::columns())),
        "SurfaceMeasures" => Ok(about(carom_surface::Measures::COLUMNS)),
        "WallPlace" => Ok(about(WALL_COLUMNS)),
        _ => Err(PyValueError::new_err(format!("unknown result `{record}`"))),
    }
}

fn about<R>(
    columns: &[Column<R>],
) -> Vec<(&'static str, &'static str, &'static str, &'static str)> {
    let one =
        |column: &Column<R>| (column.name(), column.unit(), column.meaning(), kind_name(column));
    columns.iter().map(one).collect()
}

/// Memory that one record takes until its arrays are made, in bytes: the record, its numbers and texts, and
/// one column in conversion.
pub(crate) fn bytes<R>(columns: &[Column<R>]) -> usize {
    let numbers: usize = columns.iter().map(|column| column.parts().len().max(1)).sum();
    let texts = columns.len() * size_of::<String>();
    size_of::<R>() + numbers * size_of::<f64>() + texts + size_of::<Value>()
}

/// Converts records to one array for each column: numbers, counts and flags (n,), vectors (n, 3), texts as
/// lists. A missing value is NaN, 0 or an empty text.
pub(crate) fn arrays<'py, R>(
    py: Python<'py>,
    columns: &[Column<R>],
    records: &[R],
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    add(&dict, columns, records)?;
    Ok(dict)
}

/// Adds the columns of records to arrays as of [`arrays`].
pub(crate) fn add<R>(
    dict: &Bound<'_, PyDict>,
    columns: &[Column<R>],
    records: &[R],
) -> PyResult<()> {
    let py = dict.py();
    for column in columns {
        let values: Vec<Value> = records.iter().map(|record| column.value(record)).collect();
        let (name, values) = (column.name(), values.into_iter());
        match column.kind() {
            Kind::Vector => {
                let parts = values.flat_map(vector).collect::<Vec<f64>>();
                let array = PyArray1::from_vec(py, parts).reshape([records.len(), 3])?;
                let _: &Bound<'_, PyArray2<f64>> = &array;
                dict.set_item(name, array)?;
            }
            Kind::Text => dict.set_item(name, values.map(text).collect::<Vec<_>>())?,
            Kind::Count => {
                dict.set_item(name, PyArray1::from_vec(py, values.map(count).collect()))?
            }
            Kind::Flag => {
                dict.set_item(name, PyArray1::from_vec(py, values.map(flag).collect()))?
            }
            Kind::Number => {
                dict.set_item(name, PyArray1::from_vec(py, values.map(number).collect()))?
            }
        }
    }
    Ok(())
}

fn vector(value: Value) -> [f64; 3] {
    match value {
        Value::Vector(parts) => parts,
        _ => [f64::NAN; 3],
    }
}

fn number(value: Value) -> f64 {
    match value {
        Value::Number(number) => number,
        _ => f64::NAN,
    }
}

fn count(value: Value) -> i64 {
    match value {
        Value::Count(count) => i64::try_from(count).unwrap_or(i64::MAX),
        _ => 0,
    }
}

fn flag(value: Value) -> bool {
    value == Value::Flag(true)
}

fn text(value: Value) -> String {
    match value {
        Value::Text(text) => text.into_owned(),
        Value::Words(words) => words.join(" "),
        Value::Texts(texts) => texts.join("; "),
        _ => String::new(),
    }
}
