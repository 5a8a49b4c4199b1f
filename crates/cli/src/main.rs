#![forbid(unsafe_code)]
//! The command `carom`.

use carom_cli::command::{Carom, run};
use clap::Parser as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Carom::parse();
    match run(&arguments).and_then(|answer| answer.write()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(error.exit_code())
        }
    }
}
