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
use crate::command::theory::{Excess, caution};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::input::CaseFile;
use crate::output::{Answer, Format, json};
use carom_laws::stiffness::ContactStiffness;
use follow::{Wanted, follow};
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

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let command::Given { case: file, plot } = arguments.given.read()?;
    let path = &file.path;
    let case = file.parse(HistoryCase::parse)?;
    let shifts = match &case.steps {
        Steps::Inline(shifts) => shifts.clone(),
        Steps::File(name) => read_steps(&file, name)?,
    };
    let radii = arguments.tractions.map_or(0, |count| count as usize);
    let followed = follow(&case, &shifts, Wanted { radii, picture: plot.is_some() }, |source| {
        CliError::Law { path: path.clone(), source }
    })?;
    let history = &followed.steps;
    let columns = view::columns(history);
    columns::check(path, &columns, history)?;
    let format = arguments.given.format;
    let steps = || columns::rows(format, &columns, history);
    let tractions = || {
        let tractions: Vec<_> = history.iter().flat_map(|step| step.tractions.clone()).collect();
        columns::rows(format, view::TRACTION_COLUMNS, &tractions)
    };
    let text = match (format, arguments.tractions) {
        (Format::Json, _) => json(&view::records(&columns, history))?,
        (Format::Csv, Some(_)) => tractions()?,
        (Format::Table, Some(_)) => steps()? + &tractions()?,
        _ => steps()?,
    };
    let picture = plot.map(|to| (to, plot::draw(&followed)));
    let warnings = warnings(&case, history, arguments.tractions.is_some());
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    let radius = smallest_radius(&case.hertz);
    let excesses: Vec<Excess> =
        history.iter().map(|step| Excess::of_contact(step.shift.zeta, radius)).collect();
    Ok(answer.cautioned(caution(&excesses, "steps"), format))
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
    Ok(follow(&case, &shifts, wanted, at_fault)?.steps)
}

/// What the rows hold.
fn help() -> String {
    let steps = columns::help("A row for each step", view::COLUMNS);
    let twists = columns::help("with a twist also", view::TWIST_COLUMNS);
    let tractions =
        columns::help("With --tractions as CSV, a row for each radius", view::TRACTION_COLUMNS);
    format!("{steps}{twists}\n{tractions}")
}

/// What the law neglects in this case.
fn warnings(case: &HistoryCase, history: &[Step], has_tractions: bool) -> Vec<String> {
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
    if !history.iter().any(|step| step.twist.is_some()) {
        return warnings;
    }
    if (case.hertz.axis_ratio().get() - 1.0).abs() > 1e-12 {
        let tractions = if has_tractions { "; its tractions are left out" } else { "" };
        warnings.push(format!(
            "the contact is no circle: between no slip and sliding the law of the twist is an \
             approximation{tractions}"
        ));
    }
    let both = |step: &Step| step.twist.map_or(0.0, |twist| twist.share.min(step.share));
    let most = history.iter().map(both).fold(0.0, f64::max);
    if most > 0.01 {
        let percent = 100.0 * most;
        warnings.push(format!(
            "shift and twist are computed each as if the other were absent, which is right while \
             one of them is small: both reach {percent:.0} % of their friction limits at once"
        ));
    }
    warnings
}
