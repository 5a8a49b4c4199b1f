//! Errors at a field of a table.

use super::spelling::line_at;
use super::{Place, Section};
use crate::case::error::{CaseError, CaseFault};
use crate::case::field::{Entry, Field, Form, Need, entries};
use crate::case::range::Range;
use crate::case::unit::{Measure, pointed};
use carom_special::RangeError;
use carom_special::nearest;
use toml::Spanned;
use toml::de::DeValue;

/// Names that other programs and books use for fields and words. A name of a quantity with another value follows it in
/// [`DIFFERENT`].
const OTHER_NAMES: &[(&str, &str)] = &[
    ("E", "young_modulus"),
    ("young", "young_modulus"),
    ("G", "shear_modulus"),
    ("shear", "shear_modulus"),
    ("nu", "poisson"),
    ("poissons_ratio", "poisson"),
    ("poisson_ratio", "poisson"),
    ("rho", "density"),
    ("m", "mass"),
    ("h", "thickness"),
    ("r", "radius"),
    ("R", "radius"),
    ("diameter", "radius"),
    ("d", "radius"),
    ("mu", "friction"),
    ("friction_coefficient", "friction"),
    ("coefficient_of_friction", "friction"),
    ("cof", "friction"),
    ("cor", "normal_restitution"),
    ("e", "normal_restitution"),
    ("restitution", "normal_restitution"),
    ("v", "velocity"),
    ("omega", "spin"),
    ("angular_velocity", "spin"),
    ("F", "force"),
    ("load", "force"),
    ("load", "F_z"),
    ("N", "F_z"),
    ("z", "zeta"),
    ("duration", "time"),
    ("type", "shape"),
    ("ball", "sphere"),
    ("wall", "plane"),
    ("floor", "plane"),
    ("nx", "cells"),
    ("g", "gravity"),
    ("elongation", "dilatation"),
    ("from", "start"),
    ("to", "stop"),
    ("end", "stop"),
    ("min", "start"),
    ("max", "stop"),
    ("min", "low"),
    ("max", "high"),
    ("n", "count"),
    ("num", "count"),
    ("step", "count"),
    ("steps", "count"),
    ("gauss", "normal"),
    ("gaussian", "normal"),
    ("std", "sd"),
    ("sigma", "sd"),
    ("lambda_", "lam"),
];

/// What of the value of another name belongs into the field.
const DIFFERENT: &[(&str, &str)] =
    &[("diameter", ", half of it"), ("d", ", half of it"), ("step", ", the number of values")];

/// The field that the name of another program stands for, if the table has it.
pub(super) fn meant<'a>(name: &str, valid: &[&'a str]) -> Option<&'a str> {
    let is_meant = |field: &&&str| OTHER_NAMES.contains(&(name, **field));
    valid.iter().find(is_meant).copied()
}

/// What of the value of another name belongs into the field, after a comma.
fn different(name: &str) -> &'static str {
    DIFFERENT.iter().find(|(other, _)| *other == name).map_or("", |(_, hint)| hint)
}

/// Letters of a name that tell which one is begun.
const BEGINNING: usize = 3;

/// The name that is probably meant, of those that are valid, and what of the value belongs there; empty if none is
/// similar.
#[must_use]
pub fn likely(name: &str, valid: &[&str]) -> String {
    // The beginning of one name alone says more than its letters.
    let mut begun = valid.iter().filter(|field| name.len() >= BEGINNING && field.starts_with(name));
    let begun = match (begun.next(), begun.next()) {
        (Some(field), None) => Some(*field),
        _ => None,
    };
    let near = meant(name, valid).or(begun).or_else(|| nearest(name, valid));
    near.map_or_else(String::new, |near| format!(", did you mean `{near}`{}?", different(name)))
}

/// The field of this name in one of the tables, as it is written there, with those that the table needs besides. Of
/// several tables the one that takes most of the names that are given.
fn inner(name: &str, given: &[&str], fields: &[Field]) -> Option<String> {
    let own = |table: &Field, name: &str| {
        let names: Vec<&'static str> = table.fields().iter().map(|field| field.name).collect();
        names.iter().find(|own| **own == name).copied().or_else(|| meant(name, &names))
    };
    let taken = |table: &&Field| given.iter().filter(|name| own(table, name).is_some()).count();
    // The first of those that take as many.
    let tables = fields.iter().rev().filter(|field| matches!(field.form, Form::Table(_)));
    let table = tables.filter(|table| own(table, name).is_some()).max_by_key(taken)?;
    let named = own(table, name)?;
    let is_told = |field: &&Field| field.name == named || matches!(field.need, Need::Must);
    let mut inside: Vec<String> =
        table.fields().iter().filter(is_told).map(|field| format!("{} = ..", field.name)).collect();
    // A field may be a number or a table.
    inside.dedup();
    Some(format!("{} = {{ {} }}", table.name, inside.join(", ")))
}

