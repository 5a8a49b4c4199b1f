//! Uncertain inputs of an impact case: a distribution in the place of a number, and
//! `[uncertainty]`.

use super::error::CaseError;
use super::impact::ImpactCase;
use super::range::Range;
use super::section::{Section, Words, parse};
use super::unit::{Dimension, Measure};
use carom_impact::uncertain::{Distribution, Sampling};
use carom_special::RangeError;
use std::ops::Range as Span;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Fields that may be a distribution, and their ranges.
const FIELDS: [(&str, Measure); 27] = [
    ("contact.friction", Range::NonNegativeOrInfinite.of(Dimension::None)),
    ("approach.speed", Range::NonNegativeSpeed.of(Dimension::Speed)),
    ("approach.angle", Range::Incidence.of(Dimension::Degrees)),
    ("body_1.radius", Range::Positive.of(Dimension::Length)),
    ("body_1.density", Range::Positive.of(Dimension::Density)),
    ("body_1.mass", Range::PositiveOrInfinite.of(Dimension::Mass)),
    ("body_1.velocity.x", Range::Speed.of(Dimension::Speed)),
    ("body_1.velocity.y", Range::Speed.of(Dimension::Speed)),
    ("body_1.velocity.z", Range::Speed.of(Dimension::Speed)),
    ("body_1.spin.x", Range::Speed.of(Dimension::Spin)),
    ("body_1.spin.y", Range::Speed.of(Dimension::Spin)),
    ("body_1.spin.z", Range::Speed.of(Dimension::Spin)),
    ("body_1.material.young_modulus", Range::Positive.of(Dimension::Pressure)),
    ("body_1.material.shear_modulus", Range::Positive.of(Dimension::Pressure)),
    ("body_1.material.poisson", Range::Poisson.of(Dimension::None)),
    ("body_2.radius", Range::Positive.of(Dimension::Length)),
    ("body_2.density", Range::Positive.of(Dimension::Density)),
    ("body_2.mass", Range::PositiveOrInfinite.of(Dimension::Mass)),
    ("body_2.material.young_modulus", Range::Positive.of(Dimension::Pressure)),
    ("body_2.material.shear_modulus", Range::Positive.of(Dimension::Pressure)),
    ("body_2.material.poisson", Range::Poisson.of(Dimension::None)),
    ("body_2.velocity.x", Range::Speed.of(Dimension::Speed)),
    ("body_2.velocity.y", Range::Speed.of(Dimension::Speed)),
    ("body_2.velocity.z", Range::Speed.of(Dimension::Speed)),
    ("body_2.spin.x", Range::Speed.of(Dimension::Spin)),
    ("body_2.spin.y", Range::Speed.of(Dimension::Spin)),
    ("body_2.spin.z", Range::Speed.of(Dimension::Spin)),
];
const KINDS: Words = Words {
    words: &["normal", "log_normal", "uniform", "triangular"],
    allowed: "{ normal = { mean, sd } }, { log_normal = { mean, sd } }, \
              { uniform = { low, high } } or { triangular = { low, mode, high } }",
};
const SETTINGS: &[&str] = &["samples", "seed", "bins", "quantiles"];
/// The largest whole number that a floating-point number holds with all before it.
const MOST_SEED: f64 = 9_007_199_254_740_992.0;

/// An impact with uncertain inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct UncertainCase {
    /// How many samples, from which seed.
    pub sampling: Sampling,
    /// Bins of the histograms.
    pub bins: usize,
    /// Quantiles to give, in [0, 1].
    pub quantiles: Vec<f64>,
    inputs: Vec<Input>,
    source: String,
}

/// A field with its distribution and where it stands in the file.
#[derive(Debug, Clone, PartialEq)]
struct Input {
    field: &'static str,
    distribution: Distribution,
    span: Span<usize>,
}

impl UncertainCase {
    /// Reads a case from the text of its file; none if no field is uncertain.
    ///
    /// # Errors
    /// If the text is not TOML, a field is missing, unknown, out of range (a distribution's mean
    /// included) or in conflict with another, or the case sweeps over angles.
    pub fn parse(source: &str) -> Result<Option<Self>, CaseError> {
        let table = parse(source)?;
        let mut inputs = Vec::new();
        walk(source, table.get_ref(), "", &mut inputs)?;
        inputs.sort_by_key(|input| input.span.start);
        let case = Section::root(source, table.get_ref(), super::impact::FIELDS)?;
        if inputs.is_empty() && !case.has("uncertainty") {
            return Ok(None);
        }
        if inputs.is_empty() {
            let field = "contact.friction";
            let reason = "no field is uncertain; give one as a distribution";
            return Err(case.conflict("uncertainty", field, reason));
        }
        let settings = case.section("uncertainty", SETTINGS)?;
        let (sampling, bins, quantiles) = read_settings(&settings)?;
        let read = Self { sampling, bins, quantiles, inputs, source: source.to_owned() };
        let nominal = read.nominal()?;
        if nominal.is_sweep() {
            let reason = "a sweep has no single impact to vary";
            return Err(case.conflict("uncertainty", "approach.angle", reason));
        }
        Ok(Some(read))
    }

