//! A table of a case file, read field by field. Every error names the field by its full path.

mod arrays;
mod error;
mod not_toml;
mod spelling;
pub(super) mod survey;
mod sweep;
mod understood;
mod usual;

pub use error::likely;
pub use sweep::Numbers;
pub(super) use sweep::{COUNT, START, STOP, SWEEP};
pub use understood::Understood;

use super::error::{CaseError, CaseFault};
use super::field::{Default, Field, Form, Need};
use super::unit::Measure;
use spelling::line_at;
pub(crate) use spelling::shortened;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Numbers of a case that may be replaced by others.
pub(super) trait Varying: std::fmt::Debug {
    /// The number that represents a varied value; none if the value does not vary.
    fn number<'a>(
        &self,
        section: &Section<'a>,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        measure: Measure,
    ) -> Result<Option<f64>, CaseError>;
}

/// A table of a case file; only its declared fields can be read.
#[derive(Debug, Clone)]
pub(super) struct Section<'a> {
    source: &'a str,
    path: String,
    /// Its line; 0 for the top table.
    line: usize,
    table: &'a DeTable<'a>,
    fields: &'static [Field],
    /// The fields of the case.
    top: &'static [Field],
    /// Collects numbers that vary, where the case allows them.
    varied: Option<&'a dyn Varying>,
}

/// A field of this table or of a table in it.
pub(super) trait Place {
    /// The names on the path.
    fn names(&self) -> Vec<&'static str>;
}

impl Place for &Field {
    fn names(&self) -> Vec<&'static str> {
        vec![self.name]
    }
}

impl<const N: usize> Place for [&Field; N] {
    fn names(&self) -> Vec<&'static str> {
        self.map(|field| field.name).to_vec()
    }
}

impl<'a> Section<'a> {
    /// The top table of a file, with these fields and no others.
    ///
    /// # Errors
    /// If there is a field of another name.
    pub(super) fn root(
        source: &'a str,
        table: &'a DeTable<'a>,
        fields: &'static [Field],
    ) -> Result<Self, CaseError> {
        let section = Self::unread(source, table, fields);
        section.check(None).map(|()| section)
    }

    /// The same without a check.
    fn unread(source: &'a str, table: &'a DeTable<'a>, fields: &'static [Field]) -> Self {
        let (path, top) = (String::new(), fields);
        Self { source, path, line: 0, table, fields, top, varied: None }
    }

    /// The same table, in which every number may vary.
    pub(super) fn varying(self, varied: &'a dyn Varying) -> Self {
        Self { varied: Some(varied), ..self }
    }

    /// Checks that it has only fields of this shape.
    fn check(&self, shape: Option<&str>) -> Result<(), CaseError> {
        self.all_unknown(shape).into_iter().next().map_or(Ok(()), Err)
    }

    /// The errors of all fields that this shape does not have.
    fn all_unknown(&self, shape: Option<&str>) -> Vec<CaseError> {
        let valid = self.fields.iter().filter(|field| field.is_of(shape));
        let mut valid: Vec<&'static str> = valid.map(|field| field.name).collect();
        // A plain field and a table may share a name.
        valid.dedup();
        let names = self.table.iter().map(|(name, _)| name);
        let unknown = names.filter(|name| !valid.contains(&name.get_ref().as_ref()));
        unknown.map(|name| self.unknown(name.get_ref(), name.span().start, shape, &valid)).collect()
    }

    /// The table that replaces the value of a number, with these fields.
    pub(super) fn table_at(
        &self,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        fields: &'static [Field],
    ) -> Result<Self, CaseError> {
        let section = self.within(name, value, fields);
        let section = section.ok_or_else(|| self.kind(name, value, "a table"))?;
        section.check(None).map(|()| Self { varied: None, ..section })
    }

    /// The table of this name with these fields, before a check; none if the value is no table.
    fn within(
        &self,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        fields: &'static [Field],
    ) -> Option<Self> {
        let table = value.get_ref().as_table()?;
        let (path, line) = (self.full(name), self.line_of(value));
        Some(Self { path, line, table, fields, ..self.clone() })
    }

    /// The tables in the value of a field of tables, before a check; none for any other field or value.
    pub(super) fn tables(
        &self,
        field: &Field,
        value: &'a Spanned<DeValue<'a>>,
    ) -> Option<Vec<Self>> {
        match (field.form, value.get_ref()) {
            (Form::Table(fields), _) => Some(vec![self.within(field.name, value, fields)?]),
            (Form::Tables(fields), DeValue::Array(items)) => {
                let item = |(i, item)| self.within(&format!("{}[{i}]", field.name), item, fields);
                Some(items.iter().enumerate().filter_map(item).collect())
            }
            _ => None,
        }
    }

    /// The path of a field of this table.
    #[must_use]
    pub(super) fn full(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }

