//! The flange of a case: `[flange]`.

use super::{elastic, wall};
use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::material::ELASTIC;
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::{Dimension, Measure};
use carom_shells::flange::{Flange, Ring, RingForce, RingStiffness, StiffnessKind, Tube, TubeEdge};
use carom_shells::fourier::Sector;
use carom_special::RangeError;

const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const PLACE: Measure = Range::Finite.of(Dimension::Length);
const FORCE: Measure = Range::Finite.of(Dimension::Force);
const ANGLE: Measure = Range::Around.of(Dimension::Degrees);
const RIGIDITY: Measure = Range::Positive.of(Dimension::Rigidity);

const RADIUS: Field =
    Field::number("radius", LENGTH, "radius of the centroid line of the ring").such_as("0.15");

const ALONG: Field = Field::number("along", LENGTH, "width along the tube").such_as("0.02");
const OUTWARD: Field = Field::number("outward", LENGTH, "height outward").such_as("0.03");
const SECTION: Field = Field::new(
    "section",
    Form::Table(&[ALONG, OUTWARD]),
    "sides of a rectangular section of the ring",
)
.or("`stiffness`")
.such_as("{ along = 0.02, outward = 0.03 }");

const STRETCHING: Field =
    Field::number("stretching", Range::Positive.of(Dimension::Force), "EA, against stretching")
        .such_as("1.2e8");
const IN_PLANE: Field =
    Field::number("in_plane", RIGIDITY, "EI, against bending in the plane of the ring")
        .such_as("9000");
const OUT_OF_PLANE: Field =
    Field::number("out_of_plane", RIGIDITY, "EJ, against bending out of the plane").such_as("4000");
const TORSION: Field = Field::number("torsion", RIGIDITY, "GJ, against torsion").such_as("3600");
const STIFFNESS: Field = Field::new(
    "stiffness",
    Form::Table(&[STRETCHING, IN_PLANE, OUT_OF_PLANE, TORSION]),
    "stiffnesses of the section of the ring",
)
.or("`section`");

const RING_MATERIAL: Field = ELASTIC.or("`stiffness`");

const MIDDLE: Field = Field::number("angle", ANGLE, "middle of the sector").such_as("22.5");
const HALF_WIDTH: Field =
    Field::number("half_width", Range::HalfTurn.of(Dimension::Degrees), "half of its angle")
        .such_as("3");
const FACTOR: Field =
    Field::number("factor", Range::Factor.pure(), "stiffness in the sector over that outside")
        .such_as("0.5");
const ALL: &str = "all";
const OF: Field = Field::new(
    "of",
    Form::Word(&[
        (ALL, "all four"),
        ("stretching", "EA"),
        ("in_plane", "EI"),
        ("out_of_plane", "EJ"),
        ("torsion", "GJ"),
    ]),
    "the stiffness that the factor multiplies",
)
.default(Default::Word(ALL));
const SECTOR: Field = Field::new(
    "sector",
    Form::Tables(&[MIDDLE, HALF_WIDTH, FACTOR, OF]),
    "a bolt hole or rib: a sector of the ring with another stiffness",
)
.may("the ring is uniform");

const TUBE_RADIUS: Field = Field::number("radius", LENGTH, "radius of its middle surface")
    .may("that of the ring")
    .such_as("0.15");
const THICKNESS: Field =
    Field::number("thickness", LENGTH, "thickness of its wall").such_as("0.004");
const HALF_MOMENTLESS: &str = "half-momentless";
const KOITER_SANDERS: &str = "koiter-sanders";
const THEORY: Field = Field::new(
    "theory",
    Form::Word(&[
        (HALF_MOMENTLESS, "for long waves, such as those of pinching"),
        (KOITER_SANDERS, "the whole shell, also for short waves, such as those of prying"),
    ]),
    "theory of the tube",
)
.default(Default::Word(HALF_MOMENTLESS));
const TUBE_LENGTH: Field =
    Field::number("length", LENGTH, "length of a tube whose far end is clamped")
        .may("the tube is long, and the motion of the whole is held")
        .such_as("0.5");
const EDGE_ALONG: Field =
    Field::number("along", PLACE, "from the centroid of the ring to the edge, along the tube")
        .default(Default::Number(0.0));
const EDGE_OUTWARD: Field = Field::number("outward", PLACE, "the same outward")
    .may("radius of the tube less that of the ring")
    .such_as("0");
