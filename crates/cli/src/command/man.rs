//! `carom man`: manual pages.

use super::Carom;
use crate::error::CliError;
use crate::output::Answer;
use clap::CommandFactory as _;
use clap_mangen::Man;
use std::path::Path;

/// Print a manual page in the format of man.
///
/// To read a page: carom man impact | man -l -. To install: carom man >
/// ~/.local/share/man/man1/carom.1, and carom man impact > ~/.local/share/man/man1/carom-impact.1.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The command of the page; by default carom itself.
    #[arg(value_parser = commands())]
    command: Option<String>,
}

/// The names of all commands except `man`, which is being defined.
const NAMES: &[&str] = &[
    "impact",
    "restitution",
    "hertz",
    "history",
    "scene",
    "solve",
    "roll",
    "stress",
    "surface",
    "shell",
    "contact",
    "fit",
    "compare",
    "new",
    "check",
    "schema",
    "completions",
    "man",
];

fn commands() -> clap::builder::PossibleValuesParser {
    NAMES.into()
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let mut root = Carom::command().disable_help_subcommand(true);
    root.build();
    let name = arguments.command.as_deref();
    let command = name.and_then(|name| root.find_subcommand(name)).unwrap_or(&root);
    let mut page = Vec::new();
    let man = Man::new(command.clone()).source(format!("carom {}", env!("CARGO_PKG_VERSION")));
    man.render(&mut page)
        .map_err(|error| CliError::io("write", Path::new("standard output"), error))?;
    Ok(Answer { text: String::from_utf8_lossy(&page).into_owned(), ..Answer::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_has_a_page() {
        let root = Carom::command();
        let names: Vec<&str> = root.get_subcommands().map(clap::Command::get_name).collect();
        assert_eq!(names, NAMES);
    }
}
