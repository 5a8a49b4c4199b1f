//! `carom scene`: the path of a ball between walls, from a case file.

mod plot;
mod view;

use crate::case::SceneCase;
use crate::command::theory::{Excess, caution, warnings};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::output::{Answer, Format, csv, json, table};

/// Path and bounces of a ball between walls, from a case file.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see the cases scene_*.toml under
/// examples/. The picture shows walls, path and bounces.
#[derive(Debug, clap::Args)]
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
    let report = view::report(&case, &path, arguments.points.map(|count| count as usize))?;
    let text = match arguments.given.format {
        Format::Json => json(&report)?,
        Format::Csv => match &report.path {
            Some(points) => csv(&view::POINT_HEADS, &view::point_rows(points, f64::to_string))?,
            None => csv(&view::HEADS, &view::rows(&report, f64::to_string))?,
        },
        Format::Table => read(&report),
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

fn read(report: &view::Report) -> String {
    let number = |value: &f64| crate::output::short(*value);
    let mut text = table(&view::HEADS, &view::rows(report, number));
    let end = &report.end;
    let place = end.position.map(crate::output::short).join("  ");
    text.push_str(&format!(
        "end: {} after {} s at {place} m\n",
        report.ending,
        crate::output::short(end.time)
    ));
    if let Some(points) = &report.path {
        text.push_str(&table(&view::POINT_HEADS, &view::point_rows(points, number)));
    }
    text
}
