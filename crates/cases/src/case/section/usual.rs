//! Plain numbers that are allowed but unusual, probably in another unit.

use super::{Section, number, parse};
use crate::case::field::{Field, Schema};
use crate::case::shape::SHAPE;
use carom_special::Readable;
use toml::Spanned;
use toml::de::DeValue;

impl Schema {
    /// A sentence for each plain number of a file of this kind that is unusual, in the order of the
    /// fields; empty if the text is not TOML. Numbers with a unit are taken as meant.
    #[must_use]
    pub fn unusual(&self, source: &str) -> Vec<String> {
        let Ok(table) = parse(source) else { return Vec::new() };
        let mut found = Vec::new();
        let top = Section::unread(source, table.get_ref(), self.fields);
        look(&top, &mut found);
        found
    }
}

fn look(section: &Section<'_>, found: &mut Vec<String>) {
    let shape = section.find(&&SHAPE).and_then(|value| value.get_ref().as_str());
    for field in section.fields.iter().filter(|field| field.is_of(shape)) {
        let Some(value) = section.find(&field) else { continue };
        match section.tables(field, value) {
            Some(tables) => tables.iter().for_each(|table| look(table, found)),
            None => found.extend(told(section, field, value)),
        }
    }
}

/// The first unusual number of a value: the number, one of a list, or an end of a range.
fn told(section: &Section<'_>, field: &Field, value: &Spanned<DeValue<'_>>) -> Option<String> {
    let usual = field.usual?;
    let all: Vec<f64> = match value.get_ref() {
        DeValue::Array(items) => items.iter().filter_map(|item| number(item.get_ref())).collect(),
        DeValue::Table(range) => {
            let ends = range
                .iter()
                .filter(|(name, _)| ["start", "stop"].contains(&name.get_ref().as_ref()));
            ends.filter_map(|(_, end)| number(end.get_ref())).collect()
        }
        plain => number(plain).into_iter().collect(),
    };
    // In a range from small to usual angles the small ones are meant.
    let is_meant = all.iter().any(|value| *value != 0.0 && usual.has(*value));
    let value_of = all.into_iter().find(|value| !usual.has(*value)).filter(|_| !is_meant)?;
    Some(format!(
        "line {}: `{}` = {} is unusual: {}",
        section.line_of(value),
        section.full(field.name),
        Readable(value_of),
        usual.words
    ))
}
