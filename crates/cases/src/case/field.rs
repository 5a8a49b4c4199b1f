//! Fields of case files, each defined once: name, kind, range, unit, default and meaning. The reader, its
//! error messages, `carom new`, `carom check` and `carom schema` all use these definitions.

use super::range::End;
use super::section::START;
use super::unit::Measure;
use carom_table::{Column, Value};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// A field of a case file.
#[derive(Debug, Clone, Copy)]
pub struct Field {
    /// Its name in the table that holds it.
    pub name: &'static str,
    /// The kind of its value.
    pub form: Form,
    /// Whether it is necessary, and its default if it is not.
    pub need: Need,
    /// Its meaning in a few words.
    pub meaning: &'static str,
    /// An example value as TOML; the default if it is empty.
    pub(super) example: &'static str,
    /// The shapes that have this field; empty for all.
    pub(super) shapes: &'static [&'static str],
    /// Fields that a new case sets in this table, beside the necessary ones, with their values; an empty
    /// value stands for the example.
    pub(super) begun: &'static [(&'static Field, &'static str)],
    /// Plain numbers that are usual, if others are probably in another unit.
    pub(super) usual: Option<Usual>,
}

/// Plain numbers that are usual in a field; zero and infinity always are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Usual {
    /// The smallest.
    pub(super) low: f64,
    /// The largest.
    pub(super) high: f64,
    /// What to keep in mind, in words.
    pub(super) words: &'static str,
}

impl Usual {
    /// Coefficients of friction.
    pub(super) const FRICTION: Self = Self {
        low: 1e-4,
        high: 3.0,
        words: "most pairs have 0.05 to 1.5 (a percentage is divided by 100)",
    };
    /// Densities.
    pub(super) const DENSITY: Self =
        Self { low: 20.0, high: 23_000.0, words: "it is in kg/m3, and steel has 7850" };
    /// Angles of incidence; smaller ones are probably radians.
    pub(super) const INCIDENCE: Self =
        Self { low: 1.6, high: 90.0, words: "it is in degrees; \"0.785 rad\" is 45" };
    /// Radii of bodies.
    pub(super) const RADIUS: Self =
        Self { low: 1e-7, high: 5.0, words: "it is in m; \"10 mm\" is 0.01" };
    /// Semi-axes of contacts.
    pub(super) const SEMI_AXIS: Self =
        Self { low: 1e-9, high: 0.5, words: "it is in m; \"6 mm\" is 0.006" };
    /// Moduli of elasticity.
    pub(super) const MODULUS: Self =
        Self { low: 1e3, high: 2e12, words: "it is in Pa; \"208 GPa\" is steel" };

    /// Yield stresses and hardnesses.
    pub(super) const STRENGTH: Self = Self {
        low: 1e5,
        high: 2e11,
        words: "it is in Pa; steel yields at \"300 MPa\" to \"2 GPa\"",
    };

    /// Whether the number is usual.
    pub(super) fn has(self, value: f64) -> bool {
        let size = value.abs();
        size == 0.0 || size.is_infinite() || (self.low..=self.high).contains(&size)
    }
}

/// A word with its meaning.
pub type Word = (&'static str, &'static str);

