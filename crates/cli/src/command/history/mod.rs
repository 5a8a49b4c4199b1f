//! `carom history`: loads of a contact along a history of shifts.

mod follow;
mod plot;
mod view;

use crate::columns;
use crate::command::case_arguments::{CaseArguments, Given};
use crate::error::CliError;
use crate::output::{Answer, Format, Results};
use crate::rows::{Rows, check_count, indented};
use carom_cases::case::HistoryCase;
use carom_cases::history::{self, Step, Traction, shifts};
use carom_cases::theory::ValidityReport;
use carom_laws::stiffness::ContactStiffness;
use carom_table::row;
use follow::{Wanted, follow};

/// Loads of a contact along a history of shifts and twists, with memory.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm".
/// Steps are listed in the file or in a CSV file; see examples/history_*.toml. xi and eta shift
/// body 2 against body 1 along x and y, zeta is the approach, omega (radians) the twist about z.
/// The picture shows loads, stick area and energy, and the last tractions if requested.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// Also give the tangential traction after each step, at this number of radii from the centre
    /// to the edge.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    tractions: Option<u32>,
}

pub(super) fn run(arguments: &Arguments, results: &mut Results) -> Result<Answer, CliError> {
    let Given { case: file, plot } = arguments.given.read()?;
    let case = file.parse::<HistoryCase>()?;
    let shifts = shifts(&file, &case)?;
    let format = arguments.given.format();
    let radii = arguments.tractions.map_or(0, |count| count as usize);
    check_count(format, shifts.len().saturating_mul(radii.max(1)))?;
    let wanted = Wanted { radii, picture: plot.is_some() };
    let columns = history::columns(&shifts);
    let (mut steps, mut tractions) =
        (Rows::new(format), Rows::new(format).of(history::TRACTION_COLUMNS));
    let (mut report, mut limits, mut first) = (ValidityReport::default(), Limits::default(), 0);
    let drawn = follow(&case, &shifts, wanted, |done| {
        let cells = |step: &Step| row(&columns, Some(step));
        columns::check_rows(done, [first, shifts.len()], cells)?;
        first += done.len();
        for step in done.iter() {
            step.add_to(&mut report, &case);
            limits.add(step);
        }
        if format != Format::Csv || radii == 0 {
            let json = |step: &Step, depth| {
                indented(&view::record(&columns, step, step.validity(&case)), depth)
            };
            steps.put(done, cells, json, results)?;
        }
        if matches!(format, Format::Csv | Format::Table(_)) && radii > 0 {
            let given: Vec<_> = done.iter().flat_map(|step| &step.tractions).collect();
            let cells = |traction: &&Traction| row(history::TRACTION_COLUMNS, Some(traction));
            tractions.put(&given, cells, |_, _| Ok(String::new()), results)?;
        }
        Ok(())
    })?;
    let text = match (format, radii) {
        (Format::Csv | Format::Chosen(_), 1..) => tractions.finish()?,
        (Format::Table(_), 1..) => steps.finish()? + &tractions.finish()?,
        _ => steps.finish()?,
    };
    let picture = plot.map(|to| arguments.given.drawn(to, plot::draw(&drawn)));
    let mut warnings = warnings(&case, &limits, arguments.tractions.is_some());
    let (caution, exceeded) = report.told("steps");
    warnings.extend(exceeded);
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution, format))
}

/// Help on the columns of the rows.
fn help() -> String {
    let steps = columns::help("A row for each step", history::COLUMNS);
    let twists = columns::help("with a twist also", history::TWIST_COLUMNS);
    let tractions =
        columns::help("With --tractions as CSV, a row for each radius", history::TRACTION_COLUMNS);
    format!("{steps}{twists}\n{tractions}")
}

/// Largest use of the friction limits by shift and twist.
#[derive(Debug, Default)]
struct Limits {
    is_twisted: bool,
    /// The largest share of both at the same time.
    both: f64,
}

impl Limits {
    fn add(&mut self, step: &Step) {
        self.is_twisted |= step.twist.is_some();
        self.both = step.twist.map_or(0.0, |twist| twist.share.min(step.share)).max(self.both);
    }
}

/// Warnings about effects that the law neglects in this case.
fn warnings(case: &HistoryCase, limits: &Limits, has_tractions: bool) -> Vec<String> {
    let mut warnings = Vec::new();
    let ContactStiffness { c_x, c_y, .. } = case.hertz.stiffness();
    if (c_x - c_y).abs() > 1e-12 * c_x {
        warnings.push(format!(
            "c_y/c_x = {:.4}: where the direction of the shift turns, the law is an approximation",
            c_y / c_x
        ));
    }
    if !limits.is_twisted {
        return warnings;
    }
    if (case.hertz.axis_ratio().get() - 1.0).abs() > 1e-12 {
        let tractions = if has_tractions { "; tractions of the twist are not given" } else { "" };
        warnings.push(format!(
            "the contact is not circular: between no slip and sliding the torsional law is an \
             approximation{tractions}"
        ));
    }
    if limits.both > 0.01 {
        let percent = 100.0 * limits.both;
        warnings.push(format!(
            "shift and twist are computed independently, which is valid if one of them is small: \
             both reach {percent:.0} % of their friction limits at the same time"
        ));
    }
    warnings
}
