//! The case file of `carom impact`.
//!
//! SI units. z points into body 1, so that body 1 above a plane falls with velocity
//! `[vx, vy, -vz]`.

use super::body::{BodyCase, Motion, Shape};
use super::contact::{self, Contact};
use super::error::CaseError;
use super::placed;
use super::range::Range;
use super::section::{Numbers, Section, parse};
use super::unit::Dimension;
use carom_halfspace::{Material, MaterialPair};

/// The tables of a case; `[uncertainty]` is read by [`UncertainCase`](super::UncertainCase).
pub(super) const FIELDS: &[&str] = &["body_1", "body_2", "contact", "approach", "uncertainty"];

/// An impact, or a sweep of impacts over the angle of incidence.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpactCase {
    /// The body into which z points.
    pub body_1: BodyCase,
    /// The other body.
    pub body_2: BodyCase,
    /// Friction and torsion. The law for turning directions is without effect: spheres and planes
    /// move in one plane.
    pub contact: Contact,
    /// How body 1 comes, if not by its velocity.
    pub approach: Option<Approach>,
}

/// Body 1 coming at a speed under one or more angles.
#[derive(Debug, Clone, PartialEq)]
pub struct Approach {
    /// Speed, m/s.
    pub speed: f64,
    /// Angles from the normal, degrees; the tangential velocity is along +x.
    pub angles: Numbers,
}

impl Approach {
    /// The velocity under `angle` degrees from the normal.
    #[must_use]
    pub fn velocity(&self, angle: f64) -> [f64; 3] {
        // The ends are exact: straight down, and grazing.
        let (sin, cos) = match angle {
            90.0 => (1.0, 0.0),
            _ => (libm::sin(angle.to_radians()), libm::cos(angle.to_radians())),
        };
        [self.speed * sin, 0.0, -self.speed * cos]
    }
}

impl ImpactCase {
    /// Whether it asks for several impacts.
    #[must_use]
    pub fn is_sweep(&self) -> bool {
        let angles = self.approach.as_ref().map(|approach| &approach.angles);
        matches!(angles, Some(Numbers::Sweep(_)))
    }

    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        placed::check(&case, "body_1")?;
        placed::check(&case, "body_2")?;
        let (motion, approach) = match case.has("approach") {
            true => (Motion::Approach, Some(read_approach(&case)?)),
            false => (Motion::Velocity, None),
        };
        let body_1 = BodyCase::read(&case, "body_1", motion)?;
        let body_2 = BodyCase::read(&case, "body_2", Motion::Velocity)?;
        check_pair(&case, &body_1, &body_2)?;
        let contact = Contact::read(&case.section("contact", &contact::FIELDS)?)?;
        if contact.is_numerical {
            let reason = "the numerical law takes bodies with a place: give `position`, with \
                          `contact.search`, in both";
            return Err(case.conflict("contact.law", "body_1", reason));
        }
        Ok(Self { body_1, body_2, contact, approach })
    }
}

/// What two bodies cannot both be.
fn check_pair(case: &Section<'_>, body_1: &BodyCase, body_2: &BodyCase) -> Result<(), CaseError> {
    if body_1.shape == Shape::Plane && body_2.shape == Shape::Plane {
        let reason = "two planes do not meet in a point; one body must be a sphere";
        return Err(case.conflict("body_2.shape", "body_1.shape", reason));
    }
    check_masses(case, [body_1.mass.is_infinite(), body_2.mass.is_infinite()])?;
    check_materials(case, [body_1.material, body_2.material])
}

/// At least one body can move.
pub(super) fn check_masses(case: &Section<'_>, are_infinite: [bool; 2]) -> Result<(), CaseError> {
    if are_infinite != [true; 2] {
        return Ok(());
    }
    let name = if case.has("body_2.fixed") { "body_2.fixed" } else { "body_2.mass" };
    let allowed = "a finite mass for at least one of the two bodies";
    Err(case.out_of_range(name, f64::INFINITY, allowed))
}

/// At least one body gives way.
pub(super) fn check_materials(
    case: &Section<'_>,
    [one, two]: [Material; 2],
) -> Result<(), CaseError> {
    MaterialPair::new(one, two)
        .map(|_| ())
        .map_err(|error| case.out_of_range("body_2.material", error.value, error.allowed))
}

fn read_approach(case: &Section<'_>) -> Result<Approach, CaseError> {
    let approach = case.section("approach", &["speed", "angle"])?;
    let speed = approach.number("speed", Range::NonNegativeSpeed.of(Dimension::Speed))?;
    let angles = approach.numbers("angle", Range::Incidence.of(Dimension::Degrees))?;
    Ok(Approach { speed, angles })
}
