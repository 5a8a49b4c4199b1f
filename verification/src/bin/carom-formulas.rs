#![forbid(unsafe_code)]
//! Preprocessor of mdBook that converts the formulas of the book to MathML.

use carom_verification::book::set_in_chapters;
use serde_json::Value;
use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    // mdBook first asks whether a format is supported: all formats that contain HTML are.
    if std::env::args().nth(1).as_deref() == Some("supports") {
        return ExitCode::SUCCESS;
    }
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn std::error::Error>> {
    let mut given: Vec<Value> = serde_json::from_reader(std::io::stdin())?;
    let mut book = given.pop().ok_or("no book on standard input")?;
    set_in_chapters(&mut book)?;
    serde_json::to_writer(std::io::stdout(), &book)?;
    Ok(())
}
