//! New cases: a commented file with every field, in which the necessary fields have values.

use super::field::{Field, Form, Need, Word};
use super::kind::CaseKind;

/// Maximum number of characters of a line.
const WIDTH: usize = 98;
const HEAD: &str = "SI units; a number may also be a text with its unit, such as \"2.5 mm\". Fields \
                    behind # are optional or alternatives.";
const VARIED: &str = "Any number may be a sweep, as a list or { start, stop, count }, or uncertain, \
                      as { normal = { mean, sd } }, log_normal, { uniform = { low, high } } or \
                      { triangular = { low, mode, high } }; `carom schema impact` has them all.";

impl CaseKind {
    /// A commented case of this kind with all its fields, ready to run.
    #[must_use]
    pub fn begin(self) -> String {
        let mut text = String::new();
        comment(&mut text, self.meaning());
        comment(&mut text, HEAD);
        if !self.varied().is_empty() {
            comment(&mut text, VARIED);
        }
        for field in self.fields() {
            // Of tables that replace one another the one that says how it begins.
            let is_active = match field.need {
                Need::Must => true,
                Need::Or(_) => !field.begun.is_empty(),
                _ => false,
            };
            add_table(&mut text, field.name, field, is_active);
        }
        text
    }
}

/// Adds a table with its fields, then its tables; commented out unless `active`.
fn add_table(text: &mut String, path: &str, table: &Field, is_active: bool) {
    text.push('\n');
    comment(text, &capital(&described(table)));
    let head = match table.form {
        Form::Tables(_) => format!("[[{path}]]"),
        _ => format!("[{path}]"),
    };
    line(text, &head, is_active);
    let begun = |field: &Field| {
        let found = table.begun.iter().find(|(begun, _)| begun.name == field.name);
        found.map(|(_, value)| *value)
    };
    let all = table.fields();
    let shape = all.iter().find(|field| field.name == super::body::SHAPE.name);
    let shape = shape.map(|field| value(field, begun(field)).trim_matches('"').to_owned());
    let is_here = |field: &Field| {
        let is_needed = begun(field).is_some() || matches!(field.need, Need::Must);
        is_active && is_needed && field.is_of(shape.as_deref())
    };
    let (tables, fields): (Vec<_>, Vec<_>) =
        all.iter().partition(|field| !field.fields().is_empty());
    for field in fields {
        comment(text, &capital(&described(field)));
        line(text, &format!("{} = {}", field.name, value(field, begun(field))), is_here(field));
    }
    for field in tables {
        add_table(text, &format!("{path}.{}", field.name), field, is_here(field));
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
fn described(field: &Field) -> String {
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

fn capital(text: &str) -> String {
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
