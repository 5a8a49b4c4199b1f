//! Why the results of a case may be inaccurate.

use super::follow::Followed;
use crate::case::{GridCase, SolveCase};
use carom_solver::{ContactState, Estimates, GridWarning, StepSummary};

impl Followed {
    /// What is told as warnings of a case that was run.
    #[must_use]
    pub fn warnings(&self, case: &SolveCase) -> Vec<String> {
        let last = self.steps.last();
        let few = last.and_then(|last| few_cells(&self.state, last.estimates));
        let told = self.told.iter().cloned();
        let mut warnings: Vec<String> = told.chain(few).chain(unestimated(case, self)).collect();
        warnings.extend(untouched(&self.steps));
        warnings.extend(self.large());
        warnings.extend(self.validity_report().told("steps").1);
        warnings.extend(unreached(case, &self.steps));
        warnings
    }
}

/// A warning if the bodies do not touch in any step.
fn untouched(steps: &[StepSummary]) -> Option<String> {
    let are_apart = !steps.is_empty() && steps.iter().all(|step| step.contact_area == 0.0);
    are_apart.then(|| {
        "no contact in any step: a greater `zeta` or `F_z` > 0 presses the bodies together, unless \
         `grid.size`, in m, makes cells so wide that they miss the place where the bodies are closest"
            .to_owned()
    })
}

/// A warning if a plate has no error estimates.
fn unestimated(case: &SolveCase, followed: &Followed) -> Option<String> {
    let missing = followed.steps.last().is_some_and(|step| step.estimates.is_none());
    (case.plate.is_some() && missing).then(|| {
        let grid = followed.window.grid();
        let nested = [grid.nx(), grid.ny()].iter().all(|count| count.is_multiple_of(4));
        let reason = match nested {
            true => "a coarser grid could not be solved",
            false => "on a plate both numbers of `grid.cells` must be divisible by 4",
        };
        format!("no error estimate is available: {reason}")
    })
}

/// A warning if a contact is only a few cells wide, with its errors if they are estimated.
#[must_use]
pub fn few_cells(state: &ContactState, estimates: Option<Estimates>) -> Option<String> {
    let across = state.warnings().into_iter().find_map(|warning| match warning {
        GridWarning::FewCells { across } => Some(across),
        GridWarning::Border { .. } | GridWarning::LargeDisplacement { .. } => None,
    })?;
    let error = estimates.map(|all| Estimates::worst(&[all]));
    let error = match error {
        None => "no error estimate is available".to_owned(),
        Some(error) if error < 1.0 => {
            format!("the estimated error of loads and shifts is {:.1} %", 100.0 * error)
        }
        Some(_) => "the error of loads and shifts cannot be estimated on this grid".to_owned(),
    };
    let cells = if across == 1 { "cell" } else { "cells" };
    Some(format!("the contact is only {across} {cells} wide: {error}"))
}

/// A warning if steps within the legs, or increments between steps, have larger errors than
/// requested.
fn unreached(case: &SolveCase, steps: &[StepSummary]) -> Option<String> {
    let GridCase::Accuracy(accuracy) = case.grid else { return None };
    let all: Option<Vec<Estimates>> = steps.iter().map(|step| step.estimates).collect();
    let reached = all.map_or(f64::INFINITY, |all| Estimates::worst(&all));
    (reached > accuracy).then(|| {
        format!(
            "estimated errors reach {reached:.1e} within the history, above {accuracy}; request a \
             higher accuracy"
        )
    })
}
