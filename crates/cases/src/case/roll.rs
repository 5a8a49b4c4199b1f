//! The case file of `carom roll`.

use super::error::CaseError;
use super::field::{Default, Field, Form, Usual};
use super::kind::CaseKind;
use super::material::{self, MATERIAL};
use super::range::Range;
use super::section::{Numbers, Section, parse, survey};
use super::unit::{Dimension, Measure};
use carom_halfspace::MaterialPair;
use carom_laws::curvature::{CurvatureError, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::hertz::{Hertz, HertzState};
use carom_rolling::Creepage;

const BODY_1: Field =
    Field::new("body_1", Form::Table(&[MATERIAL]), "the body on the side to which z points");
const BODY_2: Field = Field::new("body_2", Form::Table(&[MATERIAL]), "the other body");

const PAIR: &str = "two lengths [along the rolling direction, across it]";
const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const SEMI_AXES: Field = Field::new(
    "semi_axes",
    Form::Vector(&["x", "y"], LENGTH, PAIR),
    "semi-axes of the contact ellipse",
)
.or("`radii`")
.such_as("[0.006, 0.004]");
const RADII: Field =
    Field::new("radii", Form::Vector(&["x", "y"], LENGTH, PAIR), "relative radii of curvature")
        .or("`semi_axes`")
        .such_as("[0.46, 0.3]");
const FORCE: Field =
    Field::number("F_z", Range::Positive.of(Dimension::Force), "normal force").such_as("8e4");
const FRICTION: Field =
    Field::number("friction", Range::Positive.pure(), "coefficient of friction f")
        .such_as("0.3")
        .usually(Usual::FRICTION);
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[SEMI_AXES, RADII, FORCE, FRICTION]),
    "an elliptical contact under load",
)
.begun(&[(&SEMI_AXES, "")]);

const SPEED: Field =
    Field::number("speed", Range::Positive.of(Dimension::Speed), "rolling speed, along x")
        .such_as("20");
const ALONG: Field = creepage(
    "creepage",
    Range::Finite.pure(),
    "creepage along x: sliding velocity of body 2 against body 1 over the rolling speed",
)
.such_as("[0.0005, 0.001, 0.002, 0.004]");
const ACROSS: Field = creepage("creepage_across", Range::Finite.pure(), "creepage along y");
const SPIN: Field = creepage(
    "spin",
    Range::Finite.of(Dimension::PerLength),
    "spin creepage: rotation of body 2 against body 1 about the normal per length rolled",
);
const DISTANCE: Field = Field::number(
    "distance",
    LENGTH,
    "distance to roll from rest, step by step, with one creepage; at most 100 lengths of the contact",
)
.may("the steady state is computed directly")
.such_as("0.03");
const ROLLING: Field = Field::new(
    "rolling",
    Form::Table(&[SPEED, ALONG, ACROSS, SPIN, DISTANCE]),
    "speed and creepages; a creepage is one value or several: a list, or { start, stop, count }",
)
.begun(&[(&SPEED, ""), (&ALONG, "")]);

const ELEMENTS_ACROSS: f64 = 20.0;
const ELEMENTS: Field =
    Field::number("elements", Range::Elements.pure(), "cells across the contact, along both axes")
        .default(Default::Number(ELEMENTS_ACROSS));
const GRID: Field = Field::new("grid", Form::Table(&[ELEMENTS]), "the grid").may("its defaults");

/// All fields.
pub(super) const FIELDS: &[Field] = &[BODY_1, BODY_2, CONTACT, ROLLING, GRID];

/// Longest rolling distance, in lengths of the contact.
const MOST_LENGTHS: f64 = 100.0;

const fn creepage(name: &'static str, measure: Measure, meaning: &'static str) -> Field {
    Field::new(name, Form::Numbers(measure), meaning).default(Default::Number(0.0))
}

/// A rolling contact.
#[derive(Debug, Clone, PartialEq)]
pub struct RollCase {
    /// The contact; x is the direction of rolling.
    pub hertz: Hertz,
    /// The contact under its load.
    pub loaded: HertzState,
    /// Coefficient of friction.
    pub friction: f64,
    /// Rolling speed, m/s.
    pub speed: f64,
    /// The creepages, each computed separately.
    pub creepages: Vec<Creepage>,
    /// How far it rolls from rest, m; none for the steady state.
    pub distance: Option<f64>,
    /// Elements across the contact.
    pub elements: usize,
}

