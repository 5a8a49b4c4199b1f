#![forbid(unsafe_code)]
//! Sets the formulas of the book: a preprocessor of mdBook, which hands it the chapters and takes them back.

use carom_verification::book::set_formulas;
use serde_json::Value;
use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    // mdBook asks first which formats are supported: all that hold HTML.
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
    set(&mut book)?;
    serde_json::to_writer(std::io::stdout(), &book)?;
    Ok(())
}

/// Sets the formulas of all chapters, wherever they stand.
fn set(value: &mut Value) -> Result<(), Box<dyn std::error::Error>> {
    match value {
        Value::Array(items) => items.iter_mut().try_for_each(set),
        Value::Object(fields) => {
            if let Some(Value::String(content)) = fields.get_mut("content") {
                *content = set_formulas(content)?;
            }
            fields.values_mut().try_for_each(set)
        }
        _ => Ok(()),
    }
}
