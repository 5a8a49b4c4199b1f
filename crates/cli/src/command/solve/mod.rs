//! `carom solve`: a contact with friction on a grid, step by step.

mod below;
pub(super) mod compare;
mod kept;
mod limits;
pub(super) mod plot;
mod store;
mod view;

use crate::columns::{self, Records};
use crate::command::case_arguments::{CaseArguments, Given};
use crate::command::surface::Saved;
use crate::error::CliError;
use crate::global_options::Messages;
use crate::output::{Answer, Format, json};
use crate::outputs::{Outputs, Place};
use crate::progress::Progress;
use carom_cases::Error;
use carom_cases::case::SolveCase;
use carom_cases::solve::{Bodies, Followed, Found, Run};
use carom_halfspace::Field;
use carom_solver::{Accuracy, StepSummary};
use kept::Folder;
use serde::Serialize;
use std::path::PathBuf;
use store::Store;

/// A contact with friction on a grid: any gap, any materials, any history.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/solve_*.toml. Each [[step]] prescribes a shift or a load for each of the four motions
/// (zeta or F_z, xi or F_x, eta or F_y, omega or M_z), reached in `count` equal parts; a motion
/// that is not named keeps its value. Body 2 is shifted against body 1; loads act on body 1. The
/// picture shows loads, stick and slip, stresses and energies of the last step.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// Save each step in this folder when it is complete: loads.csv, and the fields as NumPy
    /// archives step-000001.npz, ... The folder must be new, empty or from an earlier run, and no
    /// other run may use it at the same time.
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
    /// Choose window and cells for this accuracy instead of those of the case: estimated errors of
    /// loads and shifts are at most this share of the largest ones.
    #[arg(long, value_name = "ACCURACY")]
    accuracy: Option<f64>,
    /// Continue from the steps in the folder. Results are the same bits as without interruption.
    #[arg(long, requires = "keep")]
    resume: bool,
    /// Also give the stress in both bodies after the last step, at this number of depths below the
    /// maximum pressure.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    depths: Option<u32>,
    /// Save the pressure after the last step in Pa as .npy or .x3p.
    #[arg(long, value_name = "FILE")]
    pressure: Option<PathBuf>,
    /// Save the distance of the surfaces after the last step in m as .npy or .x3p.
    #[arg(long, value_name = "FILE")]
    gap_map: Option<PathBuf>,
}

/// Maps of the last step and their places.
struct Maps {
    keep: Option<PathBuf>,
    pressure: Option<Saved>,
    gap: Option<Saved>,
}

impl Maps {
    fn claim(arguments: &Arguments, outputs: &mut Outputs) -> Result<Self, CliError> {
        let mut map = |option, path: &Option<PathBuf>| {
            path.as_ref().map(|path| Saved::claim(path, option, outputs)).transpose()
        };
        let (pressure, gap) =
            (map("pressure", &arguments.pressure)?, map("gap-map", &arguments.gap_map)?);
        let keep = arguments.keep.as_ref().map(|path| outputs.folder("keep", path)).transpose()?;
        Ok(Self { keep, pressure, gap })
    }

    /// The files of the state after the last step.
    fn files(
        self,
        followed: &Followed,
        gap: Option<&Field>,
    ) -> Result<Vec<(Place, Vec<u8>)>, CliError> {
        let pressure = (self.pressure, Some(&followed.state.pressure), "pressure in Pa");
        let gap = (self.gap, gap, "distance of the surfaces in m");
        let mut files = Vec::new();
        for (saved, field, meaning) in [pressure, gap] {
            if let (Some(saved), Some(field)) = (saved, field) {
                let grid = field.grid();
                files.push(saved.values(
                    field.values(),
                    grid.nx(),
                    [grid.dx(), grid.dy()],
                    meaning,
                )?);
            }
        }
        Ok(files)
    }
}

/// Help on the columns of the rows.
fn help() -> String {
    let steps = columns::help("A row for each step", &StepSummary::columns());
    let depths = columns::help("With --depths as CSV, a row for each depth", below::COLUMNS);
    format!("{steps}\n{depths}")
}

