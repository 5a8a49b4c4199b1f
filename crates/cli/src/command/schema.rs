//! `carom schema`: the fields of a kind of case.

use crate::columns::{self, Records};
use crate::command::case_arguments::kind;
use crate::error::CliError;
use crate::format::Printing;
use crate::output::{Answer, Format, json};
use carom_cases::case::{CaseKind, Entry};

/// List all fields of a kind of case: kind, range, unit, default, meaning.
///
/// Fields under `*` may replace any number. JSON and CSV also give the ends of the ranges and the
/// allowed words. With --json-schema it is written in the language of editors, JSON Schema draft 4:
/// carom schema impact --json-schema > impact.schema.json
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each field", Entry::COLUMNS))]
pub(super) struct Arguments {
    /// The kind of case.
    #[arg(value_parser = kind())]
    kind: CaseKind,
    /// Print a JSON Schema (draft 4), with which editors complete and check case files.
    #[arg(long, conflicts_with_all = ["format", "all"])]
    json_schema: bool,
    #[command(flatten)]
    printing: Printing,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    if arguments.json_schema {
        return Ok(Answer { text: arguments.kind.json_schema(), ..Answer::default() });
    }
    let entries = arguments.kind.entries();
    arguments.printing.check()?;
    let text = match arguments.printing.format() {
        Format::Json => json(&Records(Entry::COLUMNS, &entries))?,
        Format::Table(page) => columns::texts(page, Entry::readable(), &entries),
        format => columns::rows(format, Entry::COLUMNS, &entries)?,
    };
    Ok(Answer { text, ..Answer::default() })
}