impl RollCase {
    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        Self::read(source).map_err(|first| survey::all(CaseKind::Roll, source, first))
    }

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let body = |field| material::read(&case.section(field)?);
        let materials = MaterialPair::new(body(&BODY_1)?, body(&BODY_2)?)
            .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
        let contact = case.section(&CONTACT)?;
        let (hertz, loaded) = read_contact(&contact, materials)?;
        let friction = contact.number(&FRICTION)?;
        let rolling = case.section(&ROLLING)?;
        let speed = rolling.number(&SPEED)?;
        let creepages = read_creepages(&rolling)?;
        let distance = read_distance(&rolling, loaded.ellipse.semi_axis_a(), creepages.len())?;
        let elements = match case.has(&GRID) {
            true => case.section(&GRID)?.count(&ELEMENTS)?,
            false => ELEMENTS_ACROSS as usize,
        };
        Ok(Self { hertz, loaded, friction, speed, creepages, distance, elements })
    }
}

fn read_contact(
    contact: &Section<'_>,
    materials: MaterialPair,
) -> Result<(Hertz, HertzState), CaseError> {
    let force = contact.number(&FORCE)?;
    let field = match contact.given([&SEMI_AXES, &RADII]).as_slice() {
        [] => return Err(contact.missing(&SEMI_AXES)),
        [field] => *field,
        both => return Err(contact.several(both, "give one of the two")),
    };
    let [x, y]: [f64; 2] = contact.vector(field)?;
    let made = if field.name == SEMI_AXES.name {
        ContactEllipse::new(x, y)
            .map_err(CurvatureError::from)
            .and_then(|ellipse| Hertz::from_ellipse_and_force(ellipse, force, materials))
    } else {
        RelativeCurvature::from_coefficients(0.5 / x, 0.5 / y)
            .and_then(|curvature| Ok(Hertz::new(curvature, materials)?))
    };
    let hertz = made.map_err(|source| CaseError::Curvature { source })?;
    let loaded = hertz
        .at_force(force)
        .map_err(|error| contact.out_of_range(&FORCE, error.value, error.allowed))?;
    Ok((hertz, loaded))
}

/// Reads the creepages. Several values of one are combined with the single value of another, or pairwise with
/// as many.
fn read_creepages(rolling: &Section<'_>) -> Result<Vec<Creepage>, CaseError> {
    let fields = [&ALONG, &ACROSS, &SPIN];
    let read = |field| match rolling.has(field) {
        true => rolling.numbers(field),
        false => Ok(Numbers::One(0.0)),
    };
    let [along, across, spin] = [read(fields[0])?, read(fields[1])?, read(fields[2])?];
    let all = [along.as_slice(), across.as_slice(), spin.as_slice()];
    let longest = (0..3).max_by_key(|i| all[*i].len()).unwrap_or(0);
    let count = all[longest].len();
    if let Some(i) = (0..3).find(|i| all[*i].len() > 1 && all[*i].len() != count) {
        let reason = "both must have the same number of values";
        return Err(rolling.conflict(fields[i], fields[longest], reason));
    }
    let at = |values: &[f64], i: usize| values[i.min(values.len() - 1)];
    let row = |i| Creepage { along: at(all[0], i), across: at(all[1], i), spin: at(all[2], i) };
    Ok((0..count).map(row).collect())
}

fn read_distance(
    rolling: &Section<'_>,
    semi_axis: f64,
    creepages: usize,
) -> Result<Option<f64>, CaseError> {
    let Some(distance) = rolling.maybe(&DISTANCE)? else { return Ok(None) };
    if creepages > 1 {
        let several = [&ALONG, &ACROSS, &SPIN].into_iter().find(|field| rolling.has(*field));
        let reason = "rolling from rest takes a single creepage";
        return Err(rolling.conflict(&DISTANCE, several.unwrap_or(&ALONG), reason));
    }
    if distance > 2.0 * MOST_LENGTHS * semi_axis {
        return Err(rolling.out_of_range(
            &DISTANCE,
            distance,
            "at most 100 lengths of the contact",
        ));
    }
    Ok(Some(distance))
}
