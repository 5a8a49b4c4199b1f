//! What drives the contact: `[rolling]`.

use super::contact::{CONTACT, Touching};
use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::range::Range;
use crate::case::section::{Numbers, Section};
use crate::case::solve::GridCase;
use crate::case::unit::{Dimension, Measure};
use carom_rolling::{RollingDrive, SteadyMethod};
use carom_solver::Driven;

const FORCE: Measure = Range::Finite.of(Dimension::Force);
const LENGTH: Measure = Range::Positive.of(Dimension::Length);

const SPEED: Field =
    Field::number("speed", Range::Positive.of(Dimension::Speed), "rolling speed").such_as("20");
const DIRECTION: Field = Field::number(
    "direction",
    Range::Around.of(Dimension::Degrees),
    "direction in which the contact moves over the bodies, from +x towards +y",
)
.default(Default::Number(0.0))
.such_as("180");
const ZETA: Field =
    Field::new("zeta", Form::Numbers(Range::Finite.of(Dimension::Length)), "approach of a gap")
        .or("`F_z`, or `contact.F_z` of an elliptical contact or a line")
        .such_as("2e-5");
const F_Z: Field = Field::new(
    "F_z",
    Form::Numbers(Range::Positive.of(Dimension::Force)),
    "normal force of a gap, instead of `zeta`",
)
.or("`zeta`, or `contact.F_z` of an elliptical contact or a line")
.such_as("8e4");
const ALONG: Field = motion(
    "creepage",
    Range::Finite.pure(),
    "creepage along x: sliding velocity of body 2 against body 1 over the rolling speed",
)
.may("0, or what `F_x` needs")
.such_as("[0.0005, 0.001, 0.002, 0.004]");
const F_X: Field = motion("F_x", FORCE, "force on body 1 along x, instead of `creepage`")
    .may("what the creepage gives")
    .such_as("5e3");
const ACROSS: Field = motion("creepage_across", Range::Finite.pure(), "creepage along y")
    .may("0, or what `F_y` needs")
    .such_as("0.001");
const F_Y: Field = motion("F_y", FORCE, "force on body 1 along y, instead of `creepage_across`")
    .may("what the creepage gives")
    .such_as("5e3");
const SPIN: Field = motion(
    "spin",
    Range::Finite.of(Dimension::PerLength),
    "spin creepage: rotation of body 2 against body 1 about the normal per length rolled",
)
.may("0, or what `M_z` needs")
.such_as("0.2");
const M_Z: Field =
    motion("M_z", Range::Finite.of(Dimension::Torque), "torque on body 1, instead of `spin`")
        .may("what the creepage gives")
        .such_as("10");
const DISTANCE: Field = Field::number(
    "distance",
    LENGTH,
    "distance to roll from rest, step by step, with one value of each motion; at most 100 lengths \
     of the contact or of the grid",
)
.may("the steady state is computed directly")
.such_as("0.03");
const STEP: Field = Field::number(
    "step",
    LENGTH,
    "length of a step: the surfaces are compared at points this far apart",
)
.may("the width of a cell in the direction of rolling")
.such_as("3e-4");
const SPIN_OFFSET: Field = Field::number(
    "spin_offset",
    Range::SignedPart.pure(),
    "where in a step the rigid shift of a spin is taken: 0 at the end of the step, 1 at its start; \
     CONTACT takes 1/6 by default",
)
.default(Default::Number(0.0));
/// The field `rolling` of a case.
pub(super) const ROLLING: Field = Field::new(
    "rolling",
    Form::Table(&[
        SPEED,
        DIRECTION,
        ZETA,
        F_Z,
        ALONG,
        F_X,
        ACROSS,
        F_Y,
        SPIN,
        M_Z,
        DISTANCE,
        STEP,
        SPIN_OFFSET,
    ]),
    "speed, direction, and each motion by creepage or by force; a motion is one value or several: \
     a list, or { start, stop, count }",
)
.begun(&[(&SPEED, ""), (&ALONG, "")]);

/// Longest rolling distance, in lengths of the contact.
const MOST_LENGTHS: f64 = 100.0;

/// The greatest number of steps from rest.
const MOST_STEPS: f64 = 1e5;

const fn motion(name: &'static str, measure: Measure, meaning: &'static str) -> Field {
    Field::new(name, Form::Numbers(measure), meaning)
}

/// A motion with its values in all rows.
struct Motion {
    /// The field that gives it; none for the default.
    field: Option<&'static Field>,
    is_load: bool,
    values: Numbers,
}

impl Motion {
    fn read(
        rolling: &Section<'_>,
        shift: &'static Field,
        load: &'static Field,
    ) -> Result<Self, CaseError> {
        match (rolling.has(shift), rolling.has(load)) {
            (true, true) => Err(rolling.conflict(load, shift, "give one of them")),
            (false, false) => Ok(Self { field: None, is_load: false, values: Numbers::One(0.0) }),
            (_, is_load) => {
                let field = if is_load { load } else { shift };
                Ok(Self { field: Some(field), is_load, values: rolling.numbers(field)? })
            }
        }
    }

    fn count(&self) -> usize {
        self.values.as_slice().len()
    }

    fn row(&self, i: usize) -> Driven {
        let values = self.values.as_slice();
        let value = values[i.min(values.len() - 1)];
        if self.is_load { Driven::Load(value) } else { Driven::Shift(value) }
    }
}

