//! The case file of `carom impact`: two bodies of any smooth shape and their contact point.
//!
//! SI units. z points into body 1. Without positions body 1 lies on top of body 2 along z. With positions the
//! bodies touch where `[contact]` says so, or where a search finds the contact point. A number may be
//! replaced by several values, a sweep, or by a distribution.

use super::body::{BODY_1, BODY_2, BodyCase, FIXED, MASS, VELOCITY, Velocity};
use super::contact::Contact;
use super::error::{CaseError, CaseFault};
use super::field::{Default, Field, Form, Schema, Usual};
use super::material::MATERIAL;
use super::range::Range;
use super::reader::Case;
use super::section::{Section, parse};
use super::shape::SHAPE;
use super::touch::{CONTACT, Touch};
use super::uncertainty::{UNCERTAINTY, Uncertainty};
use super::unit::Dimension;
use super::varied::{Input, VARIED, Varied};
use carom_halfspace::MaterialPair;
use carom_impact::{Body, Collision, CollisionError, Motion};
use nalgebra::Vector3;
use toml::Spanned;
use toml::de::DeTable;

const SPEED: Field = Field::number(
    "speed",
    Range::NonNegativeSpeed.of(Dimension::Speed),
    "speed of body 1 in space",
)
.such_as("1");
const ANGLE: Field = Field::number(
    "angle",
    Range::Incidence.of(Dimension::Degrees),
    "angle of incidence, from the normal; the tangential velocity is along the projection of +x on the tangent plane",
)
.such_as("45")
.usually(Usual::INCIDENCE);
const APPROACH: Field = Field::new(
    "approach",
    Form::Table(&[SPEED, ANGLE]),
    "the velocity of body 1 by speed and angle",
)
.may("the velocity is `body_1.velocity`");

const TIME: Field = Field::number(
    "time",
    Range::Finite.of(Dimension::Time),
    "reading of the clock, which each row of the data replaces",
)
.such_as("0");
const CLOCK_TOUCH: Field = Field::number(
    "touch",
    Range::Finite.of(Dimension::Time),
    "reading of the clock at which the bodies first touch: `time` counts from there",
)
.default(Default::Number(0.0))
.such_as("0");
const CLOCK: Field = Field::new(
    "clock",
    Form::Table(&[TIME, CLOCK_TOUCH]),
    "the times of data that `carom fit` compares with the history of the impact",
)
.may("the data have no times");

/// All fields.
const FIELDS: &[Field] = &[BODY_1, BODY_2, CONTACT, APPROACH, CLOCK, UNCERTAINTY];

/// An impact of two bodies.
#[derive(Debug, Clone)]
pub struct ImpactCase {
    /// The bodies in contact, with their motions before the impact.
    pub collision: Collision,
    /// Friction, law and torsion.
    pub contact: Contact,
    /// Angle of incidence, degrees, if the case gives it.
    pub angle: Option<f64>,
    /// The reading of the clock of the data and that at the first touch, s, if they have times.
    pub clock: Option<[f64; 2]>,
}

/// The case file of one or more impacts, parsed once.
#[derive(Debug)]
pub struct ImpactFile<'a> {
    source: &'a str,
    table: Spanned<DeTable<'a>>,
    inputs: Vec<Input>,
    uncertainty: Option<Uncertainty>,
    nominal: ImpactCase,
}

impl<'a> Case<'a> for ImpactFile<'a> {
    const SCHEMA: Schema =
        Schema::new("impact", "An impact of two bodies of any smooth shape.", FIELDS)
            .varying(VARIED);

    fn read(source: &'a str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let varied = Varied::new(FIELDS, Vec::new());
        let nominal = read(source, table.get_ref(), &varied)?;
        let inputs = varied.found();
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let sweeps: Vec<&Input> = inputs.iter().filter(|input| input.sweep().is_some()).collect();
        if let [one, other, ..] = sweeps.as_slice() {
            let fault = CaseFault::Conflict {
                other: one.field.to_owned(),
                reason: "sweep over one field at a time; for each value of the other run a case of its own, in a \
                         loop of the shell, or use `carom.collide_many` in Python",
            };
            return Err(fault.at(other.field, other.line));
        }
        let uncertainty = Uncertainty::read(&case, &inputs)?;
        Ok(Self { source, table, inputs, uncertainty, nominal })
    }
}

impl ImpactFile<'_> {
    /// The impact with the mean of every distribution and the first value of a sweep.
    #[must_use]
    pub const fn nominal(&self) -> &ImpactCase {
        &self.nominal
    }

    /// The numbers that vary, in the order of the file.
    #[must_use]
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// The sampling of its distributions, if it has any.
    #[must_use]
    pub const fn uncertainty(&self) -> Option<&Uncertainty> {
        self.uncertainty.as_ref()
    }

    /// The number that a sweep varies and its values, if there is a sweep.
    #[must_use]
    pub fn sweep(&self) -> Option<(&Input, &[f64])> {
        self.inputs.iter().find_map(|input| Some((input, input.sweep()?)))
    }

    /// The impact with these values of the varied numbers.
    ///
    /// # Errors
    /// As [`Case::parse`].
    pub fn case(&self, values: &[f64]) -> Result<ImpactCase, CaseError> {
        let drawn = self.inputs.iter().map(Input::place).zip(values.iter().copied()).collect();
        read(self.source, self.table.get_ref(), &Varied::new(FIELDS, drawn))
    }
}

