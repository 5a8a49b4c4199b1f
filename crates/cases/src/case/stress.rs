//! The case file of `carom stress`.

use super::error::CaseError;
use super::field::{Field, Form, Schema, Usual, Word};
use super::pair::{self, ANGLE, BODY_1, BODY_2, LENGTH};
use super::range::Range;
use super::reader::Case;
use super::section::{Section, parse};
use super::unit::Dimension;
use crate::PointOrLine;

const FRICTION: Field = Field::number(
    "friction",
    Range::NonNegative.pure(),
    "coefficient of friction f; the tangential force must not exceed f times the normal force",
)
.such_as("0.3")
.usually(Usual::FRICTION);
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[ANGLE, LENGTH, FRICTION]),
    "orientation of the bodies, length of a line, and friction",
);
const FORCE: Field =
    Field::number("force", Range::Positive.of(Dimension::Force), "normal force").such_as("10");
const FORCE_X: Field = Field::number(
    "force_x",
    Range::Finite.of(Dimension::Force),
    "force on body 1 along x, the direction of the larger relative curvature",
)
.such_as("2");
const FORCE_Y: Field =
    Field::number("force_y", Range::Finite.of(Dimension::Force), "the same along y").such_as("0");
const LOAD: Field = Field::new(
    "load",
    Form::Table(&[FORCE, FORCE_X, FORCE_Y]),
    "the forces; the tangential force is applied after the normal one",
);

const ONE: &str = "body 1";
const BODIES: &[Word] = &[(ONE, "to which z points"), ("body 2", "the other")];
const INSIDE: Field =
    Field::new("inside", Form::Word(BODIES), "the body in which stresses are computed")
        .such_as("\"body 1\"");
const X: Field = along("x", Range::Finite, "along the larger relative curvature")
    .such_as("{ start = -2e-4, stop = 2e-4, count = 41 }");
const Y: Field = along("y", Range::Finite, "perpendicular to x").such_as("0");
const DEPTH: Field = along("depth", Range::NonNegative, "below the surface")
    .such_as("{ start = 0, stop = 2e-4, count = 21 }");
const POINTS: Field = Field::new(
    "points",
    Form::Table(&[INSIDE, X, Y, DEPTH]),
    "every x with every y and every depth: each a number, a list, or { start, stop, count }",
);

/// All fields.
const FIELDS: &[Field] = &[BODY_1, BODY_2, CONTACT, LOAD, POINTS];

/// Largest number of points.
const MOST: usize = 1_000_000;

const fn along(name: &'static str, range: Range, meaning: &'static str) -> Field {
    Field::new(name, Form::Numbers(range.of(Dimension::Length)), meaning)
}

/// A contact under normal and tangential load, and the points at which stresses are computed.
#[derive(Debug, Clone, PartialEq)]
pub struct StressCase {
    /// The contact.
    pub contact: PointOrLine,
    /// The smallest radius of curvature of both bodies, m; infinite for planes.
    pub smallest_radius: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Force on body 1 along x, along y and normal, N.
    pub force: [f64; 3],
    /// Whether the points lie in body 1.
    pub is_in_body_1: bool,
    /// The places along x, along y, and the depths, m.
    pub places: [Vec<f64>; 3],
}

impl Case<'_> for StressCase {
    const SCHEMA: Schema =
        Schema::new("stress", "Stresses below a contact under normal and tangential load.", FIELDS);

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let contact = case.section(&CONTACT)?;
        let (touching, smallest_radius) = pair::read_any(&case, Some(&contact))?;
        let friction = contact.number(&FRICTION)?;
        let load = case.section(&LOAD)?;
        let force = [load.number(&FORCE_X)?, load.number(&FORCE_Y)?, load.number(&FORCE)?];
        let pushed = force[0].hypot(force[1]);
        if pushed > friction * force[2] {
            let field = if force[0] == 0.0 { &FORCE_Y } else { &FORCE_X };
            return Err(load.out_of_range(
                field,
                pushed,
                "at most friction times the normal force",
            ));
        }
        let points = case.section(&POINTS)?;
        let is_in_body_1 = points.word(&INSIDE)? == ONE;
        let read = |field| points.numbers(field).map(|numbers| numbers.as_slice().to_vec());
        let places = [read(&X)?, read(&Y)?, read(&DEPTH)?];
        let count = places.iter().map(Vec::len).product::<usize>();
        if count > MOST {
            return Err(points.out_of_range(&X, count as f64, "at most 1000000 points in all"));
        }
        let contact = touching;
        Ok(Self { contact, smallest_radius, friction, force, is_in_body_1, places })
    }
}