const TUBE_MATERIAL: Field =
    Field::new("material", ELASTIC.form, "material of the tube: two elastic constants")
        .may("that of the ring");
const TUBE: Field = Field::new(
    "tube",
    Form::Table(&[
        TUBE_RADIUS,
        THICKNESS,
        THEORY,
        TUBE_LENGTH,
        EDGE_ALONG,
        EDGE_OUTWARD,
        TUBE_MATERIAL,
    ]),
    "the tube at whose end the ring is",
)
.may("the ring is alone");

const AT: Field = Field::number("angle", ANGLE, "where it acts").default(Default::Number(0.0));
const NONE: Default = Default::Number(0.0);
const RADIAL: Field = Field::number("radial", FORCE, "component outward").default(NONE);
const TANGENTIAL: Field =
    Field::number("tangential", FORCE, "component along the ring").default(NONE);
const AXIAL: Field = Field::number("axial", FORCE, "component along the tube").default(NONE);
const ARM: Field =
    Field::number("arm", PLACE, "from the centroid line outward to the axial force").default(NONE);
const LOADS: Field =
    Field::new("force", Form::Tables(&[AT, RADIAL, TANGENTIAL, AXIAL, ARM]), "a force on the ring")
        .begun(&[(&RADIAL, "10000")]);

const HARMONICS_OF_FLANGE: f64 = 64.0;
const HARMONICS: Field = Field::number("harmonics", Range::Harmonics.pure(), "number of harmonics")
    .default(Default::Number(HARMONICS_OF_FLANGE));
const PLACES_AROUND: f64 = 72.0;
const PLACES: Field = Field::number(
    "places",
    Range::Places.pure(),
    "number of equidistant places around, beside those of the forces",
)
.default(Default::Number(PLACES_AROUND));
/// The field `flange` of a case.
pub(super) const FLANGE: Field = Field::new(
    "flange",
    Form::Table(&[
        RADIUS,
        SECTION,
        STIFFNESS,
        HARMONICS,
        PLACES,
        RING_MATERIAL,
        SECTOR,
        TUBE,
        LOADS,
    ]),
    "a ring under forces around it, alone or as the flange of a tube",
)
.or("`bellows`");

/// A flange and its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct FlangeCase {
    /// The flange.
    pub flange: Flange,
    /// The forces.
    pub forces: Vec<RingForce>,
    /// Number of harmonics.
    pub harmonics: usize,
    /// Number of equidistant places around.
    pub places: usize,
}

impl FlangeCase {
    pub(super) fn read(case: &Section<'_>) -> Result<Self, CaseError> {
        let given = &case.section(&FLANGE)?;
        let radius = given.number(&RADIUS)?;
        let ring = read_sectors(given, read_ring(given, radius)?)?;
        let flange = match given.has(&TUBE) {
            true => read_tube(given, ring)?,
            false => Flange::bare(ring),
        };
        let forces = given.sections(&LOADS)?.iter().map(read_force).collect::<Result<_, _>>()?;
        let (harmonics, places) = (given.count(&HARMONICS)?, given.count(&PLACES)?);
        Ok(Self { flange, forces, harmonics, places })
    }
}

fn read_ring(given: &Section<'_>, radius: f64) -> Result<Ring, CaseError> {
    match given.given([&SECTION, &STIFFNESS]).as_slice() {
        [] => Err(given.missing(&SECTION)),
        [field] if field.name == SECTION.name => {
            let [young_modulus, poisson] = elastic(given)?;
            let section = given.section(&SECTION)?;
            let (along, outward) = (section.number(&ALONG)?, section.number(&OUTWARD)?);
            let stiffness = RingStiffness::rectangle(young_modulus, poisson, along, outward);
            let refused = |error: RangeError| {
                let allowed = error.allowed;
                let (field, value, allowed) = match error.field {
                    "in_plane" => (&OUTWARD, outward, SLENDER),
                    "out_of_plane" => (&ALONG, along, SLENDER),
                    "along/outward" => (&ALONG, along, "from 0.001 to 1000 times `outward`"),
                    _ => (&ALONG, along, allowed),
                };
                section.out_of_range(field, value, allowed)
            };
            Ring::new(radius, stiffness.map_err(refused)?).map_err(refused)
        }
        [_] => {
            let stiffness = given.section(&STIFFNESS)?;
            let of = |field| stiffness.number(field);
            let made = RingStiffness::new(
                of(&STRETCHING)?,
                of(&IN_PLANE)?,
                of(&OUT_OF_PLANE)?,
                of(&TORSION)?,
            );
            made.and_then(|made| Ring::new(radius, made)).map_err(|error| stiffness.refused(error))
        }
        both => Err(given.several(both, "give one of the two")),
    }
}

