//! The commands, one module each. A command returns an [`Answer`] and writes nothing itself, except
//! for tables too large to hold in memory.

mod between;
mod case_arguments;
mod check;
mod completions;
mod contact;
mod fit;
mod hertz;
mod history;
mod impact;
mod man;
mod new;
mod npz;
mod plot;
mod restitution;
mod roll;
mod scene;
mod schema;
mod shell;
mod solve;
mod stress;
mod surface;
mod thinned;

use crate::error::CliError;
use crate::global_options::{GlobalOptions, Messages};
use crate::output::{Answer, Results};
use crate::progress::Progress;
use carom_cases::case::CaseKind;
use case_arguments::CaseArguments;
use std::path::Path;

/// Elastic impact with friction: how two bodies make contact, slip, stick, twist and rebound.
///
/// A case file describes what to compute: bodies, materials, friction, motions. Results go to
/// standard output, which must be open unless --format none is given; everything else goes to
/// standard error. No input is ever overwritten: such a run is rejected. Pictures are written when
/// the computation has succeeded. Exit code 2 means bad input, 1 a file that cannot be read or
/// written, 3 a warning with --strict.
#[derive(Debug, clap::Parser)]
#[command(name = "carom", version, after_long_help = FIRST_STEPS)]
pub struct Carom {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    options: GlobalOptions,
}

const FIRST_STEPS: &str = "\
First steps:
  carom new impact > ball.toml                 a commented case: a steel ball meets a plate
  carom impact ball.toml                       the motions afterwards, and the energy dissipated
  carom impact ball.toml --plot ball.svg       velocities and forces during the impact
  carom impact ball.toml --format csv          the results as CSV for other programs (or json)
  carom schema impact                          all fields of an impact case
  carom check ball.toml                        the fields of a case as read

R_x of a ball without a case file; kappa = 1.21 for Poisson's ratio 0.3:
  carom restitution --kappa 1.2143 --lambda 0.1:8:80 --plot rebound.svg
";

impl Carom {
    /// Whether a warning is to be an exit code.
    #[must_use]
    pub const fn is_strict(&self) -> bool {
        self.options.is_strict()
    }

    /// The message writer for the given options.
    #[must_use]
    pub fn messages(&self) -> Messages {
        self.options.messages()
    }
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    Impact(impact::Arguments),
    Restitution(restitution::Arguments),
    Hertz(hertz::Arguments),
    History(history::Arguments),
    Scene(scene::Arguments),
    Solve(solve::Arguments),
    Roll(roll::Arguments),
    Stress(stress::Arguments),
    Surface(surface::Arguments),
    Shell(shell::Arguments),
    Contact(contact::Arguments),
    Fit(fit::Arguments),
    Compare(solve::compare::Arguments),
    New(new::Arguments),
    Check(check::Arguments),
    Schema(schema::Arguments),
    Completions(completions::Arguments),
    Man(man::Arguments),
}

impl Command {
    /// What a command does that has no progress of its own.
    const fn working(&self) -> Option<&'static str> {
        match self {
            Self::Impact(_) => Some("computing impacts"),
            Self::Hertz(_) => Some("computing contacts"),
            Self::History(_) => Some("following the history"),
            Self::Scene(_) => Some("following the ball"),
            Self::Stress(_) => Some("computing stresses"),
            Self::Surface(_) => Some("reading the map"),
            Self::Shell(_) => Some("computing the shell"),
            Self::Fit(_) => Some("fitting"),
            _ => None,
        }
    }

    /// The kind of case that the command takes, and its arguments.
    const fn given(&self) -> Option<(CaseKind, &CaseArguments)> {
        Some(match self {
            Self::Impact(arguments) => (CaseKind::Impact, &arguments.given),
            Self::Hertz(arguments) => (CaseKind::Hertz, &arguments.given),
            Self::History(arguments) => (CaseKind::History, &arguments.given),
            Self::Scene(arguments) => (CaseKind::Scene, &arguments.given),
            Self::Solve(arguments) => (CaseKind::Solve, &arguments.given),
            Self::Roll(arguments) => (CaseKind::Roll, &arguments.given),
            Self::Stress(arguments) => (CaseKind::Stress, &arguments.given),
            Self::Shell(arguments) => (CaseKind::Shell, &arguments.given),
            _ => return None,
        })
    }

    /// The case file of the command, if it has one.
    fn file(&self) -> Option<&Path> {
        match self {
            Self::Compare(arguments) => Some(&arguments.case),
            Self::Check(arguments) => Some(&arguments.case),
            Self::Surface(arguments) => Some(&arguments.file),
            Self::Contact(arguments) => Some(&arguments.file),
            Self::Fit(arguments) => Some(&arguments.given.case),
            _ => self.given().map(|(_, given)| given.case.as_path()),
        }
    }
}

/// Runs the command given by the arguments.
///
/// # Errors
/// If its input is bad, or a file cannot be read.
pub fn run(arguments: &Carom, results: &mut Results) -> Result<Answer, CliError> {
    let messages = &arguments.messages();
    let Some(threads) = arguments.options.threads() else {
        return go(&arguments.command, messages, results);
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let failed = |error| CliError::Threads { count: threads, source: Box::new(error) };
    pool.map_err(failed)?.install(|| go(&arguments.command, messages, results))
}

/// Runs the command. Errors name its case, and warnings of unusual numbers in it come first.
fn go(command: &Command, messages: &Messages, results: &mut Results) -> Result<Answer, CliError> {
    let answer = run_one(command, messages, results);
    let of_file = |error: CliError| match command.file() {
        Some(path) => error.of_file(path),
        None => error,
    };
    let mut answer = answer.map_err(of_file)?;
    if let Some((kind, given)) = command.given() {
        let unusual = given.text.get().map(|text| kind.unusual(text));
        answer.warnings.splice(..0, unusual.unwrap_or_default());
    }
    Ok(answer)
}

fn run_one(
    command: &Command,
    messages: &Messages,
    results: &mut Results,
) -> Result<Answer, CliError> {
    // The others tell their own progress, or are done at once.
    let _progress = command.working().map(|what| Progress::new(*messages, 0, what));
    match command {
        Command::Impact(arguments) => impact::run(arguments, results),
        Command::Restitution(arguments) => restitution::run(arguments, messages, results),
        Command::Hertz(arguments) => hertz::run(arguments),
        Command::History(arguments) => history::run(arguments, results),
        Command::Scene(arguments) => scene::run(arguments, results),
        Command::Solve(arguments) => solve::run(arguments, messages),
        Command::Roll(arguments) => roll::run(arguments, messages),
        Command::Stress(arguments) => stress::run(arguments),
        Command::Surface(arguments) => surface::run(arguments),
        Command::Shell(arguments) => shell::run(arguments),
        Command::Contact(arguments) => contact::run(arguments, messages),
        Command::Fit(arguments) => fit::run(arguments),
        Command::Compare(arguments) => solve::compare::run(arguments, messages),
        Command::New(arguments) => new::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Completions(arguments) => Ok(completions::run(arguments)),
        Command::Man(arguments) => man::run(arguments),
    }
}
