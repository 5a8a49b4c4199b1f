//! Columns of results, defined once: name, unit, meaning and value.
//!
//! A result lists its quantities as [`Column`]s. All output is printed from that list:
//! comma-separated values, JSON, tables, axes of plots, help texts. A row of [`Cell`]s combines
//! quantities of several results. This crate contains neither mechanics nor file formats.
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

/// The components of a vector.
const AXES: &[&str] = &["x", "y", "z"];

/// A value in a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// An integer count.
    Count(u64),
    /// Yes or no, printed so.
    Flag(bool),
    /// A text.
    Text(Cow<'static, str>),
    /// A list of words.
    Words(Vec<&'static str>),
    /// A list of texts.
    Texts(Vec<String>),
    /// A vector: one cell for each component of the column.
    Vector([f64; 3]),
    /// The quantity does not exist for this record.
    Absent,
    /// The quantity exists for this record but is undefined (for example 0/0).
    Undefined,
}

/// What the values of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Numbers.
    Number,
    /// Whole numbers.
    Count,
    /// Yes or no.
    Flag,
    /// Texts, words or lists of them.
    Text,
    /// Vectors of three components.
    Vector,
}

/// Anything with a heading: a column, or a cell of a row.
pub trait Quantity {
    /// The name: a word of letters, digits and `_`.
    fn name(&self) -> &str;
    /// The unit; empty for pure numbers and words.
    fn unit(&self) -> &'static str;
    /// The meaning of the quantity, in a few words.
    fn meaning(&self) -> &'static str;
    /// What its values are.
    fn kind(&self) -> Kind;

    /// The components of a vector; empty for anything else.
    fn parts(&self) -> &'static [&'static str] {
        if self.kind() == Kind::Vector { AXES } else { &[] }
    }
}

/// What a quantity is called now that had this name before version 0.1.
#[must_use]
pub fn renamed(name: &str) -> Option<&'static str> {
    match name {
        "maximal_pressure" | "p_max" => Some("peak_pressure"),
        "p_max_error" => Some("peak_pressure_error"),
        _ => None,
    }
}

/// A quantity of one record, with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    name: Cow<'static, str>,
    unit: &'static str,
    meaning: &'static str,
    kind: Kind,
    value: Value,
}

/// A quantity of the records `R`.
#[derive(Debug)]
pub struct Column<R> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    kind: Kind,
    value: fn(&R) -> Value,
}

impl<R> Clone for Column<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Column<R> {}

/// Constructors of a column, one for each kind of values.
macro_rules! constructors {
    ($($(#[$doc:meta])* $constructor:ident: $kind:ident,)*) => {
        impl<R> Column<R> {
            $($(#[$doc])*
            #[must_use]
            pub const fn $constructor(
                name: &'static str,
                unit: &'static str,
                meaning: &'static str,
                value: fn(&R) -> Value,
            ) -> Self {
                Self { name, unit, meaning, kind: Kind::$kind, value }
            })*
        }
    };
}

constructors! {
    /// A column of numbers. `unit` is empty for pure numbers.
    new: Number,
    /// A column of whole numbers.
    count: Count,
    /// A column of flags, which are printed as yes or no.
    flag: Flag,
    /// A column of texts or words.
    text: Text,
    /// A column of vectors, with three components.
    vector: Vector,
}

impl<R> Column<R> {
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

    /// The meaning of the quantity, in a few words.
    #[must_use]
    pub const fn meaning(&self) -> &'static str {
        self.meaning
    }

    /// The value of the quantity for a record.
    #[must_use]
    pub fn value(&self, record: &R) -> Value {
        (self.value)(record)
    }

    /// The cell for a record; without a record its value is absent.
    #[must_use]
    pub fn cell(&self, record: Option<&R>) -> Cell {
        let Self { name, unit, meaning, kind, value } = *self;
        Cell { name: name.into(), unit, meaning, kind, value: record.map_or(Value::Absent, value) }
    }

    /// The label of an axis: `time / s`.
    #[must_use]
    pub fn label(&self) -> String {
        labelled(self.name, self.unit)
    }
}

macro_rules! quantities {
    ($([$($record:ident)?] $quantity:ty,)*) => {
        $(impl<$($record)?> Quantity for $quantity {
            fn name(&self) -> &str {
                &self.name
            }

            fn unit(&self) -> &'static str {
                self.unit
            }

            fn meaning(&self) -> &'static str {
                self.meaning
            }

            fn kind(&self) -> Kind {
                self.kind
            }
        })*
    };
}

quantities! {
    [R] Column<R>,
    [] Cell,
}

impl Cell {
    /// A cell without a column.
    #[must_use]
    pub fn new(
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        meaning: &'static str,
        value: impl Into<Value>,
    ) -> Self {
        Self { name: name.into(), unit, meaning, kind: Kind::Number, value: value.into() }
    }

    /// Gives the cell another value.
    pub fn set_value(&mut self, value: Value) {
        self.value = value;
    }

    /// The value.
    #[must_use]
    pub const fn value(&self) -> &Value {
        &self.value
    }

