//! `carom completions`: what a shell needs to complete the command.

use super::Carom;
use crate::output::Answer;
use clap::CommandFactory as _;
use clap_complete::{Shell, generate};

/// A script by which a shell completes commands, options, their values and files.
///
/// For bash: carom completions bash > ~/.local/share/bash-completion/completions/carom. For zsh, a file
/// _carom in a folder of $fpath; for fish, ~/.config/fish/completions/carom.fish; for PowerShell, a line
/// in $PROFILE that runs it.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The shell.
    #[arg(value_enum)]
    shell: Shell,
}

pub(super) fn run(arguments: &Arguments) -> Answer {
    let mut script = Vec::new();
    generate(arguments.shell, &mut Carom::command(), "carom", &mut script);
    Answer { text: String::from_utf8_lossy(&script).into_owned(), ..Answer::default() }
}
