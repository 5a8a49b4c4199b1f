//! `carom impact`: one impact, a sweep, or a distribution of impacts, from a case file.

mod movie;
mod plot;
mod sweep;
mod table;
mod uncertain;
mod view;

use crate::columns;
use crate::command::case_arguments::{CaseArguments, Given};
use crate::destination::Destination;
use crate::error::CliError;
use crate::output::{Answer, Format, Results, json};
use crate::rows::{BLOCK, Rows, check_count, indented};
use carom_cases::Error;
use carom_cases::case::{ImpactCase, ImpactFile, Input, Uncertainty};
use carom_cases::impact::{self, outcome};
use carom_cases::theory::ValidityReport;
use carom_impact::HistoryPoint;
use carom_table::row;
use rayon::prelude::*;
use std::path::PathBuf;
use view::{Parameter, Record};

/// Impact of two bodies of any smooth shape.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see the cases
/// under examples/. z points into body 1. Any number may be a sweep, that is a list or { start, stop, count
/// }, or a distribution, as in glass_scatter.toml. `contact.law` and `contact.torsion` choose the effects
/// that are computed: by default the coupling of dissimilar materials and the spin about the normal, where
/// they matter; each impact by rings then takes some milliseconds. The picture shows the history of the
/// impact, the sweep, or the distribution.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each impact, motions afterwards", &view::cells(None)) + "\n"
    + &columns::help("With --history a row for each instant, in contact axes", HistoryPoint::COLUMNS)
    + "\n" + &uncertain::help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// Also give the history of the impact at this many instants; not for a sweep. For bodies other than
    /// spheres and planes, values are interpolated linearly between computed steps.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    history: Option<u32>,
    /// Draw the moving bodies, the contact and the forces into this SVG file, which a browser shows; instead
    /// of --plot, and not for a sweep. A .png or .pdf shows one frame.
    #[arg(long, value_name = "FILE", conflicts_with = "plot")]
    animate: Option<PathBuf>,
}

const ELASTIC_COURSE: &str = "history, duration and maximum force are those of elastic bodies: energy dissipated in the material is taken off at the end";
const NOTHING_TO_DRAW: &str = "no impact: there is nothing to draw";

impl Arguments {
    /// The format of the results; with a picture, none by default.
    fn format(&self) -> Format {
        match self.animate {
            Some(_) => self.given.printing.format_beside_picture(),
            None => self.given.format(),
        }
    }
}

pub(super) fn run(arguments: &Arguments, results: &mut Results) -> Result<Answer, CliError> {
    let (Given { case: text, plot }, moving) = arguments.given.read_beside(|outputs| {
        let to = |path: &PathBuf| outputs.picture("animate", path, arguments.format());
        arguments.animate.as_ref().map(to).transpose()
    })?;
    let plot = moving.or(plot);
    let file = text.parse::<ImpactFile<'_>>()?;
    impact::check_known(&file)?;
    if arguments.animate.is_some() && (file.sweep().is_some() || file.uncertainty().is_some()) {
        return Err(CliError::Options("--animate requires a case with one impact"));
    }
    if let Some(uncertainty) = file.uncertainty() {
        return scatter(arguments, plot, &file, uncertainty);
    }
    match file.sweep() {
        None => single(arguments, plot, &file, results),
        Some(_) if arguments.history.is_some() => {
            Err(CliError::Options("--history requires a case with one impact, not a sweep"))
        }
        Some(swept) => sweep(arguments, plot, &file, swept, results),
    }
}

/// Computes one impact.
fn single(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
    results: &mut Results,
) -> Result<Answer, CliError> {
    let format = arguments.format();
    check_count(format, arguments.history.map_or(0, |count| count as usize))?;
    let mut record = record(None, file.nominal())?;
    if let Some(count) = arguments.history {
        record.history = Some(course(file, count as usize)?);
    }
    let cells = view::cells(Some(&record));
    columns::check_rows(&[&cells[1..]], [0, 1], |cells| cells.to_vec())?;
    let text = match (format, &record.history) {
        (Format::Json, _) => json(&record)?,
        (Format::Csv | Format::Chosen(_), Some(points)) => {
            let mut rows = Rows::new(format).of(HistoryPoint::COLUMNS);
            for points in points.chunks(BLOCK) {
                let cells = |point: &HistoryPoint| row(HistoryPoint::COLUMNS, Some(point));
                rows.put(points, cells, |_, _| Ok(String::new()), results)?;
            }
            rows.finish()?
        }
        (Format::Csv | Format::Chosen(_), None) => columns::cell_rows(format, &[cells])?,
        (Format::Table(page), _) => table::one(page, &record)?,
        (Format::None, _) => String::new(),
    };
    let mut report = ValidityReport::default();
    report.add_warned(|| place(&record), record.limits(), record.validity);
    let (caution, mut warnings) = report.told(several(&record));
    // The table begins with it.
    if record.rebound().is_none() && !matches!(format, Format::Table(_)) {
        warnings.push(table::NO_IMPACT.trim_end().to_owned());
    }
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
            Some((to, movie::movie(&record, &course(file, movie::INSTANTS)?)))
        }
        Some(to) => {
            let history = course(file, plot::INSTANTS)?;
            let friction = file.nominal().collision.friction();
            Some(arguments.given.drawn(to, plot::course(&history, friction)))
        }
        None => None,
    };
    Ok(Answer { text, warnings, picture, ..Answer::default() }.cautioned(caution, format))
}

