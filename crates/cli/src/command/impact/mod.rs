//! `carom impact`: one impact, or a sweep over the angle of incidence, from a case file.

mod encounter;
mod model;
mod plot;
mod samples;
mod table;
mod uncertain;
mod view;

use crate::case::{CaseError, EncounterCase, ImpactCase, UncertainCase};
use crate::command::CaseArguments;
use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, check_finite, csv, json, read_case};
use carom_impact::CollisionError;
use model::Shot;
use std::path::PathBuf;
use view::{Instant, Record};

/// Impact of two bodies from a case file: spheres and planes, or any smooth bodies in any place.
///
/// The file is TOML in SI units; see the cases under examples/. z points into body 1. A
/// distribution in the place of a number, as in glass_scatter.toml, gives the scatter of the
/// outcome of spheres. The spin about the normal is left alone unless `contact.torsion = true`.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Draw the course of the impact, or the sweep, into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Give the course of the impact at this many instants too; not for a sweep. Of bodies with a
    /// place it is in contact axes, straight between the instants that were computed.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    history: Option<u32>,
}

const NOTHING_TO_DRAW: &str = "no impact: there is nothing to draw";

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    if let Some(case) = read_case(&arguments.given.case, EncounterCase::parse)? {
        return encounter::run(arguments, &case);
    }
    if let Some(case) = read_case(&arguments.given.case, UncertainCase::parse)? {
        return scatter(arguments, &case);
    }
    let case = read_case(&arguments.given.case, ImpactCase::parse)?;
    let at_fault = |source| blamed(arguments, &case, source);
    let shots = model::shots(&case).map_err(at_fault)?;
    let is_sweep = case.is_sweep();
    if is_sweep && arguments.history.is_some() {
        return Err(CliError::Options("--history takes a case with one impact, not a sweep"));
    }
    let course = |shot: &Shot, count| {
        let history = view::history(shot, count).map_err(at_fault)?;
        check_finite(&arguments.given.case, &view::HISTORY_HEADS, &full(&history))?;
        Ok(history)
    };
    let mut records = view::records(&shots).map_err(at_fault)?;
    if let (Some(count), [shot], [record]) =
        (arguments.history, shots.as_slice(), records.as_mut_slice())
    {
        record.history = Some(course(shot, count as usize)?);
    }
    let rows: Vec<_> = records.iter().map(view::cells).collect();
    check_finite(&arguments.given.case, &view::HEADS, &rows)?;
    let text = match arguments.given.format {
        Format::Json if is_sweep => json(&records)?,
        Format::Json => json(&records.first())?,
        Format::Csv => comma_separated(&records, &rows)?,
        Format::Table => table::render(&records, is_sweep),
    };
    let mut warnings = warnings(&records);
    let svg = match &arguments.plot {
        Some(_) => draw(&shots, &records, is_sweep, course)?,
        None => None,
    };
    if arguments.plot.is_some() && svg.is_none() {
        warnings.push(NOTHING_TO_DRAW.to_owned());
    }
    let plot = arguments.plot.clone().zip(svg).map(|(path, svg)| PlotFile { path, svg });
    Ok(Answer { text, warnings, plot })
}

/// The case is to blame for torsion that cannot be given.
fn blamed(arguments: &Arguments, case: &ImpactCase, source: CollisionError) -> CliError {
    let path = arguments.given.case.clone();
    match (source, case.contact.torsion) {
        (CollisionError::NormalSpin(source), Some(line)) => {
            CliError::Case { path, source: CaseError::Torsion { line, source: Box::new(source) } }
        }
        (source, _) => CliError::Collision { path, source },
    }
}

fn scatter(arguments: &Arguments, case: &UncertainCase) -> Result<Answer, CliError> {
    if arguments.history.is_some() {
        return Err(CliError::Options("--history takes a case with one impact, not [uncertainty]"));
    }
    let study = uncertain::study(case)
        .map_err(|source| CliError::Uncertain { path: arguments.given.case.clone(), source })?;
    let report = uncertain::report(case, &study)?;
    let plot = match &arguments.plot {
        Some(path) => Some(PlotFile { path: path.clone(), svg: uncertain::draw(&report)? }),
        None => None,
    };
    let text = uncertain::render_text(&report, arguments.given.format)?;
    Ok(Answer { text, warnings: uncertain::warnings(&report), plot })
}

fn comma_separated(records: &[Record], rows: &[Vec<String>]) -> Result<String, CliError> {
    match records {
        [Record { history: Some(history), .. }] => csv(&view::HISTORY_HEADS, &full(history)),
        _ => csv(&view::HEADS, rows),
    }
}

/// The rows of a history with all digits.
fn full(history: &[Instant]) -> Vec<Vec<String>> {
    history.iter().map(|instant| view::history_cells(instant, |value| value.to_string())).collect()
}

/// The picture; none if no impact happens.
fn draw(
    shots: &[Shot],
    records: &[Record],
    is_sweep: bool,
    course: impl Fn(&Shot, usize) -> Result<Vec<Instant>, CliError>,
) -> Result<Option<String>, CliError> {
    if records.iter().all(|record| record.rebound.is_none()) {
        return Ok(None);
    }
    match shots {
        [shot] if !is_sweep => plot::course(&course(shot, plot::INSTANTS)?).map(Some),
        _ => plot::sweep(records).map(Some),
    }
}

/// Every warning once, in the order it first came.
fn warnings(records: &[Record]) -> Vec<String> {
    let mut warnings: Vec<String> = Vec::new();
    for warning in records.iter().flat_map(|record| &record.warnings) {
        if !warnings.contains(warning) {
            warnings.push(warning.clone());
        }
    }
    warnings
}
