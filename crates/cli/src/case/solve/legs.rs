//! The history: `[[step]]`.

use crate::case::error::CaseError;
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::Dimension;

const FIELDS: &[&str] = &["zeta", "F_z", "xi", "F_x", "eta", "F_y", "omega", "M_z", "count"];

/// What one motion reaches at the end of a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// As the leg before left it: a shift stays, a given load stays.
    Kept,
    /// A shift or twist.
    Shift(f64),
    /// A load.
    Load(f64),
}

/// Some equal steps to the same targets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Normal, along x, along y, twist.
    pub targets: [Target; 4],
    /// In so many steps.
    pub count: usize,
}

pub(super) fn read(case: &Section<'_>) -> Result<Vec<Leg>, CaseError> {
    let legs = case.sections("step", FIELDS)?;
    let legs: Vec<Leg> = legs.iter().map(leg).collect::<Result<_, _>>()?;
    if legs[0].targets[0] == Target::Kept {
        return Err(case.missing("step[0].zeta", "given in the first step, or `F_z`"));
    }
    Ok(legs)
}

fn leg(step: &Section<'_>) -> Result<Leg, CaseError> {
    let (length, force) = (Dimension::Length, Dimension::Force);
    let count = match step.has("count") {
        true => step.number("count", Range::Whole)? as usize,
        false => 1,
    };
    let targets = [
        target(step, ("zeta", length), ("F_z", force, Range::NonNegative))?,
        target(step, ("xi", length), ("F_x", force, Range::Finite))?,
        target(step, ("eta", length), ("F_y", force, Range::Finite))?,
        target(step, ("omega", Dimension::Radians), ("M_z", Dimension::None, Range::Finite))?,
    ];
    Ok(Leg { targets, count })
}

fn target(
    step: &Section<'_>,
    (shift, dimension): (&str, Dimension),
    (load, own, range): (&str, Dimension, Range),
) -> Result<Target, CaseError> {
    match (step.has(shift), step.has(load)) {
        (true, true) => Err(step.conflict(load, shift, "give one of them")),
        (true, false) => Ok(Target::Shift(step.number(shift, Range::Finite.of(dimension))?)),
        (false, true) => Ok(Target::Load(step.number(load, range.of(own))?)),
        (false, false) => Ok(Target::Kept),
    }
}