/// The kind of value of a field.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A number; in an impact also a sweep or a distribution.
    Number(Measure),
    /// A number, a list, or a range with a count.
    Numbers(Measure),
    /// A number, or a list of two.
    Pair(Measure),
    /// A list of numbers, at least one.
    List(Measure),
    /// A list with one number for each component, with a description.
    Vector(&'static [&'static str], Measure, &'static str),
    /// One of these words, or a list with one number for each component.
    WordOrVector(&'static [Word], &'static [&'static str], Measure, &'static str),
    /// A list of rows of numbers.
    Rows(Rows),
    /// One of these words.
    Word(&'static [Word]),
    /// Any text, and what it is.
    Text(&'static str),
    /// Any text, with a description.
    Switch,
    /// A table.
    Table(&'static [Field]),
    /// Tables of one kind, at least one.
    Tables(&'static [Field]),
}

/// Rows of numbers.
#[derive(Debug, Clone, Copy)]
pub struct Rows {
    /// The columns of a row.
    pub parts: &'static [&'static str],
    /// Their ranges.
    pub measures: &'static [Measure],
    /// Number of columns at the end that may be omitted; they are then 0.
    pub optional: usize,
    /// Minimum number of rows.
    pub least: usize,
    /// A description of the rows.
    pub words: &'static str,
}

/// Whether a field is necessary.
#[derive(Debug, Clone, Copy)]
pub enum Need {
    /// It is necessary.
    Must,
    /// It, or the alternative that the text names.
    Or(&'static str),
    /// Optional, with this default.
    Default(Default),
    /// Optional; the text says what its absence means.
    May(&'static str),
}

/// The default of an optional field.
#[derive(Debug, Clone, Copy)]
pub enum Default {
    /// A number, in the base unit.
    Number(f64),
    /// Numbers.
    List(&'static [f64]),
    /// A word.
    Word(&'static str),
    /// False.
    False,
}

/// The axes of a vector.
pub(super) const AXES: &[&str] = &["x", "y", "z"];
/// The same, described in words.
pub(super) const XYZ: &str = "three numbers [x, y, z]";

impl Field {
    pub(super) const fn new(name: &'static str, form: Form, meaning: &'static str) -> Self {
        let (need, example, shapes, begun): (_, _, &[_], &[_]) = (Need::Must, "", &[], &[]);
        Self { name, form, need, meaning, example, shapes, begun, usual: None }
    }

    pub(super) const fn number(
        name: &'static str,
        measure: Measure,
        meaning: &'static str,
    ) -> Self {
        Self::new(name, Form::Number(measure), meaning)
    }

    pub(super) const fn vector(
        name: &'static str,
        measure: Measure,
        meaning: &'static str,
    ) -> Self {
        Self::new(name, Form::Vector(AXES, measure, XYZ), meaning)
    }

    pub(super) const fn such_as(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

    pub(super) const fn or(self, others: &'static str) -> Self {
        Self { need: Need::Or(others), ..self }
    }

    pub(super) const fn may(self, absent: &'static str) -> Self {
        Self { need: Need::May(absent), ..self }
    }

    pub(super) const fn default(self, default: Default) -> Self {
        Self { need: Need::Default(default), ..self }
    }

    pub(super) const fn usually(self, usual: Usual) -> Self {
        Self { usual: Some(usual), ..self }
    }

    pub(super) const fn of(self, shapes: &'static [&'static str]) -> Self {
        Self { shapes, ..self }
    }

    pub(super) const fn begun(self, begun: &'static [(&'static Self, &'static str)]) -> Self {
        Self { begun, ..self }
    }

    /// The field with another range or unit.
    pub(super) const fn measured(self, measure: Measure) -> Self {
        Self { form: Form::Number(measure), ..self }
    }

    /// Whether this shape has the field.
    pub(super) fn is_of(&self, shape: Option<&str>) -> bool {
        self.shapes.is_empty() || shape.is_none_or(|shape| self.shapes.contains(&shape))
    }

    /// The fields of a table; empty for other kinds.
    #[must_use]
    pub const fn fields(&self) -> &'static [Self] {
        match self.form {
            Form::Table(fields) | Form::Tables(fields) => fields,
            _ => &[],
        }
    }

    /// The range of its numbers.
    #[must_use]
    pub const fn measure(&self) -> Option<Measure> {
        match self.form {
            Form::Number(measure)
            | Form::Numbers(measure)
            | Form::Pair(measure)
            | Form::List(measure)
            | Form::Vector(_, measure, _)
            | Form::WordOrVector(_, _, measure, _) => Some(measure),
            _ => None,
        }
    }

    /// The allowed values, in words.
    #[must_use]
    pub fn allowed(&self) -> String {
        match self.form {
            Form::Number(measure) | Form::Numbers(measure) => measure.range.allowed().to_owned(),
            Form::Pair(_) => "one number, or two in a list".to_owned(),
            Form::List(_) => "a list with at least one number".to_owned(),
            Form::Vector(_, _, words) => words.to_owned(),
            Form::WordOrVector(words, _, _, vector) => {
                format!("{} or {vector}", quoted(words, ", "))
            }
            Form::Rows(rows) => rows.words.to_owned(),
            Form::Word(words) => quoted(words, " or "),
            Form::Text(words) => words.to_owned(),
            Form::Switch => "true or false".to_owned(),
            Form::Table(_) => "a table".to_owned(),
            Form::Tables(_) => {
                "at least one table, headed by the name in double brackets".to_owned()
            }
        }
    }

    /// The default as written in a case; none if there is none.
    #[must_use]
    pub fn default_text(&self) -> Option<String> {
        let Need::Default(default) = self.need else { return None };
        Some(match default {
            Default::Number(number) => number.to_string(),
            Default::List(numbers) => format!("{numbers:?}"),
            Default::Word(word) => format!("{word:?}"),
            Default::False => "false".to_owned(),
        })
    }
}

/// Words in quotation marks, with `last` before the last one.
fn quoted(words: &[Word], last: &str) -> String {
    if let [(word, why)] = words {
        return format!("{word:?} ({why})");
    }
    let words: Vec<String> = words.iter().map(|(word, _)| format!("{word:?}")).collect();
    match words.split_last() {
        Some((end, before)) => format!("{}{last}{end}", before.join(", ")),
        None => String::new(),
    }
}

/// A field with its path.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The names of its tables and its own, joined by dots; `[]` marks arrays of tables.
    pub path: String,
    /// The field.
    pub field: Field,
}

/// The name and the fields of a kind of case.
#[derive(Debug, Clone, Copy)]
pub struct Schema {
    /// The command that takes it.
    pub name: &'static str,
    /// Its description, a sentence.
    pub meaning: &'static str,
    /// Its fields.
    pub fields: &'static [Field],
    /// The forms that may replace any of its numbers, except those of `[uncertainty]`.
    pub varied: &'static [Field],
}

impl Schema {
    pub(super) const fn new(
        name: &'static str,
        meaning: &'static str,
        fields: &'static [Field],
    ) -> Self {
        Self { name, meaning, fields, varied: &[] }
    }

    /// The same kind, of which these forms may replace any number.
    pub(super) const fn varying(self, varied: &'static [Field]) -> Self {
        Self { varied, ..self }
    }

    /// Whether a number may be a sweep or a distribution.
    pub(super) fn has_sweeps(&self) -> bool {
        self.varied.iter().any(|form| form.name == START.name)
    }

    /// Its fields with their paths. The forms that may replace a number come last, under `*`.
    #[must_use]
    pub fn entries(&self) -> Vec<Entry> {
        let mut all = entries(self.fields);
        let forms = entries(self.varied).into_iter();
        all.extend(forms.map(|entry| Entry { path: format!("*.{}", entry.path), ..entry }));
        all
    }
}

/// All fields, each table followed by its own fields.
#[must_use]
pub fn entries(fields: &[Field]) -> Vec<Entry> {
    let mut found = Vec::new();
    add("", fields, &mut found);
    found
}

fn add(prefix: &str, fields: &[Field], found: &mut Vec<Entry>) {
    for field in fields {
        let path = match field.form {
            Form::Tables(_) => format!("{prefix}{}[]", field.name),
            _ => format!("{prefix}{}", field.name),
        };
        found.push(Entry { path: path.clone(), field: *field });
        add(&format!("{path}."), field.fields(), found);
    }
}

impl Entry {
    /// The columns of a schema.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::text("field", "", "name with its path", |entry| entry.path.clone().into()),
        Column::text("kind", "", "kind of the value", |entry| entry.kind().into()),
        Column::text("allowed", "", "allowed values in words", |entry| {
            match entry.field.measure() {
                Some(measure) => measure.range.allowed().into(),
                None => entry.field.allowed().into(),
            }
        }),
        Column::text("unit", "", "unit of a plain number", |entry| match entry.field.form {
            Form::Rows(rows) => rows
                .measures
                .iter()
                .map(|measure| measure.dimension.unit())
                .collect::<Vec<_>>()
                .into(),
            _ => entry.field.measure().map_or("", |measure| measure.dimension.unit()).into(),
        }),
        Column::text("need", "", "must, or (one of several), may", |entry| {
            match entry.field.need {
                Need::Must => "must".into(),
                Need::Or(_) => "or".into(),
                Need::Default(_) | Need::May(_) => "may".into(),
            }
        }),
        Column::text("default", "", "value if the field is missing", |entry| {
            entry.field.default_text().into()
        }),
        Column::text("shapes", "", "shapes that have this field", |entry| {
            match entry.field.shapes {
                [] => Value::Absent,
                shapes => shapes.to_vec().into(),
            }
        }),
        Column::text("meaning", "", "meaning of the field", |entry| entry.field.meaning.into()),
        Column::text("words", "", "allowed words", |entry| match entry.field.form {
            Form::Word(words) | Form::WordOrVector(words, ..) => {
                words.iter().map(|(word, _)| *word).collect::<Vec<_>>().into()
            }
            _ => Value::Absent,
        }),
        Column::new("low", "", "lower end", |entry| entry.end(0).map(End::number).into()),
        Column::flag("low_is_in", "", "whether the lower end is allowed", |entry| entry.is_in(0)),
        Column::new("high", "", "upper end", |entry| entry.end(1).map(End::number).into()),
        Column::flag("high_is_in", "", "whether the upper end is allowed", |entry| entry.is_in(1)),
    ];

    /// The columns of a schema that fit a printed table.
    #[must_use]
    pub fn readable() -> &'static [Column<Self>] {
        &Self::COLUMNS[..8]
    }

    const fn kind(&self) -> &'static str {
        match self.field.form {
            Form::Number(Measure { range, .. }) if range.is_whole() => "whole number",
            Form::Number(_) => "number",
            Form::Numbers(_) => "number, list or range",
            Form::Pair(_) => "number or two",
            Form::List(_) => "list",
            Form::Vector(_, _, words) => words,
            Form::WordOrVector(..) => "word or numbers",
            Form::Rows(_) => "rows",
            Form::Word(_) => "word",
            Form::Text(_) => "text",
            Form::Switch => "true or false",
            Form::Table(_) => "table",
            Form::Tables(_) => "tables",
        }
    }

    fn end(&self, which: usize) -> Option<End> {
        self.field.measure().map(|measure| measure.range.ends()[which])
    }

    fn is_in(&self, which: usize) -> Value {
        self.end(which).map(|end| matches!(end, End::In(_))).into()
    }
}

/// The path of a field, or of a component of one, as a static text; an unknown path gives "a number of the
/// case".
pub(super) fn interned(fields: &[Field], path: &str) -> &'static str {
    static PATHS: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let is_known = entries(fields).into_iter().any(|Entry { path: own, field }| {
        let parts = match field.form {
            Form::Vector(parts, ..) | Form::WordOrVector(_, parts, ..) => parts,
            _ => &[],
        };
        own == path || parts.iter().any(|part| format!("{own}.{part}") == path)
    });
    if !is_known {
        return "a number of the case";
    }
    let mut paths = PATHS.lock().unwrap_or_else(PoisonError::into_inner);
    match paths.get(path) {
        Some(kept) => kept,
        None => {
            let kept: &'static str = Box::leak(path.to_owned().into_boxed_str());
            paths.insert(kept);
            kept
        }
    }
}
