//! Results as columns; their names, units and meanings come from the tables beside the Rust results.

use carom::impact::restitution::DissimilarRestitution;
use carom::impact::{HistoryPoint, Outcome};
use carom::laws::hertz::HertzState;
use carom::table::{Column, Quantity as _, Value};
use carom_cases::history::all_columns as history_columns;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Columns of texts. They are lists even if no record has a value.
const TEXTS: [&str; 6] = ["outcome", "regimes", "method", "warnings", "regime", "twist_regime"];

/// Name, unit, meaning and number of components of each column of a result; 0 components for texts.
#[pyfunction]
pub(crate) fn columns(
    record: &str,
) -> PyResult<Vec<(&'static str, &'static str, &'static str, usize)>> {
    match record {
        "DissimilarRestitution" => Ok(about(DissimilarRestitution::COLUMNS)),
        "HertzState" => Ok(about(HertzState::COLUMNS)),
        "HistoryPoint" => Ok(about(HistoryPoint::COLUMNS)),
        "HistoryStep" => Ok(about(&history_columns())),
        "Rebound" => Ok(about(Outcome::COLUMNS)),
        "SolverStep" => Ok(about(&carom::solver::StepSummary::columns())),
        _ => Err(PyValueError::new_err(format!("unknown result `{record}`"))),
    }
}

fn about<R>(columns: &[Column<R>]) -> Vec<(&'static str, &'static str, &'static str, usize)> {
    let one = |column: &Column<R>| {
        let parts = if TEXTS.contains(&column.name()) { 0 } else { column.parts().len().max(1) };
        (column.name(), column.unit(), column.meaning(), parts)
    };
    columns.iter().map(one).collect()
}

/// Memory that one record takes until its arrays are made, in bytes: the record, its numbers and texts, and
/// one column in conversion.
pub(crate) fn bytes<R>(columns: &[Column<R>]) -> usize {
    let numbers: usize = columns.iter().map(|column| column.parts().len().max(1)).sum();
    let texts = columns.len() * size_of::<String>();
    size_of::<R>() + numbers * size_of::<f64>() + texts + size_of::<Value>()
}

/// Converts records to one array for each column: numbers (n,), vectors (n, 3), texts as lists. A missing
/// value is NaN or an empty text.
pub(crate) fn arrays<'py, R>(
    py: Python<'py>,
    columns: &[Column<R>],
    records: &[R],
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for column in columns {
        let values: Vec<Value> = records.iter().map(|record| column.value(record)).collect();
        if column.parts().len() == 3 {
            let parts = values.into_iter().flat_map(vector).collect::<Vec<f64>>();
            let array = PyArray1::from_vec(py, parts).reshape([records.len(), 3])?;
            let _: &Bound<'_, PyArray2<f64>> = &array;
            dict.set_item(column.name(), array)?;
        } else if TEXTS.contains(&column.name()) {
            dict.set_item(column.name(), values.into_iter().map(text).collect::<Vec<_>>())?;
        } else {
            let numbers = values.into_iter().map(number).collect();
            dict.set_item(column.name(), PyArray1::from_vec(py, numbers))?;
        }
    }
    Ok(dict)
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
        Value::Count(count) => count as f64,
        _ => f64::NAN,
    }
}

fn text(value: Value) -> String {
    match value {
        Value::Text(text) => text.into_owned(),
        Value::Words(words) => words.join(" "),
        Value::Texts(texts) => texts.join("; "),
        _ => String::new(),
    }
}
