//! The case file of `carom roll`.

mod contact;
mod rolling;

pub use contact::{Elliptical, Straight, Touching};

use super::error::CaseError;
use super::field::{Field, Form, Schema};
use super::material::{self, MATERIAL};
use super::reader::Case;
use super::section::{Section, parse};
use super::solve::influence::{self, INFLUENCE};
use super::solve::{FrictionCase, GAP, GapCase, GridCase, InfluenceFile, TOLERANCE};
use carom_halfspace::MaterialPair;
use carom_laws::validity::PressureLimits;
use carom_rolling::{RollingDrive, RollingFriction, SteadyMethod};
use contact::{CONTACT, GRID};
use rolling::ROLLING;

const BODY_1: Field =
    Field::new("body_1", Form::Table(&[MATERIAL]), "the body on the side to which z points");
const BODY_2: Field = Field::new("body_2", Form::Table(&[MATERIAL]), "the other body");
/// The gap of `carom solve`, which an elliptical contact need not give.
const ANY_GAP: Field =
    GAP.or("`contact.semi_axes`, `contact.radii`, or `contact.radius` and `contact.length`");

const BODIES: Field = Field::new("bodies", Form::Table(&[INFLUENCE]), "what the bodies are")
    .may("both are half-spaces");

/// All fields.
const FIELDS: &[Field] = &[BODY_1, BODY_2, BODIES, ANY_GAP, CONTACT, ROLLING, GRID];

/// A rolling contact.
#[derive(Debug, Clone, PartialEq)]
pub struct RollCase {
    /// Both bodies.
    pub materials: MaterialPair,
    /// The elliptical contact or the line under its load, if the case gives one instead of a gap.
    pub touching: Option<Touching>,
    /// The gap between the bodies.
    pub gap: GapCase,
    /// The file of influence numbers; none for half-spaces.
    pub influence: Option<InfluenceFile>,
    /// The grid.
    pub grid: GridCase,
    /// Coefficients of friction, equal at rest and in motion; by the slip speed that at rest, and the law is in the
    /// method.
    pub friction: FrictionCase,
    /// Rolling speed, m/s.
    pub speed: f64,
    /// Direction of rolling, length of a step, place of the spin and tolerance.
    pub method: SteadyMethod,
    /// What drives each row.
    pub drives: Vec<RollingDrive>,
    /// How far it rolls from rest, m; none for the steady state.
    pub distance: Option<f64>,
}

impl Case<'_> for RollCase {
    const SCHEMA: Schema =
        Schema::new("roll", "A rolling contact, driven by creepages or by forces.", FIELDS);

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let body = |field| material::read(&case.section(field)?);
        let materials = MaterialPair::new(body(&BODY_1)?, body(&BODY_2)?)
            .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
        let contact = case.section(&CONTACT)?;
        let touching = contact::read(&case, &contact, materials)?;
        let grid = contact::read_grid(&case, touching.as_ref())?;
        let gap = match &touching {
            Some(touching) => GapCase::Formula(touching.gap()),
            None => GapCase::read(&case, grid.given())?,
        };
        let influence = influence::read(&case, &BODIES, grid)?;
        if influence.is_some() && touching.is_some() {
            let reason = "influence numbers belong to the cells of a grid; give `gap` and `grid`";
            return Err(case.conflict([&BODIES, &INFLUENCE], &CONTACT, reason));
        }
        let (friction, by_slip) = contact::read_friction(&contact, grid)?;
        let tolerance = contact.maybe(&TOLERANCE)?;
        let rolling = case.section(&ROLLING)?;
        let normal = touching.as_ref().map(Touching::force);
        let drives = rolling::drives(&case, &rolling, normal)?;
        if friction.map.is_none() {
            rolling::check_friction(&rolling, &drives, friction.motion)?;
        }
        let distance = rolling::distance(&rolling, &drives, touching.as_ref(), grid)?;
        let speed = rolling::speed(&rolling)?;
        let mut method = rolling::method(&rolling, tolerance)?;
        if let Some(law) = by_slip {
            if distance.is_some() {
                let reason = "from rest, friction that falls with the slip speed lets cells stick and slip in turn, and no \
                              grid settles it; the steady state has it";
                return Err(case.conflict(
                    [&CONTACT, &contact::FRICTION_BY_SLIP],
                    &ROLLING,
                    reason,
                ));
            }
            let friction = RollingFriction::new(law, speed);
            let friction = friction.map_err(|error| rolling.refused(error))?;
            method = method.with_friction_by_slip(friction);
        }
        Ok(Self {
            materials,
            touching,
            gap,
            influence,
            grid,
            friction,
            speed,
            method,
            drives,
            distance,
        })
    }
}

impl RollCase {
    /// What the bodies bear.
    #[must_use]
    pub fn pressure_limits(&self) -> PressureLimits {
        let limits = PressureLimits::of(&self.materials);
        if self.influence.is_none() { limits } else { limits.without_half_spaces() }
    }
}
