//! `carom impact`: one impact, a sweep, or a scatter, from a case file.

mod movie;
mod plot;
mod table;
mod uncertain;
mod view;

use crate::columns;
use crate::command::theory::{Warnings, Worst, caution};
use crate::command::{self, CaseArguments};
use crate::destination::Destination;
use crate::error::CliError;
use crate::output::{Answer, Format, Results, json};
use crate::rows::{BLOCK, Rows, check_count, indented};
use carom_cases::case::{ImpactCase, ImpactFile, Input, Uncertainty};
use carom_cases::impact::{self, outcome, swept};
use carom_impact::HistoryPoint;
use carom_table::row;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use view::{Parameter, Record};

/// Impact of two bodies of any smooth shape from a case file.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see the cases under examples/. z
/// points into body 1. Any number may be a sweep, a list or { start, stop, count }, or a
/// distribution, as in glass_scatter.toml. `contact.law` and `contact.torsion` choose what counts:
/// by default the coupling of unlike materials and the spin about the normal where they matter, of
/// which each impact by rings takes about a millisecond. The picture shows the course of the impact,
/// the sweep, or the scatter.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each impact, motions afterwards", &view::cells(None)) + "\n"
    + &columns::help("With --history a row for each instant, in contact axes", HistoryPoint::COLUMNS)
    + "\n" + &uncertain::help())]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Give the course of the impact at this many instants too; not for a sweep. Of other bodies
    /// than spheres and planes it is straight between the instants that were computed.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    history: Option<u32>,
    /// Draw the bodies, the contact and the forces as they move into this SVG file, which a browser
    /// shows; in place of --plot, and not for a sweep. A .png stands still.
    #[arg(long, value_name = "FILE", conflicts_with = "plot")]
    animate: Option<PathBuf>,
}

const ELASTIC_COURSE: &str = "the course, duration and greatest force are those of elastic bodies: the material takes its part at the end";
const NOTHING_TO_DRAW: &str = "no impact: there is nothing to draw";

pub(super) fn run(arguments: &Arguments, results: &mut Results) -> Result<Answer, CliError> {
    let (command::Given { case: text, plot }, moving) = arguments.given.read_beside(|outputs| {
        let to = |path: &PathBuf| outputs.picture("animate", path, arguments.given.format);
        arguments.animate.as_ref().map(to).transpose()
    })?;
    let plot = moving.or(plot);
    let file = text.parse(ImpactFile::parse)?;
    if arguments.animate.is_some() && (file.sweep().is_some() || file.uncertainty().is_some()) {
        return Err(CliError::Options("--animate takes a case with one impact"));
    }
    if let Some(uncertainty) = file.uncertainty() {
        return scatter(arguments, plot, &file, uncertainty);
    }
    match file.sweep() {
        None => single(arguments, plot, &file, results),
        Some(_) if arguments.history.is_some() => {
            Err(CliError::Options("--history takes a case with one impact, not a sweep"))
        }
        Some(swept) => sweep(arguments, plot, &file, swept, results),
    }
}

/// One impact.
fn single(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
    results: &mut Results,
) -> Result<Answer, CliError> {
    let (path, format) = (&arguments.given.case, arguments.given.format);
    check_count(format, arguments.history.map_or(0, |count| count as usize))?;
    let mut record = record(path, None, file.nominal())?;
    if let Some(count) = arguments.history {
        record.history = Some(course(path, file, count as usize)?);
    }
    let cells = view::cells(Some(&record));
    columns::check_rows(path, &[&cells[1..]], [0, 1], |cells| cells.to_vec())?;
    let text = match (format, &record.history) {
        (Format::Json, _) => json(&record)?,
        (Format::Csv, Some(points)) => {
            let mut rows = Rows::new(format).of(HistoryPoint::COLUMNS);
            for points in points.chunks(BLOCK) {
                let cells = |point: &HistoryPoint| row(HistoryPoint::COLUMNS, Some(point));
                rows.put(points, cells, |_, _| Ok(String::new()), results)?;
            }
            rows.finish()?
        }
        (Format::Csv, None) => columns::cell_rows(format, &[cells])?,
        (Format::Table, _) => table::one(&record)?,
        (Format::None, _) => String::new(),
    };
    let mut warnings = Warnings::default();
    warnings.add(|| place(&record), record.limits());
    let mut warnings = warnings.told(several(&record));
    if (arguments.history.is_some() || plot.is_some())
        && record.rebound().is_some_and(|rebound| rebound.energy.lost > 0.0)
    {
        warnings.push(ELASTIC_COURSE.to_owned());
    }
    let picture = match plot {
        Some(_) if record.rebound().is_none() => {
            warnings.push(NOTHING_TO_DRAW.to_owned());
            None
        }
        Some(to) if arguments.animate.is_some() => {
            Some((to, movie::movie(&record, &course(path, file, movie::INSTANTS)?)))
        }
        Some(to) => Some((to, plot::course(&course(path, file, plot::INSTANTS)?))),
        None => None,
    };
    let caution = caution(&[record.excess], several(&record));
    Ok(Answer { text, warnings, picture, ..Answer::default() }.cautioned(caution, format))
}

