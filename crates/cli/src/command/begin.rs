//! `carom new`: a new case file.

use crate::command::kind;
use crate::error::CliError;
use crate::output::Answer;
use carom_cases::case::CaseKind;

/// Print a commented case of a kind, with all its fields; it runs without changes.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The kind of case.
    #[arg(value_parser = kind())]
    kind: CaseKind,
    /// Only the necessary fields, without comments.
    #[arg(long)]
    short: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let Arguments { kind, short } = arguments;
    let text = if *short { kind.begin_short() } else { kind.begin() };
    Ok(Answer { text, ..Answer::default() })
}
