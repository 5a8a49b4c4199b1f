//! `carom check`: what a case says, without computing it.

use crate::columns::{self, Record};
use crate::command::kind;
use crate::error::CliError;
use crate::output::{Answer, Format, json};
use crate::outputs::Outputs;
use carom_cases::case::{CaseKind, HistoryCase, SolveCase, Steps, Understood};
use carom_cases::history::read_steps;
use carom_cases::input::CaseFile;
use carom_cases::solve::Bodies;
use serde::Serialize;
use std::path::PathBuf;

/// Reads a case and says what it understood, or what is wrong with it; computes nothing.
///
/// Files that the case names are read too. Fields that it leaves out stand with what holds then.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each field", Understood::COLUMNS))]
pub(super) struct Arguments {
    /// The case file; - is standard input.
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// The kind of case; that whose tables the file has if this is left out.
    #[arg(long, value_parser = kind())]
    kind: Option<CaseKind>,
    /// Format of the table.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// The kind and the fields.
#[derive(Serialize)]
struct Checked<'a> {
    kind: &'static str,
    fields: Vec<Record<'a, Understood>>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let outputs = Outputs::of_command(arguments.format)?;
    let file = outputs.read_case(&arguments.case)?;
    let kind = match arguments.kind {
        Some(kind) => kind,
        None => file.parse(CaseKind::of)?,
    };
    file.parse(|source| kind.check(source))?;
    check_files(&file, kind)?;
    let fields = file.parse(|source| kind.understood(source))?;
    let rows = |format| columns::rows(format, Understood::COLUMNS, &fields);
    let text = match arguments.format {
        Format::Json => {
            let records = fields.iter().map(|field| Record::new(Understood::COLUMNS, field));
            json(&Checked { kind: kind.name(), fields: records.collect() })?
        }
        Format::Table => format!("a case for `carom {}`\n", kind.name()) + &rows(Format::Table)?,
        format => rows(format)?,
    };
    Ok(Answer { text, ..Answer::default() })
}

/// Whether the files that the case names can be read.
fn check_files(file: &CaseFile, kind: CaseKind) -> Result<(), CliError> {
    match kind {
        CaseKind::History => match file.parse(HistoryCase::parse)?.steps {
            Steps::File(name) => read_steps(file, &name).map(|_| ())?,
            Steps::Inline(_) => {}
        },
        CaseKind::Solve => {
            Bodies::of(file, &file.parse(SolveCase::parse)?)?;
        }
        CaseKind::Impact
        | CaseKind::Hertz
        | CaseKind::Scene
        | CaseKind::Roll
        | CaseKind::Stress => {}
    }
    Ok(())
}