/// Reads what drives each row. Several values of one motion are combined with the single value of
/// another, or pairwise with as many. `force` is that of an elliptical contact.
pub(super) fn drives(
    case: &Section<'_>,
    rolling: &Section<'_>,
    force: Option<f64>,
) -> Result<Vec<RollingDrive>, CaseError> {
    let normal = match force {
        Some(force) => {
            if let Some(field) = [&ZETA, &F_Z].into_iter().find(|field| rolling.has(*field)) {
                let reason = "an elliptical contact takes its load as `contact.F_z`";
                return Err(case.conflict([&ROLLING, field], &CONTACT, reason));
            }
            Motion { field: None, is_load: true, values: Numbers::One(force) }
        }
        None => Motion::read(rolling, &ZETA, &F_Z)?,
    };
    if force.is_none() && normal.field.is_none() {
        return Err(rolling.missing_as(&F_Z, "given beside `gap`, or `zeta`"));
    }
    let motions = [
        normal,
        Motion::read(rolling, &ALONG, &F_X)?,
        Motion::read(rolling, &ACROSS, &F_Y)?,
        Motion::read(rolling, &SPIN, &M_Z)?,
    ];
    let longest = motions.iter().max_by_key(|motion| motion.count());
    let count = longest.map_or(1, Motion::count);
    let other = motions.iter().find(|motion| motion.count() > 1 && motion.count() != count);
    if let Some((own, longest)) =
        other.and_then(|other| other.field).zip(longest.and_then(|longest| longest.field))
    {
        let reason = "both must have the same number of values";
        return Err(rolling.conflict(own, longest, reason));
    }
    let [normal, along, across, spin] = &motions;
    let row = |i| RollingDrive {
        normal: normal.row(i),
        along: along.row(i),
        across: across.row(i),
        spin: spin.row(i),
    };
    Ok((0..count).map(row).collect())
}

/// Checks that given tangential forces are below what friction holds under a given normal force.
pub(super) fn check_friction(
    rolling: &Section<'_>,
    drives: &[RollingDrive],
    friction: f64,
) -> Result<(), CaseError> {
    let load = |driven| match driven {
        Driven::Load(load) => load,
        Driven::Shift(_) => 0.0,
    };
    for drive in drives {
        let Driven::Load(force) = drive.normal else { continue };
        let (x, y, limit) = (load(drive.along), load(drive.across), friction * force);
        if x.hypot(y) >= limit && (x != 0.0 || y != 0.0) {
            let (field, value) = if x.abs() >= y.abs() { (&F_X, x) } else { (&F_Y, y) };
            let allowed = format!(
                "such that F_x and F_y together are below friction times F_z, {limit} N: at this \
                 limit the whole contact slides, and no creepage belongs to the force"
            );
            return Err(rolling.out_of_range(field, value, &allowed));
        }
    }
    Ok(())
}

/// Reads how far it rolls from rest.
pub(super) fn distance(
    rolling: &Section<'_>,
    drives: &[RollingDrive],
    touching: Option<&Touching>,
    grid: GridCase,
) -> Result<Option<f64>, CaseError> {
    let Some(distance) = rolling.maybe(&DISTANCE)? else { return Ok(None) };
    if drives.len() > 1 {
        let all = [&ALONG, &F_X, &ACROSS, &F_Y, &SPIN, &M_Z, &ZETA, &F_Z];
        let several = all
            .into_iter()
            .find(|field| rolling.numbers(field).is_ok_and(|numbers| numbers.as_slice().len() > 1));
        let reason = "rolling from rest takes a single value of each motion";
        return Err(rolling.conflict(&DISTANCE, several.unwrap_or(&ALONG), reason));
    }
    let Some(cells) = grid.given() else {
        let reason = "an accuracy needs the steady state; give a grid";
        return Err(rolling.excluded(&DISTANCE, "grid.accuracy".to_owned(), reason));
    };
    let length = match touching {
        Some(touching) => 2.0 * touching.semi_axis_a(),
        None => (cells.nx() as f64 * cells.dx()).max(cells.ny() as f64 * cells.dy()),
    };
    if distance > MOST_LENGTHS * length {
        let allowed = match touching {
            Some(_) => "at most 100 lengths of the contact",
            None => "at most 100 lengths of the grid",
        };
        return Err(rolling.out_of_range(&DISTANCE, distance, allowed));
    }
    if let Some(step) = rolling.maybe(&STEP)?.filter(|step| distance / step > MOST_STEPS) {
        let allowed = "such that the distance has at most 100000 steps";
        return Err(rolling.out_of_range(&STEP, step, allowed));
    }
    Ok(Some(distance))
}

/// Reads the rolling speed.
pub(super) fn speed(rolling: &Section<'_>) -> Result<f64, CaseError> {
    rolling.number(&SPEED)
}

/// Reads direction, length of a step and place of the spin.
pub(super) fn method(
    rolling: &Section<'_>,
    tolerance: Option<f64>,
) -> Result<SteadyMethod, CaseError> {
    let refused = |error| rolling.refused(error);
    let direction = rolling.number(&DIRECTION)?.to_radians();
    let spin_offset = rolling.number(&SPIN_OFFSET)?;
    let mut method = SteadyMethod::default()
        .towards(direction)
        .and_then(|method| method.with_spin_at(spin_offset))
        .map_err(refused)?;
    if let Some(step) = rolling.maybe(&STEP)? {
        method = method.in_steps_of(step).map_err(refused)?;
    }
    match tolerance {
        Some(tolerance) => method.within(tolerance).map_err(refused),
        None => Ok(method),
    }
}
