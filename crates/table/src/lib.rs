//! Columns of results, written once: name, unit, meaning and value.
//!
//! A result says what it holds as a list of [`Column`]s. Whatever shows it (comma-separated values,
//! JSON, a table to read, the axis of a picture, a page of help) is printed from that list. This
//! crate knows neither mechanics nor formats.
//!
//! ```
//! use carom_table::{Column, cells, heads};
//! struct Bounce { time: f64, velocity: [f64; 3], wall: &'static str }
//! const BOUNCES: &[Column<Bounce>] = &[
//!     Column::new("time", "s", "since the start", |bounce| bounce.time.into()),
//!     Column::vector("velocity", "m/s", "afterwards", |bounce| bounce.velocity.into()),
//!     Column::new("wall", "", "that it meets", |bounce| bounce.wall.into()),
//! ];
//! assert_eq!(heads(BOUNCES), ["time", "velocity_x", "velocity_y", "velocity_z", "wall"]);
//! let bounce = Bounce { time: 0.5, velocity: [1.0, 0.0, 2.0], wall: "floor" };
//! assert_eq!(cells(BOUNCES, &bounce, |x| x.to_string()), ["0.5", "1", "0", "2", "floor"]);
//! assert_eq!(BOUNCES[0].label(), "time / s");
//! ```
#![forbid(unsafe_code)]

use std::borrow::Cow;

/// The parts of a vector.
const AXES: &[&str] = &["x", "y", "z"];

/// A value in a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A number of things.
    Count(u64),
    /// A word or text.
    Text(Cow<'static, str>),
    /// Several words.
    Words(Vec<&'static str>),
    /// A vector: as many cells as the column has parts.
    Vector([f64; 3]),
    /// Nothing, where this record has none.
    Absent,
}

/// One quantity of the records `R`.
#[derive(Debug)]
pub struct Column<R> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    parts: &'static [&'static str],
    value: fn(&R) -> Value,
}

impl<R> Clone for Column<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Column<R> {}

impl<R> Column<R> {
    /// A column of numbers or words. `unit` is empty for pure numbers and words.
    #[must_use]
    pub const fn new(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: fn(&R) -> Value,
    ) -> Self {
        Self { name, unit, meaning, parts: &[], value }
    }

    /// A column of vectors, three cells wide.
    #[must_use]
    pub const fn vector(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: fn(&R) -> Value,
    ) -> Self {
        Self { name, unit, meaning, parts: AXES, value }
    }

    /// The name: a word of letters, digits and `_`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The unit; empty for pure numbers and words.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        self.unit
    }

    /// What it is, in a few words.
    #[must_use]
    pub const fn meaning(&self) -> &'static str {
        self.meaning
    }

    /// The value of a record.
    #[must_use]
    pub fn value(&self, record: &R) -> Value {
        (self.value)(record)
    }

    /// The heads of its cells: the name, for a vector with each of its parts.
    pub fn heads(&self) -> impl Iterator<Item = String> {
        let (name, parts) = (self.name, self.parts);
        let single = parts.is_empty().then(|| name.to_owned());
        single.into_iter().chain(parts.iter().map(move |part| format!("{name}_{part}")))
    }

    /// The label of an axis: `time / s`.
    #[must_use]
    pub fn label(&self) -> String {
        match self.unit {
            "" => self.name.to_owned(),
            unit => format!("{} / {unit}", self.name),
        }
    }

    /// Its cells of a record, numbers written by `number`; what is absent is empty.
    fn add_cells(&self, record: &R, number: &impl Fn(f64) -> String, cells: &mut Vec<String>) {
        match self.value(record) {
            Value::Number(value) => cells.push(number(value)),
            Value::Count(count) => cells.push(count.to_string()),
            Value::Text(text) => cells.push(text.into_owned()),
            Value::Words(words) => cells.push(words.join(" ")),
            Value::Vector(parts) => cells.extend(parts.map(number)),
            Value::Absent => {
                cells.extend(std::iter::repeat_n(String::new(), self.parts.len().max(1)));
            }
        }
    }
}

/// The heads of all cells of a row.
#[must_use]
pub fn heads<R>(columns: &[Column<R>]) -> Vec<String> {
    columns.iter().flat_map(Column::heads).collect()
}

/// The heads of all cells of a row, with their units: `time / s`.
#[must_use]
pub fn labels<R>(columns: &[Column<R>]) -> Vec<String> {
    let labels = columns.iter().flat_map(|column| {
        column.heads().map(|head| match column.unit {
            "" => head,
            unit => format!("{head} / {unit}"),
        })
    });
    labels.collect()
}

/// The cells of a record, numbers written by `number`; what is absent is empty.
#[must_use]
pub fn cells<R>(columns: &[Column<R>], record: &R, number: impl Fn(f64) -> String) -> Vec<String> {
    let mut cells = Vec::with_capacity(columns.len());
    for column in columns {
        column.add_cells(record, &number, &mut cells);
    }
    cells
}

/// A line for each column: name, unit, meaning.
#[must_use]
pub fn described<R>(columns: &[Column<R>]) -> String {
    let name = |column: &Column<R>| match column.parts {
        [] => column.name.to_owned(),
        parts => format!("{}_{}", column.name, parts.join(",_")),
    };
    let width = columns.iter().map(|column| name(column).len()).max().unwrap_or(0);
    let unit_width = columns.iter().map(|column| column.unit.len()).max().unwrap_or(0);
    let line = |column: &Column<R>| {
        let (name, unit, meaning) = (name(column), column.unit, column.meaning);
        format!("  {name:<width$}  {unit:<unit_width$}  {meaning}").trim_end().to_owned() + "\n"
    };
    columns.iter().map(line).collect()
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<u64> for Value {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<&'static str> for Value {
    fn from(word: &'static str) -> Self {
        Self::Text(Cow::Borrowed(word))
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(Cow::Owned(text))
    }
}

impl From<Vec<&'static str>> for Value {
    fn from(words: Vec<&'static str>) -> Self {
        Self::Words(words)
    }
}

impl From<[f64; 3]> for Value {
    fn from(parts: [f64; 3]) -> Self {
        Self::Vector(parts)
    }
}

impl<T: Into<Self>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Absent, Into::into)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Record {
        size: Option<f64>,
        force: Option<[f64; 3]>,
    }

    const COLUMNS: &[Column<Record>] = &[
        Column::new("size", "m", "how large", |record| record.size.into()),
        Column::vector("force", "N", "how strong", |record| record.force.into()),
        Column::new("names", "", "who", |_| vec!["a", "b"].into()),
    ];

    #[test]
    fn what_is_absent_keeps_its_place() {
        let record = Record { size: None, force: None };
        assert_eq!(cells(COLUMNS, &record, |x| x.to_string()), ["", "", "", "", "a b"]);
        assert_eq!(labels(COLUMNS)[..2], ["size / m", "force_x / N"]);
        assert_eq!(heads(COLUMNS), ["size", "force_x", "force_y", "force_z", "names"]);
    }

    #[test]
    fn columns_describe_themselves() {
        let lines = described(COLUMNS);
        assert_eq!(
            lines.lines().collect::<Vec<_>>(),
            [
                "  size           m  how large",
                "  force_x,_y,_z  N  how strong",
                "  names             who",
            ]
        );
    }
}
