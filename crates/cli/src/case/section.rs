//! A table of a case file, read field by field; every error names the field by its full path.

mod arrays;

use super::error::CaseError;
use super::range::Range;
use super::unit::Measure;
use super::varied::Varied;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Letters of a bad value that its message shows.
const MOST_SHOWN: usize = 200;

const LIST: &str = "a list with at least one number";

/// A table of a case file.
#[derive(Debug, Clone)]
pub(super) struct Section<'a> {
    source: &'a str,
    path: String,
    table: &'a DeTable<'a>,
    /// Where numbers may stand for many.
    varied: Option<&'a Varied>,
}

impl<'a> Section<'a> {
    /// The whole file, which takes these fields and no others.
    ///
    /// # Errors
    /// If there is a field of another name.
    pub(super) fn root(
        source: &'a str,
        table: &'a DeTable<'a>,
        valid: &[&'static str],
    ) -> Result<Self, CaseError> {
        Self::new(source, String::new(), table, valid)
    }

    /// The table at `path`, which takes these fields and no others.
    pub(super) fn new(
        source: &'a str,
        path: String,
        table: &'a DeTable<'a>,
        valid: &[&'static str],
    ) -> Result<Self, CaseError> {
        let section = Self { source, path, table, varied: None };
        section.check(valid)?;
        Ok(section)
    }

    /// The same, in which every number may stand for many.
    pub(super) fn varying(self, varied: &'a Varied) -> Self {
        Self { varied: Some(varied), ..self }
    }

    /// Whether it has these fields and no others.
    pub(super) fn check(&self, valid: &[&'static str]) -> Result<(), CaseError> {
        let unknown = self.table.iter().find(|(name, _)| !valid.contains(&name.get_ref().as_ref()));
        match unknown {
            Some((name, _)) => Err(self.unknown(name.get_ref(), name.span().start, valid)),
            None => Ok(()),
        }
    }

    /// The table that stands as `value`, which takes any field.
    pub(super) fn table_at(
        &self,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
    ) -> Result<Self, CaseError> {
        match value.get_ref() {
            DeValue::Table(table) => {
                Ok(Self { source: self.source, path: self.full(name), table, varied: None })
            }
            _ => Err(self.kind(name, value, "a table")),
        }
    }

    fn unknown(&self, name: &str, at: usize, valid: &[&'static str]) -> CaseError {
        CaseError::Unknown {
            field: self.full(name),
            line: line_at(self.source, at),
            table: match self.path.as_str() {
                "" => "a case".to_owned(),
                path => format!("`{path}`"),
            },
            nearest: nearest(name, valid),
            valid: valid.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "),
        }
    }

    /// The path of a field of this table.
    #[must_use]
    pub(super) fn full(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }

    /// Whether the field is there.
    #[must_use]
    pub(super) fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// The line of the field, or 0 if it is not there.
    #[must_use]
    pub(super) fn line(&self, name: &str) -> usize {
        self.find(name).map_or(0, |value| line_at(self.source, value.span().start))
    }

    /// A table in this one, which takes these fields and no others.
    ///
    /// # Errors
    /// If it is missing, no table, or has a field of another name.
    pub(super) fn section(&self, name: &str, valid: &[&'static str]) -> Result<Self, CaseError> {
        let value = self.find(name).ok_or_else(|| self.missing(name, "a table"))?;
        match value.get_ref() {
            DeValue::Table(table) => {
                let section = Self::new(self.source, self.full(name), table, valid)?;
                Ok(Self { varied: self.varied, ..section })
            }
            _ => Err(self.kind(name, value, "a table")),
        }
    }

    /// The tables `[[name]]`, at least one, which take these fields and no others.
    ///
    /// # Errors
    /// If there is none, or one has a field of another name.
    pub(super) fn sections(
        &self,
        name: &str,
        valid: &[&'static str],
    ) -> Result<Vec<Self>, CaseError> {
        let allowed = "at least one table, headed by the name in double brackets";
        let value = self.find(name).ok_or_else(|| self.missing(name, allowed))?;
        let DeValue::Array(items) = value.get_ref() else {
            return Err(self.kind(name, value, allowed));
        };
        let sections = items.iter().enumerate().map(|(i, item)| match item.get_ref() {
            DeValue::Table(table) => {
                Self::new(self.source, self.full(&format!("{name}[{i}]")), table, valid)
            }
            _ => Err(self.kind(name, value, allowed)),
        });
        sections.collect()
    }

    /// A number in its range.
    ///
    /// # Errors
    /// If it is missing, no number, or out of range.
    pub(super) fn number(&self, name: &str, measure: impl Into<Measure>) -> Result<f64, CaseError> {
        let measure = measure.into();
        let value = self.find(name).ok_or_else(|| self.missing(name, measure.range.allowed()))?;
        self.as_number(name, value, measure)
    }

    /// A list of numbers in their range, at least one.
    ///
    /// # Errors
    /// If it is missing, no such list, or a number is out of range.
    pub(super) fn list(
        &self,
        name: &str,
        measure: impl Into<Measure>,
    ) -> Result<Vec<f64>, CaseError> {
        let measure = measure.into();
        let value = self.find(name).ok_or_else(|| self.missing(name, LIST))?;
        self.list_at(name, value, measure)
    }

    pub(super) fn list_at(
        &self,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        measure: Measure,
    ) -> Result<Vec<f64>, CaseError> {
        match value.get_ref() {
            DeValue::Array(items) if items.iter().next().is_some() => {
                items.iter().map(|item| self.plain_number(name, item, measure)).collect()
            }
            _ => Err(self.kind(name, value, LIST)),
        }
    }

    /// One of these words.
    ///
    /// # Errors
    /// If it is missing or another word.
    pub(super) fn word(&self, name: &str, words: Words) -> Result<&'a str, CaseError> {
        let value = self.find(name).ok_or_else(|| self.missing(name, words.allowed))?;
        match value.get_ref() {
            DeValue::String(word) if words.words.contains(&word.as_ref()) => Ok(word),
            _ => Err(self.kind(name, value, words.allowed)),
        }
    }

    /// True or false; false if it is missing.
    ///
    /// # Errors
    /// If it is neither.
    pub(super) fn switch(&self, name: &str) -> Result<bool, CaseError> {
        match self.find(name) {
            None => Ok(false),
            Some(value) => match value.get_ref() {
                DeValue::Boolean(value) => Ok(*value),
                _ => Err(self.kind(name, value, "true or false")),
            },
        }
    }

    /// One number in its range, a list of them, or `{ start, stop, count }`.
    ///
    /// # Errors
    /// If it is missing, of another kind, or a number is out of range.
    pub(super) fn numbers(
        &self,
        name: &str,
        measure: impl Into<Measure>,
    ) -> Result<Numbers, CaseError> {
        let measure = measure.into();
        match self.find(name).map(Spanned::get_ref) {
            Some(DeValue::Array(_)) => self.list(name, measure).map(Numbers::Sweep),
            Some(DeValue::Table(_)) => self.spaced(name, measure).map(Numbers::Sweep),
            _ => self.number(name, measure).map(Numbers::One),
        }
    }

    fn spaced(&self, name: &str, measure: Measure) -> Result<Vec<f64>, CaseError> {
        let table = self.section(name, &["start", "stop", "count"])?;
        let start = table.number("start", measure)?;
        let stop = table.number("stop", measure)?;
        let count = table.number("count", Range::Count)?;
        Ok(carom_special::linspace(start, stop, count as usize))
    }

    /// A text.
    ///
    /// # Errors
    /// If it is missing or no text.
    pub(super) fn text(&self, name: &str, allowed: &'static str) -> Result<&'a str, CaseError> {
        let value = self.find(name).ok_or_else(|| self.missing(name, allowed))?;
        match value.get_ref() {
            DeValue::String(text) => Ok(text),
            _ => Err(self.kind(name, value, allowed)),
        }
    }

    /// The error that `name` is missing.
    #[must_use]
    pub(super) fn missing(&self, name: &str, allowed: &'static str) -> CaseError {
        CaseError::Missing { field: self.full(name), allowed }
    }

    /// The error that a value found elsewhere to be bad stands at field `name`.
    #[must_use]
    pub(super) fn out_of_range(&self, name: &str, value: f64, allowed: &str) -> CaseError {
        CaseError::Range {
            field: self.full(name),
            line: self.line(name),
            value,
            allowed: allowed.to_owned(),
        }
    }

    /// The error that `name` excludes `other`.
    #[must_use]
    pub(super) fn conflict(&self, name: &str, other: &str, reason: &'static str) -> CaseError {
        CaseError::Conflict {
            field: self.full(name),
            line: self.line(name),
            other: self.full(other),
            reason,
        }
    }

    /// The value at `name`, which may be a path with dots.
    fn find(&self, name: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        name.split('.').try_fold(None, |found: Option<&'a Spanned<DeValue<'a>>>, part| {
            let table = match found {
                None => self.table,
                Some(value) => value.get_ref().as_table()?,
            };
            table.iter().find(|(key, _)| key.get_ref() == part).map(|(_, value)| Some(value))
        })?
    }

    fn as_number(
        &self,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        measure: Measure,
    ) -> Result<f64, CaseError> {
        let varied = self.varied.map(|varied| varied.number(self, name, value, measure));
        match varied.transpose()?.flatten() {
            Some(number) => Ok(number),
            None => self.plain_number(name, value, measure),
        }
    }

    /// A number that stands for a value, if it is in its range.
    pub(super) fn in_range(
        &self,
        name: &str,
        number: f64,
        Measure { range, .. }: Measure,
    ) -> Result<f64, CaseError> {
        match range.holds(number) {
            true => Ok(number),
            false => Err(self.out_of_range(name, number, range.allowed())),
        }
    }

    fn plain_number(
        &self,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        Measure { range, dimension }: Measure,
    ) -> Result<f64, CaseError> {
        let is_text = value.get_ref().is_str();
        let read = match value.get_ref() {
            DeValue::String(text) => dimension.read(text),
            plain => number(plain),
        };
        match read {
            Some(number) if range.holds(number) => Ok(number),
            Some(number) if !is_text => Err(CaseError::Range {
                field: self.full(name),
                line: line_at(self.source, value.span().start),
                value: number,
                allowed: range.allowed().to_owned(),
            }),
            // As it is written.
            Some(_) => Err(self.kind(name, value, range.allowed())),
            None => Err(self.kind(name, value, &dimension.allowed(range))),
        }
    }

    fn kind(&self, name: &str, value: &Spanned<DeValue<'_>>, allowed: &str) -> CaseError {
        let span = value.span();
        CaseError::Kind {
            field: self.full(name),
            line: line_at(self.source, span.start),
            found: shortened(self.source.get(span).unwrap_or("?").trim()),
            allowed: allowed.to_owned(),
        }
    }
}

/// The text of a case file as TOML.
///
/// # Errors
/// If it is not.
pub(super) fn parse(source: &str) -> Result<Spanned<DeTable<'_>>, CaseError> {
    DeTable::parse(source).map_err(|error| CaseError::Syntax {
        line: line_at(source, error.span().map_or(0, |span| span.start)),
        message: error.message().to_owned(),
    })
}

/// One number, or those of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub enum Numbers {
    /// One.
    One(f64),
    /// A sweep.
    Sweep(Vec<f64>),
}

impl Numbers {
    /// The numbers in order.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        match self {
            Self::One(number) => std::slice::from_ref(number),
            Self::Sweep(numbers) => numbers,
        }
    }
}

/// Words among which a field chooses.
#[derive(Debug, Clone, Copy)]
pub(super) struct Words {
    /// The words.
    pub(super) words: &'static [&'static str],
    /// The same, for a message.
    pub(super) allowed: &'static str,
}

fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Integer(integer) => {
            i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|value| value as f64)
        }
        _ => None,
    }
}

