//! A case of which data determine numbers: its unknowns, and the numbers that a row of data replaces.

use super::error::{CaseError, CaseFault};
use super::field::{Entry, Field, Form, Schema, entries, interned};
use super::hertz::HertzCase;
use super::history::HistoryCase;
use super::impact::ImpactCase;
use super::reader::Case;
use super::section::parse;
use super::unit::Measure;
use super::varied::{Input, Varied};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A kind of case that is read anew with other numbers.
pub trait Renewed: Sized {
    /// Its name and its fields.
    const SCHEMA: Schema;

    /// Reads the case with some of its numbers replaced.
    #[doc(hidden)]
    fn renewed(source: &str, table: &DeTable<'_>, varied: &Replaced) -> Result<Self, CaseError>;
}

/// The numbers that replace those of a case.
#[derive(Debug)]
pub struct Replaced(pub(super) Varied);

impl Renewed for ImpactCase {
    const SCHEMA: Schema = <super::ImpactFile<'_> as Case<'_>>::SCHEMA;

    fn renewed(source: &str, table: &DeTable<'_>, varied: &Replaced) -> Result<Self, CaseError> {
        super::impact::read(source, table, &varied.0)
    }
}

impl Renewed for HertzCase {
    const SCHEMA: Schema = <Self as Case<'_>>::SCHEMA;

    fn renewed(source: &str, table: &DeTable<'_>, varied: &Replaced) -> Result<Self, CaseError> {
        super::hertz::read(source, table, &varied.0)
    }
}

impl Renewed for HistoryCase {
    const SCHEMA: Schema = <Self as Case<'_>>::SCHEMA;

    fn renewed(source: &str, table: &DeTable<'_>, varied: &Replaced) -> Result<Self, CaseError> {
        super::history::read(source, table, &varied.0)
    }
}

/// A case with unknowns, parsed once.
///
/// ```
/// use carom_cases::case::{Case as _, HertzCase, OpenCase};
/// let text = "body_1 = { radii = 0.01, material = { young_modulus = { fit = [1e6, 1e9] }, poisson = 0.5 } }
/// body_2 = { radii = inf, material = { rigid = true } }
/// load = { approach = 1e-4 }";
/// let file = OpenCase::<HertzCase>::parse(text)?;
/// assert_eq!(file.inputs()[0].field, "body_1.material.young_modulus");
/// let [modulus, approach] = [file.inputs()[0].place(), file.stated("load.approach")?.place];
/// let soft = file.case(&[(modulus, 2e6), (approach, 3e-4)])?;
/// assert_eq!(soft.values.as_slice(), [3e-4]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct OpenCase<'a, C> {
    source: &'a str,
    table: Spanned<DeTable<'a>>,
    inputs: Vec<Input>,
    nominal: C,
}

/// A number that stands in a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stated {
    /// Its field with the path.
    pub field: &'static str,
    /// Its offset in the file.
    pub place: usize,
    /// Its range and unit.
    pub measure: Measure,
}

impl<'a, C: Renewed> Case<'a> for OpenCase<'a, C> {
    const SCHEMA: Schema = C::SCHEMA;

    fn read(source: &'a str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let varied = Replaced(Self::varied(Vec::new()));
        let nominal = C::renewed(source, table.get_ref(), &varied)?;
        Ok(Self { source, table, inputs: varied.0.found(), nominal })
    }
}

impl<C: Renewed> OpenCase<'_, C> {
    fn varied(drawn: Vec<(usize, f64)>) -> Varied {
        let varied = Varied::new(C::SCHEMA.fields, drawn);
        if C::SCHEMA.has_sweeps() { varied } else { varied.unknown() }
    }

    /// The case with a value of each unknown in the middle of what is allowed.
    #[must_use]
    pub const fn nominal(&self) -> &C {
        &self.nominal
    }

    /// The numbers that vary or are unknown, in the order of the file.
    #[must_use]
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// The case with these numbers at these places.
    ///
    /// # Errors
    /// As [`Case::parse`].
    pub fn case(&self, numbers: &[(usize, f64)]) -> Result<C, CaseError> {
        let varied = Replaced(Self::varied(numbers.to_vec()));
        C::renewed(self.source, self.table.get_ref(), &varied)
    }

    /// The number of a field that the case states.
    ///
    /// # Errors
    /// [`CaseFault::Unknown`] if the kind has no number of this name, [`CaseFault::Missing`] if the case does not
    /// state it.
    pub fn stated(&self, path: &str) -> Result<Stated, CaseError> {
        let Some(measure) = measure(C::SCHEMA.fields, path) else {
            let fault = CaseFault::Unknown {
                table: "a case".to_owned(),
                nearest: None,
                hint: "",
                valid: "the fields that `carom schema` lists".to_owned(),
            };
            return Err(fault.at(path, 0));
        };
        let found = place(self.table.get_ref(), path);
        let place = found.filter(|(_, is_plain)| *is_plain || C::SCHEMA.has_sweeps());
        let place = place.map(|(place, _)| place).ok_or_else(|| {
            let told = "a number in the case, which each row of data replaces";
            CaseFault::Missing(told.to_owned()).at(path, 0)
        })?;
        Ok(Stated { field: interned(C::SCHEMA.fields, path), place, measure })
    }
}

/// The measure of the number at this path, or of a component of a vector.
fn measure(fields: &'static [Field], path: &str) -> Option<Measure> {
    let is_it = |Entry { path: own, field }: &Entry| match field.form {
        Form::Number(_) | Form::Numbers(_) => own == path,
        Form::Vector(parts, ..) => parts.iter().any(|part| {
            path.strip_prefix(own.as_str()).and_then(|rest| rest.strip_prefix('.')) == Some(part)
        }),
        _ => false,
    };
    entries(fields).iter().find(|entry| is_it(entry)).and_then(|entry| entry.field.measure())
}

/// The offset of the value at this path, and whether it is one number.
fn place(table: &DeTable<'_>, path: &str) -> Option<(usize, bool)> {
    let of = |value: &Spanned<DeValue<'_>>| {
        let is_plain = !matches!(value.get_ref(), DeValue::Array(_) | DeValue::Table(_));
        (value.span().start, is_plain)
    };
    let (name, rest) = path.split_once('.').map_or((path, None), |(name, rest)| (name, Some(rest)));
    let (_, value) = table.iter().find(|(key, _)| key.get_ref() == name)?;
    match (value.get_ref(), rest) {
        (_, None) => Some(of(value)),
        (DeValue::Table(inner), Some(rest)) => place(inner, rest),
        (DeValue::Array(items), Some(part)) => {
            let index = ["x", "y", "z"].iter().position(|axis| *axis == part)?;
            items.get(index).map(of)
        }
        _ => None,
    }
}
