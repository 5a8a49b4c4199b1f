//! `carom impact`: one impact, a sweep, or a scatter, from a case file.

mod movie;
mod plot;
mod table;
mod uncertain;
mod view;

use crate::case::{CaseError, ImpactCase, ImpactFile, Uncertainty};
use crate::columns;
use crate::command::theory::{self, caution};
use crate::command::{self, CaseArguments};
use crate::destination::Destination;
use crate::error::CliError;
use crate::input::CaseFile;
use crate::output::{Answer, Format, Picture, json};
use carom_impact::{CollisionError, HistoryPoint, NumericalImpact, NumericalImpactError, Outcome};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use view::{Parameter, Record};

/// Impact of two bodies of any smooth shape from a case file.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm"; see the cases under examples/. z
/// points into body 1. Any number may be a sweep, a list or { start, stop, count }, or a
/// distribution, as in glass_scatter.toml. The spin about the normal is left alone unless
/// `contact.torsion = true`. The picture shows the course of the impact, the sweep, or the scatter.
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

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let (command::Given { case: text, plot }, moving) = arguments.given.read_beside(|outputs| {
        let to = |path: &PathBuf| outputs.picture("animate", path, arguments.given.format);
        arguments.animate.as_ref().map(to).transpose()
    })?;
    let plot = moving.or(plot);
    let file = text.parse(ImpactFile::parse)?;
    if arguments.animate.is_some() && (file.sweep().is_some() || file.uncertainty().is_some()) {
        return Err(CliError::Options("--animate takes a case with one impact"));
    }
    match file.uncertainty() {
        Some(uncertainty) => scatter(arguments, plot, &file, uncertainty),
        None => impacts(arguments, plot, &file),
    }
}

fn impacts(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
) -> Result<Answer, CliError> {
    let (path, format) = (&arguments.given.case, arguments.given.format);
    let sweep = file.sweep();
    if sweep.is_some() && arguments.history.is_some() {
        return Err(CliError::Options("--history takes a case with one impact, not a sweep"));
    }
    let mut outcomes = match sweep {
        Some((_, values)) => records(path, file, values)?,
        None => vec![record(path, None, file.nominal())?],
    };
    if let (Some(count), [record]) = (arguments.history, outcomes.as_mut_slice()) {
        record.history = Some(course(path, file, count as usize)?);
    }
    let rows: Vec<_> = outcomes.iter().map(|record| view::cells(Some(record))).collect();
    // The number that is swept over may be infinite, as friction.
    columns::check_cells(path, rows.iter().map(|row| &row[1..]))?;
    let text = match (format, outcomes.as_slice()) {
        (Format::Json, [record]) if sweep.is_none() => json(record)?,
        (Format::Json, records) => json(&records)?,
        (Format::Csv, [Record { history: Some(points), .. }]) => {
            columns::rows(format, HistoryPoint::COLUMNS, points)?
        }
        (Format::Csv, _) => columns::cell_rows(format, &rows)?,
        (Format::Table, records) => {
            table::render(records, sweep.map(|(input, _)| Parameter::of(input, 0.0).name))?
        }
        (Format::None, _) => String::new(),
    };
    let mut warnings = warnings(&outcomes);
    if let (None, [record]) = (sweep, outcomes.as_slice())
        && (arguments.history.is_some() || plot.is_some())
        && record.rebound().is_some_and(|rebound| rebound.energy.lost > 0.0)
    {
        warnings.push(ELASTIC_COURSE.to_owned());
    }
    let mut picture = None;
    if let Some(to) = plot {
        match draw(arguments, file, &outcomes)? {
            Some(drawn) => picture = Some((to, drawn)),
            None => warnings.push(NOTHING_TO_DRAW.to_owned()),
        }
    }
    let excesses: Vec<_> = outcomes.iter().map(|record| record.excess).collect();
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution(&excesses, several(&outcomes)), format))
}

/// The impacts of a case.
#[derive(Debug)]
pub struct Followed {
    /// Name, unit and values of the number that is swept over, if there is one.
    pub swept: Option<(&'static str, &'static str, Vec<f64>)>,
    /// What came of each.
    pub outcomes: Vec<Outcome>,
}

