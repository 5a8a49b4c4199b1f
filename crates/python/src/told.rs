//! What results exceed of the theory, as the command tells it.

use carom::impact::Outcome;
use carom_cases::theory::{Excess, Warnings, Worst};

/// The warnings of many impacts: whether they lie outside the theory, then each kind once, in its worst form.
pub(crate) fn of_impacts(outcomes: &[Outcome]) -> Vec<String> {
    let (mut warnings, mut worst) = (Warnings::default(), Worst::default());
    for (i, outcome) in outcomes.iter().enumerate() {
        let rebound = outcome.rebound();
        let exceeded = rebound.map_or(&[][..], |rebound| &rebound.warnings);
        warnings.add(|| format!("at entry {i}"), exceeded);
        worst.add(rebound.map(Excess::of_impact).unwrap_or_default());
    }
    together(worst.caution("impacts"), warnings.told("impacts"))
}

/// The warning on results outside the theory, then all others.
pub(crate) fn together(caution: Option<String>, warnings: Vec<String>) -> Vec<String> {
    caution.into_iter().chain(warnings).collect()
}
