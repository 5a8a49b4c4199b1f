//! `carom scene`: the path of a ball between walls, from a case file.

mod plot;
mod view;

use crate::case::SceneCase;
use crate::command::CaseArguments;
use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, csv, json, read_case, table};
use std::path::PathBuf;

/// Path and bounces of a ball between walls, from a case file.
///
/// The file is TOML in SI units; see the cases scene_*.toml under examples/.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Draw walls, path and bounces into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Give the ball at this many instants of every flight, too; as CSV, instead of the bounces.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    points: Option<u32>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let case = read_case(&arguments.given.case, SceneCase::parse)?;
    let path = case
        .scene
        .run(&case.ball, case.limits)
        .map_err(|source| CliError::Scene { path: arguments.given.case.clone(), source })?;
    let report = view::report(&case, &path, arguments.points.map(|count| count as usize))?;
    let text = match arguments.given.format {
        Format::Json => json(&report)?,
        Format::Csv => match &report.path {
            Some(points) => csv(&view::POINT_HEADS, &view::point_rows(points, f64::to_string))?,
            None => csv(&view::HEADS, &view::rows(&report, f64::to_string))?,
        },
        Format::Table => read(&report),
    };
    let mut warnings: Vec<String> = Vec::new();
    for warning in path.bounces().iter().flat_map(|bounce| &bounce.rebound.warnings) {
        let warning = warning.to_string();
        if !warnings.contains(&warning) {
            warnings.push(warning);
        }
    }
    let plot = match &arguments.plot {
        Some(file) => Some(PlotFile { path: file.clone(), svg: plot::draw(&case, &path)? }),
        None => None,
    };
    Ok(Answer { text, warnings, plot })
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
