//! The rolling cases shipped with CONTACT, and how far a number is from a printed one.

use carom_rolling::SteadyRolling;
use carom_solver::CellState;
use serde_json::Value;

use crate::{Cell, Failure, Figure, NewClaim};

/// Where the printed numbers come from.
pub(super) const SOURCE: &str = "printed by CONTACT, open version 2025-07, for its own example";

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

/// How far a number is from one printed to four digits, in units of the fourth.
pub(super) fn off(own: f64, printed: f64) -> f64 {
    (own - printed).abs() / 10_f64.powi(printed.abs().log10().floor() as i32 - 3)
}

/// The same as a cell of a table.
pub(super) fn off_cell(own: f64, printed: f64) -> Cell {
    Cell::Remark(format!("{:.2}", off(own, printed)))
}

/// Claims that numbers agree in all four printed digits: the worst is at most half a unit of the
/// last away.
#[track_caller]
pub(super) fn all_digits<'f>(
    figure: &'f mut Figure,
    what: &str,
    pairs: impl IntoIterator<Item = (f64, f64)>,
) -> NewClaim<'f> {
    let worst = pairs.into_iter().map(|(own, printed)| off(own, printed)).reduce(f64::max);
    let statement = format!("{what}: worst difference, in units of the fourth digit");
    // Without a pair the claim fails.
    figure.at_most(statement, worst.unwrap_or(f64::NAN), 0.5)
}