    /// The uncertain fields, in the order of the file.
    #[must_use]
    pub fn fields(&self) -> Vec<&'static str> {
        self.inputs.iter().map(|input| input.field).collect()
    }

    /// Their distributions.
    #[must_use]
    pub fn distributions(&self) -> Vec<Distribution> {
        self.inputs.iter().map(|input| input.distribution).collect()
    }

    /// The case with these values in the place of the distributions.
    ///
    /// # Errors
    /// As [`ImpactCase::parse`].
    pub fn case(&self, values: &[f64]) -> Result<ImpactCase, CaseError> {
        let mut text = String::with_capacity(self.source.len());
        let mut from = 0;
        for (Input { span, .. }, value) in self.inputs.iter().zip(values) {
            text.push_str(self.source.get(from..span.start).unwrap_or_default());
            text.push_str(&format!("{value:?}"));
            // Lines keep their numbers.
            let lines = self.source.get(span.clone()).unwrap_or_default().matches('\n').count();
            text.push_str(&"\n".repeat(lines));
            from = span.end;
        }
        text.push_str(self.source.get(from..).unwrap_or_default());
        ImpactCase::parse(&text)
    }

    /// The error of [`UncertainCase::case`] for drawn values as that of a field out of range.
    #[must_use]
    pub fn out_of_range(error: &CaseError) -> RangeError {
        if let CaseError::Range { field, value, .. } = error {
            if let Some((name, measure)) = FIELDS.iter().find(|(name, _)| name == field) {
                return RangeError::new(name, *value, measure.range.allowed());
            }
            return RangeError::new("a derived value", *value, "possible together with the others");
        }
        RangeError::new("the drawn values", f64::NAN, "possible together")
    }

    /// The case with every input at its mean.
    ///
    /// # Errors
    /// As [`ImpactCase::parse`].
    pub fn nominal(&self) -> Result<ImpactCase, CaseError> {
        let means: Vec<f64> = self.inputs.iter().map(|input| input.distribution.mean()).collect();
        self.case(&means)
    }
}

fn read_settings(settings: &Section<'_>) -> Result<(Sampling, usize, Vec<f64>), CaseError> {
    let samples = settings.number("samples", Range::Count)?;
    let seed = settings.number("seed", Range::NonNegative)?;
    if seed.fract() != 0.0 || seed > MOST_SEED {
        return Err(settings.out_of_range("seed", seed, "a whole number from 0 to 2^53"));
    }
    let sampling = Sampling::new(samples as usize, seed as u64)
        .map_err(|error| settings.out_of_range("samples", error.value, error.allowed))?;
    let bins = match settings.has("bins") {
        true => settings.number("bins", Range::Whole)? as usize,
        false => 40,
    };
    if !settings.has("quantiles") {
        return Ok((sampling, bins, vec![0.05, 0.25, 0.5, 0.75, 0.95]));
    }
    let quantiles = settings.list("quantiles", Range::NonNegative)?;
    match quantiles.iter().find(|part| **part > 1.0) {
        Some(part) => Err(settings.out_of_range("quantiles", *part, "in [0, 1]")),
        None => Ok((sampling, bins, quantiles)),
    }
}

/// Finds the distributions in a table and the tables in it.
fn walk<'a>(
    source: &'a str,
    table: &'a DeTable<'a>,
    path: &str,
    inputs: &mut Vec<Input>,
) -> Result<(), CaseError> {
    for (name, value) in table.iter() {
        let name = name.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        match value.get_ref() {
            DeValue::Table(_) => table_at(source, value, path, inputs)?,
            DeValue::Array(items) => {
                for (axis, item) in ["x", "y", "z"].iter().zip(items.iter()) {
                    if item.get_ref().is_table() {
                        table_at(source, item, format!("{path}.{axis}"), inputs)?;
                    }
                }
            }
            _ => {}
        }
    }
    Ok(())
}

fn table_at<'a>(
    source: &'a str,
    value: &'a Spanned<DeValue<'a>>,
    path: String,
    inputs: &mut Vec<Input>,
) -> Result<(), CaseError> {
    let DeValue::Table(table) = value.get_ref() else {
        return Ok(());
    };
    let span = value.span();
    let is_inline = source.get(span.clone()).is_some_and(|text| text.starts_with('{'));
    let is_sweep = table.iter().any(|(name, _)| name.get_ref() == "start");
    match FIELDS.iter().find(|(name, _)| *name == path) {
        Some((field, Measure { dimension, .. })) if is_inline && !is_sweep => {
            let section = Section::new(source, path, table, KINDS.words)?;
            let distribution = read_distribution(&section, *dimension)?;
            inputs.push(Input { field, distribution, span });
            Ok(())
        }
        _ => walk(source, table, &path, inputs),
    }
}

fn read_distribution(
    section: &Section<'_>,
    dimension: Dimension,
) -> Result<Distribution, CaseError> {
    let given: Vec<&str> = KINDS.words.iter().copied().filter(|word| section.has(word)).collect();
    let kind = match given.as_slice() {
        [kind] => *kind,
        [] => return Err(section.missing("normal", KINDS.allowed)),
        [one, other, ..] => return Err(section.conflict(other, one, "give one of them")),
    };
    let names: &[&'static str] = match kind {
        "uniform" => &["low", "high"],
        "triangular" => &["low", "mode", "high"],
        _ => &["mean", "sd"],
    };
    let of = section.section(kind, names)?;
    let number = |name: &str| of.number(name, Range::Finite.of(dimension));
    let made = match kind {
        "uniform" => Distribution::uniform(number("low")?, number("high")?),
        "triangular" => Distribution::triangular(number("low")?, number("mode")?, number("high")?),
        "normal" => Distribution::normal(number("mean")?, number("sd")?),
        _ => Distribution::log_normal(number("mean")?, number("sd")?),
    };
    made.map_err(|error| of.out_of_range(error.field, error.value, error.allowed))
}
