//! `carom new`: a case to begin with.

use crate::command::kind;
use crate::error::CliError;
use crate::output::Answer;
use carom_cases::case::CaseKind;

/// A commented case of a kind, with every field that it may have: it runs as it stands.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The kind of case.
    #[arg(value_parser = kind())]
    kind: CaseKind,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    Ok(Answer { text: arguments.kind.begin(), ..Answer::default() })
}
