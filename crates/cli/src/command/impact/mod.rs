//! `carom impact`: one impact, or a sweep over the angle of incidence, from a case file.

mod encounter;
mod model;
mod plot;
mod samples;
mod table;
mod uncertain;
mod view;

use crate::case::{CaseError, EncounterCase, ImpactCase, UncertainCase};
use crate::command::theory::{self, caution};
use crate::command::{self, CaseArguments};
use crate::destination::Destination;
use crate::error::CliError;
use crate::output::{Answer, Format, Picture, check_finite, csv, json};
use carom_impact::CollisionError;
use model::Shot;
use view::{Instant, Record};

/// Impact of two bodies from a case file: spheres and planes, or any smooth bodies in any place.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see the cases under examples/. z
/// points into body 1. A distribution in the place of a number, as in glass_scatter.toml, gives the
/// scatter of the outcome of spheres. The spin about the normal is left alone unless
/// `contact.torsion = true`. The picture shows the course of the impact, the sweep, or the scatter.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Give the course of the impact at this many instants too; not for a sweep. Of bodies with a
    /// place it is in contact axes, straight between the instants that were computed.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    history: Option<u32>,
}

const NOTHING_TO_DRAW: &str = "no impact: there is nothing to draw";

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let given = arguments.given.read()?;
    if let Some(case) = given.case.parse(EncounterCase::parse)? {
        return encounter::run(arguments, given.plot, &case);
    }
    if let Some(case) = given.case.parse(UncertainCase::parse)? {
        return scatter(arguments, given.plot, &case);
    }
    let command::Given { case: file, plot } = given;
    let case = file.parse(ImpactCase::parse)?;
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
        Format::None => String::new(),
    };
    let mut warnings = warnings(&records);
    let mut picture = None;
    if let Some(to) = plot {
        match draw(&case, &shots, &records, (course, at_fault))? {
            Some(drawn) => picture = Some((to, drawn)),
            None => warnings.push(NOTHING_TO_DRAW.to_owned()),
        }
    }
    let excesses: Vec<_> = records.iter().map(|record| record.excess).collect();
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution(&excesses, "angles"), arguments.given.format))
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

fn scatter(
    arguments: &Arguments,
    plot: Option<Destination>,
    case: &UncertainCase,
) -> Result<Answer, CliError> {
    if arguments.history.is_some() {
        return Err(CliError::Options("--history takes a case with one impact, not [uncertainty]"));
    }
    let study = uncertain::study(case)
        .map_err(|source| CliError::Uncertain { path: arguments.given.case.clone(), source })?;
    let excess = uncertain::excess(case);
    let report = uncertain::report(case, &study, excess)?;
    let picture = plot.map(|to| (to, uncertain::draw(&report)));
    let text = uncertain::render_text(&report, arguments.given.format)?;
    let answer =
        Answer { text, warnings: uncertain::warnings(&report), picture, ..Answer::default() };
    Ok(answer.cautioned(caution(&[excess], "means"), arguments.given.format))
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
    case: &ImpactCase,
    shots: &[Shot],
    records: &[Record],
    (course, at_fault): (
        impl Fn(&Shot, usize) -> Result<Vec<Instant>, CliError>,
        impl Fn(CollisionError) -> CliError,
    ),
) -> Result<Option<Picture>, CliError> {
    if records.iter().all(|record| record.rebound.is_none()) {
        return Ok(None);
    }
    if let ([shot], false) = (shots, case.is_sweep()) {
        return Ok(Some(plot::course(&course(shot, plot::INSTANTS)?)));
    }
    let between = plot::between(case, records).map_err(at_fault)?;
    Ok(Some(plot::sweep(&between, records)))
}

/// What limits the validity of the outcomes.
fn warnings(records: &[Record]) -> Vec<String> {
    let concerned = records.iter().map(|record| {
        let place = record.angle.map_or_else(String::new, |angle| format!("at {angle}°"));
        (place, record.limits.as_slice())
    });
    theory::warnings(concerned, "angles")
}
