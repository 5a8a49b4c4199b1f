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
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    Ok(Answer { text: arguments.kind.begin(), ..Answer::default() })
}
