//! `carom roll`: a rolling contact, driven by creepages or by forces.

mod contact;
mod plot;
mod view;

use crate::columns::{self, Record, Records};
use crate::command::case_arguments::{CaseArguments, Given};
use crate::error::CliError;
use crate::global_options::Messages;
use crate::output::{Answer, Format, json};
use crate::progress::Progress;
use carom_cases::case::RollCase;
use carom_cases::input::CaseFile;
use carom_cases::roll::{self, COLUMNS, CREEP, Creep, Rolled, Row, Wanted};
use carom_cases::theory::ValidityReport;
use carom_table::row;
use serde::Serialize;

/// A rolling contact: creep forces in the steady state, or step by step from rest.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/roll_*.toml. The contact is an ellipse or any gap; it rolls along x or in another direction.
/// Creepages are motions of body 2 against body 1 per length rolled; loads act on body 1, and each
/// motion is given by one or the other. Several values give a curve. The picture shows the curve and
/// the last contact. Errors of the mesh are estimated; the table shows the greatest one.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// Also give Kalker's creep coefficients of the contact; as CSV they replace the rows.
    #[arg(long)]
    coefficients: bool,
    /// Also give the forces of FASTSIM, an elastic foundation model.
    #[arg(long)]
    fastsim: bool,
    /// Also give the forces of the table of creep forces, and how far they may be off. The table takes bodies of like
    /// materials.
    #[arg(long)]
    table: bool,
}

fn help() -> String {
    let rows = columns::help("A row for each drive, or each step from rest", COLUMNS);
    let creep = columns::help("With --coefficients as CSV, one row", CREEP);
    format!("{rows}\n{creep}")
}

/// The complete JSON output with `--coefficients`.
#[derive(Serialize)]
struct Both<'a> {
    coefficients: Record<'a, Creep>,
    rows: Records<'a, Row>,
}

pub(super) fn run(arguments: &Arguments, messages: &Messages) -> Result<Answer, CliError> {
    let Given { case: file, plot } = arguments.given.read()?;
    let case = file.parse::<RollCase>()?;
    if (arguments.fastsim || arguments.table) && case.distance.is_some() {
        return Err(CliError::Options(
            "--fastsim and --table support the steady state only: remove `distance`",
        ));
    }
    let wanted = Wanted {
        coefficients: arguments.coefficients,
        springs: arguments.fastsim,
        table: arguments.table,
    };
    let rolled = watched(&file, &case, wanted, messages)?;
    let Rolled { rows, creep, .. } = &rolled;
    let format = arguments.given.format();
    columns::check(&view::columns(rows, false), rows)?;
    let text = text(format, rows, creep.as_ref())?;
    let picture = match plot {
        Some(to) => Some(arguments.given.drawn(to, plot::draw(&case, &rolled)?)),
        None => None,
    };
    let mut report = ValidityReport::default();
    report.add(String::new, roll::validity(&case, rows));
    let (caution, mut warnings) = report.told("contacts");
    warnings.extend(roll::warnings(&case, &rolled, wanted));
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution, format))
}

/// Computes the rows, and tells how far that is.
fn watched(
    file: &CaseFile,
    case: &RollCase,
    wanted: Wanted,
    messages: &Messages,
) -> Result<Rolled, CliError> {
    let mut progress = None;
    let rolled = roll::rolled(file, case, wanted, &mut |now| match now {
        roll::Progress::Begun(count) => progress = Some(Progress::new(*messages, count, "rows")),
        roll::Progress::Row => progress.iter().for_each(|progress| progress.inc(1)),
    });
    Ok(rolled?)
}

fn text(format: Format, rows: &[Row], creep: Option<&Creep>) -> Result<String, CliError> {
    match (format, creep) {
        (Format::Json, None) => json(&Records(COLUMNS, rows)),
        (Format::Json, Some(creep)) => {
            json(&Both { coefficients: Record::new(CREEP, creep), rows: Records(COLUMNS, rows) })
        }
        (Format::Csv | Format::Chosen(_), Some(creep)) => {
            columns::rows(format, CREEP, std::slice::from_ref(creep))
        }
        (Format::Table(page), creep) => {
            let creep = creep.map(|creep| columns::upright(page, &row(CREEP, Some(creep))));
            Ok(creep.unwrap_or_default()
                + &columns::rows(format, &view::columns(rows, true), rows)?)
        }
        (format, _) => columns::rows(format, &view::columns(rows, false), rows),
    }
}
