//! `carom history`: loads of a contact along a history of shifts.

mod laws;
mod plot;
mod steps;
mod twist;
mod view;

pub use steps::StepsError;

use crate::case::{HistoryCase, Steps};
use crate::command::CaseArguments;
use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, check_finite, csv, json, read_case, short, table};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_laws::stiffness::ContactStiffness;
use laws::Laws;
use std::path::{Path, PathBuf};
use view::Step;

/// Loads of a contact along a history of shifts and twists, with memory.
///
/// The file is TOML in SI units, its steps inline or in a CSV file; see examples/history_*.toml.
/// xi and eta shift body 2 against body 1 along x and y, zeta presses it in, omega (radians) twists
/// it about z.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Draw loads and stick area, and the last tractions asked for, into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Give the tangential traction after each step at this many radii, from the centre to the
    /// edge.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    tractions: Option<u32>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let path = &arguments.given.case;
    let case = read_case(path, HistoryCase::parse)?;
    let shifts = match &case.steps {
        Steps::Inline(shifts) => shifts.clone(),
        Steps::File(name) => steps::read(&path.parent().unwrap_or(Path::new("")).join(name))?,
    };
    let history = follow(&case, &shifts, arguments)?;
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
    };
    let plot = match &arguments.plot {
        Some(file) => Some(PlotFile { path: file.clone(), svg: plot::draw(&history)? }),
        None => None,
    };
    Ok(Answer { text, warnings: warnings(&case, &history, arguments.tractions.is_some()), plot })
}

fn follow(
    case: &HistoryCase,
    shifts: &[Shift],
    arguments: &Arguments,
) -> Result<Vec<Step>, CliError> {
    let at_fault = |source| CliError::Law { path: arguments.given.case.clone(), source };
    let friction = Friction::new(case.friction).map_err(at_fault)?;
    if arguments.tractions.is_some() && friction.coefficient().is_none() {
        return Err(CliError::Options("--tractions takes a case with finite friction"));
    }
    let mut laws = Laws::new(case, friction, shifts).map_err(at_fault)?;
    let count = arguments.tractions.map_or(0, |count| count as usize);
    shifts
        .iter()
        .enumerate()
        .map(|(i, shift)| {
            laws.advance(*shift).map_err(at_fault)?;
            view::step(i + 1, &laws, friction, count)
        })
        .collect()
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