/// Steps, and stresses below the last one, in JSON.
#[derive(Serialize)]
struct Both<'a> {
    steps: Records<'a, StepSummary>,
    depths: Records<'a, below::Below>,
}

pub(super) fn run(arguments: &Arguments, messages: &Messages) -> Result<Answer, CliError> {
    let claims = |outputs: &mut Outputs| Maps::claim(arguments, outputs);
    let (Given { case: file, plot }, mut maps) = arguments.given.read_beside(claims)?;
    let keep = maps.keep.take();
    if let Some(accuracy) = arguments.accuracy {
        Accuracy::new(accuracy)?;
    }
    let case = file.parse_by(|source| SolveCase::parse_to(source, arguments.accuracy))?;
    if arguments.depths.is_some() {
        only_half_spaces(&case, "--depths")?;
    }
    let bodies = Bodies::of(&file, &case)?;
    let accuracy = arguments.accuracy.map(f64::to_le_bytes).unwrap_or_default();
    let inputs = [file.text().as_bytes(), bodies.read(), &accuracy];
    let keep = keep.map(|path| Folder::new(path, &inputs, arguments.resume));
    keep.as_ref().map(Folder::check).transpose()?;
    let run = Run::new(&case, &bodies)?;
    let store = keep.map(Folder::open).transpose()?.map(Store::new);
    let found = match &store {
        Some(store) => store.find(run.window().grid(), run.count())?,
        None => Found::default(),
    };
    let followed = follow(run, found, store.as_ref(), messages)?;
    let (steps, format) = (&followed.steps, arguments.given.format());
    let all = StepSummary::columns();
    columns::check(&all, steps)?;
    let stresses = match (arguments.depths, steps.last()) {
        (Some(count), Some(last)) => {
            below::along_normal(&case, &followed.state, last, count as usize)?
        }
        _ => Vec::new(),
    };
    let depths = || columns::rows(format, below::COLUMNS, &stresses);
    let text = match (format, arguments.depths) {
        (Format::Json, None) => json(&Records(&all, steps))?,
        (Format::Json, Some(_)) => {
            json(&Both { steps: Records(&all, steps), depths: Records(below::COLUMNS, &stresses) })?
        }
        (Format::Table(page), depth) => {
            let rows =
                columns::rows(format, view::readable(), steps)? + &page.fold(&view::errors(steps));
            if depth.is_some() { rows + &depths()? } else { rows }
        }
        (_, Some(_)) => depths()?,
        (_, None) => columns::rows(format, &all, steps)?,
    };
    let mut warnings = Vec::new();
    if followed.found > 0 {
        warnings.push(format!(
            "{} of {} steps were already in the folder",
            followed.found,
            steps.len()
        ));
    }
    warnings.extend(followed.warnings(&case));
    let picture = match plot {
        Some(to) => Some(arguments.given.drawn(to, plot::draw(&followed, &case)?)),
        None => None,
    };
    let gap = maps.gap.as_ref().map(|_| bodies.gap_left(&followed)).transpose()?;
    let files = maps.files(&followed, gap.as_ref())?;
    Ok(Answer { text, warnings, picture, files, ..Answer::default() })
}

/// Continues from the saved steps to the last one; each step is saved when it is complete.
fn follow(
    run: Run<'_>,
    found: Found,
    store: Option<&Store>,
    messages: &Messages,
) -> Result<Followed, CliError> {
    let progress = Progress::new(*messages, run.count(), "steps");
    progress.found(found.steps.len());
    let followed = run.follow(found, |steps, history, window| {
        if let Some(store) = store {
            store.save(steps, history, window)?;
        }
        progress.inc(1);
        Ok::<_, CliError>(())
    })?;
    Ok(followed)
}

/// An error if a body is a plate, which this request does not support.
fn only_half_spaces(case: &SolveCase, request: &str) -> Result<(), Error> {
    if case.plate.is_none() {
        return Ok(());
    }
    let reason = format!("`bodies.plate` excludes {request}: it is for half-spaces");
    Err(Error::input(reason))
}