/// Reads a case with values for its varied numbers.
pub(super) fn read(
    source: &str,
    table: &DeTable<'_>,
    varied: &Varied,
) -> Result<ImpactCase, CaseError> {
    let case = &Section::root(source, table, FIELDS)?.varying(varied);
    let velocity = if case.has(&APPROACH) { Velocity::Approach } else { Velocity::Own };
    let approach = match velocity {
        Velocity::Approach => Some(Approach::read(case)?),
        Velocity::Own => None,
    };
    let bodies =
        [BodyCase::read(case, &BODY_1, velocity)?, BodyCase::read(case, &BODY_2, Velocity::Own)?];
    check_pair(case, &bodies)?;
    if approach.is_none() && !case.has([&BODY_1, &VELOCITY]) && !case.has([&BODY_2, &VELOCITY]) {
        let allowed = format!("{} (or `[approach]`)", VELOCITY.allowed());
        return Err(case.missing_as([&BODY_1, &VELOCITY], allowed));
    }
    let table = case.section(&CONTACT)?;
    let contact = Contact::read(&table)?;
    let touch = Touch::read(case, &table, &bodies)?;
    let [one, two] = bodies.map(|body| body.body);
    let meet = |one: Body| touch.collision(one, two.clone(), contact.friction);
    let at_fault = |source| touch.at_fault(case, source);
    let collision = match &approach {
        None => meet(one),
        Some(approach) => approach.meet(&one, touch.is_approach(), meet),
    };
    let loss = contact.normal_restitution.clone();
    let collision = collision.map_err(at_fault)?.with_normal_restitution(loss);
    let collision = collision.with_torsion_mode(contact.torsion);
    let collision = match contact.stiffness_ratio {
        Some(ratio) => {
            collision.with_stiffness_ratio(ratio).map_err(|error| table.refused(error))?
        }
        None => collision,
    };
    let clock = case.has(&CLOCK).then(|| case.section(&CLOCK)).transpose()?;
    let read = |clock: Section<'_>| Ok([clock.number(&TIME)?, clock.number(&CLOCK_TOUCH)?]);
    let clock = clock.map(read).transpose()?;
    let angle = approach.map(|approach| approach.angle);
    Ok(ImpactCase { collision, contact, angle, clock })
}

/// Rejects combinations of bodies that have no impact.
fn check_pair(case: &Section<'_>, bodies: &[BodyCase; 2]) -> Result<(), CaseError> {
    let [one, two] = bodies;
    if one.is_plane && two.is_plane {
        let reason = "two planes do not touch at a point";
        return Err(case.conflict([&BODY_2, &SHAPE], [&BODY_1, &SHAPE], reason));
    }
    if one.is_heavy() && two.is_heavy() {
        let field = if case.has([&BODY_2, &FIXED]) { &FIXED } else { &MASS };
        let allowed = "a finite mass for at least one of the two bodies";
        return Err(case.out_of_range([&BODY_2, field], f64::INFINITY, allowed));
    }
    MaterialPair::new(one.body.material(), two.body.material())
        .map(|_| ())
        .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))
}

/// Speed and angle of incidence of body 1.
#[derive(Debug, Clone, Copy)]
struct Approach {
    /// Speed, m/s.
    speed: f64,
    /// Angle from the normal, degrees; the tangential velocity is along the projection of +x on the tangent
    /// plane.
    angle: f64,
}

impl Approach {
    fn read(case: &Section<'_>) -> Result<Self, CaseError> {
        let approach = case.section(&APPROACH)?;
        Ok(Self { speed: approach.number(&SPEED)?, angle: approach.number(&ANGLE)? })
    }

    fn velocity(&self, normal: &Vector3<f64>) -> Vector3<f64> {
        // Exact at both ends: normal and grazing incidence.
        let (sin, cos) = match self.angle {
            90.0 => (1.0, 0.0),
            angle => (libm::sin(angle.to_radians()), libm::cos(angle.to_radians())),
        };
        let along = Vector3::y().cross(normal);
        let along = along.try_normalize(1e-6).unwrap_or(Vector3::x());
        (along * sin - normal * cos) * self.speed
    }

    /// Brings the bodies into contact. The normal is that at the contact point; if a search needs the
    /// velocity first, the angle of incidence is measured from z.
    fn meet(
        &self,
        one: &Body,
        comes: bool,
        meet: impl Fn(Body) -> Result<Collision, CollisionError>,
    ) -> Result<Collision, CollisionError> {
        let moving = |normal: &Vector3<f64>| -> Result<Body, CollisionError> {
            let spin = one.motion().spin.into();
            let motion = Motion::new(self.velocity(normal).into(), spin)?;
            Ok(one.clone().moving(motion))
        };
        let first = meet(moving(&Vector3::z())?)?;
        let normal = first.frame().z();
        if comes || normal == Vector3::z() { Ok(first) } else { meet(moving(&normal)?) }
    }
}
