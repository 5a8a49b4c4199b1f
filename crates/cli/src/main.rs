#![forbid(unsafe_code)]
//! The command `carom`.

use carom_cli::command::{Carom, run};
use carom_cli::error::CliError;
use carom_cli::global_options::{STRICT, asked_colour, is_coloured};
use carom_cli::output::{Results, is_open};
use carom_cli::page::{hang, width};
use clap::error::{ContextKind, ContextValue};
use clap::{ColorChoice, CommandFactory as _, FromArgMatches as _};
use console::Term;
use std::error::Error as _;
use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;
#[cfg(unix)]
use std::sync::Arc;

/// How results get into a file.
const TO_A_FILE: &str = "results go to standard output: write `--format csv > results.csv`";

/// A file that would exceed the size that the system allows becomes an error of the write, which removes its part.
#[cfg(unix)]
fn report_files_that_are_too_large() {
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

fn main() -> ExitCode {
    #[cfg(unix)]
    report_files_that_are_too_large();
    let colour = asked_colour(std::env::args_os());
    let matches = Carom::command().color(colour).try_get_matches();
    let arguments = match matches.and_then(|matches| Carom::from_arg_matches(&matches)) {
        Ok(arguments) => arguments,
        Err(mut message) => return print_message(&mut message, colour),
    };
    let mut results = Results::default();
    let messages = arguments.messages();
    let answered = run(&arguments, &mut results)
        .and_then(|answer| answer.write(&mut results, &messages).map(|()| answer.has_warnings()));
    match answered {
        Ok(true) if arguments.is_strict() => ExitCode::from(STRICT),
        Ok(_) => ExitCode::SUCCESS,
        Err(error @ CliError::Messages { .. }) => ExitCode::from(error.exit_code()),
        Err(error) => {
            messages.error(&error.to_string());
            ExitCode::from(error.exit_code())
        }
    }
}

/// Prints help and version to standard output, or errors in the options to standard error.
fn print_message(message: &mut clap::Error, colour: ColorChoice) -> ExitCode {
    if !message.use_stderr() && is_open().is_err() {
        return ExitCode::FAILURE;
    }
    let hint = way_out(message);
    if message.get(ContextKind::InvalidArg).is_some() {
        // An option that does not exist is no value either.
        message.remove(ContextKind::Suggested);
    }
    let printed = print_fitted(message, colour);
    if let Some(hint) = hint {
        eprintln!("{hint}");
    }
    match printed {
        Err(error) if !message.use_stderr() && error.kind() != ErrorKind::BrokenPipe => {
            ExitCode::FAILURE
        }
        _ => ExitCode::from(u8::try_from(message.exit_code()).unwrap_or(2)),
    }
}

/// What to write instead of an argument that does not exist, if that is known.
fn way_out(message: &clap::Error) -> Option<String> {
    if let Some(case) = word(message, ContextKind::InvalidSubcommand) {
        let told =
            || format!("`{case}` is a case: `carom check {case}` tells which command computes it");
        return case.ends_with(".toml").then(told);
    }
    let wrong = word(message, ContextKind::InvalidArg)?;
    if message.source().is_some_and(|source| source.is::<std::num::ParseIntError>()) {
        return Some(format!("{wrong} takes a whole number"));
    }
    let is_file = [".csv", ".json", ".txt"].iter().any(|ending| wrong.ends_with(ending));
    match wrong {
        "--csv" | "--json" => Some(format!("write --format {}", wrong.trim_start_matches('-'))),
        "-o" | "--out" | "--output" => Some(TO_A_FILE.to_owned()),
        _ if is_file => Some(TO_A_FILE.to_owned()),
        _ if wrong.parse::<f64>().is_ok() => Some(
            "several numbers of one option are a list with commas and no blanks: 1,1.2".to_owned(),
        ),
        _ => None,
    }
}

/// The word in a message of the parser.
fn word(message: &clap::Error, kind: ContextKind) -> Option<&str> {
    match message.get(kind) {
        Some(ContextValue::String(word)) => Some(word),
        _ => None,
    }
}

/// Prints it in lines as long as those of the terminal.
fn print_fitted(message: &clap::Error, colour: ColorChoice) -> std::io::Result<()> {
    let mut terminal = if message.use_stderr() { Term::stderr() } else { Term::stdout() };
    let Some(width) = width(&terminal) else { return message.print() };
    let text = match is_coloured(colour, true) {
        true => message.render().ansi().to_string(),
        false => message.render().to_string(),
    };
    terminal.write_all(hang(&text, width).as_bytes())
}
