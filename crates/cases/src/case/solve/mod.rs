//! The case file of `carom solve`.

mod friction;
mod gap;
mod grid;
pub(super) mod influence;
mod legs;
mod method;
mod plate;

pub use friction::FrictionCase;
pub use gap::{GapCase, HeightFile, Missing};
pub use grid::{Border, GridCase};
pub use influence::InfluenceFile;
pub use legs::{Leg, Target};
pub use method::SolveMethod;
pub use plate::PlateCase;

use super::error::CaseError;
use super::field::{Field, Form, Schema};
use super::material::{self, MATERIAL};
use super::range::Range;
use super::reader::Case;
use super::section::{Section, parse, survey};
use carom_halfspace::MaterialPair;
use carom_laws::validity::PressureLimits;
use friction::STATIC;
pub(super) use friction::{FRICTION, FRICTION_MAP};
pub(super) use gap::GAP;
use grid::PERIODIC;
pub(super) use grid::{ACCURACY, CELLS, CUT, SIZE};
use legs::STEP;
use method::METHOD;
use plate::BODIES;

const BODY_1: Field =
    Field::new("body_1", Form::Table(&[MATERIAL]), "the body on the side to which z points");
const BODY_2: Field = Field::new("body_2", Form::Table(&[MATERIAL]), "the other body");
const GRID: Field =
    Field::new("grid", Form::Table(&[CELLS, SIZE, CUT, PERIODIC, ACCURACY]), "the grid")
        .or("`gap.file`")
        .begun(&[(&CELLS, ""), (&SIZE, "")]);
/// The field `tolerance` of a contact.
pub(super) const TOLERANCE: Field = Field::number(
    "tolerance",
    Range::SolveTolerance.pure(),
    "residual to which each step is solved, relative to the largest pressure",
)
.may("the default of the method")
.such_as("1e-9");
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[FRICTION, STATIC, FRICTION_MAP, TOLERANCE, METHOD]),
    "friction, tolerance and method",
);

/// All fields.
const FIELDS: &[Field] = &[BODY_1, BODY_2, BODIES, GAP, GRID, CONTACT, STEP];

/// A contact on a grid and its load history.
#[derive(Debug, Clone, PartialEq)]
pub struct SolveCase {
    /// Both bodies.
    pub materials: MaterialPair,
    /// The plate that body 2 is; none for a half-space.
    pub plate: Option<PlateCase>,
    /// The file of influence numbers; none for half-spaces and a plate.
    pub influence: Option<InfluenceFile>,
    /// The gap between them.
    pub gap: GapCase,
    /// The grid.
    pub grid: GridCase,
    /// Coefficients of friction.
    pub friction: FrictionCase,
    /// Tolerance of each step; none for the default of the method.
    pub tolerance: Option<f64>,
    /// The solution method.
    pub method: SolveMethod,
    /// The load history.
    pub legs: Vec<Leg>,
}

impl Case<'_> for SolveCase {
    const SCHEMA: Schema =
        Schema::new("solve", "A contact with friction on a grid, step by step.", FIELDS);

    fn read(source: &str) -> Result<Self, CaseError> {
        Self::read_to(source, None)
    }
}

impl SolveCase {
    /// What the bodies bear.
    #[must_use]
    pub fn pressure_limits(&self) -> PressureLimits {
        let limits = PressureLimits::of(&self.materials);
        if self.influence.is_none() && self.plate.is_none() {
            limits
        } else {
            limits.without_half_spaces()
        }
    }

    /// Reads a case; if an accuracy is given, it replaces the grid of the file.
    ///
    /// # Errors
    /// As [`Case::parse`].
    pub fn parse_to(source: &str, accuracy: Option<f64>) -> Result<Self, CaseError> {
        Self::read_to(source, accuracy).map_err(|first| survey::all(&Self::SCHEMA, source, first))
    }

    fn read_to(source: &str, accuracy: Option<f64>) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let body = |field| material::read(&case.section(field)?);
        let materials = MaterialPair::new(body(&BODY_1)?, body(&BODY_2)?)
            .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
        let grid = match accuracy {
            Some(accuracy) => GridCase::Accuracy(accuracy),
            None if GapCase::is_of_file(&case) => GridCase::read_beside_file(&case, &GRID)?,
            None => GridCase::read(&case.section(&GRID)?)?,
        };
        let gap = GapCase::read(&case, grid.given())?;
        let contact = case.section(&CONTACT)?;
        let (friction, tolerance) =
            (FrictionCase::read(&contact, grid)?, contact.maybe(&TOLERANCE)?);
        let method = method::read(&contact)?;
        let plate = plate::read(&case, materials, grid)?;
        let influence = influence::read(&case, &BODIES, grid)?;
        if plate.is_some() && influence.is_some() {
            let reason = "influence numbers are those of both bodies together";
            let place = [&BODIES, &influence::INFLUENCE];
            return Err(case.conflict(place, [&BODIES, &plate::PLATE], reason));
        }
        if plate.is_some() {
            check_contact(&case, &contact, friction.rest, method)?;
        }
        let legs = legs::read(&case)?;
        Ok(Self { materials, plate, influence, gap, grid, friction, tolerance, method, legs })
    }
}

/// Checks that a contact with a plate has no friction and the method for it.
fn check_contact(
    case: &Section<'_>,
    contact: &Section<'_>,
    friction: f64,
    method: SolveMethod,
) -> Result<(), CaseError> {
    if friction > 0.0 {
        let place = if contact.number(&FRICTION)? > 0.0 { &FRICTION } else { &STATIC };
        return Err(contact.out_of_range(place, friction, "0 beside `bodies.plate`"));
    }
    if method != SolveMethod::Newton {
        let reason = "a plate is solved without friction, by conjugate gradients";
        return Err(case.conflict([&CONTACT, &METHOD], [&BODIES, &plate::PLATE], reason));
    }
    Ok(())
}
