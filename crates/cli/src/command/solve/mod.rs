//! `carom solve`: a contact with friction on a grid, step by step.

mod below;
mod classic;
pub(super) mod compare;
mod follow;
pub(super) mod heights;
mod npz;
pub(super) mod plot;
mod store;
mod view;

use crate::case::SolveCase;
use crate::columns::{self, Record};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::output::{Answer, Format, json};
use carom_solver::{CellState, ContactState};
use follow::Run;
use serde::Serialize;
use std::path::PathBuf;
use store::{Found, Store};

/// A contact with friction on a grid: any gap, any materials, any history.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see examples/solve_*.toml. Each
/// [[step]] goes to a shift or a load for each of the four motions (zeta or F_z, xi or F_x, eta or
/// F_y, omega or M_z) in `count` equal parts; what it does not name stays as it was. Body 2 is
/// shifted against body 1; loads act on body 1. The picture shows loads, stick and slip, stresses and
/// energies of the last step.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Keep each step in this folder as soon as it is done: loads.csv, and the fields as NumPy
    /// archives step-000001.npz, ...
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
    /// Go on from the steps that are in the folder: the same bits as if it had never stopped.
    #[arg(long, requires = "keep")]
    resume: bool,
    /// Give the stress in both bodies at the end too, at this many depths below the greatest
    /// pressure.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    depths: Option<u32>,
}

/// What the rows hold.
fn help() -> String {
    let steps = columns::help("A row for each step", view::COLUMNS);
    let depths = columns::help("With --depths as CSV, a row for each depth", below::COLUMNS);
    format!("{steps}\n{depths}")
}

/// Steps, and stresses below the last one, as they stand in JSON.
#[derive(Serialize)]
struct Both<'a> {
    steps: Vec<Record<'a, view::Step>>,
    depths: Vec<Record<'a, below::Below>>,
}

/// Fewer cells than this across the contact give a warning.
const COARSE: f64 = 10.0;

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let command::Given { case: file, plot } = arguments.given.read()?;
    let case = file.parse(SolveCase::parse)?;
    let (gap, heights) = heights::gap(&file.path, &case)?;
    let run = Run::new(&file.path, &case, gap)?;
    let text =
        std::fs::read(&file.path).map_err(|error| CliError::io("read", &file.path, error))?;
    let inputs = [text.as_slice(), heights.as_bytes()];
    let store = arguments.keep.as_ref().map(|folder| Store::open(folder, &inputs)).transpose()?;
    let nothing = || Found { steps: Vec::new(), state: ContactState::apart(case.grid) };
    let found = match &store {
        Some(store) if arguments.resume => {
            store.find(case.grid, case.legs.iter().map(|leg| leg.count).sum())?
        }
        Some(store) => {
            store.check_empty()?;
            nothing()
        }
        None => nothing(),
    };
    let followed = run.follow(found, store.as_ref())?;
    let (steps, format) = (&followed.steps, arguments.given.format);
    columns::check(&file.path, view::COLUMNS, steps)?;
    let stresses = match (arguments.depths, steps.last()) {
        (Some(count), Some(last)) => {
            below::along_normal(&file.path, &case, &followed.state, last, count as usize)?
        }
        _ => Vec::new(),
    };
    let depths = || columns::rows(format, below::COLUMNS, &stresses);
    let text = match (format, arguments.depths) {
        (Format::Json, None) => json(&view::records(steps))?,
        (Format::Json, Some(_)) => json(&Both {
            steps: view::records(steps),
            depths: stresses.iter().map(|row| Record::new(below::COLUMNS, row)).collect(),
        })?,
        (Format::Table, None) => columns::rows(format, &view::readable(), steps)?,
        (Format::Table, Some(_)) => columns::rows(format, &view::readable(), steps)? + &depths()?,
        (_, Some(_)) => depths()?,
        (_, None) => columns::rows(format, view::COLUMNS, steps)?,
    };
    let mut warnings = Vec::new();
    if followed.found > 0 {
        warnings.push(format!("{} of {} steps were there already", followed.found, steps.len()));
    }
    warnings.extend(coarse(&followed.state));
    let picture = match plot {
        Some(to) => Some((to, plot::draw(&followed, &case)?)),
        None => None,
    };
    Ok(Answer { text, warnings, picture, ..Answer::default() })
}

/// A warning if few cells lie across the contact.
fn coarse(state: &ContactState) -> Option<String> {
    let touching = state.cells.values().iter().filter(|cell| **cell != CellState::Exterior).count();
    let across = (4.0 / std::f64::consts::PI * touching as f64).sqrt();
    (touching > 0 && across < COARSE).then(|| {
        format!(
            "only about {across:.0} cells lie across the contact: loads may be off by {:.0} %",
            100.0 / (across * across)
        )
    })
}
