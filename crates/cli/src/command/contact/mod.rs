//! `carom contact`: an input of the program CONTACT, solved by carom.

mod view;

use crate::columns::{self, Records};
use crate::error::CliError;
use crate::format::Printing;
use crate::global_options::Messages;
use crate::output::{Answer, Format, json};
use crate::outputs::Outputs;
use crate::progress::Progress;
use carom_cases::contact::{BELOW, Below, COLUMNS, Row, Solved, cases, solved};
use carom_cases::input::Expected;
use serde::Serialize;
use std::path::PathBuf;

/// An input of the program CONTACT (module 3), solved by carom's own solver.
///
/// The cases are solved in the order of the file. The results have CONTACT's names, signs and units, each with the
/// error of the mesh that carom estimates. What carom does not do is refused by line, name and value before anything
/// is solved. Digits for CONTACT's solvers, its output and initial estimates have no effect. The page "CONTACT
/// says, carom says" of the book has all control digits.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    /// The input; - is standard input.
    #[arg(value_name = "FILE.inp")]
    pub(super) file: PathBuf,
    #[command(flatten)]
    printing: Printing,
    /// Give the extreme stresses below the surface (S digit) instead of forces and creepages; JSON has both.
    #[arg(long)]
    below: bool,
    /// Do not solve, but print the case of this number as a case of `carom roll` or `carom solve`, in SI units.
    #[arg(long, value_name = "CASE", conflicts_with_all = ["below", "format"])]
    to_toml: Option<usize>,
}

fn help() -> String {
    let rows = columns::help("A row for each case", COLUMNS);
    let below = columns::help("With --below, a row for each extreme", BELOW);
    format!("{rows}\n{below}")
}

/// The complete JSON output.
#[derive(Serialize)]
struct Report<'a> {
    cases: Records<'a, Row>,
    below: Records<'a, Below>,
}

pub(super) fn run(arguments: &Arguments, messages: &Messages) -> Result<Answer, CliError> {
    arguments.printing.check()?;
    let format = arguments.printing.format();
    let outputs = Outputs::of_command(format)?;
    outputs.check_input(&arguments.file)?;
    let file = outputs.read_expected(&arguments.file, Expected::CONTACT)?;
    let given = cases(file.text()).map_err(carom_cases::Error::from)?;
    if let Some(number) = arguments.to_toml {
        let text = carom_cases::contact::toml(&given, number)?;
        return Ok(Answer { text, ..Answer::default() });
    }
    let progress = Progress::new(*messages, given.len(), "cases");
    let all = file.follow(|| solved(&file, &given, &mut || progress.inc(1)))?;
    drop(progress);
    let rows: Vec<Row> = all.iter().map(|solved| solved.row.clone()).collect();
    let below: Vec<Below> = all.iter().flat_map(|solved| solved.below.clone()).collect();
    columns::check(COLUMNS, &rows)?;
    columns::check(BELOW, &below)?;
    let text = match (format, arguments.below) {
        (Format::Json, _) => {
            json(&Report { cases: Records(COLUMNS, &rows), below: Records(BELOW, &below) })?
        }
        (format, true) => columns::rows(format, BELOW, &below)?,
        (Format::Table(page), false) => view::table(page, &rows),
        (format, false) => columns::rows(format, COLUMNS, &rows)?,
    };
    Ok(Answer { text, warnings: warnings(&all), ..Answer::default() })
}

/// Notes on the cases, each once with the cases that it concerns.
fn warnings(all: &[Solved]) -> Vec<String> {
    let mut told: Vec<(&str, Vec<usize>)> = Vec::new();
    for solved in all {
        for note in &solved.notes {
            match told.iter_mut().find(|(known, _)| known == note) {
                Some((_, cases)) => cases.push(solved.row.case),
                None => told.push((note, vec![solved.row.case])),
            }
        }
    }
    let line = |(note, cases): (&str, Vec<usize>)| match cases.as_slice() {
        [one] => format!("case {one}: {note}"),
        [first, ..] => format!("case {first} and {} more: {note}", cases.len() - 1),
        [] => note.to_owned(),
    };
    told.into_iter().map(line).collect()
}
