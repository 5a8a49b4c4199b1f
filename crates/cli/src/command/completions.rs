//! `carom completions`: scripts for completion in a shell.

use super::Carom;
use crate::output::Answer;
use clap::CommandFactory as _;
use clap_complete::{Shell, generate};

/// Print a completion script for a shell: commands, options, values and files.
///
/// For bash: carom completions bash > ~/.local/share/bash-completion/completions/carom. For zsh: a
/// file _carom in a folder of $fpath. For fish: ~/.config/fish/completions/carom.fish. For
/// PowerShell: a line in $PROFILE that runs the script.
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
