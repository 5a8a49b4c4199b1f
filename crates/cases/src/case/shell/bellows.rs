//! The bellows of a case: `[bellows]`.

use super::{elastic, wall};
use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form, Need};
use crate::case::material::ELASTIC;
use crate::case::range::Range;
use crate::case::section::{Numbers, Section};
use crate::case::unit::{Dimension, Measure};
use carom_shells::bellows::{Axial, Bellows, BellowsLoad, Meridian};
use carom_special::RangeError;

const SINE: &str = "sine";
const U_SHAPED: &str = "u-shaped";
const FOLDED: &str = "folded";
const TORUS: &str = "torus";

const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const SHAPE: Field = Field::new(
    "shape",
    Form::Word(&[
        (SINE, "a sine wave"),
        (U_SHAPED, "half circles joined by flat annular plates"),
        (FOLDED, "arcs joined by cones; with a turn above 90 degrees narrower at the mouth"),
        (TORUS, "a circle with a slit at its inside; the elongation is the gape of the slit"),
    ]),
    "meridian of a corrugation",
)
.such_as("\"u-shaped\"");
const MEAN_RADIUS: Field =
    Field::number("mean_radius", LENGTH, "mean of the radii of crest and root").such_as("0.1");
const AMPLITUDE: Field = Field::number(
    "amplitude",
    Range::NonNegative.of(Dimension::Length),
    "half of the height of the wave, at most 0.9 `mean_radius`",
)
.of(&[SINE])
.such_as("0.005");
const PITCH: Field = Field::number("pitch", LENGTH, "length of a corrugation along the axis")
    .of(&[SINE])
    .such_as("0.02");
const ARC: Field = Field::number("arc", LENGTH, "radius of the arcs or of the circle")
    .of(&[U_SHAPED, FOLDED, TORUS])
    .such_as("0.005");
const STRAIGHT: Field = Field::number(
    "straight",
    Range::NonNegative.of(Dimension::Length),
    "length of the straight part between two arcs",
)
.of(&[U_SHAPED, FOLDED])
.such_as("0.01");
const TURN: Field = Field::number(
    "turn",
    Range::Turn.of(Dimension::Degrees),
    "angle by which each arc turns to each side",
)
.of(&[FOLDED])
.such_as("100");
const THICKNESS: Field =
    Field::number("thickness", LENGTH, "thickness of the wall").such_as("5e-4");
const CORRUGATIONS: Field = Field::number(
    "corrugations",
    Range::Whole.pure(),
    "number of corrugations; loads and results are those of all of them",
)
.default(Default::Number(1.0));
const HARMONICS_OF_BELLOWS: f64 = 48.0;
const HARMONICS: Field =
    Field::number("harmonics", Range::Harmonics.pure(), "number of harmonics of each series")
        .default(Default::Number(HARMONICS_OF_BELLOWS));
const PRESSURE: Field = Field::new(
    "pressure",
    Form::Numbers(Range::Finite.of(Dimension::Pressure)),
    "pressure inside; negative from outside",
)
.default(Default::Number(0.0));
const DILATATION: Field = Field::new(
    "dilatation",
    Form::Numbers(Range::Finite.of(Dimension::Length)),
    "growth of the length; 0 at fixed ends",
)
.or("`force`")
.such_as("[-0.002, 0, 0.002]");
const FORCE: Field = Field::new(
    "force",
    Form::Numbers(Range::Finite.of(Dimension::Force)),
    "tension of closed ends, beside the pressure on them",
)
.or("`dilatation`")
.such_as("[0, 500, 1000]");
const LOAD: Field = Field::new(
    "load",
    Form::Table(&[PRESSURE, DILATATION, FORCE]),
    "pressure, with the elongation or the force; each one value or several: a list, or { start, \
     stop, count }",
)
.begun(&[(&DILATATION, "")]);
/// The field `bellows` of a case.
pub(super) const BELLOWS: Field = Field::new(
    "bellows",
    Form::Table(&[
        SHAPE,
        MEAN_RADIUS,
        AMPLITUDE,
        PITCH,
        ARC,
        STRAIGHT,
        TURN,
        THICKNESS,
        CORRUGATIONS,
        HARMONICS,
        ELASTIC,
        LOAD,
    ]),
    "an expansion bellows: a row of equal corrugations of a thin wall",
)
.or("`flange`")
.begun(&[(&SHAPE, "")]);

