//! The case file of `carom solve`.

mod gap;
mod legs;
mod method;
mod plate;

pub use gap::{GapCase, HeightFile};
pub use legs::{Leg, Target};
pub use method::SolveMethod;
pub use plate::PlateCase;

use super::error::CaseError;
use super::field::{Default, Field, Form, Usual};
use super::kind::CaseKind;
use super::material::{self, MATERIAL};
use super::range::Range;
use super::section::{Section, parse, survey};
use super::unit::Dimension;
use carom_halfspace::{Grid, MaterialPair};
use gap::GAP;
use legs::STEP;
use method::METHOD;
use plate::BODIES;

const BODY_1: Field =
    Field::new("body_1", Form::Table(&[MATERIAL]), "the body on the side to which z points");
const BODY_2: Field = Field::new("body_2", Form::Table(&[MATERIAL]), "the other body");
const CELLS: Field = Field::new(
    "cells",
    Form::Vector(&["x", "y"], Range::Cells.pure(), "two whole numbers [along x, along y]"),
    "cells of the grid",
)
.or("`accuracy`")
.such_as("[40, 40]");
const SIZE: Field = Field::new(
    "size",
    Form::Vector(
        &["x", "y"],
        Range::Positive.of(Dimension::Length),
        "two lengths [along x, along y]",
    ),
    "sides of the whole grid, on a plate those of the plate; the contact must not reach its border",
)
.or("`accuracy`")
.such_as("[2.6e-4, 2.6e-4]");
const CUT: Field = Field::new(
    "cut",
    Form::Switch,
    "whether the bodies end at the border, so that the contact may reach it",
)
.default(Default::False);
const PERIODIC: Field = Field::new(
    "periodic",
    Form::Switch,
    "whether the surfaces are periodic; the approach is then measured from the mean plane",
)
.default(Default::False);
const ACCURACY: Field = Field::number(
    "accuracy",
    Range::Accuracy.pure(),
    "window and cells are chosen so that estimated errors of loads and shifts are at most this part \
     of the greatest ones, instead of `cells` and `size`",
)
.may("a grid is given")
.such_as("1e-3");
const GRID: Field =
    Field::new("grid", Form::Table(&[CELLS, SIZE, CUT, PERIODIC, ACCURACY]), "the grid")
        .begun(&[(&CELLS, ""), (&SIZE, "")]);
const FRICTION: Field =
    Field::number("friction", Range::NonNegative.pure(), "coefficient of friction f")
        .such_as("0.3")
        .usually(Usual::FRICTION);
const STATIC: Field = Field::number(
    "static_friction",
    Range::NonNegative.pure(),
    "coefficient of static friction: cells stick below it; slipping cells have `friction`",
)
.may("the same as `friction`")
.such_as("0.4");
const TOLERANCE: Field = Field::number(
    "tolerance",
    Range::SolveTolerance.pure(),
    "residual to which each step is solved, relative to the largest pressure",
)
.may("the default of the method")
.such_as("1e-9");
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[FRICTION, STATIC, TOLERANCE, METHOD]),
    "friction, tolerance and method",
);

/// All fields.
pub(super) const FIELDS: &[Field] = &[BODY_1, BODY_2, BODIES, GAP, GRID, CONTACT, STEP];

/// A contact on a grid and its load history.
#[derive(Debug, Clone, PartialEq)]
pub struct SolveCase {
    /// Both bodies.
    pub materials: MaterialPair,
    /// The plate that body 2 is; none for a half-space.
    pub plate: Option<PlateCase>,
    /// The gap between them.
    pub gap: GapCase,
    /// The grid.
    pub grid: GridCase,
    /// Coefficient of kinetic friction.
    pub friction: f64,
    /// Coefficient of static friction, at least as large.
    pub static_friction: f64,
    /// Tolerance of each step; none for the default of the method.
    pub tolerance: Option<f64>,
    /// The solution method.
    pub method: SolveMethod,
    /// The load history.
    pub legs: Vec<Leg>,
}

/// A grid, or the accuracy for which one is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GridCase {
    /// Cells about the origin.
    Cells {
        /// The grid.
        grid: Grid,
        /// What lies beyond its border.
        border: Border,
    },
    /// A grid chosen for this accuracy.
    Accuracy(f64),
}

/// What lies beyond the border of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Border {
    /// The bodies continue, and the contact must not reach the border.
    Free,
    /// The bodies end there.
    Cut,
    /// The surfaces are periodic.
    Periodic,
}

impl SolveCase {
    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        Self::parse_to(source, None)
    }

    /// Reads a case; if an accuracy is given, it replaces the grid of the file.
    ///
    /// # Errors
    /// As [`SolveCase::parse`].
    pub fn parse_to(source: &str, accuracy: Option<f64>) -> Result<Self, CaseError> {
        Self::read(source, accuracy).map_err(|first| survey::all(CaseKind::Solve, source, first))
    }

    fn read(source: &str, accuracy: Option<f64>) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let body = |field| material::read(&case.section(field)?);
        let materials = MaterialPair::new(body(&BODY_1)?, body(&BODY_2)?)
            .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
        let grid = match accuracy {
            Some(accuracy) => GridCase::Accuracy(accuracy),
            None => read_grid(&case)?,
        };
        let fixed = match grid {
            GridCase::Cells { grid, .. } => Some(grid),
            GridCase::Accuracy(_) => None,
        };
        let gap = GapCase::read(&case, fixed)?;
        let contact = case.section(&CONTACT)?;
        let (friction, tolerance) = (contact.number(&FRICTION)?, contact.maybe(&TOLERANCE)?);
        let static_friction = contact.maybe(&STATIC)?.unwrap_or(friction);
        if static_friction < friction {
            return Err(contact.out_of_range(&STATIC, static_friction, "at least `friction`"));
        }
        let method = method::read(&contact)?;
        let plate = plate::read(&case, materials, grid)?;
        if plate.is_some() {
            check_contact(&case, &contact, static_friction, method)?;
        }
        let legs = legs::read(&case)?;
        Ok(Self { materials, plate, gap, grid, friction, static_friction, tolerance, method, legs })
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

fn read_grid(case: &Section<'_>) -> Result<GridCase, CaseError> {
    let grid = case.section(&GRID)?;
    if let Some(accuracy) = grid.maybe(&ACCURACY)? {
        let others: [&Field; 4] = [&CELLS, &SIZE, &CUT, &PERIODIC];
        return match others.into_iter().find(|field| grid.has(*field)) {
            Some(other) => Err(grid.conflict(&ACCURACY, other, "an accuracy chooses the grid")),
            None => Ok(GridCase::Accuracy(accuracy)),
        };
    }
    let counts: [f64; 2] = grid.vector(&CELLS)?;
    let sizes: [f64; 2] = grid.vector(&SIZE)?;
    let [nx, ny] = counts.map(|count| count as usize);
    let made = Grid::new(nx, ny, sizes[0] / counts[0], sizes[1] / counts[1])
        .map_err(|error| grid.out_of_range(&SIZE, error.value, error.allowed))?;
    let border = match (grid.switch(&CUT)?, grid.switch(&PERIODIC)?) {
        (true, true) => {
            let reason = "bodies that end at the border are not periodic";
            return Err(grid.conflict(&PERIODIC, &CUT, reason));
        }
        (true, false) => Border::Cut,
        (false, true) => Border::Periodic,
        (false, false) => Border::Free,
    };
    Ok(GridCase::Cells { grid: made, border })
}
