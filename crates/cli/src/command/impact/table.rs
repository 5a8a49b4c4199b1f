//! The outcome of an impact as tables.

use super::view::Record;
use crate::columns;
use crate::error::CliError;
use crate::output::Format;
use crate::page::Page;
use carom_cases::case::ImpactCase;
use carom_impact::{HistoryPoint, ImpactFriction, LogEntry, Motion};
use carom_table::{Cell, row};

/// Columns of a sweep in a table, beside the swept number.
pub(super) const OF_SWEEP: [&str; 11] = [
    "outcome",
    "R_x",
    "body_1_velocity_x",
    "body_1_velocity_z",
    "body_1_spin_y",
    "body_1_speed",
    "body_1_angle",
    "duration",
    "peak_pressure",
    "pressure_over_yield",
    "regimes",
];

/// Instead of a rebound.
pub(super) const NO_IMPACT: &str = "no impact: the bodies do not approach each other\n\
    (body 1 lies on the side to which `z_axis` points: exchange the bodies, or change the sign of a velocity)\n";

/// The column of friction in the table of a sweep, if friction depends on the slip speed.
pub(super) const fn friction(case: &ImpactCase) -> &'static [&'static str] {
    match case.contact.friction {
        ImpactFriction::Constant(_) | ImpactFriction::Static(_) => &[],
        ImpactFriction::SlipSpeed(_) => &["friction"],
    }
}

/// One impact in full: contact point, motions, outcome, regimes and history.
pub(super) fn one(page: Page, record: &Record) -> Result<String, CliError> {
    let mut text = columns::upright(page, &record.contact()) + &motions(page, record)?;
    match record.rebound() {
        None => text.insert_str(0, NO_IMPACT),
        Some(rebound) => {
            text.push_str(&columns::upright(page, &record.quantities()));
            text.push_str(&events(page, record, rebound.duration)?);
        }
    }
    if let Some(points) = &record.history {
        text.push_str(&columns::rows(Format::Table(page), HistoryPoint::COLUMNS, points)?);
    }
    Ok(text)
}

fn motions(page: Page, record: &Record) -> Result<String, CliError> {
    let [before, after] = record.motions();
    let line = |i: usize, when: &'static str, motion: &Motion| {
        let words = [
            Cell::new("body", "", "1 or 2", i as u64 + 1),
            Cell::new("when", "", "before or after the impact", when),
        ];
        words.into_iter().chain(row(Motion::COLUMNS, Some(motion))).collect()
    };
    let rows: Vec<Vec<Cell>> =
        (0..2).flat_map(|i| [line(i, "before", &before[i]), line(i, "after", &after[i])]).collect();
    columns::cell_rows(Format::Table(page), &rows)
}

fn events(page: Page, record: &Record, duration: f64) -> Result<String, CliError> {
    let line = |entry: &LogEntry| {
        let mut cells = row(LogEntry::COLUMNS, Some(entry));
        let part = format!("{:.2}", 100.0 * entry.time / duration);
        cells.insert(1, Cell::new("part", "%", "of the duration", part));
        cells
    };
    columns::cell_rows(Format::Table(page), &record.events().iter().map(line).collect::<Vec<_>>())
}