    /// Whether the field is present.
    #[must_use]
    pub(super) fn has(&self, place: impl Place) -> bool {
        self.find(&place).is_some()
    }

    /// Whether the value of a name that a plain field and a table share is meant for this field. It is meant for the
    /// table if it is a table with one of its names.
    #[must_use]
    pub(super) fn means(&self, field: &Field) -> bool {
        let is_table = |field: &Field| matches!(field.form, Form::Table(_));
        let twin = |other: &&Field| other.name == field.name && is_table(other) != is_table(field);
        let Some(twin) = self.fields.iter().find(twin) else { return true };
        let parts = if is_table(field) { field } else { twin }.fields();
        let is_part = |name: &str| parts.iter().any(|part| part.name == name);
        let has_part = self
            .find(&field)
            .and_then(|value| value.get_ref().as_table())
            .is_some_and(|table| table.iter().any(|(name, _)| is_part(name.get_ref())));
        has_part == is_table(field)
    }

    /// Those of the fields that are present.
    #[must_use]
    pub(super) fn given<const N: usize>(&self, fields: [&'static Field; N]) -> Vec<&'static Field> {
        fields.into_iter().filter(|field| self.has(*field)).collect()
    }

    /// The field with its value as written in the file.
    #[must_use]
    pub(super) fn stated(&self, place: impl Place) -> String {
        let value = self.find(&place).map_or_else(String::new, |value| self.written(value));
        format!("`{}` = {value}", self.path(&place))
    }

    /// The line of the field, or 0 if it is missing.
    #[must_use]
    pub(super) fn line(&self, place: impl Place) -> usize {
        self.find(&place).map_or(0, |value| line_at(self.source, value.span().start))
    }

    /// Reads a table in this one.
    ///
    /// # Errors
    /// If it is missing, is not a table, or has an unknown field.
    pub(super) fn section(&self, field: &Field) -> Result<Self, CaseError> {
        let section = self.unchecked(field)?;
        section.check(None).map(|()| section)
    }

    /// Reads a table in this one and its field `shape`; only the fields of that shape are allowed.
    ///
    /// # Errors
    /// As [`Section::section`], or if `shape` is not one of its words.
    pub(super) fn shaped(
        &self,
        field: &Field,
        shape: &Field,
    ) -> Result<(Self, &'static str), CaseError> {
        let section = self.unchecked(field)?;
        match section.word(shape) {
            // The name of `shape` may be misspelt.
            Err(missing @ CaseError { fault: CaseFault::Missing(_), .. }) => {
                section.check(None).and(Err(missing))
            }
            Err(wrong) => Err(wrong),
            Ok(word) => section.check(Some(word)).map(|()| (section, word)),
        }
    }

    fn unchecked(&self, field: &Field) -> Result<Self, CaseError> {
        let value = self.value(field)?;
        let section = self.within(field.name, value, field.fields());
        section.ok_or_else(|| self.wrong(field, value))
    }

    /// Reads the tables `[[name]]`, at least one.
    ///
    /// # Errors
    /// If there is none, or one has an unknown field.
    pub(super) fn sections(&self, field: &Field) -> Result<Vec<Self>, CaseError> {
        let value = self.value(field)?;
        let items = match value.get_ref() {
            DeValue::Array(items) if items.iter().next().is_some() => items,
            _ => return Err(self.wrong(field, value)),
        };
        let sections = items
            .iter()
            .enumerate()
            .map(|(i, item)| self.table_at(&format!("{}[{i}]", field.name), item, field.fields()));
        sections.collect()
    }

    /// Reads a number, or its default.
    ///
    /// # Errors
    /// If it is missing without a default, not a number, or out of range.
    pub(super) fn number(&self, field: &Field) -> Result<f64, CaseError> {
        match (self.find(&field), field.need, field.measure()) {
            (None, Need::Default(Default::Number(number)), _) => Ok(number),
            (Some(value), _, Some(measure)) => self.as_number(field.name, value, measure),
            _ => Err(self.missing(field)),
        }
    }

    /// Reads a number, if it is present.
    ///
    /// # Errors
    /// If it is not a number, or out of range.
    pub(super) fn maybe(&self, field: &Field) -> Result<Option<f64>, CaseError> {
        self.has(field).then(|| self.number(field)).transpose()
    }

    /// Reads a whole number, or its default.
    ///
    /// # Errors
    /// As [`Section::number`].
    pub(super) fn count(&self, field: &Field) -> Result<usize, CaseError> {
        Ok(self.number(field)? as usize)
    }

    /// Reads a list of at least one number, or its default.
    ///
    /// # Errors
    /// If it is missing without a default, not such a list, or a number is out of range.
    pub(super) fn list(&self, field: &Field) -> Result<Vec<f64>, CaseError> {
        match (self.find(&field), field.need, field.measure()) {
            (None, Need::Default(Default::List(numbers)), _) => Ok(numbers.to_vec()),
            (Some(value), _, Some(measure)) => self.list_at(field.name, value, measure),
            _ => Err(self.missing(field)),
        }
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
            _ => Err(self.kind(name, value, "a list with at least one number")),
        }
    }

    /// Reads a word, or its default.
    ///
    /// # Errors
    /// If it is missing without a default, or not one of the allowed words.
    pub(super) fn word(&self, field: &Field) -> Result<&'static str, CaseError> {
        // The words that this table allows, which may be fewer.
        let field = self.fields.iter().find(|own| own.name == field.name).unwrap_or(field);
        let (Form::Word(words) | Form::WordOrVector(words, ..)) = field.form else {
            return Err(self.missing(field));
        };
        let value = match (self.find(&field), field.need) {
            (Some(value), _) => value,
            (None, Need::Default(Default::Word(word))) => return Ok(word),
            (None, _) => return Err(self.missing(field)),
        };
        let text = value.get_ref().as_str();
        let known = words.iter().find(|(word, _)| text == Some(word));
        let wrong = || {
            let allowed = field.allowed() + &survey::meant(text, words);
            self.kind(field.name, value, &allowed)
        };
        known.map(|(word, _)| *word).ok_or_else(wrong)
    }