/// Computes the impacts of a sweep in order, several in parallel.
fn sweep(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
    (input, values): (&Input, &[f64]),
    results: &mut Results,
) -> Result<Answer, CliError> {
    let format = arguments.format();
    check_count(format, values.len())?;
    let swept = Parameter::of(input, 0.0).name;
    let shown = [&[swept][..], &table::OF_SWEEP, table::friction(file.nominal())].concat();
    let mut rows = Rows::new(format).showing(shown);
    let mut drawn = plot.is_some().then(|| sweep::Sweep::new(values));
    let (mut report, mut what) = (ValidityReport::default(), "impacts");
    for block in values.chunks(BLOCK) {
        let records = records(file, block)?;
        let first = report.count();
        // The swept number itself may be infinite, like friction.
        columns::check_rows(&records, [first, values.len()], |record| {
            view::cells(Some(record)).split_off(1)
        })?;
        rows.put(&records, |record| view::cells(Some(record)), indented, results)?;
        for record in &records {
            what = several(record);
            report.add_warned(|| place(record), record.limits(), record.validity);
        }
        match &mut drawn {
            Some(drawn) => drawn.add(&records),
            // Stops if nobody reads the results.
            None if results.is_closed() => break,
            None => {}
        }
    }
    let (caution, mut warnings) = report.told(what);
    let mut picture = None;
    if let (Some(to), Some(mut drawn)) = (plot, drawn) {
        for block in drawn.between().chunks(BLOCK) {
            drawn.add_between(&records(file, block)?);
        }
        match drawn.draw(input) {
            Some(drawn) => picture = Some(arguments.given.drawn(to, drawn)),
            None => warnings.push(NOTHING_TO_DRAW.to_owned()),
        }
    }
    let answer = Answer { text: rows.finish()?, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution, format))
}

/// The impacts for these values of a sweep, in order.
fn records(file: &ImpactFile<'_>, values: &[f64]) -> Result<Vec<Record>, CliError> {
    let input = file.sweep().map(|(input, _)| input);
    let record = |value: &f64| {
        let parameter = input.map(|input| Parameter::of(input, *value));
        record(parameter, &file.case(&[*value]).map_err(Error::from)?)
    };
    values.par_iter().map(record).collect()
}

fn record(parameter: Option<Parameter>, case: &ImpactCase) -> Result<Record, CliError> {
    Ok(Record::new(parameter, case.clone(), outcome(case)?))
}

/// The history of the impact, with all numbers checked.
fn course(file: &ImpactFile<'_>, count: usize) -> Result<Vec<HistoryPoint>, CliError> {
    let history = impact::course(file.nominal(), count)?;
    columns::check(HistoryPoint::COLUMNS, &history)?;
    Ok(history)
}

fn scatter(
    arguments: &Arguments,
    plot: Option<Destination>,
    file: &ImpactFile<'_>,
    uncertainty: &Uncertainty,
) -> Result<Answer, CliError> {
    if arguments.history.is_some() {
        return Err(CliError::Options(
            "--history requires a case with one impact, not [uncertainty]",
        ));
    }
    let study = uncertain::study(file, uncertainty)?;
    let validity = uncertain::validity(file);
    let report = uncertain::report(file, uncertainty, &study, validity)?;
    let picture = plot.map(|to| (to, uncertain::draw(&report)));
    let text = uncertain::render_text(&report, arguments.format())?;
    let answer = Answer {
        text,
        warnings: uncertain::warnings(&report, validity),
        picture,
        ..Answer::default()
    };
    let mut means = ValidityReport::default();
    means.add(String::new, validity);
    Ok(answer.cautioned(means.told("means").0, arguments.format()))
}

/// The plural of the swept quantity, for warnings.
fn several(record: &Record) -> &'static str {
    match record.parameter {
        Some(Parameter { name: "angle", .. }) => "angles",
        _ => "impacts",
    }
}

/// The place of an impact in the sweep, for warnings.
fn place(record: &Record) -> String {
    match record.parameter {
        Some(Parameter { name: "angle", value, .. }) => format!("at {value}°"),
        Some(Parameter { name, value, .. }) => format!("at {name} = {value}"),
        None => String::new(),
    }
}