/// The most loads of a case.
const MOST_LOADS: usize = 10_000;

/// A bellows and its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct BellowsCase {
    /// The bellows.
    pub bellows: Bellows,
    /// Number of corrugations.
    pub corrugations: usize,
    /// The loads of one corrugation, in the order of the case.
    pub loads: Vec<BellowsLoad>,
}

impl BellowsCase {
    pub(super) fn read(case: &Section<'_>) -> Result<Self, CaseError> {
        let (given, shape) = &case.shaped(&BELLOWS, &SHAPE)?;
        let radius = given.number(&MEAN_RADIUS)?;
        let meridian = match *shape {
            SINE => Meridian::sine(radius, given.number(&AMPLITUDE)?, given.number(&PITCH)?),
            U_SHAPED => Meridian::u_shaped(radius, given.number(&ARC)?, given.number(&STRAIGHT)?),
            FOLDED => Meridian::folded(
                radius,
                given.number(&ARC)?,
                given.number(&STRAIGHT)?,
                given.number(&TURN)?.to_radians(),
            ),
            _ => Meridian::torus(radius, given.number(&ARC)?),
        };
        let refused = |error: RangeError| match error.field {
            "height" => {
                let allowed = "such that the height of a corrugation is at most 1.8 mean_radius";
                given.out_of_range(&ARC, given.number(&ARC).unwrap_or(error.value), allowed)
            }
            _ => given.refused(error),
        };
        let meridian = meridian.map_err(refused)?;
        let wall = wall(given, elastic(given)?, &THICKNESS)?;
        let bellows = Bellows::new(meridian, wall, given.count(&HARMONICS)?).map_err(refused)?;
        let corrugations = given.count(&CORRUGATIONS)?;
        let loads = read_loads(&given.section(&LOAD)?, corrugations)?;
        Ok(Self { bellows, corrugations, loads })
    }
}

/// Reads the loads. Several pressures are combined with a single force or elongation, or one by one with as
/// many.
fn read_loads(load: &Section<'_>, corrugations: usize) -> Result<Vec<BellowsLoad>, CaseError> {
    let field = match load.given([&DILATATION, &FORCE]).as_slice() {
        [] => return Err(load.missing(&DILATATION)),
        [field] => *field,
        both => return Err(load.several(both, "give one of the two")),
    };
    let pressures = match (load.has(&PRESSURE), PRESSURE.need) {
        (false, Need::Default(Default::Number(pressure))) => Numbers::One(pressure),
        _ => load.numbers(&PRESSURE)?,
    };
    let axial = load.numbers(field)?;
    let (pressures, axial) = (pressures.as_slice(), axial.as_slice());
    let count = pressures.len().max(axial.len());
    if pressures.len() > 1 && axial.len() > 1 && pressures.len() != axial.len() {
        let reason = "both must have the same number of values";
        return Err(load.conflict(&PRESSURE, field, reason));
    }
    if count > MOST_LOADS {
        return Err(load.out_of_range(field, count as f64, "at most 10000 loads"));
    }
    let at = |values: &[f64], i: usize| values[i.min(values.len() - 1)];
    let one = |i: usize| {
        let axial = match field.name == FORCE.name {
            true => Axial::Force(at(axial, i)),
            false => Axial::Dilatation(at(axial, i) / corrugations as f64),
        };
        BellowsLoad::new(at(pressures, i), axial).map_err(|error| load.refused(error))
    };
    (0..count).map(one).collect()
}