/// The radius of gyration, a side over the root of 12, is at most a fifth of the radius.
const SLENDER: &str = "at most 0.69 times the radius, for a slender ring";

/// The stiffnesses that a sector concerns.
fn kinds(word: &str) -> &'static [StiffnessKind] {
    match word {
        "stretching" => &[StiffnessKind::Stretching],
        "in_plane" => &[StiffnessKind::InPlane],
        "out_of_plane" => &[StiffnessKind::OutOfPlane],
        "torsion" => &[StiffnessKind::Torsion],
        _ => &StiffnessKind::ALL,
    }
}

fn read_sectors(given: &Section<'_>, mut ring: Ring) -> Result<Ring, CaseError> {
    if !given.has(&SECTOR) {
        return Ok(ring);
    }
    let mut all = [const { Vec::<Sector>::new() }; 4];
    for given in given.sections(&SECTOR)? {
        let (angle, half_width) = (given.number(&MIDDLE)?, given.number(&HALF_WIDTH)?);
        let sector =
            Sector::new(angle.to_radians(), half_width.to_radians(), given.number(&FACTOR)?)
                .map_err(|error| given.refused(error))?;
        for &kind in kinds(given.word(&OF)?) {
            let own = &mut all[kind as usize];
            if own.iter().any(|earlier| sector.overlaps(earlier)) {
                let allowed = "so that no two sectors of a stiffness overlap";
                return Err(given.out_of_range(&MIDDLE, angle, allowed));
            }
            own.push(sector);
        }
    }
    for kind in StiffnessKind::ALL {
        let sectors = &all[kind as usize];
        ring = ring
            .with_sectors(kind, sectors)
            .map_err(|error| given.out_of_range(&SECTOR, sectors.len() as f64, error.allowed))?;
    }
    Ok(ring)
}

fn read_tube(given: &Section<'_>, ring: Ring) -> Result<Flange, CaseError> {
    let tube = given.section(&TUBE)?;
    let radius = tube.maybe(&TUBE_RADIUS)?.unwrap_or(ring.radius());
    let material = match tube.has(&TUBE_MATERIAL) {
        true => elastic(&tube)?,
        false => elastic(given)?,
    };
    let wall = wall(&tube, material, &THICKNESS)?;
    let length = tube.maybe(&TUBE_LENGTH)?;
    let made = match (tube.word(&THEORY)?, length) {
        (KOITER_SANDERS, Some(_)) => {
            let reason = "the whole shell is semi-infinite";
            return Err(tube.conflict(&TUBE_LENGTH, &THEORY, reason));
        }
        (KOITER_SANDERS, None) => Tube::koiter_sanders(radius, wall),
        (_, Some(length)) => Tube::half_momentless_clamped(radius, wall, length),
        (_, None) => Tube::half_momentless(radius, wall),
    };
    let made = made.map_err(|error| tube.refused(error))?;
    let outward = tube.maybe(&EDGE_OUTWARD)?.unwrap_or(radius - ring.radius());
    let edge =
        TubeEdge::new(tube.number(&EDGE_ALONG)?, outward).map_err(|error| tube.refused(error))?;
    Flange::on_tube(ring, made, edge).map_err(|error| match error.field {
        "radius of the tube" => tube.out_of_range(&TUBE_RADIUS, radius, error.allowed),
        _ => tube.refused(error),
    })
}

fn read_force(given: &Section<'_>) -> Result<RingForce, CaseError> {
    if given.given([&RADIAL, &TANGENTIAL, &AXIAL]).is_empty() {
        return Err(given.missing_as(&RADIAL, "a number (or `tangential` or `axial`)"));
    }
    let of = |field| given.number(field);
    let (radial, tangential, axial, arm) = (of(&RADIAL)?, of(&TANGENTIAL)?, of(&AXIAL)?, of(&ARM)?);
    RingForce::at(of(&AT)?.to_radians())
        .and_then(|force| force.radial(radial)?.tangential(tangential)?.axial_at(axial, arm))
        .map_err(|error| match error.field {
            // The product of force and arm.
            "couple" => given.out_of_range(&ARM, arm, error.allowed),
            _ => given.refused(error),
        })
}
