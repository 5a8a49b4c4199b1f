//! Numbers of a case that vary: a sweep or a distribution.

use super::error::CaseError;
use super::field::{Field, Form, interned};
use super::range::Range;
use super::section::{COUNT, START, STOP, Section, Varying};
use super::unit::Measure;
use carom_impact::uncertain::Distribution;
use std::cell::RefCell;
use toml::Spanned;
use toml::de::DeValue;

const fn number(name: &'static str, meaning: &'static str) -> Field {
    Field::number(name, Range::Finite.pure(), meaning)
}

const fn distribution(
    name: &'static str,
    fields: &'static [Field],
    meaning: &'static str,
) -> Field {
    Field::new(name, Form::Table(fields), meaning).or(KINDS)
}

const MEAN: Field = number("mean", "mean of the number itself");
const DEVIATION: Field = number("sd", "standard deviation of the number itself");
const LOW: Field = number("low", "smallest value");
const MODE: Field = number("mode", "most likely value");
const HIGH: Field = number("high", "largest value");
const NORMAL: Field = distribution("normal", &[MEAN, DEVIATION], "a normal distribution");
const LOG_NORMAL: Field =
    distribution("log_normal", &[MEAN, DEVIATION], "a log-normal distribution");
const UNIFORM: Field = distribution("uniform", &[LOW, HIGH], "a uniform distribution");
const TRIANGULAR: Field =
    distribution("triangular", &[LOW, MODE, HIGH], "a triangular distribution");
const KINDS: &str = "{ normal = { mean, sd } }, { log_normal = { mean, sd } }, \
                     { uniform = { low, high } }, { triangular = { low, mode, high } }, a sweep \
                     { start, stop, count } or an unknown { fit = [low, high] }";
const UNKNOWNS: &str = "{ fit = [low, high] } or { prior = { mean, sd } }";
const ENDS: &str = "two numbers [low, high]";
const FIT: Field = Field::new(
    "fit",
    Form::Vector(&["low", "high"], Range::Finite.pure(), ENDS),
    "an unknown between these numbers, which `carom fit` determines from data",
)
.or(UNKNOWNS);
const PRIOR: Field = Field::new(
    "prior",
    Form::Table(&[MEAN, DEVIATION]),
    "an unknown of which this is known before the data: it counts as one more measurement",
)
.or(UNKNOWNS);
/// How far from its mean an unknown with a prior is looked for at first and at most, in standard deviations.
const REACH: [f64; 2] = [8.0, 1e4];
/// Standard deviations of a prior over the size of its mean.
const DEVIATIONS: std::ops::RangeInclusive<f64> = 1e-12..=1e6;

/// The fields of a varied number of an impact.
pub(super) const VARIED: &[Field] =
    &[START, STOP, COUNT, NORMAL, LOG_NORMAL, UNIFORM, TRIANGULAR, FIT, PRIOR];
/// The fields of an unknown number.
pub(super) const UNKNOWN: &[Field] = &[FIT, PRIOR];

/// A number that data shall determine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unknown {
    /// The smallest value that is looked for.
    pub low: f64,
    /// The largest.
    pub high: f64,
    /// Mean and standard deviation of what is known before the data, if anything is.
    pub prior: Option<[f64; 2]>,
    /// As far as a fit may move the bounds: those of a prior are but where the search begins.
    pub widest: [f64; 2],
}

/// The values of a varied number.
#[derive(Debug, Clone, PartialEq)]
pub enum Variation {
    /// Computed one after the other.
    Sweep(Vec<f64>),
    /// Sampled from this distribution.
    Uncertain(Distribution),
    /// Determined by data.
    Unknown(Unknown),
}

impl Variation {
    /// The single value that represents it: the first of a sweep, the mean of a distribution, the middle of an unknown.
    fn nominal(&self) -> f64 {
        match self {
            // A sweep has at least one value.
            Self::Sweep(values) => values.first().copied().unwrap_or(f64::NAN),
            Self::Uncertain(distribution) => distribution.mean(),
            Self::Unknown(Unknown { prior: Some([mean, _]), .. }) => *mean,
            Self::Unknown(Unknown { low, high, .. }) => 0.5 * low + 0.5 * high,
        }
    }
}

/// A varied number.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Its field with the path.
    pub field: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The allowed values, in words.
    pub allowed: &'static str,
    /// Its values.
    pub variation: Variation,
    /// Its line, from 1.
    pub line: usize,
    /// Its offset in the file.
    place: usize,
}

impl Input {
    /// The values of a sweep.
    #[must_use]
    pub fn sweep(&self) -> Option<&[f64]> {
        match &self.variation {
            Variation::Sweep(values) => Some(values),
            _ => None,
        }
    }

    /// The distribution of an uncertain number.
    #[must_use]
    pub const fn distribution(&self) -> Option<Distribution> {
        match self.variation {
            Variation::Uncertain(distribution) => Some(distribution),
            _ => None,
        }
    }

    /// The bounds of an unknown.
    #[must_use]
    pub const fn unknown(&self) -> Option<Unknown> {
        match self.variation {
            Variation::Unknown(unknown) => Some(unknown),
            _ => None,
        }
    }

    /// Its offset in the file.
    #[must_use]
    pub const fn place(&self) -> usize {
        self.place
    }
}

/// The varied numbers of a case, collected while it is read, and the values that replace them.
#[derive(Debug)]
pub(super) struct Varied {
    fields: &'static [Field],
    forms: &'static [Field],
    drawn: Vec<(usize, f64)>,
    found: RefCell<Vec<Input>>,
}