    /// Reads true or false; false if it is missing.
    ///
    /// # Errors
    /// If it is neither.
    pub(super) fn switch(&self, field: &Field) -> Result<bool, CaseError> {
        let Some(value) = self.find(&field) else { return Ok(false) };
        value.get_ref().as_bool().ok_or_else(|| self.wrong(field, value))
    }

    /// Reads a text.
    ///
    /// # Errors
    /// If it is missing or not a text.
    pub(super) fn text(&self, field: &Field) -> Result<&'a str, CaseError> {
        let value = self.value(field)?;
        value.get_ref().as_str().ok_or_else(|| self.wrong(field, value))
    }

    /// A value as written, with numbers in the base unit.
    #[must_use]
    pub(super) fn shown(&self, value: &Spanned<DeValue<'_>>, measure: Option<Measure>) -> String {
        let written = || self.written(value);
        match (value.get_ref(), measure) {
            (DeValue::String(text), Some(measure)) => {
                measure.dimension.read(text).map_or_else(written, |number| number.to_string())
            }
            (DeValue::Array(items), Some(_)) => {
                let items: Vec<_> = items.iter().map(|item| self.shown(item, measure)).collect();
                format!("[{}]", items.join(", "))
            }
            _ => written(),
        }
    }

    /// A value as written; of a table that has a heading or dotted names, these.
    #[must_use]
    pub(super) fn written(&self, value: &Spanned<DeValue<'_>>) -> String {
        let text = self.source.get(value.span()).unwrap_or("?").trim();
        match value.get_ref() {
            DeValue::Table(table) if !text.starts_with('{') => {
                let names: Vec<_> =
                    table.iter().map(|(name, _)| format!("{} = ..", name.get_ref())).collect();
                shortened(&format!("{{ {} }}", names.join(", ")))
            }
            _ => shortened(text),
        }
    }

    /// The line of a value.
    #[must_use]
    pub(super) fn line_of(&self, value: &Spanned<DeValue<'_>>) -> usize {
        line_at(self.source, value.span().start)
    }

    fn value(&self, field: &Field) -> Result<&'a Spanned<DeValue<'a>>, CaseError> {
        self.find(&field).ok_or_else(|| self.missing(field))
    }

    /// The value of a field; none if the table does not have the field.
    fn find(&self, place: &impl Place) -> Option<&'a Spanned<DeValue<'a>>> {
        let (mut table, mut fields) = (self.table, self.fields);
        let mut found = None;
        for name in place.names() {
            let field = fields.iter().find(|field| field.name == name)?;
            let (_, value) = table.iter().find(|(key, _)| key.get_ref() == name)?;
            found = Some(value);
            if let DeValue::Table(inner) = value.get_ref() {
                (table, fields) = (inner, field.fields());
            } else {
                fields = &[];
            }
        }
        found
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
            Some(number) if !is_text => Err(self.beyond(name, value, number, range)),
            // The error shows the value as written.
            Some(_) => Err(self.kind(name, value, range.allowed())),
            None => {
                let meant =
                    value.get_ref().as_str().map_or_else(String::new, |t| dimension.meant(t));
                Err(self.kind(name, value, &(dimension.allowed(range) + &meant)))
            }
        }
    }
}

/// Parses a case file as TOML.
///
/// # Errors
/// If the text is not TOML.
pub(super) fn parse(source: &str) -> Result<Spanned<DeTable<'_>>, CaseError> {
    DeTable::parse(source).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let before = source.get(..at).unwrap_or("");
        let column = before.chars().rev().take_while(|letter| *letter != '\n').count();
        let message = error.message().to_owned();
        CaseFault::Syntax { column, message }.at("", line_at(source, at))
    })
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
