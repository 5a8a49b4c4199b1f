//! The load history: `[[step]]`.

use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::{Dimension, Measure};

const LENGTH: Measure = Range::Finite.of(Dimension::Length);
const FORCE: Measure = Range::Finite.of(Dimension::Force);
const KEPT: &str = "unchanged: the shift or load that was given before";
const ZETA: Field = Field::number("zeta", LENGTH, "approach")
    .may("unchanged; the first step needs it or `F_z`")
    .such_as("1e-6");
const F_Z: Field = Field::number(
    "F_z",
    Range::NonNegative.of(Dimension::Force),
    "normal force, instead of `zeta`",
)
.may(KEPT)
.such_as("1");
const XI: Field =
    Field::number("xi", LENGTH, "shift of body 2 against body 1 along x").may(KEPT).such_as("2e-7");
const F_X: Field = Field::number("F_x", FORCE, "force on body 1 along x, instead of `xi`")
    .may(KEPT)
    .such_as("0.1");
const ETA: Field = Field::number("eta", LENGTH, "the same along y").may(KEPT).such_as("2e-7");
const F_Y: Field =
    Field::number("F_y", FORCE, "the same along y, instead of `eta`").may(KEPT).such_as("0.1");
const OMEGA: Field =
    Field::number("omega", Range::Finite.of(Dimension::Radians), "twist about the normal")
        .may(KEPT)
        .such_as("1e-3");
const M_Z: Field = Field::number(
    "M_z",
    Range::Finite.of(Dimension::Torque),
    "torque on body 1, instead of `omega`",
)
.may(KEPT)
.such_as("1e-6");
const COUNT: Field =
    Field::number("count", Range::Whole.pure(), "number of equal steps to the new values")
        .default(Default::Number(1.0));
/// The field `step` of a case.
pub(super) const STEP: Field = Field::new(
    "step",
    Form::Tables(&[ZETA, F_Z, XI, F_X, ETA, F_Y, OMEGA, M_Z, COUNT]),
    "new value of each motion: its shift or its load",
)
.begun(&[(&ZETA, ""), (&XI, ""), (&COUNT, "4")]);

/// The value of one motion at the end of a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// Unchanged: the shift or load that was given before.
    Kept,
    /// A shift or twist.
    Shift(f64),
    /// A load.
    Load(f64),
}

/// A leg of the history: equal steps to the same targets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Targets: normal, along x, along y, twist.
    pub targets: [Target; 4],
    /// Number of steps.
    pub count: usize,
}

pub(super) fn read(case: &Section<'_>) -> Result<Vec<Leg>, CaseError> {
    let sections = case.sections(&STEP)?;
    let legs: Vec<Leg> = sections.iter().map(leg).collect::<Result<_, _>>()?;
    match sections.first().zip(legs.first()) {
        Some((first, leg)) if leg.targets[0] == Target::Kept => {
            Err(first.missing_as(&ZETA, "given in the first step, or `F_z`"))
        }
        _ => Ok(legs),
    }
}

fn leg(step: &Section<'_>) -> Result<Leg, CaseError> {
    let targets = [
        target(step, &ZETA, &F_Z)?,
        target(step, &XI, &F_X)?,
        target(step, &ETA, &F_Y)?,
        target(step, &OMEGA, &M_Z)?,
    ];
    Ok(Leg { targets, count: step.count(&COUNT)? })
}

fn target(step: &Section<'_>, shift: &Field, load: &Field) -> Result<Target, CaseError> {
    match (step.maybe(shift)?, step.maybe(load)?) {
        (Some(_), Some(_)) => Err(step.conflict(load, shift, "give one of them")),
        (Some(shift), None) => Ok(Target::Shift(shift)),
        (None, Some(load)) => Ok(Target::Load(load)),
        (None, None) => Ok(Target::Kept),
    }
}
