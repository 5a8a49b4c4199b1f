//! All errors of a case at once. The reader of a kind stops at its first error; then every table is gone
//! through with its declared fields, and whatever is unknown, of a wrong value or missing is reported.

use super::error::meant as of_others;
use super::{Section, not_toml, parse};
use crate::case::error::{CaseError, CaseFault};
use crate::case::field::{Field, Form, Need, Schema, Word};
use crate::case::shape::SHAPE;
use crate::case::unit::Measure;
use carom_special::nearest;
use toml::Spanned;
use toml::de::DeValue;

/// The errors of a case that its reader rejected with `first`.
pub(in crate::case) fn all(schema: &Schema, source: &str, first: CaseError) -> CaseError {
    if let CaseFault::Syntax { column, message } = first.fault {
        let message = not_toml::told(schema.name, source, first.line, column, message);
        return CaseFault::Syntax { column, message }.at("", first.line);
    }
    let mut errors = survey(schema, source);
    match errors.iter_mut().find(|error| !first.field.is_empty() && error.field == first.field) {
        // The reader's own text, which may say more.
        Some(error) => *error = first,
        None => errors.push(first),
    }
    match errors.len() {
        1 => errors.swap_remove(0),
        _ => CaseFault::Several(errors).at("", 0),
    }
}

/// The errors that the declared fields tell: unknown fields and wrong values first, then missing fields.
pub(in crate::case) fn survey(schema: &Schema, source: &str) -> Vec<CaseError> {
    let Ok(table) = parse(source) else { return Vec::new() };
    let top = Section::unread(source, table.get_ref(), schema.fields);
    let mut found = Found { may_vary: !schema.varied.is_empty(), ..Found::default() };
    found.table(&top);
    found.wrong.sort_by_key(|error| error.line);
    found.wrong.append(&mut found.missing);
    found.wrong
}

#[derive(Default)]
struct Found {
    /// Whether a table or a list may replace a number.
    may_vary: bool,
    wrong: Vec<CaseError>,
    missing: Vec<CaseError>,
}

impl Found {
    fn table(&mut self, section: &Section<'_>) {
        let has_shape = section.fields.iter().any(|field| field.name == SHAPE.name);
        let shape = if has_shape { section.word(&SHAPE).ok() } else { None };
        let unknown = section.all_unknown(shape);
        let meant = |field: &Field| {
            unknown.iter().any(|error| matches!(&error.fault, CaseFault::Unknown { nearest: Some(name), .. } if name == field.name))
        };
        let is_meant = |field: &&Field| field.is_of(shape) && section.means(field);
        for field in section.fields.iter().filter(is_meant) {
            match section.find(&field) {
                Some(value) => self.value(section, field, value),
                // Without a shape it is not known which fields of shapes are necessary.
                None if has_shape && shape.is_none() && !field.shapes.is_empty() => {}
                None if matches!(field.need, Need::Must) && !meant(field) => {
                    self.missing.push(section.missing(field));
                }
                None => {}
            }
        }
        self.wrong.extend(unknown);
    }

    fn value<'a>(&mut self, section: &Section<'a>, field: &Field, value: &'a Spanned<DeValue<'a>>) {
        if let Some(tables) = section.tables(field, value) {
            tables.iter().for_each(|table| self.table(table));
            let items = value.get_ref().as_array().into_iter().flat_map(|items| items.iter());
            let wrong = items.filter(|item| !item.get_ref().is_table());
            self.wrong.extend(wrong.map(|_| section.wrong(field, value)));
            return;
        }
        let error = match (field.form, value.get_ref()) {
            (Form::Table(_) | Form::Tables(_), _) => Err(section.wrong(field, value)),
            (Form::Number(measure), _) => self.number(section, field.name, value, measure),
            (Form::Numbers(_), DeValue::Table(_)) | (Form::Rows(_), DeValue::Array(_)) => Ok(()),
            (
                Form::Pair(measure) | Form::Numbers(measure) | Form::List(measure),
                DeValue::Array(_),
            ) => section.list_at(field.name, value, measure).map(|_| ()),
            (Form::Pair(measure) | Form::Numbers(measure), _) => {
                self.number(section, field.name, value, measure)
            }
            (Form::List(_) | Form::Rows(_), _) => Err(section.wrong(field, value)),
            (Form::Vector(parts, measure, _), _) => {
                self.vector(section, field, value, parts, measure)
            }
            (Form::WordOrVector(_, parts, measure, _), DeValue::Array(_)) => {
                self.vector(section, field, value, parts, measure)
            }
            (Form::Word(_) | Form::WordOrVector(..), _) => section.word(field).map(|_| ()),
            (Form::Text(_), DeValue::String(_)) | (Form::Switch, DeValue::Boolean(_)) => Ok(()),
            (Form::Text(_) | Form::Switch, _) => Err(section.wrong(field, value)),
        };
        self.wrong.extend(error.err());
    }

    fn number(
        &self,
        section: &Section<'_>,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        measure: Measure,
    ) -> Result<(), CaseError> {
        let varies = matches!(value.get_ref(), DeValue::Table(_) | DeValue::Array(_));
        if varies && self.may_vary {
            return Ok(());
        }
        section.plain_number(name, value, measure).map(|_| ())
    }

    fn vector(
        &self,
        section: &Section<'_>,
        field: &Field,
        value: &Spanned<DeValue<'_>>,
        parts: &[&str],
        measure: Measure,
    ) -> Result<(), CaseError> {
        let items = match value.get_ref() {
            DeValue::Array(items) if items.iter().count() == parts.len() => items,
            _ => return Err(section.wrong(field, value)),
        };
        items.iter().zip(parts).try_for_each(|(item, part)| {
            self.number(section, &format!("{}.{part}", field.name), item, measure)
        })
    }
}

/// The word that was probably meant by the text, in words; empty if none is similar.
pub(super) fn meant(text: Option<&str>, words: &[Word]) -> String {
    let words: Vec<&'static str> = words.iter().map(|(word, _)| *word).collect();
    let near = text.and_then(|text| of_others(text, &words).or_else(|| nearest(text, &words)));
    near.map_or_else(String::new, |word| format!("; did you mean {word:?}?"))
}
