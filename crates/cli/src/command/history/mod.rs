//! `carom history`: loads of a contact along a history of shifts.

mod follow;
mod laws;
mod plot;
mod steps;
mod twist;
mod view;

pub use steps::StepsError;
pub(super) use steps::read as read_steps;

use crate::case::{HistoryCase, Steps};
use crate::columns;
use crate::command::hertz::smallest_radius;
use crate::command::theory::{Excess, Worst};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::input::CaseFile;
use crate::output::{Answer, Format, Results};
use crate::rows::{Rows, check_count, indented};
use carom_laws::stiffness::ContactStiffness;
use carom_table::row;
use follow::{Wanted, follow};
use view::Traction;
pub use view::{Step, all_columns};

/// Loads of a contact along a history of shifts and twists, with memory.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm", its steps inline or, plain, in a
/// CSV file; see examples/history_*.toml. xi and eta shift body 2 against body 1 along x and y, zeta
/// presses it in, omega (radians) twists it about z. The picture shows loads, stick area and energy,
/// and the last tractions asked for.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Give the tangential traction after each step at this many radii, from the centre to the
    /// edge.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    tractions: Option<u32>,
}

pub(super) fn run(arguments: &Arguments, results: &mut Results) -> Result<Answer, CliError> {
    let command::Given { case: file, plot } = arguments.given.read()?;
    let path = &file.path;
    let case = file.parse(HistoryCase::parse)?;
    let shifts = match &case.steps {
        Steps::Inline(shifts) => shifts.clone(),
        Steps::File(name) => read_steps(&file, name)?,
    };
    let format = arguments.given.format;
    let radii = arguments.tractions.map_or(0, |count| count as usize);
    check_count(format, shifts.len().saturating_mul(radii.max(1)))?;
    let wanted = Wanted { radii, picture: plot.is_some() };
    let at_fault = |source| CliError::Law { path: path.clone(), source };
    let radius = smallest_radius(&case.hertz);
    let columns = view::columns(&shifts);
    let (mut steps, mut tractions) =
        (Rows::new(format), Rows::new(format).of(view::TRACTION_COLUMNS));
    let (mut worst, mut limits, mut first) = (Worst::default(), Limits::default(), 0);
    let drawn = follow(&case, &shifts, wanted, at_fault, |history| {
        let cells = |step: &Step| row(&columns, Some(step));
        columns::check_rows(path, history, [first, shifts.len()], cells)?;
        first += history.len();
        for step in history.iter() {
            worst.add(Excess::of_contact(step.shift.zeta, radius));
            limits.add(step);
        }
        if format != Format::Csv || radii == 0 {
            let json = |step: &Step, depth| indented(&view::record(&columns, step), depth);
            steps.put(history, cells, json, results)?;
        }
        if matches!(format, Format::Csv | Format::Table) && radii > 0 {
            let given: Vec<_> = history.iter().flat_map(|step| &step.tractions).collect();
            let cells = |traction: &&Traction| row(view::TRACTION_COLUMNS, Some(traction));
            tractions.put(&given, cells, |_, _| Ok(String::new()), results)?;
        }
        Ok(())
    })?;
    let text = match (format, radii) {
        (Format::Csv, 1..) => tractions.finish()?,
        (Format::Table, 1..) => steps.finish()? + &tractions.finish()?,
        _ => steps.finish()?,
    };
    let picture = plot.map(|to| (to, plot::draw(&drawn)));
    let warnings = warnings(&case, &limits, arguments.tractions.is_some());
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(worst.caution("steps"), format))
}

/// The contact after each step of a history; files that the case names lie beside it.
///
/// # Errors
/// If the case is bad, a file cannot be read, or a law refuses a value.
pub fn followed(file: &CaseFile) -> Result<Vec<Step>, CliError> {
    let case = file.parse(HistoryCase::parse)?;
    let shifts = match &case.steps {
        Steps::Inline(shifts) => shifts.clone(),
        Steps::File(name) => read_steps(file, name)?,
    };
    let at_fault = |source| CliError::Law { path: file.path.clone(), source };
    let wanted = Wanted { radii: 0, picture: false };
    let mut all = Vec::with_capacity(shifts.len());
    follow(&case, &shifts, wanted, at_fault, |steps| {
        all.append(steps);
        Ok(())
    })?;
    Ok(all)
}

/// What the rows hold.
fn help() -> String {
    let steps = columns::help("A row for each step", view::COLUMNS);
    let twists = columns::help("with a twist also", view::TWIST_COLUMNS);
    let tractions =
        columns::help("With --tractions as CSV, a row for each radius", view::TRACTION_COLUMNS);
    format!("{steps}{twists}\n{tractions}")
}

/// How close shift and twist come to their friction limits.
#[derive(Debug, Default)]
struct Limits {
    is_twisted: bool,
    /// The greatest share of both at once.
    both: f64,
}

impl Limits {
    fn add(&mut self, step: &Step) {
        self.is_twisted |= step.twist.is_some();
        self.both = step.twist.map_or(0.0, |twist| twist.share.min(step.share)).max(self.both);
    }
}

/// What the law neglects in this case.
fn warnings(case: &HistoryCase, limits: &Limits, has_tractions: bool) -> Vec<String> {
    let mut warnings = Vec::new();
    let materials = case.hertz.materials();
    if !materials.is_uncoupled() {
        let gamma = materials.gamma();
        warnings.push(format!(
            "dissimilar materials: gamma = {gamma:.4}, f/|gamma| = {:.3}; the coupling of normal \
             and tangential displacements is neglected",
            case.friction / gamma.abs()
        ));
    }
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
        let tractions = if has_tractions { "; its tractions are left out" } else { "" };
        warnings.push(format!(
            "the contact is no circle: between no slip and sliding the law of the twist is an \
             approximation{tractions}"
        ));
    }
    if limits.both > 0.01 {
        let percent = 100.0 * limits.both;
        warnings.push(format!(
            "shift and twist are computed each as if the other were absent, which is right while \
             one of them is small: both reach {percent:.0} % of their friction limits at once"
        ));
    }
    warnings
}
