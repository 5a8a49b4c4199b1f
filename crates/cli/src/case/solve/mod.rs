//! The case file of `carom solve`.

mod gap;
mod legs;
mod method;

pub use gap::{GapCase, HeightFile};
pub use legs::{Leg, Target};
pub use method::SolveMethod;

use super::error::CaseError;
use super::field::{Default, Field, Form};
use super::material::{self, MATERIAL};
use super::range::Range;
use super::section::{Section, parse};
use super::unit::Dimension;
use carom_halfspace::{Grid, MaterialPair};
use gap::GAP;
use legs::STEP;
use method::METHOD;

const BODY_1: Field =
    Field::new("body_1", Form::Table(&[MATERIAL]), "the body on the side to which z points");
const BODY_2: Field = Field::new("body_2", Form::Table(&[MATERIAL]), "the other body");
const CELLS: Field = Field::new(
    "cells",
    Form::Vector(&["x", "y"], Range::Cells.pure(), "two whole numbers [along x, along y]"),
    "cells of the grid",
)
.such_as("[40, 40]");
const SIZE: Field = Field::new(
    "size",
    Form::Vector(
        &["x", "y"],
        Range::Positive.of(Dimension::Length),
        "two lengths [along x, along y]",
    ),
    "of the whole grid; the contact must not reach its border",
)
.such_as("[2.6e-4, 2.6e-4]");
const CUT: Field = Field::new(
    "cut",
    Form::Switch,
    "whether the bodies end at the border, so that the contact may reach it",
)
.default(Default::False);
const GRID: Field = Field::new("grid", Form::Table(&[CELLS, SIZE, CUT]), "the cells");
const FRICTION: Field =
    Field::number("friction", Range::NonNegative.pure(), "coefficient of friction f")
        .such_as("0.3");
const TOLERANCE: Field = Field::number(
    "tolerance",
    Range::SolveTolerance.pure(),
    "to which each step is solved, over the greatest pressure",
)
.may("that of the method")
.such_as("1e-9");
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[FRICTION, TOLERANCE, METHOD]),
    "friction, tolerance and method",
);

/// All fields.
pub(super) const FIELDS: &[Field] = &[BODY_1, BODY_2, GAP, GRID, CONTACT, STEP];

/// A contact on a grid and what it goes through.
#[derive(Debug, Clone, PartialEq)]
pub struct SolveCase {
    /// Both bodies.
    pub materials: MaterialPair,
    /// What lies between them before.
    pub gap: GapCase,
    /// The cells.
    pub grid: Grid,
    /// Whether the bodies end at the border of the grid, so that the contact may reach it.
    pub is_cut: bool,
    /// Coefficient of friction.
    pub friction: f64,
    /// To which each step is solved; none for the method's own.
    pub tolerance: Option<f64>,
    /// By which method.
    pub method: SolveMethod,
    /// The history.
    pub legs: Vec<Leg>,
}

impl SolveCase {
    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let body = |field| material::read(&case.section(field)?);
        let materials = MaterialPair::new(body(&BODY_1)?, body(&BODY_2)?)
            .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
        let (grid, is_cut) = read_grid(&case)?;
        let gap = GapCase::read(&case, grid)?;
        let contact = case.section(&CONTACT)?;
        let (friction, tolerance) = (contact.number(&FRICTION)?, contact.maybe(&TOLERANCE)?);
        let method = method::read(&contact)?;
        let legs = legs::read(&case)?;
        Ok(Self { materials, gap, grid, is_cut, friction, tolerance, method, legs })
    }
}

fn read_grid(case: &Section<'_>) -> Result<(Grid, bool), CaseError> {
    let grid = case.section(&GRID)?;
    let counts: [f64; 2] = grid.vector(&CELLS)?;
    let sizes: [f64; 2] = grid.vector(&SIZE)?;
    let [nx, ny] = counts.map(|count| count as usize);
    let made = Grid::new(nx, ny, sizes[0] / counts[0], sizes[1] / counts[1])
        .map_err(|error| grid.out_of_range(&SIZE, error.value, error.allowed))?;
    Ok((made, grid.switch(&CUT)?))
}
