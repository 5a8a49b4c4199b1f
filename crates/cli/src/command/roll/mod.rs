//! `carom roll`: a rolling contact under creepage and spin.

mod plot;
mod solve;
mod view;

use crate::columns::{self, Record};
use crate::command::theory::{Excess, caution};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::output::{Answer, Format, json};
use carom_cases::case::RollCase;
use carom_table::row;
use serde::Serialize;
use solve::Rolling;
use view::{COLUMNS, CREEP, Creep, Row};

/// A rolling contact: creep forces in the steady state, or step by step from rest.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see examples/roll_*.toml. The contact
/// rolls along x; creepages are motions of body 2 against body 1 for each length rolled, loads act on
/// body 1. Several creepages give a creep curve. The picture shows the curve and the last contact.
/// Forces under small creepage are within some 5 % at 20 elements across, and the better the more there
/// are; --coefficients gives their limit.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Give Kalker's creep coefficients of the contact too; as CSV they stand alone.
    #[arg(long)]
    coefficients: bool,
    /// Give the forces of FASTSIM, rolling on springs, beside the solver's.
    #[arg(long)]
    fastsim: bool,
}

fn help() -> String {
    let rows = columns::help("A row for each creepage, or each cell rolled", COLUMNS);
    let creep = columns::help("With --coefficients as CSV, one row", CREEP);
    format!("{rows}\n{creep}")
}

/// All of a case as it stands in JSON with `--coefficients`.
#[derive(Serialize)]
struct Both<'a> {
    coefficients: Record<'a, Creep>,
    rows: Vec<Record<'a, Row>>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let command::Given { case: file, plot } = arguments.given.read()?;
    let case = file.parse(RollCase::parse)?;
    if arguments.fastsim && case.distance.is_some() {
        return Err(CliError::Options(
            "--fastsim knows the steady state only: leave out `distance`",
        ));
    }
    let creep = (arguments.coefficients || arguments.fastsim)
        .then(|| solve::creep(&file.path, &case))
        .transpose()?;
    let rolling = Rolling::new(&file.path, &case)?;
    let (rows, state) = match case.distance {
        Some(distance) => rolling.step_by_step(distance)?,
        None => rolling.steadily(creep.as_ref().filter(|_| arguments.fastsim))?,
    };
    let format = arguments.given.format;
    columns::check(&file.path, &view::columns(&rows, false), &rows)?;
    let creep = creep.filter(|_| arguments.coefficients);
    let text = text(format, &rows, creep.as_ref())?;
    let picture = match plot {
        Some(to) => Some((to, plot::draw(&rows, &state)?)),
        None => None,
    };
    let warnings = warnings(&case, &rows, arguments.coefficients || arguments.fastsim);
    let curvature = case.hertz.curvature();
    let radius = 0.5 / curvature.a().max(curvature.b());
    let excess = Excess::of_contact(case.loaded.approach, radius);
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution(&[excess], "contacts"), format))
}

fn text(format: Format, rows: &[Row], creep: Option<&Creep>) -> Result<String, CliError> {
    let records = || rows.iter().map(|row| Record::new(COLUMNS, row)).collect::<Vec<_>>();
    match (format, creep) {
        (Format::Json, None) => json(&records()),
        (Format::Json, Some(creep)) => {
            json(&Both { coefficients: Record::new(CREEP, creep), rows: records() })
        }
        (Format::Csv, Some(creep)) => columns::rows(format, CREEP, std::slice::from_ref(creep)),
        (Format::Table, creep) => {
            let creep = creep.map(|creep| columns::upright(&row(CREEP, Some(creep))));
            Ok(creep.unwrap_or_default()
                + &columns::rows(format, &view::columns(rows, true), rows)?)
        }
        (format, _) => columns::rows(format, &view::columns(rows, false), rows),
    }
}

/// Full sliding, and what creep coefficients leave out.
fn warnings(case: &RollCase, rows: &[Row], uses_coefficients: bool) -> Vec<String> {
    let sliding = rows.iter().filter(|row| row.slides).count();
    let mut warnings = Vec::new();
    if sliding > 0 {
        warnings.push(format!(
            "full sliding in {sliding} of {} rows: the creepage is beyond saturation, more of it \
             brings no more force",
            rows.len()
        ));
    }
    if uses_coefficients && !case.hertz.materials().is_uncoupled() {
        let note =
            "creep coefficients and FASTSIM take two equal bodies in the place of unlike ones";
        warnings.push(note.to_owned());
    }
    warnings
}