impl Varied {
    /// For a case with these fields; with values for the numbers at these offsets.
    pub(super) const fn new(fields: &'static [Field], drawn: Vec<(usize, f64)>) -> Self {
        Self { fields, forms: VARIED, drawn, found: RefCell::new(Vec::new()) }
    }

    /// The same for a case whose numbers may be unknown, but not vary otherwise.
    pub(super) fn unknown(self) -> Self {
        Self { forms: UNKNOWN, ..self }
    }

    /// The varied numbers, in the order of the file.
    pub(super) fn found(self) -> Vec<Input> {
        let mut found = self.found.into_inner();
        found.sort_by_key(|input| input.place);
        found
    }
}

impl Varying for Varied {
    fn number<'a>(
        &self,
        section: &Section<'a>,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        measure: Measure,
    ) -> Result<Option<f64>, CaseError> {
        let place = value.span().start;
        if let Some((_, number)) = self.drawn.iter().find(|(at, _)| *at == place) {
            return section.in_range(name, value, *number, measure).map(Some);
        }
        let variation = match value.get_ref() {
            DeValue::Array(_) if self.forms.len() == VARIED.len() => {
                Variation::Sweep(section.list_at(name, value, measure)?)
            }
            DeValue::Table(_) => read(&section.table_at(name, value, self.forms)?, measure)?,
            _ => return Ok(None),
        };
        if let Variation::Unknown(Unknown { low, high, .. }) = variation {
            section.in_range(name, value, low, measure)?;
            section.in_range(name, value, high, measure)?;
        }
        let number = section.in_range(name, value, variation.nominal(), measure)?;
        let mut found = self.found.borrow_mut();
        if found.iter().all(|input| input.place != place) {
            let (field, line) =
                (interned(self.fields, &section.full(name)), section.line_of(value));
            let (unit, allowed) = (measure.dimension.unit(), measure.range.allowed());
            found.push(Input { field, unit, allowed, variation, line, place });
        }
        Ok(Some(number))
    }
}

fn read(section: &Section<'_>, measure: Measure) -> Result<Variation, CaseError> {
    let sweep = section.given([&START, &STOP, &COUNT]);
    let kinds = section.given([&NORMAL, &LOG_NORMAL, &UNIFORM, &TRIANGULAR, &FIT, &PRIOR]);
    match (sweep.as_slice(), kinds.as_slice()) {
        ([], [kind]) if UNKNOWN.iter().any(|unknown| unknown.name == kind.name) => {
            read_unknown(section, kind, measure).map(Variation::Unknown)
        }
        ([], [kind]) => read_distribution(section, kind, measure).map(Variation::Uncertain),
        ([], []) => Err(section.empty(KINDS)),
        (_, []) => section.spaced(measure).map(Variation::Sweep),
        ([], several) => Err(section.several(several, "give one of them")),
        ([one, ..], [other, ..]) => {
            Err(section.conflict(*other, *one, "give a sweep or a distribution"))
        }
    }
}

fn read_unknown(
    section: &Section<'_>,
    kind: &'static Field,
    measure: Measure,
) -> Result<Unknown, CaseError> {
    let plain = Range::Finite.of(measure.dimension);
    if kind.name == PRIOR.name {
        let of = section.section(&PRIOR)?;
        let [mean, sd] =
            [of.number(&MEAN.measured(plain))?, of.number(&DEVIATION.measured(plain))?];
        let size = if mean == 0.0 { 1.0 } else { mean.abs() };
        if !DEVIATIONS.contains(&(sd / size)) {
            return Err(of.out_of_range(
                &DEVIATION,
                sd,
                "from 1e-12 to 1e6 times the size of the mean",
            ));
        }
        // As far as the number may go.
        let within = |value: f64, end: usize| match measure.range.holds(value) {
            true => value,
            false => measure.range.ends()[end].within(mean),
        };
        let ends = |reach: f64| [within(mean - reach * sd, 0), within(mean + reach * sd, 1)];
        let ([low, high], widest) = (ends(REACH[0]), ends(REACH[1]));
        return Ok(Unknown { low, high, prior: Some([mean, sd]), widest });
    }
    let ends = Field { form: Form::Vector(&["low", "high"], plain, ENDS), ..FIT };
    let [low, high] = section.vector::<2>(&ends)?;
    if low >= high || !(high - low).is_finite() {
        return Err(section.out_of_range(&FIT, high, "[low, high] with low < high"));
    }
    Ok(Unknown { low, high, prior: None, widest: [low, high] })
}

fn read_distribution(
    section: &Section<'_>,
    kind: &'static Field,
    measure: Measure,
) -> Result<Distribution, CaseError> {
    let of = section.section(kind)?;
    let plain = Range::Finite.of(measure.dimension);
    let number = |field: &Field| of.number(&field.measured(plain));
    let made = if kind.name == UNIFORM.name {
        Distribution::uniform(number(&LOW)?, number(&HIGH)?)
    } else if kind.name == TRIANGULAR.name {
        Distribution::triangular(number(&LOW)?, number(&MODE)?, number(&HIGH)?)
    } else if kind.name == NORMAL.name {
        Distribution::normal(number(&MEAN)?, number(&DEVIATION)?)
    } else {
        Distribution::log_normal(number(&MEAN)?, number(&DEVIATION)?)
    };
    made.map_err(|error| {
        let field = [&MEAN, &DEVIATION, &LOW, &MODE, &HIGH];
        let field = field.into_iter().find(|field| field.name == error.field);
        of.out_of_range(field.unwrap_or(&MEAN), error.value, error.allowed)
    })
}
