//! `carom scene`: the path of a ball between walls, from a case file.

mod plot;
mod view;

use crate::case::SceneCase;
use crate::columns;
use crate::command::theory::{Excess, caution, warnings};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::output::{Answer, Format, json, short};
use carom_impact::scene::PathPoint;

/// Path and bounces of a ball between walls, from a case file.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see the cases scene_*.toml under
/// examples/. The picture shows walls, path and bounces.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each bounce", &view::cells(None)) + "\n"
    + &columns::help("With --points a row for each instant", PathPoint::COLUMNS))]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Give the ball at this many instants of every flight, too; as CSV, instead of the bounces.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    points: Option<u32>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let command::Given { case: file, plot } = arguments.given.read()?;
    let case = file.parse(SceneCase::parse)?;
    let path = case
        .scene
        .run(&case.ball, case.limits)
        .map_err(|source| CliError::Scene { path: file.path.clone(), source })?;
    let report = view::Report::new(&case, &path, arguments.points.map(|count| count as usize))?;
    let text = match arguments.given.format {
        Format::Json => json(&report)?,
        Format::Csv => match &report.points {
            Some(points) => columns::rows(Format::Csv, PathPoint::COLUMNS, points)?,
            None => columns::cell_rows(Format::Csv, &report.rows())?,
        },
        Format::Table => read(&report)?,
        Format::None => String::new(),
    };
    let picture = match plot {
        Some(to) => Some((to, plot::draw(&case, &path)?)),
        None => None,
    };
    let bounces = || path.bounces().iter().enumerate();
    let concerned = bounces()
        .map(|(i, bounce)| (format!("at bounce {}", i + 1), bounce.rebound.warnings.as_slice()));
    let answer =
        Answer { text, warnings: warnings(concerned, "bounces"), picture, ..Answer::default() };
    let excesses: Vec<Excess> =
        bounces().map(|(_, bounce)| Excess::of_impact(&bounce.rebound)).collect();
    Ok(answer.cautioned(caution(&excesses, "bounces"), arguments.given.format))
}

fn read(report: &view::Report<'_>) -> Result<String, CliError> {
    let mut text = columns::selected(&report.rows(), &view::READABLE);
    let end = report.end();
    let place = <[f64; 3]>::from(end.position).map(short).join("  ");
    let (ending, time) = (report.ending(), short(end.time));
    text.push_str(&format!("end: {ending} after {time} s at {place} m\n"));
    if let Some(points) = &report.points {
        text.push_str(&columns::rows(Format::Table, PathPoint::COLUMNS, points)?);
    }
    Ok(text)
}
