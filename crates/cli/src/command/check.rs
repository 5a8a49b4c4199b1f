//! `carom check`: validates a case without computing it.

use crate::columns::{self, Records};
use crate::command::case_arguments::kind;
use crate::error::CliError;
use crate::format::Printing;
use crate::output::{Answer, Format, json};
use crate::outputs::Outputs;
use carom_cases::case::{CaseKind, HistoryCase, SolveCase, Understood};
use carom_cases::history;
use carom_cases::input::CaseFile;
use carom_cases::solve::Bodies;
use serde::Serialize;
use std::path::PathBuf;

/// Check a case file and list the fields as read, without computing anything.
///
/// Files that the case names are read too. Omitted fields are listed with their defaults.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each field", Understood::COLUMNS))]
pub(super) struct Arguments {
    /// The case file; - is standard input.
    #[arg(value_name = "CASE.toml")]
    pub(super) case: PathBuf,
    /// The kind of case; by default that given by the tables of the file.
    #[arg(long, value_parser = kind())]
    kind: Option<CaseKind>,
    #[command(flatten)]
    printing: Printing,
}

/// The kind and the fields.
#[derive(Serialize)]
struct Checked<'a> {
    kind: &'static str,
    fields: Records<'a, Understood>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    arguments.printing.check()?;
    let format = arguments.printing.format();
    let outputs = Outputs::of_command(format)?;
    let file = outputs.read_case(&arguments.case)?;
    let kind = match arguments.kind {
        Some(kind) => kind,
        None => file.told(CaseKind::of)?,
    };
    file.told(|source| kind.check(source))?;
    check_files(&file, kind)?;
    let fields = file.told(|source| kind.understood(source))?;
    let text = match format {
        Format::Json => {
            json(&Checked { kind: kind.name, fields: Records(Understood::COLUMNS, &fields) })?
        }
        Format::Table(page) => {
            format!("a case for `carom {}`\n", kind.name)
                + &columns::texts(page, Understood::COLUMNS, &fields)
        }
        format => columns::rows(format, Understood::COLUMNS, &fields)?,
    };
    Ok(Answer { text, warnings: kind.unusual(file.text()), ..Answer::default() })
}

/// Checks that the files named by the case can be read.
fn check_files(file: &CaseFile, kind: CaseKind) -> Result<(), CliError> {
    match kind {
        CaseKind::History => {
            history::shifts(file, &file.parse::<HistoryCase>()?)?;
        }
        CaseKind::Solve => {
            Bodies::of(file, &file.parse::<SolveCase>()?)?;
        }
        CaseKind::Impact
        | CaseKind::Hertz
        | CaseKind::Scene
        | CaseKind::Roll
        | CaseKind::Stress
        | CaseKind::Shell => {}
    }
    Ok(())
}
