//! The commands, one a file. Each works out an [`Answer`] and writes nothing itself.

mod hertz;
mod history;
mod impact;
mod plot;
mod restitution;
mod scene;

pub use history::StepsError;

use crate::error::CliError;
use crate::output::{Answer, Format};
use std::path::PathBuf;

/// Elastic impact with friction.
///
/// Results go to standard output, everything else to standard error. Exit code 2 means bad
/// input, 1 a file that cannot be read or written.
#[derive(Debug, clap::Parser)]
#[command(name = "carom", version)]
pub struct Carom {
    #[command(subcommand)]
    command: Command,
}

/// What every command with a case file takes.
#[derive(Debug, clap::Args)]
struct CaseArguments {
    /// The case file.
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// Format of the results.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    Impact(impact::Arguments),
    Restitution(restitution::Arguments),
    Hertz(hertz::Arguments),
    History(history::Arguments),
    Scene(scene::Arguments),
}

/// Works out what the command asks for.
///
/// # Errors
/// If its input is bad, or a file cannot be read.
pub fn run(arguments: &Carom) -> Result<Answer, CliError> {
    match &arguments.command {
        Command::Impact(arguments) => impact::run(arguments),
        Command::Restitution(arguments) => restitution::run(arguments),
        Command::Hertz(arguments) => hertz::run(arguments),
        Command::History(arguments) => history::run(arguments),
        Command::Scene(arguments) => scene::run(arguments),
    }
}
