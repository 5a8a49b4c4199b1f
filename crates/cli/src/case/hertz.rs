//! The case file of `carom hertz`.

use super::error::CaseError;
use super::pair;
use super::range::Range;
use super::section::{Numbers, Section, parse};
use super::unit::Dimension;
use carom_laws::hertz::Hertz;

const FIELDS: &[&str] = &["body_1", "body_2", "contact", "load"];
const LOAD: [(&str, Given); 4] = [
    ("force", Given::Force),
    ("approach", Given::Approach),
    ("semi_axis_a", Given::SemiAxisA),
    ("semi_axis_b", Given::SemiAxisB),
];

/// A Hertz contact under one or more loads.
#[derive(Debug, Clone, PartialEq)]
pub struct HertzCase {
    /// The contact.
    pub hertz: Hertz,
    /// What the loads are given by.
    pub given: Given,
    /// The loads.
    pub values: Numbers,
}

/// What a load is given by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// The normal force, N.
    Force,
    /// The approach, m.
    Approach,
    /// The semi-axis along x, m.
    SemiAxisA,
    /// The semi-axis along y, m.
    SemiAxisB,
}

impl Given {
    const fn dimension(self) -> Dimension {
        match self {
            Self::Force => Dimension::Force,
            Self::Approach | Self::SemiAxisA | Self::SemiAxisB => Dimension::Length,
        }
    }
}

impl HertzCase {
    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let contact = case.section("contact", &["angle"])?;
        let hertz = pair::read(&case, &contact)?;
        let load = case.section("load", &LOAD.map(|(name, _)| name))?;
        let mut present = LOAD.into_iter().filter(|(name, _)| load.has(name));
        let allowed = "finite and > 0 (or `approach`, `semi_axis_a`, `semi_axis_b`)";
        let (name, given) = present.next().ok_or_else(|| load.missing("force", allowed))?;
        if let Some((other, _)) = present.next() {
            return Err(load.conflict(other, name, "give one of them"));
        }
        Ok(Self {
            hertz,
            given,
            values: load.numbers(name, Range::Positive.of(given.dimension()))?,
        })
    }
}
