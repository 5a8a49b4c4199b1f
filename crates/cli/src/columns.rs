//! Results from their columns: rows in every format.

use crate::error::CliError;
use crate::output::{Format, check_finite, csv, short, table};
use carom_table::{Column, Value, cells, described, heads, labels};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::path::Path;

/// A record as a map of its columns; what is absent is left out.
#[derive(Debug)]
pub struct Record<'a, R> {
    columns: &'a [Column<R>],
    record: &'a R,
}

impl<'a, R> Record<'a, R> {
    /// These columns of a record.
    #[must_use]
    pub const fn new(columns: &'a [Column<R>], record: &'a R) -> Self {
        Self { columns, record }
    }
}

impl<R> Serialize for Record<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for column in self.columns {
            let name = column.name();
            match column.value(self.record) {
                // JSON has no infinity: the word stands for it.
                Value::Number(value) if value.is_infinite() => {
                    map.serialize_entry(name, if value > 0.0 { "inf" } else { "-inf" })?;
                }
                Value::Number(value) => map.serialize_entry(name, &value)?,
                Value::Count(count) => map.serialize_entry(name, &count)?,
                Value::Text(text) => map.serialize_entry(name, &text)?,
                Value::Words(words) => map.serialize_entry(name, &words)?,
                Value::Vector(parts) => map.serialize_entry(name, &parts)?,
                Value::Absent => {}
            }
        }
        map.end()
    }
}

/// The records as rows: comma-separated values with all digits, or a table to read; nothing in
/// the other formats.
///
/// # Errors
/// If they cannot be put so.
pub fn rows<R>(format: Format, columns: &[Column<R>], records: &[R]) -> Result<String, CliError> {
    let rows = |number: fn(f64) -> String| -> Vec<Vec<String>> {
        records.iter().map(|record| cells(columns, record, number)).collect()
    };
    match format {
        Format::Csv => csv(&heads(columns), &rows(|value| value.to_string())),
        Format::Table => Ok(table(&labels(columns), &rows(short))),
        Format::Json | Format::None => Ok(String::new()),
    }
}

/// Refuses numbers that are not finite.
///
/// # Errors
/// [`CliError::Overflow`] that names the first.
pub fn check<R>(path: &Path, columns: &[Column<R>], records: &[R]) -> Result<(), CliError> {
    let rows: Vec<_> =
        records.iter().map(|record| cells(columns, record, |value| value.to_string())).collect();
    check_finite(path, &heads(columns), &rows)
}

/// A paragraph of help that says what the columns are.
#[must_use]
pub fn help<R>(title: &str, columns: &[Column<R>]) -> String {
    format!("{title}:\n{}", described(columns))
}
