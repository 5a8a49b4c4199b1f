//! `carom scene`: the path of a ball between walls, from a case file.

mod plot;
mod view;

use crate::columns;
use crate::command::case_arguments::{CaseArguments, Given};
use crate::error::CliError;
use crate::output::{Answer, Format, Results};
use crate::rows::{BLOCK, Rows, indented};
use carom_cases::case::SceneCase;
use carom_cases::scene::{End, add_bounce, follow};
use carom_cases::theory::ValidityReport;
use carom_impact::scene::{Bounce, Event, Leg, PathPoint};
use carom_table::{row, short};

/// Path and bounces of a ball between walls.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/scene_*.toml. The coupling of dissimilar materials and the spin about the normal are included
/// where they matter; a bounce then takes some milliseconds (the first up to a tenth of a second), with a viscous loss
/// (`normal_restitution` below 1) some milliseconds too, otherwise some microseconds. After the last bounce
/// the ball slides and rolls on its wall until it rests, comes to an edge or meets another wall. The picture shows
/// walls, path and bounces.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each bounce", &view::cells(None)) + "\n"
    + &columns::help("With --events a row for each event", &view::event_cells(None)) + "\n"
    + &columns::help("With --points a row for each instant", PathPoint::COLUMNS))]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// Also give the ball at this many instants of every flight; as CSV, these replace the bounces.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    points: Option<u32>,
    /// Instead of the bounces alone a row for each event: bounces, highest points, where the ball begins to slide or to roll,
    /// and the end. JSON has both.
    #[arg(long, conflicts_with = "points")]
    events: bool,
}

pub(super) fn run(arguments: &Arguments, results: &mut Results) -> Result<Answer, CliError> {
    let Given { case: file, plot } = arguments.given.read()?;
    let case = file.parse::<SceneCase>()?;
    let (format, points) = (arguments.given.format(), arguments.points.map(|count| count as usize));
    let mut bounces = Rows::new(format).at_depth(1);
    if !arguments.events {
        bounces = bounces.showing(view::shown(&case));
    }
    let mut events = Rows::new(format).at_depth(1);
    let mut course = plot.is_some().then(|| plot::Course::new(&case));
    let mut report = ValidityReport::default();
    if format == Format::Json {
        results.put(b"{\n  \"bounces\": ")?;
    }
    let end = follow::<CliError>(&case, |legs| {
        for leg in legs {
            if let Some(course) = &mut course {
                course.push(leg)?;
            }
        }
        let met: Vec<&Bounce> = legs.iter().filter_map(Leg::bounce).collect();
        met.iter().for_each(|bounce| add_bounce(&mut report, bounce));
        if matches!(format, Format::Csv | Format::Chosen(_)) && points.is_some() {
            return Ok(());
        }
        if arguments.events && format != Format::Json {
            let met: Vec<Event> = legs.iter().flat_map(Leg::events).collect();
            let cells = |event: &Event| view::event_cells(Some((&case, event)));
            return events.put(&met, cells, |_, _| Ok(String::new()), results);
        }
        let cells = |bounce: &&Bounce| view::cells(Some((&case, *bounce)));
        let json =
            |bounce: &&Bounce, depth| indented(&view::BounceRecord::new(&case, bounce), depth);
        bounces.put(&met, cells, json, results)
    })?;
    let mut text = match (format, points) {
        (Format::Csv | Format::Chosen(_), Some(_)) => String::new(),
        _ if arguments.events && format != Format::Json => events.finish()?,
        _ => bounces.finish()?,
    };
    match format {
        Format::Json => text.push_str(&view::end(&case, &end)?),
        Format::Table(page) => text.push_str(&page.fold(&read_end(&case, &end))),
        Format::Csv | Format::Chosen(_) | Format::None => {}
    }
    if format == Format::Json {
        results.put(format!("{text},\n  \"events\": ").as_bytes())?;
        text = events_again(&case, results)?;
    }
    if let (Some(count), true) = (points, format != Format::None) {
        if format == Format::Json {
            results.put(format!("{text},\n  \"path\": ").as_bytes())?;
            text.clear();
        }
        text.push_str(&instants(&case, count, format, results)?);
    }
    if format == Format::Json {
        text.push_str("\n}\n");
    }
    let picture = match (plot, course) {
        (Some(to), Some(course)) => Some((to, course.draw())),
        _ => None,
    };
    let (caution, warnings) = report.told("bounces");
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution, format))
}

/// Computes the path again and writes its events in JSON; returns the end of the list, which is still to be written.
fn events_again(case: &SceneCase, results: &mut Results) -> Result<String, CliError> {
    let mut rows = Rows::new(Format::Json).at_depth(1);
    follow::<CliError>(case, |legs| {
        let met: Vec<Event> = legs.iter().flat_map(Leg::events).collect();
        let cells = |event: &Event| view::event_cells(Some((case, event)));
        let json = |event: &Event, depth| indented(&columns::Fields(&cells(event)), depth);
        rows.put(&met, cells, json, results)
    })?;
    rows.finish()
}

/// Computes the path again and writes `count` instants of every flight; returns the end of the list, which is
/// still to be written.
fn instants(
    case: &SceneCase,
    count: usize,
    format: Format,
    results: &mut Results,
) -> Result<String, CliError> {
    let mut rows = Rows::new(format).at_depth(1).of(PathPoint::COLUMNS);
    let mut waiting = Vec::new();
    let mut put = |points: &[PathPoint], results: &mut Results| {
        let cells = |point: &PathPoint| row(PathPoint::COLUMNS, Some(point));
        let json = |point: &PathPoint, depth| {
            indented(&columns::Record::new(PathPoint::COLUMNS, point), depth)
        };
        rows.put(points, cells, json, results)
    };
    follow::<CliError>(case, |legs| {
        for leg in legs {
            waiting.extend(leg.points(count)?);
            if waiting.len() >= BLOCK {
                put(&waiting, results)?;
                waiting.clear();
            }
        }
        Ok(())
    })?;
    put(&waiting, results)?;
    rows.finish()
}

fn read_end(case: &SceneCase, end: &End) -> String {
    let place = <[f64; 3]>::from(end.last.position).map(short).join("  ");
    let (ending, time) = (end.reason(case), short(end.last.time));
    format!("end: {ending} after {time} s at {place} m\n")
}
