#![forbid(unsafe_code)]
//! The command `carom`.

use carom_cli::command::{Carom, run};
use carom_cli::error::CliError;
use carom_cli::manner::{asked_colour, is_coloured};
use carom_cli::output::{Results, is_open};
use carom_cli::page::{hang, width};
use clap::error::{ContextKind, ContextValue};
use clap::{ColorChoice, CommandFactory as _, FromArgMatches as _};
use console::Term;
use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;

fn main() -> ExitCode {
    let colour = asked_colour(std::env::args_os());
    let matches = Carom::command().color(colour).try_get_matches();
    let arguments = match matches.and_then(|matches| Carom::from_arg_matches(&matches)) {
        Ok(arguments) => arguments,
        Err(message) => return print_message(&message, colour),
    };
    let mut results = Results::default();
    let messages = arguments.messages();
    match run(&arguments, &mut results).and_then(|answer| answer.write(&mut results, &messages)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error @ CliError::Messages { .. }) => ExitCode::from(error.exit_code()),
        Err(error) => {
            messages.error(&error.to_string());
            ExitCode::from(error.exit_code())
        }
    }
}

/// Prints help and version to standard output, or errors in the options to standard error.
fn print_message(message: &clap::Error, colour: ColorChoice) -> ExitCode {
    if !message.use_stderr() && is_open().is_err() {
        return ExitCode::FAILURE;
    }
    let printed = print_fitted(message, colour);
    if let Some(case) = case_without_command(message) {
        eprintln!("`{case}` is a case: `carom check {case}` tells which command computes it");
    }
    match printed {
        Err(error) if !message.use_stderr() && error.kind() != ErrorKind::BrokenPipe => {
            ExitCode::FAILURE
        }
        _ => ExitCode::from(u8::try_from(message.exit_code()).unwrap_or(2)),
    }
}

/// The case that was given where a command belongs.
fn case_without_command(message: &clap::Error) -> Option<String> {
    match message.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(word)) if word.ends_with(".toml") => Some(word.clone()),
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