/// The field of this name in another table, with its path.
fn elsewhere(name: &str, top: &'static [Field]) -> Option<String> {
    let is_named =
        |Entry { field, .. }: &Entry| field.name == name || meant(name, &[field.name]).is_some();
    let is_plain =
        |Entry { field, .. }: &Entry| field.fields().is_empty() && field.shapes.is_empty();
    entries(top)
        .into_iter()
        .find(|entry| is_named(entry) && is_plain(entry))
        .map(|entry| entry.path)
}

/// The field that names a file.
const FILE: &str = "file";
/// Endings of files with numbers.
const FILES: &[&str] = &[".csv", ".tsv", ".txt", ".dat", ".npy", ".json", ".xlsx"];

/// What may be meant by a list with a number too many.
fn of_list(value: &Spanned<DeValue<'_>>, written: &str) -> &'static str {
    match value.get_ref().is_array() && written.contains(", ") && pointed(written).is_some() {
        true => "; decimals have a point, the comma separates numbers",
        false => "",
    }
}

impl Section<'_> {
    pub(super) fn unknown(
        &self,
        name: &str,
        at: usize,
        shape: Option<&str>,
        valid: &[&'static str],
    ) -> CaseError {
        // Rather a field that is missing than one that is there.
        let is_absent =
            |name: &&&'static str| !self.table.iter().any(|(key, _)| key.get_ref() == **name);
        let absent: Vec<&'static str> = valid.iter().filter(is_absent).copied().collect();
        let given: Vec<&str> = self.table.iter().map(|(key, _)| key.get_ref().as_ref()).collect();
        let table = match self.path.as_str() {
            "" => "a case".to_owned(),
            path => format!("`{path}`"),
        };
        let unknown = CaseFault::Unknown {
            table: match shape {
                Some(shape) => format!("{table} of shape {shape:?}"),
                None => table,
            },
            nearest: meant(name, valid)
                .map(str::to_owned)
                .or_else(|| inner(name, &given, self.fields))
                .or_else(|| nearest(name, &absent).map(str::to_owned))
                .or_else(|| elsewhere(name, self.top))
                .or_else(|| nearest(name, valid).map(str::to_owned)),
            hint: different(name),
            valid: valid.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "),
        };
        unknown.at(self.full(name), line_at(self.source, at))
    }

    /// The path of a field from the top of the file.
    #[must_use]
    pub(in crate::case) fn path(&self, place: &impl Place) -> String {
        self.full(&place.names().join("."))
    }

    /// The error of a missing field.
    #[must_use]
    pub(in crate::case) fn missing(&self, field: &Field) -> CaseError {
        let allowed = self.told(field);
        let meaning = field.meaning.split(';').next().unwrap_or_default();
        let unit = field.measure().map_or("", |measure| measure.dimension.unit());
        let unit = if unit.is_empty() { String::new() } else { format!(", in {unit}") };
        let others = match field.need {
            Need::Or(others) => format!(" (or {others})"),
            _ => String::new(),
        };
        self.missing_as(field, format!("{allowed}{others}; {meaning}{unit}"))
    }

    /// What is allowed for a field; of a table, how it is headed.
    fn told(&self, field: &Field) -> String {
        let name: String = self
            .full(field.name)
            .split(']')
            .map(|part| part.split('[').next().unwrap_or(part))
            .collect();
        match field.form {
            Form::Table(fields) if fields.len() <= 3 && !self.path.is_empty() => {
                let names: Vec<_> =
                    fields.iter().map(|field| format!("{} = ..", field.name)).collect();
                format!("{} {{ {} }}", field.allowed(), names.join(", "))
            }
            Form::Table(_) => format!("{}, headed [{name}]", field.allowed()),
            Form::Tables(_) => format!("{}: [[{name}]]", field.allowed()),
            _ => field.allowed(),
        }
    }

    /// The error of a missing field, with its own text for what is allowed.
    #[must_use]
    pub(in crate::case) fn missing_as(
        &self,
        place: impl Place,
        allowed: impl Into<String>,
    ) -> CaseError {
        CaseFault::Missing(allowed.into()).at(self.path(&place), self.line)
    }

    /// The error of a value that a later check rejects, reported at its field.
    #[must_use]
    pub(in crate::case) fn out_of_range(
        &self,
        place: impl Place,
        value: f64,
        allowed: &str,
    ) -> CaseError {
        let fault = CaseFault::Range { value, allowed: allowed.to_owned() };
        fault.at(self.path(&place), self.line(place))
    }

    /// The error of a value that the library rejects, reported at the field with the same name.
    #[must_use]
    pub(in crate::case) fn refused(&self, error: RangeError) -> CaseError {
        let name = error.field.replace(' ', "_");
        match self.fields.iter().find(|field| field.name == name) {
            Some(field) => self.out_of_range(field, error.value, error.allowed),
            None => {
                let (value, allowed) = (error.value, error.allowed.to_owned());
                CaseFault::Range { value, allowed }.at(self.full(&name), 0)
            }
        }
    }

    /// The error of a value as written in the file that its field does not allow.
    #[must_use]
    pub(in crate::case) fn unfit(&self, place: impl Place, allowed: String) -> CaseError {
        let field = self.path(&place);
        let Some(value) = self.find(&place) else { return self.missing_as(place, allowed) };
        let (line, found) = (self.line_of(value), self.written(value));
        CaseFault::Kind { found, allowed }.at(field, line)
    }

    /// The error of two fields of this table that exclude each other.
    #[must_use]
    pub(in crate::case) fn conflict(
        &self,
        place: impl Place,
        other: impl Place,
        reason: &'static str,
    ) -> CaseError {
        self.excluded(place, self.path(&other), reason)
    }

    /// The error of a field that excludes the one at another path.
    #[must_use]
    pub(in crate::case) fn excluded(
        &self,
        place: impl Place,
        other: String,
        reason: &'static str,
    ) -> CaseError {
        CaseFault::Conflict { other, reason }.at(self.path(&place), self.line(place))
    }

    /// The error of several fields of which only one may be given.
    #[must_use]
    pub(in crate::case) fn several(&self, given: &[&Field], reason: &'static str) -> CaseError {
        match given {
            [one, other, ..] => self.conflict(*other, *one, reason),
            [one] => self.missing(one),
            [] => CaseFault::Missing(reason.to_owned()).at(self.path.as_str(), self.line),
        }
    }

    /// The error of a value of the wrong kind.
    pub(super) fn wrong(&self, field: &Field, value: &Spanned<DeValue<'_>>) -> CaseError {
        self.kind(field.name, value, &self.told(field))
    }

    /// The error of a table in the place of a number that has nothing in it.
    #[must_use]
    pub(in crate::case) fn empty(&self, allowed: &str) -> CaseError {
        let fault = CaseFault::Kind { found: "{}".to_owned(), allowed: allowed.to_owned() };
        fault.at(self.path.as_str(), self.line)
    }

    pub(super) fn kind(
        &self,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        allowed: &str,
    ) -> CaseError {
        let (line, found) = (self.line_of(value), self.written(value));
        let allowed = format!("{allowed}{}{}", self.of_file(value), of_list(value, &found));
        CaseFault::Kind { found, allowed }.at(self.full(name), line)
    }

    /// Where a file belongs that stands in the place of a value.
    fn of_file(&self, value: &Spanned<DeValue<'_>>) -> String {
        let text = value.get_ref().as_str().unwrap_or("").to_ascii_lowercase();
        let has_file = self.fields.iter().any(|field| field.name == FILE);
        match FILES.iter().any(|ending| text.ends_with(ending)) {
            true if has_file => format!("; a file is named by `{}`", self.full(FILE)),
            true => "; no file is read here, the values stand in the case".to_owned(),
            false => String::new(),
        }
    }

    /// Checks that a number which replaces the value of field `name` is in its range.
    pub(in crate::case) fn in_range(
        &self,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        number: f64,
        Measure { range, .. }: Measure,
    ) -> Result<f64, CaseError> {
        match range.holds(number) {
            true => Ok(number),
            false => Err(self.beyond(name, value, number, range)),
        }
    }

    /// The error of a number out of its range, at the value in which it stands.
    pub(super) fn beyond(
        &self,
        name: &str,
        at: &Spanned<DeValue<'_>>,
        value: f64,
        range: Range,
    ) -> CaseError {
        let allowed = range.allowed().to_owned();
        CaseFault::Range { value, allowed }.at(self.full(name), self.line_of(at))
    }
}
