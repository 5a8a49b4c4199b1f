//! Numbers of a case that stand for many: a sweep, or a distribution.

use super::error::CaseError;
use super::range::Range;
use super::section::{Section, Words};
use super::unit::{Dimension, Measure};
use carom_impact::uncertain::Distribution;
use std::cell::RefCell;
use toml::Spanned;
use toml::de::DeValue;

const SWEEP: [&str; 3] = ["start", "stop", "count"];
const KINDS: Words = Words {
    words: &["normal", "log_normal", "uniform", "triangular"],
    allowed: "{ normal = { mean, sd } }, { log_normal = { mean, sd } }, \
              { uniform = { low, high } }, { triangular = { low, mode, high } } or a sweep \
              { start, stop, count }",
};

/// What a number stands for.
#[derive(Debug, Clone, PartialEq)]
pub enum Variation {
    /// One after the other.
    Sweep(Vec<f64>),
    /// Drawn from this distribution.
    Uncertain(Distribution),
}

/// A varied number.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Its field with the path.
    pub field: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// What every value of it must be.
    pub allowed: &'static str,
    /// What it stands for.
    pub variation: Variation,
    /// Where in the file it stands.
    place: usize,
}

impl Input {
    /// The values of a sweep.
    #[must_use]
    pub fn sweep(&self) -> Option<&[f64]> {
        match &self.variation {
            Variation::Sweep(values) => Some(values),
            Variation::Uncertain(_) => None,
        }
    }

    /// The distribution of an uncertain number.
    #[must_use]
    pub const fn distribution(&self) -> Option<Distribution> {
        match self.variation {
            Variation::Sweep(_) => None,
            Variation::Uncertain(distribution) => Some(distribution),
        }
    }

    pub(super) const fn place(&self) -> usize {
        self.place
    }
}

/// The varied numbers of a case, found while it is read, and the values that stand for them.
#[derive(Debug, Default)]
pub(super) struct Varied {
    drawn: Vec<(usize, f64)>,
    found: RefCell<Vec<Input>>,
}

impl Varied {
    /// With these values, by their places in the file.
    pub(super) const fn drawn(drawn: Vec<(usize, f64)>) -> Self {
        Self { drawn, found: RefCell::new(Vec::new()) }
    }

    /// Those found, in the order of the file.
    pub(super) fn found(self) -> Vec<Input> {
        let mut found = self.found.into_inner();
        found.sort_by_key(|input| input.place);
        found
    }

    /// The number that stands for a value of several; none if the value is not of such a kind.
    pub(super) fn number<'a>(
        &self,
        section: &Section<'a>,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        measure: Measure,
    ) -> Result<Option<f64>, CaseError> {
        let place = value.span().start;
        if let Some((_, number)) = self.drawn.iter().find(|(at, _)| *at == place) {
            return section.in_range(name, *number, measure).map(Some);
        }
        let variation = match value.get_ref() {
            DeValue::Array(_) => Variation::Sweep(section.list_at(name, value, measure)?),
            DeValue::Table(_) => read(&section.table_at(name, value)?, measure)?,
            _ => return Ok(None),
        };
        let number = section.in_range(name, variation.nominal(), measure)?;
        let mut found = self.found.borrow_mut();
        if found.iter().all(|input| input.place != place) {
            // A few names, as long as the program runs: errors of the library carry such.
            let field = section.full(name).leak();
            let (unit, allowed) = (measure.dimension.unit(), measure.range.allowed());
            found.push(Input { field, unit, allowed, variation, place });
        }
        Ok(Some(number))
    }
}

fn read(section: &Section<'_>, measure: Measure) -> Result<Variation, CaseError> {
    if SWEEP.iter().any(|name| section.has(name)) {
        section.check(&SWEEP)?;
        let start = section.number("start", measure)?;
        let stop = section.number("stop", measure)?;
        let count = section.number("count", Range::Count)?;
        return Ok(Variation::Sweep(carom_special::linspace(start, stop, count as usize)));
    }
    section.check(KINDS.words)?;
    read_distribution(section, measure.dimension).map(Variation::Uncertain)
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