/// At most so much of a value that the message stays readable.
fn shortened(value: &str) -> String {
    match value.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}...", &value[..end]),
        None => value.to_owned(),
    }
}

/// The line, from 1, of the byte at `offset`.
fn line_at(source: &str, offset: usize) -> usize {
    1 + source.bytes().take(offset).filter(|byte| *byte == b'\n').count()
}

/// The valid name most like `name`, if it is like it at all.
fn nearest(name: &str, valid: &[&'static str]) -> Option<&'static str> {
    let scored = valid.iter().map(|candidate| (distance(name, candidate), *candidate));
    let (distance, candidate) = scored.min()?;
    (distance <= 1 + candidate.len() / 3).then_some(candidate)
}

/// How many letters must be put in, taken out or changed (Levenshtein).
fn distance(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (i, letter) in one.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, candidate) in other.iter().enumerate() {
            let changed = diagonal + usize::from(letter != *candidate);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[other.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_found() {
        let valid = ["radius", "density", "material", "mass"];
        assert_eq!(nearest("radus", &valid), Some("radius"));
        assert_eq!(nearest("Density", &valid), Some("density"));
        assert_eq!(nearest("temperature", &valid), None);
        assert_eq!(distance("kitten", "sitting"), 3);
    }

    #[test]
    fn lines_count_from_one() {
        assert_eq!(line_at("a\nb\nc", 0), 1);
        assert_eq!(line_at("a\nb\nc", 4), 3);
    }
}
