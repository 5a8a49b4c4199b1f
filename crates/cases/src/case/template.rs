//! New cases: a commented file with every field, in which the necessary fields have values.

use super::field::{Field, Form, Need, Schema, Word};
use super::shape::SHAPE;

/// Maximum number of characters of a line.
const WIDTH: usize = 98;
const HEAD: &str = "SI units; a number may also be a text with its unit, such as \"2.5 mm\". Fields \
                    behind # are optional or alternatives.";
const VARIED: &str = "Any number may be a sweep, as a list or { start, stop, count }, or uncertain, \
                      as { normal = { mean, sd } }, log_normal, { uniform = { low, high } } or \
                      { triangular = { low, mode, high } }; `carom schema impact` has them all.";
const UNKNOWN: &str = "A number may be unknown, as { fit = [low, high] } or { prior = { mean, sd } }: \
                       `carom fit` determines it from data.";

impl Schema {
    /// A commented case of this kind with all its fields, ready to run.
    #[must_use]
    pub fn template(&self) -> String {
        let mut text = String::new();
        comment(&mut text, self.meaning);
        comment(&mut text, HEAD);
        if self.has_sweeps() {
            comment(&mut text, VARIED);
        }
        if !self.varied.is_empty() {
            comment(&mut text, UNKNOWN);
        }
        for field in self.fields {
            add_table(&mut text, field.name, field, begins(field));
        }
        text
    }

    /// A case of this kind with the necessary fields and their units, ready to run.
    #[must_use]
    pub fn short_template(&self) -> String {
        let mut text = String::new();
        comment(&mut text, self.meaning);
        let all = format!("SI units. All fields: `carom schema {}`.", self.name);
        comment(&mut text, &all);
        for field in self.fields.iter().filter(|field| begins(field)) {
            add_short(&mut text, field.name, field);
        }
        text
    }
}

/// Whether a new case has this table: if it is necessary, or if it says how it begins where it is one of
/// several.
const fn begins(field: &Field) -> bool {
    match field.need {
        Need::Must => true,
        Need::Or(_) => !field.begun.is_empty(),
        _ => false,
    }
}

/// The fields that a new case sets in a table.
struct Begun<'a> {
    table: &'a Field,
    shape: Option<String>,
}

impl<'a> Begun<'a> {
    fn of(table: &'a Field) -> Self {
        let mut begun = Self { table, shape: None };
        let shape = table.fields().iter().find(|field| field.name == SHAPE.name);
        begun.shape = shape.map(|field| begun.value(field).trim_matches('"').to_owned());
        begun
    }

    fn set(&self, field: &Field) -> Option<&'static str> {
        let found = self.table.begun.iter().find(|(begun, _)| begun.name == field.name);
        found.map(|(_, value)| *value)
    }

    fn value(&self, field: &Field) -> String {
        value(field, self.set(field))
    }

    fn has(&self, field: &Field) -> bool {
        let is_needed = self.set(field).is_some() || matches!(field.need, Need::Must);
        is_needed && field.is_of(self.shape.as_deref())
    }

    /// Plain fields first, then tables.
    fn fields(&self) -> (Vec<&'a Field>, Vec<&'a Field>) {
        self.table.fields().iter().partition(|field| field.fields().is_empty())
    }
}

fn head(path: &str, table: &Field) -> String {
    match table.form {
        Form::Tables(_) => format!("[[{path}]]"),
        _ => format!("[{path}]"),
    }
}

/// Adds a table with its fields, then its tables; commented out unless `active`.
fn add_table(text: &mut String, path: &str, table: &Field, is_active: bool) {
    text.push('\n');
    comment(text, &capital(&described(table)));
    line(text, &head(path, table), is_active);
    let begun = Begun::of(table);
    let (fields, tables) = begun.fields();
    for field in fields {
        comment(text, &capital(&described(field)));
        let set = format!("{} = {}", field.name, begun.value(field));
        line(text, &set, is_active && begun.has(field));
    }
    for field in tables {
        let path = format!("{path}.{}", field.name);
        add_table(text, &path, field, is_active && begun.has(field));
    }
}

/// Adds a table with the fields that it begins with and their units, then its tables.
fn add_short(text: &mut String, path: &str, table: &Field) {
    text.push('\n');
    line(text, &head(path, table), true);
    let begun = Begun::of(table);
    let (fields, tables) = begun.fields();
    for field in fields.into_iter().filter(|field| begun.has(field)) {
        let unit = field.measure().map_or("", |measure| measure.dimension.unit());
        let note = if unit.is_empty() { String::new() } else { format!("  # {unit}") };
        line(text, &format!("{} = {}{note}", field.name, begun.value(field)), true);
    }
    for field in tables.into_iter().filter(|field| begun.has(field)) {
        add_short(text, &format!("{path}.{}", field.name), field);
    }
}

/// The value of a field in a new case.
fn value(field: &Field, begun: Option<&str>) -> String {
    let example = match begun {
        Some(value) if !value.is_empty() => value,
        _ => field.example,
    };
    match example {
        "" => field.default_text().unwrap_or_default(),
        example => example.to_owned(),
    }
}

/// Meaning, unit, range, shapes and default of a field.
pub(super) fn described(field: &Field) -> String {
    let mut parts = vec![field.meaning.to_owned()];
    let unit = field.measure().map_or("", |measure| measure.dimension.unit());
    let range = field.measure().map(|measure| match (unit, measure.range.allowed()) {
        ("", range) => range.to_owned(),
        (unit, range) => format!("{unit}, {range}"),
    });
    match (field.form, range) {
        (Form::Table(_) | Form::Tables(_) | Form::Switch, _) => {}
        (Form::Word(words), _) => parts.push(told(words)),
        (Form::WordOrVector(words, ..), Some(_)) => {
            parts.push(format!("{}, or a list, {unit}", told(words)));
        }
        (Form::Numbers(_), Some(range)) => parts.push(format!("{range}; one or several")),
        (_, Some(range)) => parts.push(range),
        (_, None) => parts.push(field.allowed()),
    }
    if !field.shapes.is_empty() {
        parts.push(format!("of shape {}", field.shapes.join(", ")));
    }
    match (field.need, field.default_text()) {
        (Need::Or(others), _) => parts.push(format!("or {others}")),
        (Need::May(absent), _) => parts.push(format!("without it {absent}")),
        (_, Some(default)) => parts.push(format!("without it {default}")),
        (_, None) => {}
    }
    parts.join("; ")
}

/// Words with their meanings.
fn told(words: &[Word]) -> String {
    let words = words.iter().map(|(word, meaning)| format!("{word:?} ({meaning})"));
    words.collect::<Vec<_>>().join(", ")
}

pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn line(text: &mut String, line: &str, is_active: bool) {
    let sign = if is_active { "" } else { "#" };
    text.push_str(&format!("{sign}{line}\n"));
}

/// Adds a wrapped comment.
fn comment(text: &mut String, words: &str) {
    let mut line = String::from("#");
    for word in words.split_whitespace() {
        if line.chars().count() + 1 + word.chars().count() > WIDTH {
            text.push_str(&line);
            text.push('\n');
            line = String::from("#");
        }
        line.push(' ');
        line.push_str(word);
    }
    text.push_str(&line);
    text.push('\n');
}
