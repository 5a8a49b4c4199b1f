//! The rolling cases shipped with CONTACT.

use carom_rolling::SteadyRolling;
use carom_solver::{CellState, ContactState};
use serde_json::Value;

use super::super::printed::{SOURCE, all_digits, off_cell};
use crate::{Absolute, Cell, Failure, Figure, Marker, Panel, Series, Table};

/// The rows that an example prints.
pub(super) fn rows(example: &str) -> Result<Vec<Value>, Failure> {
    let text = include_str!("../../../data/rolling/contact.json");
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

/// Two results, and the cells that stick and slip, of a row: printed and computed.
pub(super) struct Numbers {
    pub(super) printed: [f64; 2],
    pub(super) own: [f64; 2],
    pub(super) printed_cells: [f64; 2],
    pub(super) own_cells: [f64; 2],
}

/// The numbers of each row beside each other; a head for what the row begins with, and one for each printed result.
pub(super) fn beside<'n>(
    [first, one, two]: [&str; 3],
    rows: impl IntoIterator<Item = (Cell, &'n Numbers)>,
) -> Table {
    let heads = [
        first,
        one,
        "of carom",
        "off, units of the 4th digit",
        two,
        "of carom",
        "off",
        "cells that stick: CONTACT",
        "carom",
        "that slip: CONTACT",
        "carom",
    ];
    let mut table = Table::new("Number beside number", heads);
    for (first, row) in rows {
        let mut cells = vec![first];
        for (printed, own) in row.printed.into_iter().zip(row.own) {
            cells.extend([printed.into(), own.into(), off_cell(own, printed)]);
        }
        for (printed, own) in row.printed_cells.into_iter().zip(row.own_cells) {
            cells.extend([printed.into(), own.into()]);
        }
        table.row(cells);
    }
    table
}

/// Claims that the two results of these names agree in all printed digits, and the counts of cells in each.
#[track_caller]
pub(super) fn all_agree(figure: &mut Figure, names: [&str; 2], rows: &[&Numbers]) {
    for (which, name) in names.into_iter().enumerate() {
        let pairs = rows.iter().map(|row| (row.own[which], row.printed[which]));
        all_digits(figure, name, pairs).source(SOURCE);
    }
    for (which, name) in ["cells that stick", "cells that slip"].into_iter().enumerate() {
        let pairs = rows.iter().map(|row| (row.own_cells[which], row.printed_cells[which]));
        figure.all_close(name, pairs, Absolute(0.0)).source(SOURCE);
    }
}

/// The cells that stick and that slip, in a panel.
pub(super) fn places(state: &ContactState, mut panel: Panel) -> Panel {
    let (grid, cells) = (state.pressure.grid(), state.cells.values());
    for (label, wanted, colour) in [("slips", CellState::Slip, 1), ("sticks", CellState::Stick, 0)]
    {
        let found = grid.centres().zip(cells).filter(|(_, cell)| **cell == wanted);
        let points: Vec<(f64, f64)> = found.map(|(place, _)| place).collect();
        panel.add(Series::markers(label, Marker::Dot, points).sized(0.6).coloured(colour));
    }
    panel
}

/// The highest pressure.
pub(super) fn highest(rolled: &SteadyRolling) -> f64 {
    rolled.state.pressure.values().iter().copied().fold(0.0, f64::max)
}
