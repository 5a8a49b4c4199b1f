//! A rolling contact on its grid: creep forces in the steady state, or step by step from rest.

mod creep;
mod from_rest;
mod row;
mod steady;

pub use creep::{CREEP, Creep};
pub use row::{COLUMNS, Row};

use crate::Error;
use crate::case::{Border, RollCase};
use crate::input::CaseFile;
use crate::solve::Bodies;
use carom_laws::validity::Validity;
use carom_rolling::RollingError;
use carom_solver::{ContactState, GridWarning, Window};
use std::path::Path;

/// A rolling contact: its rows, and the contact after the last one.
#[derive(Debug, Clone)]
pub struct Rolled {
    /// A row for each drive, or from rest for each step.
    pub rows: Vec<Row>,
    /// The last contact.
    pub state: ContactState,
    /// The window and its cells.
    pub window: Window,
    /// The first row in which a displacement is too large for the theory, and how large it is.
    pub too_large: Option<(usize, GridWarning)>,
    /// The creep coefficients, if they were wanted.
    pub creep: Option<Creep>,
}

/// What is computed beside the rows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Kalker's creep coefficients.
    pub coefficients: bool,
    /// The forces of FASTSIM, in the steady state; not from rest.
    pub springs: bool,
}

/// Computes a rolling contact. `observer` is told how many rows there are, and of each one.
///
/// # Errors
/// [`Error::Rolling`] if a row cannot be solved; [`Error::RollingFit`] if no grid reaches the accuracy;
/// [`Error::Border`] if the contact reaches the border of the grid; [`Error::Law`], [`Error::Problem`],
/// [`Error::Input`] if a value or a file that the case names is not valid.
pub fn rolled(
    file: &CaseFile,
    case: &RollCase,
    wanted: Wanted,
    observer: &mut dyn FnMut(Progress),
) -> Result<Rolled, Error> {
    let creep =
        (wanted.coefficients || wanted.springs).then(|| creep::of(&file.path, case)).transpose()?;
    let bodies =
        Bodies::of_half_spaces(file, case.materials, &case.gap, case.grid, &case.friction)?;
    let springs = creep.as_ref().filter(|_| wanted.springs);
    let rolling = Rolling { path: &file.path, case, bodies: &bodies };
    let mut rolled = match case.distance {
        Some(distance) => rolling.from_rest(distance, observer)?,
        None => rolling.steadily(springs, observer)?,
    };
    rolled.creep = creep.filter(|_| wanted.coefficients);
    Ok(rolled)
}

/// How far a computation is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// The number of rows.
    Begun(usize),
    /// One more row is computed.
    Row,
}

/// How far the contact is from the limits of the theory: an elliptical one by its smallest radius, any other by
/// the pressures of its rows.
#[must_use]
pub fn validity(case: &RollCase, rows: &[Row]) -> Validity {
    if let Some(ellipse) = &case.ellipse {
        let [x, y] = ellipse.relative_radii();
        return Validity::of_hertz(&ellipse.hertz, &ellipse.loaded, x.min(y));
    }
    let peak = rows.iter().map(|row| row.greatest_pressure).fold(0.0, f64::max);
    Validity::of_pressure(peak, case.materials.yield_stress())
}

/// Warnings about full sliding, displacements too large for the theory, and effects that creep coefficients
/// neglect.
#[must_use]
pub fn warnings(case: &RollCase, rolled: &Rolled, wanted: Wanted) -> Vec<String> {
    let rows = &rolled.rows;
    let sliding = rows.iter().filter(|row| row.slides).count();
    let mut warnings = Vec::new();
    if sliding > 0 {
        warnings.push(format!(
            "full sliding in {sliding} of {} rows: the creep force is saturated, and more creepage \
             does not increase it",
            rows.len()
        ));
    }
    if let Some((row, warning)) = rolled.too_large {
        warnings.push(format!("row {row}: {warning}"));
    }
    if (wanted.coefficients || wanted.springs) && !case.materials.is_uncoupled() {
        let note = "creep coefficients and FASTSIM replace dissimilar bodies by two equal ones";
        warnings.push(note.to_owned());
    }
    warnings
}

/// A contact that rolls.
struct Rolling<'a> {
    path: &'a Path,
    case: &'a RollCase,
    bodies: &'a Bodies,
}

impl Rolling<'_> {
    fn range(&self, source: carom_special::RangeError) -> Error {
        Error::Law { path: self.path.to_owned(), source }
    }

    fn failed(&self, row: usize, source: impl Into<RollingError>) -> Error {
        Error::Rolling { path: self.path.to_owned(), row, source: Box::new(source.into()) }
    }

    /// Checks that a contact between bodies without an end does not reach the border of the grid.
    fn check_border(&self, row: usize, state: &ContactState) -> Result<(), Error> {
        if self.case.grid.border() != Border::Free {
            return Ok(());
        }
        match crate::solve::border(state) {
            Some(side) => Err(Error::Border { path: self.path.to_owned(), step: row, side }),
            None => Ok(()),
        }
    }
}

/// The warning of a displacement beyond the theory.
fn too_large(warnings: Vec<GridWarning>) -> Option<GridWarning> {
    let is_large = |warning: &GridWarning| matches!(warning, GridWarning::LargeDisplacement { .. });
    warnings.into_iter().find(is_large)
}
