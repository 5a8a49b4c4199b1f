//! `carom new`: a new case file.

use crate::command::case_arguments::kind;
use crate::error::CliError;
use crate::output::{Answer, Format};
use crate::outputs::Outputs;
use crate::page::{fold, width};
use carom_cases::case::CaseKind;
use std::path::{Path, PathBuf};

/// Print a commented case of a kind, with all its fields; it runs without changes.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The kind of case.
    #[arg(value_parser = kind())]
    kind: CaseKind,
    /// Only the necessary fields, without comments.
    #[arg(long)]
    short: bool,
    /// Write the JSON Schema of the kind into this file as well [default: KIND.schema.json], and name
    /// it in the first line of the case, which belongs beside it; editors then complete and check the
    /// case.
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    schema: Option<Option<PathBuf>>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let Arguments { kind, short, schema } = arguments;
    let text = if *short { kind.short_template() } else { kind.template() };
    let text =
        width(&console::Term::stdout()).map_or_else(|| text.clone(), |width| fitted(&text, width));
    let Some(given) = schema else { return Ok(Answer { text, ..Answer::default() }) };
    let path = given.clone().unwrap_or_else(|| format!("{}.schema.json", kind.name).into());
    let place = Outputs::of_command(Format::Csv)?.file("schema", &path)?;
    let text = directive(&path) + &text;
    Ok(Answer { text, files: vec![(place, kind.json_schema().into_bytes())], ..Answer::default() })
}

/// The case with comments that fit the lines of a terminal.
fn fitted(text: &str, width: usize) -> String {
    let line = |line: &str| match line.strip_prefix("# ") {
        Some(words) => {
            fold(words, Some(width - 2)).lines().map(|line| format!("# {line}\n")).collect()
        }
        None => format!("{line}\n"),
    };
    text.lines().map(line).collect()
}

/// The line by which editors find the schema, in the folder of the case.
fn directive(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    format!("#:schema ./{}\n", name.to_string_lossy())
}
