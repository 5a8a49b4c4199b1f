//! `carom history`: loads of a contact along a history of shifts.

mod laws;
mod plot;
mod steps;
mod twist;
mod view;

pub use steps::StepsError;

use crate::case::{HistoryCase, Steps};
use crate::command::hertz::smallest_radius;
use crate::command::theory::{Excess, caution};
use crate::command::{self, CaseArguments};
use crate::destination::{Destination, check_output};
use crate::error::CliError;
use crate::output::{Answer, Format, check_finite, csv, json, short, table};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_laws::stiffness::ContactStiffness;
use laws::Laws;
use std::path::Path;
use view::Step;

/// Loads of a contact along a history of shifts and twists, with memory.
///
/// The file is TOML in SI units, its steps inline or in a CSV file; see examples/history_*.toml.
/// xi and eta shift body 2 against body 1 along x and y, zeta presses it in, omega (radians) twists
/// it about z. The picture shows loads, stick area and energy, and the last tractions asked for.
#[derive(Debug, clap::Args)]
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
        Steps::File(name) => {
            read_steps(&path.parent().unwrap_or(Path::new("")).join(name), arguments)?
        }
    };
    let (history, course) = follow(&case, &shifts, arguments, plot.is_some())?;
    let rows = view::cells(&history, |value| value.to_string());
    check_finite(path, &view::heads(&history), &rows)?;
    let text = match arguments.given.format {
        Format::Json => json(&history)?,
        Format::Csv if arguments.tractions.is_some() => {
            csv(&view::TRACTION_HEADS, &view::traction_cells(&history, |value| value.to_string()))?
        }
        Format::Csv => csv(&view::heads(&history), &rows)?,
        Format::Table => {
            let mut text = table(&view::heads(&history), &view::cells(&history, short));
            if arguments.tractions.is_some() {
                text += &table(&view::TRACTION_HEADS, &view::traction_cells(&history, short));
            }
            text
        }
        Format::None => String::new(),
    };
    let picture = plot.map(|to| (to, plot::draw(&history, &course)));
    let warnings = warnings(&case, &history, arguments.tractions.is_some());
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    let radius = smallest_radius(&case.hertz);
    let excesses: Vec<Excess> =
        history.iter().map(|step| Excess::of_contact(step.zeta, radius)).collect();
    Ok(answer.cautioned(caution(&excesses, "steps"), arguments.given.format))
}

/// The steps in a file, which no output may overwrite either.
fn read_steps(path: &Path, arguments: &Arguments) -> Result<Vec<Shift>, CliError> {
    check_output(path)?;
    if let Some(plot) = &arguments.given.plot {
        Destination::new("plot", plot, arguments.given.format, &[path])?;
    }
    steps::read(path)
}

/// The state after every step, and if it is to be drawn also between them.
fn follow(
    case: &HistoryCase,
    shifts: &[Shift],
    arguments: &Arguments,
    is_drawn: bool,
) -> Result<(Vec<Step>, Vec<Step>), CliError> {
    let at_fault = |source| CliError::Law { path: arguments.given.case.clone(), source };
    let friction = Friction::new(case.friction).map_err(at_fault)?;
    if arguments.tractions.is_some() && friction.coefficient().is_none() {
        return Err(CliError::Options("--tractions takes a case with finite friction"));
    }
    let mut laws = Laws::new(case, friction, shifts).map_err(at_fault)?;
    let count = arguments.tractions.map_or(0, |count| count as usize);
    let radius = smallest_radius(&case.hertz);
    let parts = if is_drawn { parts_of_a_step(shifts.len()) } else { 1 };
    let (mut history, mut course) = (Vec::new(), Vec::new());
    for (i, shift) in shifts.iter().enumerate() {
        let from = laws.present();
        for part in 0..parts {
            // From the same state each, so that the line runs through the steps themselves.
            let mut between = laws.clone();
            let part = part as f64 / parts as f64;
            if is_drawn && (part > 0.0 || i == 0) {
                between.advance(lerp(from, *shift, part)).map_err(at_fault)?;
                course.push(view::step(i as f64 + part, &between, friction, 0, radius)?);
            }
        }
        laws.advance(*shift).map_err(at_fault)?;
        let number = (i + 1) as f64;
        history.push(view::step(number, &laws, friction, count, radius)?);
        course.push(view::step(number, &laws, friction, 0, radius)?);
    }
    Ok((history, course))
}

/// States drawn for every step, the last its own: enough for a smooth line.
fn parts_of_a_step(steps: usize) -> usize {
    (2000 / steps).clamp(1, 50)
}

/// The shift at a part of the way from one to the other.
fn lerp(from: Shift, to: Shift, part: f64) -> Shift {
    let between = |from: f64, to: f64| from + part * (to - from);
    Shift {
        zeta: between(from.zeta, to.zeta),
        xi: between(from.xi, to.xi),
        eta: between(from.eta, to.eta),
        omega: between(from.omega, to.omega),
    }
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
