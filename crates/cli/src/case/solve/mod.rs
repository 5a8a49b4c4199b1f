//! The case file of `carom solve`.

mod gap;
mod legs;

pub use gap::{GapCase, HeightMap};
pub use legs::{Leg, Target};

use super::body::read_material;
use super::error::CaseError;
use super::range::Range;
use super::section::{Section, parse};
use super::unit::Dimension;
use carom_halfspace::{Grid, MaterialPair};

const FIELDS: &[&str] = &["body_1", "body_2", "gap", "grid", "contact", "step"];
/// Cells of a grid, at most along each axis.
const MOST_CELLS: f64 = 4096.0;

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
        let body = |name| read_material(&case.section(name, &["material"])?);
        let materials = MaterialPair::new(body("body_1")?, body("body_2")?)
            .map_err(|error| case.out_of_range("body_2.material", error.value, error.allowed))?;
        let (grid, is_cut) = read_grid(&case)?;
        let gap = GapCase::read(&case, grid)?;
        let contact = case.section("contact", &["friction", "tolerance"])?;
        let friction = contact.number("friction", Range::NonNegative)?;
        let tolerance = match contact.has("tolerance") {
            true => Some(contact.number("tolerance", Range::Positive)?),
            false => None,
        };
        if let Some(tolerance) = tolerance
            && !(1e-13..=0.01).contains(&tolerance)
        {
            return Err(contact.out_of_range("tolerance", tolerance, "from 1e-13 to 0.01"));
        }
        let legs = legs::read(&case)?;
        Ok(Self { materials, gap, grid, is_cut, friction, tolerance, legs })
    }
}

fn read_grid(case: &Section<'_>) -> Result<(Grid, bool), CaseError> {
    let grid = case.section("grid", &["cells", "size", "cut"])?;
    let is_cut = grid.switch("cut")?;
    let whole = "two whole numbers [along x, along y]";
    let counts = grid.array("cells", ["x", "y"], Range::Whole, whole)?;
    for count in counts {
        if count > MOST_CELLS {
            return Err(grid.out_of_range("cells", count, "from 1 to 4096 along each axis"));
        }
    }
    let length = Range::Positive.of(Dimension::Length);
    let sizes = grid.array("size", ["x", "y"], length, "two lengths [along x, along y]")?;
    let [nx, ny] = counts.map(|count| count as usize);
    let made = Grid::new(nx, ny, sizes[0] / counts[0], sizes[1] / counts[1])
        .map_err(|error| grid.out_of_range("size", error.value, error.allowed))?;
    Ok((made, is_cut))
}
