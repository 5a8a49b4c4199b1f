#![forbid(unsafe_code)]
//! The command `carom`.

use carom_cli::command::{Carom, run};
use carom_cli::output::{Results, tell};
use clap::Parser as _;
use std::io::ErrorKind;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = match Carom::try_parse() {
        Ok(arguments) => arguments,
        Err(message) => return said(&message),
    };
    let mut results = Results::default();
    match run(&arguments, &mut results).and_then(|answer| answer.write(&mut results)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            tell(&format!("error: {error}"));
            ExitCode::from(error.exit_code())
        }
    }
}

/// Help and version on standard output, or what is wrong with the options on standard error.
fn said(message: &clap::Error) -> ExitCode {
    match message.print() {
        Err(error) if !message.use_stderr() && error.kind() != ErrorKind::BrokenPipe => {
            ExitCode::FAILURE
        }
        _ => ExitCode::from(u8::try_from(message.exit_code()).unwrap_or(2)),
    }
}
