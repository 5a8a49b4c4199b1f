//! A rolling contact on its grid: creep forces in the steady state, or step by step from rest.

mod creep;
mod row;
mod run;

pub use creep::{CREEP, Creep};
pub use row::{COLUMNS, Row};
pub(crate) use run::of_one_line;
pub use run::{Rows, Run, RunError};

use crate::case::{Border, GridCase, RollCase};
use crate::input::CaseFile;
use crate::solve::Bodies;
use crate::{Error, ErrorKind};
use carom_laws::validity::Validity;
use carom_solver::{Accuracy, ContactState, GridWarning, Window};

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
    /// Those of the table of creep forces, likewise.
    pub table: bool,
}

/// Computes a rolling contact. `observer` is told how many rows there are, and of each one.
///
/// # Errors
/// [`ErrorKind::Rolling`] if a row cannot be solved; [`ErrorKind::RollingFit`] if no grid reaches the accuracy;
/// [`ErrorKind::Border`] if the contact reaches the border of the grid; [`ErrorKind::Range`], [`ErrorKind::Problem`],
/// [`ErrorKind::Input`] if a value or a file that the case names is not valid.
pub fn rolled(
    file: &CaseFile,
    case: &RollCase,
    wanted: Wanted,
    observer: &mut dyn FnMut(Progress),
) -> Result<Rolled, Error> {
    file.follow(|| rows_of(file, case, wanted, observer))
}

fn rows_of(
    file: &CaseFile,
    case: &RollCase,
    wanted: Wanted,
    observer: &mut dyn FnMut(Progress),
) -> Result<Rolled, Error> {
    if (wanted.springs || wanted.table) && case.method.friction().is_some() {
        return Err(Error::input(
            "FASTSIM and the table of creep forces have one coefficient of friction",
        ));
    }
    let creep = (wanted.coefficients || wanted.springs).then(|| creep::of(case)).transpose()?;
    let table = wanted.table.then(|| creep::Tabulated::of(case)).transpose()?;
    let bodies =
        Bodies::of_half_spaces(file, case.materials, &case.gap, case.grid, &case.friction)?
            .with_influence(file, case.influence.as_ref())?;
    if case.distance.is_none() {
        observer(Progress::Begun(case.drives.len()));
    }
    let window = window(case, &bodies)?;
    let run = Run {
        grid: window.grid(),
        method: case.method,
        speed: case.speed,
        cut: case.grid.border() != Border::Free,
    };
    let make = |grid| bodies.problem(&window.with(grid));
    let computed = match (case.distance, case.drives.first()) {
        (Some(distance), Some(drive)) => {
            make(run.grid).map_err(RunError::from).and_then(|problem| {
                observer(Progress::Begun(1 + run.steps(distance)?));
                run.from_rest(&problem, drive, distance, observer)
            })
        }
        _ => run.steadily(make, &case.drives, observer),
    };
    let Rows { rows, state, too_large } = computed.map_err(of_run)?;
    let mut rows: Vec<Row> = rows.into_iter().map(|row| row.about(window.middle())).collect();
    if let Some(creep) = creep.as_ref().filter(|_| wanted.springs) {
        for row in &mut rows {
            row.springs = Some(creep::springs(case, creep.coefficients, row.creepage)?);
        }
    }
    if let Some(table) = &table {
        for row in &mut rows {
            row.table = Some(table.force(row.creepage)?);
        }
    }
    let creep = creep.filter(|_| wanted.coefficients);
    Ok(Rolled { rows, state, window, too_large, creep })
}

/// Cells of the finest grid that an accuracy may choose. The error falls with the width of a cell.
const MOST_CELLS: usize = 512 * 512;

/// The window of a case, or one chosen for its accuracy.
fn window(case: &RollCase, bodies: &Bodies) -> Result<Window, Error> {
    let accuracy = match (bodies.grid(), case.grid) {
        (Some(grid), _) => return Ok(Window::about([0.0; 2], grid)?),
        (None, GridCase::Accuracy(accuracy)) => Accuracy::new(accuracy)?,
        (None, _) => return Err(Error::input("no grid is given")),
    };
    let drives: Vec<_> = case.drives.iter().map(|drive| (*drive).into()).collect();
    let make = |window: &Window| bodies.problem(window);
    let fit = accuracy.at_most(MOST_CELLS).fit(case.method, make, bodies.sides(), &drives);
    Ok(fit?.window)
}

/// The error of a run in a case.
fn of_run(error: RunError) -> Error {
    match error {
        RunError::Range(source) => source.into(),
        RunError::Problem(source) => source.into(),
        RunError::Row { row, source } => Error::from(*source).at("row", row),
        RunError::Border { row, side } => Error::from(ErrorKind::Border(side)).at("step", row),
    }
}

/// How far a computation is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// The number of rows.
    Begun(usize),
    /// One more row is computed.
    Row,
}

/// How far the contact is from the limits of the theory: an elliptical one and a line by the smallest radius, any other by
/// the pressures of its rows.
#[must_use]
pub fn validity(case: &RollCase, rows: &[Row]) -> Validity {
    if let Some(touching) = &case.touching {
        return touching.validity();
    }
    let peak = rows.iter().map(|row| row.greatest_pressure).fold(0.0, f64::max);
    case.pressure_limits().validity(peak)
}

/// Part of the friction limit that is used from which the creep force is saturated.
const SATURATED: f64 = 0.999;

/// What is told of rows in which the whole contact slides. With spin the slip has all directions, so that the force is below
/// the limit and still grows with the creepage.
fn sliding(case: &RollCase, rows: &[Row]) -> Option<String> {
    let all = rows.len();
    let sliding = rows.iter().filter(|row| row.slides).count();
    if case.method.friction().is_some() && sliding > 0 {
        return Some(format!(
            "full sliding in {sliding} of {all} rows: there friction is that of the slip speed, not that at rest"
        ));
    }
    let saturated =
        rows.iter().filter(|row| row.slides && row.pull() >= SATURATED * row.limit).count();
    match (sliding, saturated) {
        (0, _) => None,
        (count, same) if count == same => Some(format!(
            "full sliding in {count} of {all} rows: the creep force is saturated, and more creepage does not increase it"
        )),
        (count, same) => Some(format!(
            "full sliding in {count} of {all} rows, the creep force saturated in {same}: elsewhere spin turns the slip from \
             cell to cell, and more creepage still increases the force"
        )),
    }
}

/// Warnings about full sliding, displacements too large for the theory, and effects that creep coefficients
/// neglect.
#[must_use]
pub fn warnings(case: &RollCase, rolled: &Rolled, wanted: Wanted) -> Vec<String> {
    let rows = &rolled.rows;
    let mut warnings = Vec::new();
    warnings.extend(sliding(case, rows));
    if let Some((row, warning)) = rolled.too_large {
        warnings.push(format!("row {row}: {warning}"));
    }
    if (wanted.coefficients || wanted.springs) && !case.materials.is_uncoupled() {
        let note = "creep coefficients and FASTSIM replace dissimilar bodies by two equal ones";
        warnings.push(note.to_owned());
    }
    warnings
}
