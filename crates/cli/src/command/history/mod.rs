//! `carom history`: loads of a contact along a history of shifts.

mod follow;
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
use carom_laws::law::Shift;
use carom_laws::stiffness::ContactStiffness;
use follow::{Wanted, follow};
use std::path::Path;
use view::Step;

/// Loads of a contact along a history of shifts and twists, with memory.
///
/// The file is TOML in SI units, others as texts such as "2.5 mm", its steps inline or, plain, in a
/// CSV file; see examples/history_*.toml. xi and eta shift body 2 against body 1 along x and y, zeta
/// presses it in, omega (radians) twists it about z. The picture shows loads, stick area and energy,
/// and the last tractions asked for.
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
    let radii = arguments.tractions.map_or(0, |count| count as usize);
    let followed = follow(&case, &shifts, Wanted { radii, picture: plot.is_some() }, |source| {
        CliError::Law { path: path.clone(), source }
    })?;
    let history = &followed.steps;
    let rows = view::cells(history, |value| value.to_string());
    check_finite(path, &view::heads(history), &rows)?;
    let text = match arguments.given.format {
        Format::Json => json(history)?,
        Format::Csv if arguments.tractions.is_some() => {
            csv(&view::TRACTION_HEADS, &view::traction_cells(history, |value| value.to_string()))?
        }
        Format::Csv => csv(&view::heads(history), &rows)?,
        Format::Table => {
            let mut text = table(&view::heads(history), &view::cells(history, short));
            if arguments.tractions.is_some() {
                text += &table(&view::TRACTION_HEADS, &view::traction_cells(history, short));
            }
            text
        }
        Format::None => String::new(),
    };
    let picture = plot.map(|to| (to, plot::draw(&followed)));
    let warnings = warnings(&case, history, arguments.tractions.is_some());
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