/// The impact of a case, or all of its sweep, in parallel.
///
/// # Errors
/// If the case is bad, has `[uncertainty]`, or an impact cannot be followed.
pub fn followed(file: &CaseFile) -> Result<Followed, CliError> {
    let (path, file) = (&file.path, file.parse(ImpactFile::parse)?);
    if file.uncertainty().is_some() {
        return Err(CliError::Options("a case with [uncertainty] is for `carom impact` alone"));
    }
    let Some((input, values)) = file.sweep() else {
        return Ok(Followed { swept: None, outcomes: vec![outcome(path, file.nominal())?] });
    };
    let outcome = |value: &f64| outcome(path, &swept(path, &file, *value)?);
    let outcomes = values.par_iter().map(outcome).collect::<Result<_, _>>()?;
    let Parameter { name, unit, .. } = Parameter::of(input, 0.0);
    Ok(Followed { swept: Some((name, unit, values.to_vec())), outcomes })
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

/// The case at a value of its sweep.
fn swept(path: &Path, file: &ImpactFile<'_>, value: f64) -> Result<ImpactCase, CliError> {
    file.case(&[value]).map_err(|source| refused(path, source))
}

fn record(
    path: &Path,
    parameter: Option<Parameter>,
    case: &ImpactCase,
) -> Result<Record, CliError> {
    Ok(Record::new(parameter, case.clone(), outcome(path, case)?))
}

fn outcome(path: &Path, case: &ImpactCase) -> Result<Outcome, CliError> {
    match case.contact.is_numerical {
        true => {
            NumericalImpact::new(&case.collision).solve().map_err(|source| on_grid(path, source))
        }
        false => case.collision.solve().map_err(|source| blamed(path, case, source)),
    }
}

fn course(path: &Path, file: &ImpactFile<'_>, count: usize) -> Result<Vec<HistoryPoint>, CliError> {
    let case = file.nominal();
    let history = match case.contact.is_numerical {
        true => NumericalImpact::new(&case.collision)
            .history(count)
            .map_err(|source| on_grid(path, source))?,
        false => case.collision.history(count).map_err(|source| blamed(path, case, source))?,
    };
    columns::check(path, HistoryPoint::COLUMNS, &history)?;
    Ok(history)
}

/// The case is to blame for torsion that cannot be given.
fn blamed(path: &Path, case: &ImpactCase, source: CollisionError) -> CliError {
    match (source, case.contact.torsion) {
        (CollisionError::NormalSpin(source), Some(line)) => {
            refused(path, CaseError::Torsion { line, source: Box::new(source) })
        }
        (source, _) => CliError::Collision { path: path.to_owned(), source: Box::new(source) },
    }
}

fn on_grid(path: &Path, source: NumericalImpactError) -> CliError {
    CliError::Numerical { path: path.to_owned(), source: Box::new(source) }
}

fn refused(path: &Path, source: CaseError) -> CliError {
    CliError::Case { path: path.to_owned(), source }
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

/// The picture; none if no impact happens.
fn draw(
    arguments: &Arguments,
    file: &ImpactFile<'_>,
    given: &[Record],
) -> Result<Option<Picture>, CliError> {
    if given.iter().all(|record| record.rebound().is_none()) {
        return Ok(None);
    }
    let path = &arguments.given.case;
    if let (Some(_), [record]) = (&arguments.animate, given) {
        return Ok(Some(movie::movie(record, &course(path, file, movie::INSTANTS)?)));
    }
    let Some((input, values)) = file.sweep() else {
        return Ok(Some(plot::course(&course(path, file, plot::INSTANTS)?)));
    };
    let between = records(path, file, &plot::between(values))?;
    Ok(Some(plot::sweep(input, &between, given)))
}

/// What the impacts of a sweep are called.
fn several(records: &[Record]) -> &'static str {
    match records.first().and_then(|record| record.parameter) {
        Some(Parameter { name: "angle", .. }) => "angles",
        _ => "impacts",
    }
}

/// What limits the validity of the outcomes.
fn warnings(records: &[Record]) -> Vec<String> {
    let place = |record: &Record| match record.parameter {
        Some(Parameter { name: "angle", value, .. }) => format!("at {value}°"),
        Some(Parameter { name, value, .. }) => format!("at {name} = {value}"),
        None => String::new(),
    };
    let concerned = records.iter().map(|record| (place(record), record.limits()));
    theory::warnings(concerned, several(records))
}
