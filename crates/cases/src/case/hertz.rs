//! The case file of `carom hertz`.

use super::error::CaseError;
use super::field::{Default, Field, Form, Schema};
use super::pair::{self, ANGLE, BODY_1, BODY_2, LENGTH};
use super::range::Range;
use super::reader::Case;
use super::section::{Numbers, Section, parse};
use super::unit::{Dimension, Measure};
use super::varied::{Input, UNKNOWN, Varied};
use crate::PointOrLine;
use toml::de::DeTable;

const SIZE: Measure = Range::Positive.of(Dimension::Length);
const OTHERS: &str = "one of `force`, `approach`, `semi_axis_a`, `semi_axis_b`, `peak_pressure`";
const FORCE: Field =
    load("force", Range::Positive.of(Dimension::Force), "normal force").such_as("[1, 10, 100]");
const APPROACH: Field = load("approach", SIZE, "approach of distant points").such_as("1e-6");
const TOUCH: Field = Field::number(
    "touch",
    Range::Finite.of(Dimension::Length),
    "reading of the approach at which the bodies first touch: `approach` counts from there",
)
.default(Default::Number(0.0))
.such_as("0");
const SEMI_AXIS_A: Field =
    load("semi_axis_a", SIZE, "semi-axis of the contact along x, half width of a line")
        .such_as("1e-4");
const SEMI_AXIS_B: Field =
    load("semi_axis_b", SIZE, "semi-axis of the contact along y").such_as("1e-4");
const PEAK_PRESSURE: Field =
    load("peak_pressure", Range::Positive.of(Dimension::Pressure), "greatest pressure")
        .such_as("\"1 GPa\"");
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[ANGLE, LENGTH]),
    "orientation of the bodies, length of a line",
)
.may("their first principal directions are parallel");
const LOAD: Field = Field::new(
    "load",
    Form::Table(&[FORCE, APPROACH, TOUCH, SEMI_AXIS_A, SEMI_AXIS_B, PEAK_PRESSURE]),
    "one of these, for one contact or several: a list, or { start, stop, count }",
)
.begun(&[(&FORCE, "")]);

/// All fields.
const FIELDS: &[Field] = &[BODY_1, BODY_2, CONTACT, LOAD];

const fn load(name: &'static str, measure: Measure, meaning: &'static str) -> Field {
    Field::new(name, Form::Numbers(measure), meaning).or(OTHERS)
}

/// A Hertz contact under one or more loads.
#[derive(Debug, Clone, PartialEq)]
pub struct HertzCase {
    /// The contact.
    pub contact: PointOrLine,
    /// The smallest radius of curvature of both bodies, m; infinite for planes.
    pub smallest_radius: f64,
    /// Which quantity the values give.
    pub given: Given,
    /// The values, one for each contact.
    pub values: Numbers,
    /// The reading of the approach at which the bodies first touch, m: the values count from there.
    pub touch: f64,
    /// The numbers that data shall determine.
    pub unknowns: Vec<Input>,
}

/// The quantity that gives the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// The normal force, N.
    Force,
    /// The approach, m.
    Approach,
    /// The semi-axis along x, or the half width of a line, m.
    SemiAxisA,
    /// The semi-axis along y, m.
    SemiAxisB,
    /// The greatest pressure, Pa.
    PeakPressure,
}

impl Case<'_> for HertzCase {
    const SCHEMA: Schema =
        Schema::new("hertz", "Two surfaces pressed together.", FIELDS).varying(UNKNOWN);

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let varied = Varied::new(FIELDS, Vec::new()).unknown();
        let case = read(source, table.get_ref(), &varied)?;
        Ok(Self { unknowns: varied.found(), ..case })
    }
}

/// Reads a case with values for its unknowns.
pub(super) fn read(
    source: &str,
    table: &DeTable<'_>,
    varied: &Varied,
) -> Result<HertzCase, CaseError> {
    let case = &Section::root(source, table, FIELDS)?.varying(varied);
    let contact = case.has(&CONTACT).then(|| case.section(&CONTACT)).transpose()?;
    let (contact, smallest_radius) = pair::read_any(case, contact.as_ref())?;
    let load = case.section(&LOAD)?;
    let ways = [
        (&FORCE, Given::Force),
        (&APPROACH, Given::Approach),
        (&SEMI_AXIS_A, Given::SemiAxisA),
        (&SEMI_AXIS_B, Given::SemiAxisB),
        (&PEAK_PRESSURE, Given::PeakPressure),
    ];
    let mut present = ways.into_iter().filter(|(field, _)| load.has(*field));
    let (field, given) = present.next().ok_or_else(|| load.missing(&FORCE))?;
    if let Some((other, _)) = present.next() {
        return Err(load.conflict(other, field, "give one of them"));
    }
    let touch = load.number(&TOUCH)?;
    if load.has(&TOUCH) && given != Given::Approach {
        return Err(load.conflict(&TOUCH, field, "it is a reading of the approach"));
    }
    let values = match load.numbers(field)? {
        Numbers::One(value) => Numbers::One(value - touch),
        Numbers::Sweep(values) => {
            Numbers::Sweep(values.into_iter().map(|value| value - touch).collect())
        }
    };
    let unknowns = Vec::new();
    Ok(HertzCase { contact, smallest_radius, given, values, touch, unknowns })
}