    /// The same cell with another name.
    #[must_use]
    pub fn named(self, name: impl Into<Cow<'static, str>>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// Adds the texts of the cell, one for each component, with numbers formatted by `number`.
    fn add_texts(&self, number: &impl Fn(f64) -> String, texts: &mut Vec<String>) {
        match &self.value {
            Value::Number(value) => texts.push(number(*value)),
            Value::Count(count) => texts.push(count.to_string()),
            Value::Flag(is) => texts.push(yes_or_no(*is).to_owned()),
            Value::Text(text) => texts.push(text.clone().into_owned()),
            Value::Words(words) => texts.push(words.join(" ")),
            Value::Texts(several) => texts.push(several.join("; ")),
            Value::Vector(parts) => texts.extend(parts.map(number)),
            Value::Absent | Value::Undefined => {
                texts.extend(std::iter::repeat_n(String::new(), self.parts().len().max(1)));
            }
        }
    }
}

/// A flag as it is printed.
#[must_use]
pub const fn yes_or_no(flag: bool) -> &'static str {
    if flag { "yes" } else { "no" }
}

/// The cells of a record; without a record their values are absent.
#[must_use]
pub fn row<R>(columns: &[Column<R>], record: Option<&R>) -> Vec<Cell> {
    columns.iter().map(|column| column.cell(record)).collect()
}

/// The headings of all cells of a row: the name, for a vector one with each component.
#[must_use]
pub fn heads(quantities: &[impl Quantity]) -> Vec<String> {
    parts(quantities).map(|(of, part)| named(of, part)).collect()
}

/// The headings of all cells of a row with their units: `time / s`.
#[must_use]
pub fn labels(quantities: &[impl Quantity]) -> Vec<String> {
    parts(quantities).map(|(of, part)| labelled(&named(of, part), of.unit())).collect()
}

/// The cells of a record as texts, with numbers formatted by `number`; absent values are empty.
#[must_use]
pub fn cells<R>(columns: &[Column<R>], record: &R, number: impl Fn(f64) -> String) -> Vec<String> {
    texts(&row(columns, Some(record)), number)
}

/// The cells of a row as texts, with numbers formatted by `number`; absent values are empty.
#[must_use]
pub fn texts(row: &[Cell], number: impl Fn(f64) -> String) -> Vec<String> {
    let mut texts = Vec::with_capacity(row.len());
    for cell in row {
        cell.add_texts(&number, &mut texts);
    }
    texts
}

/// Each quantity with each of its components.
fn parts<Q: Quantity>(quantities: &[Q]) -> impl Iterator<Item = (&Q, Option<&'static str>)> {
    quantities.iter().flat_map(|of| {
        let whole = of.parts().is_empty().then_some((of, None));
        whole.into_iter().chain(of.parts().iter().map(move |part| (of, Some(*part))))
    })
}

fn named(of: &impl Quantity, part: Option<&str>) -> String {
    part.map_or_else(|| of.name().to_owned(), |part| format!("{}_{part}", of.name()))
}

fn labelled(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} / {unit}") }
}

/// A line for each quantity: name, unit, meaning.
#[must_use]
pub fn described<Q: Quantity>(quantities: &[Q]) -> String {
    let name = |of: &Q| match of.parts() {
        [] => of.name().to_owned(),
        parts => format!("{}_{}", of.name(), parts.join(",_")),
    };
    let names: Vec<String> = quantities.iter().map(name).collect();
    let width = names.iter().map(String::len).max().unwrap_or(0);
    let unit_width = quantities.iter().map(|of| of.unit().len()).max().unwrap_or(0);
    let line = |(name, of): (&String, &Q)| {
        let (unit, meaning) = (of.unit(), of.meaning());
        format!("  {name:<width$}  {unit:<unit_width$}  {meaning}").trim_end().to_owned() + "\n"
    };
    names.iter().zip(quantities).map(line).collect()
}

/// A number with six significant digits, to read.
#[must_use]
pub fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        size if !size.is_finite() || (1e-4..1e6).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

macro_rules! values {
    ($($kind:ty => $variant:ident,)*) => {
        $(impl From<$kind> for Value {
            fn from(value: $kind) -> Self {
                Self::$variant(value.into())
            }
        })*
    };
}

values! {
    f64 => Number,
    u64 => Count,
    bool => Flag,
    &'static str => Text,
    String => Text,
    Vec<&'static str> => Words,
    Vec<String> => Texts,
    [f64; 3] => Vector,
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

    #[test]
    fn a_renamed_cell_keeps_its_unit_and_several_texts_stay_apart() {
        let cell = Cell::new("d", "m", "how far", 2.0).named("distance");
        assert_eq!(labels(&[cell]), ["distance / m"]);
        let notes = Cell::new("notes", "", "", vec!["a, b".to_owned(), "c".to_owned()]);
        assert_eq!(texts(&[notes], |x| x.to_string()), ["a, b; c"]);
    }

    #[test]
    fn numbers_to_read_are_short() {
        for (value, text) in [
            (1.0 / 3.0, "0.333333"),
            (-12345678.0, "-1.23457e7"),
            (1e-5, "1e-5"),
            (-0.0, "0"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(short(value), text);
        }
    }
}
