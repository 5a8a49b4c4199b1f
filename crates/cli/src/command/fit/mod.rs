//! `carom fit`: the unknown numbers of a case from measured data.

mod plot;
mod view;

use crate::columns;
use crate::command::case_arguments::{CaseArguments, Given};
use crate::error::CliError;
use crate::output::{Answer, Format};
use carom_cases::Error;
use carom_cases::input::read_table;
use carom_fit::{Correlation, Data, Determined, FitError, GivenError, Loss, Options};
use carom_fit::{Point, Prediction, Quality};
use carom_impact::HistoryPoint;
use std::path::{Path, PathBuf};

/// Points of the fitted curve in a picture.
const CURVE: usize = 201;

/// Determine unknown numbers of a case from measured data: friction, stiffness, restitution, moduli.
///
/// In the case of an impact, a Hertz contact or a history of shifts a number is unknown if it is { fit = [low, high] } or
/// { prior = { mean, sd } }. DATA is a file of comma-separated values with a line of headings, such as
/// `angle (deg)` or `body_1_spin_y / rad/s`. A column is a number that the case states, which each row
/// replaces (approach.angle or short angle, body_1.velocity.x), a measured quantity, or its standard error
/// (R_x_sd). Rows with a `time` (clock.time) are of one impact: forces and shifts of these instants.
/// Least squares, weighted by the standard errors; without any, one of each quantity is estimated.
/// What the data do not determine is said in sentences. The picture shows data, fit and its band of 95 %.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// The measured data, as comma-separated values.
    #[arg(value_name = "DATA.csv")]
    data: PathBuf,
    /// Standard error of all values of a quantity, such as body_1_tangential_ratio=0.014; the name may be left
    /// out if there is one quantity. It has the unit of the column, or one behind the name: "slip_after (mm/s)=3".
    #[arg(long, value_name = "[NAME=]ERROR", value_parser = error, allow_hyphen_values = true)]
    sd: Vec<GivenError>,
    /// Let single wrong values count little: pseudo-Huber loss, by squares up to some 1.345 standard errors, by size
    /// beyond.
    #[arg(long)]
    robust: bool,
    /// Print predictions for the inputs in this file of comma-separated values.
    #[arg(long, value_name = "INPUTS.csv")]
    predict: Option<PathBuf>,
    /// Print each measured value with its fitted one, residual and leverage.
    #[arg(long, conflicts_with = "predict")]
    points: bool,
}

/// What the rows hold.
fn help() -> String {
    let parts = [
        columns::help("A row for each unknown", Determined::COLUMNS),
        columns::help("Then how well the theory meets the data", Quality::COLUMNS),
        columns::help("and a row for each pair of unknowns", Correlation::COLUMNS),
        columns::help("With --points a row for each measured value", Point::COLUMNS),
        columns::help(
            "With --predict a row for each of its rows and quantities",
            Prediction::COLUMNS,
        ),
        "Measured quantities of impacts, beside those that `carom impact --help` lists:\n"
            .to_owned()
            + &carom_table::described(carom_fit::Bounce::COLUMNS),
        columns::help("With a column `time` also those of that instant", HistoryPoint::COLUMNS),
    ];
    parts.join("\n")
}

/// A standard error with the name of its quantity, or without one.
fn error(text: &str) -> Result<GivenError, String> {
    let (name, number) = match text.split_once('=') {
        Some((name, number)) => (Some(name.trim().to_owned()), number),
        None => (None, text),
    };
    let read = number.trim().parse().ok().filter(|error: &f64| error.is_finite() && *error > 0.0);
    let error = read.ok_or_else(|| format!("{number:?} must be a number > 0"))?;
    Ok((name, vec![error]))
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let inputs = [Some(&arguments.data), arguments.predict.as_ref()];
    let (Given { case, plot }, ()) = arguments.given.read_beside(|outputs| {
        inputs.into_iter().flatten().try_for_each(|path| outputs.check_input(path))
    })?;
    let data = data(&arguments.data)?;
    let predict = arguments.predict.as_deref().map(self::data).transpose()?;
    let options = Options {
        errors: &arguments.sd,
        loss: if arguments.robust { Loss::Huber } else { Loss::Squares },
        predict: predict.as_ref(),
        curve: if plot.is_some() { CURVE } else { 0 },
    };
    let fit = carom_fit::fit(&case, &data, &options).map_err(|error| match error {
        FitError::Inputs(error) => of_file(inputs[1].unwrap_or(&arguments.data))(*error),
        error => of_file(&arguments.data)(error),
    })?;
    let format = arguments.given.format();
    let (text, warnings) = view::answer(&fit, format, arguments.points)?;
    let picture = plot.map(|to| arguments.given.drawn(to, plot::draw(&fit)));
    let told = if matches!(format, Format::Csv | Format::None) { fit.statements } else { vec![] };
    let warnings = told.into_iter().chain(warnings).collect();
    Ok(Answer { text, warnings, picture, ..Answer::default() })
}

fn data(path: &Path) -> Result<Data, CliError> {
    let text = read_table(path)?;
    Data::from_csv(&text).map_err(of_file(path))
}

/// The error of a fit, in the file of the data if that is at fault.
fn of_file(path: &Path) -> impl FnOnce(FitError) -> CliError {
    let path = path.to_owned();
    move |error| match error {
        FitError::Case(error) => error.into(),
        FitError::Kind { .. } | FitError::NoUnknown | FitError::Varies { .. } => {
            Error::input(error.to_string()).into()
        }
        error if error.is_bad_input() => Error::input(error.to_string()).of_file(&path).into(),
        error => CliError::Fit { path, source: Box::new(error) },
    }
}