/// The impacts of a sweep, in their order; as many at once as are in flight.
fn sweep(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
    (input, values): (&Input, &[f64]),
    results: &mut Results,
) -> Result<Answer, CliError> {
    let (path, format) = (&arguments.given.case, arguments.given.format);
    check_count(format, values.len())?;
    let swept = Parameter::of(input, 0.0).name;
    let mut rows = Rows::new(format).showing([&[swept][..], &table::OF_SWEEP].concat());
    let mut drawn = plot.is_some().then(|| plot::Sweep::new(values));
    let (mut warnings, mut worst) = (Warnings::default(), Worst::default());
    let mut what = "impacts";
    for block in values.chunks(BLOCK) {
        let records = records(path, file, block)?;
        let first = warnings.count();
        // The number that is swept over may be infinite, as friction.
        columns::check_rows(path, &records, [first, values.len()], |record| {
            view::cells(Some(record)).split_off(1)
        })?;
        rows.put(&records, |record| view::cells(Some(record)), indented, results)?;
        for record in &records {
            what = several(record);
            warnings.add(|| place(record), record.limits());
            worst.add(record.excess);
        }
        match &mut drawn {
            Some(drawn) => drawn.add(&records),
            // Nobody reads, nobody looks.
            None if results.is_closed() => break,
            None => {}
        }
    }
    let mut warnings = warnings.told(what);
    let mut picture = None;
    if let (Some(to), Some(mut drawn)) = (plot, drawn) {
        for block in drawn.between().chunks(BLOCK) {
            drawn.add_between(&records(path, file, block)?);
        }
        match drawn.draw(input) {
            Some(drawn) => picture = Some((to, drawn)),
            None => warnings.push(NOTHING_TO_DRAW.to_owned()),
        }
    }
    let answer = Answer { text: rows.finish()?, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(worst.caution(what), format))
}

/// The impacts of a sweep over these values, in their order.
fn records(path: &Path, file: &ImpactFile<'_>, values: &[f64]) -> Result<Vec<Record>, CliError> {
    let input = file.sweep().map(|(input, _)| input);
    let record = |value: &f64| {
        let parameter = input.map(|input| Parameter::of(input, *value));
        record(path, parameter, &swept(path, file, *value)?)
    };
    values.par_iter().map(record).collect()
}

fn record(
    path: &Path,
    parameter: Option<Parameter>,
    case: &ImpactCase,
) -> Result<Record, CliError> {
    Ok(Record::new(parameter, case.clone(), outcome(path, case)?))
}

/// The course of the impact, checked.
fn course(path: &Path, file: &ImpactFile<'_>, count: usize) -> Result<Vec<HistoryPoint>, CliError> {
    let history = impact::course(path, file.nominal(), count)?;
    columns::check(path, HistoryPoint::COLUMNS, &history)?;
    Ok(history)
}

fn scatter(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
    uncertainty: &Uncertainty,
) -> Result<Answer, CliError> {
    if arguments.history.is_some() {
        return Err(CliError::Options("--history takes a case with one impact, not [uncertainty]"));
    }
    let study = uncertain::study(file, uncertainty)
        .map_err(|source| CliError::Uncertain { path: arguments.given.case.clone(), source })?;
    let excess = uncertain::excess(file);
    let report = uncertain::report(file, uncertainty, &study, excess)?;
    let picture = plot.map(|to| (to, uncertain::draw(&report)));
    let text = uncertain::render_text(&report, arguments.given.format)?;
    let answer =
        Answer { text, warnings: uncertain::warnings(&report), picture, ..Answer::default() };
    Ok(answer.cautioned(caution(&[excess], "means"), arguments.given.format))
}

/// What the impacts of a sweep are called.
fn several(record: &Record) -> &'static str {
    match record.parameter {
        Some(Parameter { name: "angle", .. }) => "angles",
        _ => "impacts",
    }
}

/// Which impact of a sweep it is.
fn place(record: &Record) -> String {
    match record.parameter {
        Some(Parameter { name: "angle", value, .. }) => format!("at {value}°"),
        Some(Parameter { name, value, .. }) => format!("at {name} = {value}"),
        None => String::new(),
    }
}
