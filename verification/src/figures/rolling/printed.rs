//! The rolling cases shipped with CONTACT.

use carom_rolling::SteadyRolling;
use carom_solver::CellState;
use serde_json::Value;

use crate::Failure;

/// The rows that an example prints.
pub(super) fn rows(example: &str) -> Result<Vec<Value>, Failure> {
    let text = include_str!("../../../../crates/rolling/tests/data/contact.json");
    let all: Value = serde_json::from_str(text)?;
    let rows = all[example]["results"].as_array();
    Ok(rows.ok_or("the results are missing")?.clone())
}

/// A number of a row.
pub(super) fn number(row: &Value, name: &str) -> Result<f64, Failure> {
    row[name].as_f64().ok_or_else(|| format!("{name} is missing").into())
}

/// The printed cells that stick and slip.
pub(super) fn counts(row: &Value) -> Result<[f64; 2], Failure> {
    Ok([number(row, "stick")?, number(row, "slip")?])
}

/// The computed cells that stick and slip.
pub(super) fn own_counts(rolled: &SteadyRolling) -> [f64; 2] {
    [CellState::Stick, CellState::Slip].map(|state| rolled.state.count(state) as f64)
}

/// The highest pressure.
pub(super) fn highest(rolled: &SteadyRolling) -> f64 {
    rolled.state.pressure.values().iter().copied().fold(0.0, f64::max)
}
