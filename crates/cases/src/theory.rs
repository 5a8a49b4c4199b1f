//! Checks whether results lie within the theory and reports the worst case once.

use carom_impact::{Rebound, Warning};
use carom_table::short;

/// Largest approach over the radius of curvature for which the bodies count as half-spaces.
const MAX_APPROACH_OVER_RADIUS: f64 = 0.1;
/// Largest semi-axis over the smallest radius of the bodies for which Hertz's theory holds.
const LARGE_CONTACT: f64 = 0.1;
/// Largest share of the energy that elastic waves may carry away, since the theory neglects them.
const MAX_WAVE_SHARE: f64 = 0.1;

const APPROXIMATE: &str = "The results are approximate.";
const MEANINGLESS: &str = "The results are meaningless. Is a unit wrong? Plain numbers are SI, others are \
                      texts such as \"380 GPa\" or \"2.5 mm\".";

/// How far results exceed the limits of the theory; empty if they lie within.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Excess {
    /// Approach over radius of curvature.
    approach: Option<f64>,
    /// Energy of waves over kinetic energy of the approach.
    waves: Option<f64>,
}

impl Excess {
    /// The excess of a contact with this approach and smallest radius of curvature.
    #[must_use]
    pub fn of_contact(approach: f64, radius: f64) -> Self {
        let share = approach / radius;
        Self { approach: (share > MAX_APPROACH_OVER_RADIUS).then_some(share), waves: None }
    }

    /// The excess of an impact, from its warnings.
    #[must_use]
    pub fn of_impact(rebound: &Rebound) -> Self {
        rebound.warnings.iter().fold(Self::default(), |worst, warning| match warning {
            Warning::LargeContact { ratio } => {
                let contact = rebound.maximal_contact;
                let radius = contact.semi_axis_a().max(contact.semi_axis_b()) / ratio;
                worst.and(Self::of_contact(rebound.maximal_approach, radius))
            }
            Warning::WaveLoss { share } if *share > MAX_WAVE_SHARE => {
                worst.and(Self { approach: None, waves: Some(*share) })
            }
            _ => worst,
        })
    }

    /// The worse of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let worst = |one: Option<f64>, other: Option<f64>| match (one, other) {
            (Some(one), Some(other)) => Some(one.max(other)),
            (one, other) => one.or(other),
        };
        Self {
            approach: worst(self.approach, other.approach),
            waves: worst(self.waves, other.waves),
        }
    }

    /// Whether the approach exceeds the radius, or the waves the available energy.
    fn is_meaningless(self) -> bool {
        [self.approach, self.waves].into_iter().flatten().any(|share| share > 1.0)
    }

    fn is_some(self) -> bool {
        self != Self::default()
    }

    /// One text for each limit that is exceeded.
    #[must_use]
    pub fn reasons(self) -> Vec<String> {
        let approach = self.approach.map(|share| {
            format!("the approach is {} times the radius, more than a tenth", readable(share))
        });
        let waves = self.waves.map(|share| {
            let percent = readable(100.0 * share);
            format!("elastic waves would carry away {percent} % of the energy, more than 10 %")
        });
        approach.into_iter().chain(waves).collect()
    }
}

/// The warning on a contact with this larger semi-axis between bodies with this smallest radius of
/// curvature, as for impacts.
#[must_use]
pub fn large_contact(semi_axis: f64, radius: f64) -> Option<Warning> {
    let ratio = semi_axis / radius;
    (ratio > LARGE_CONTACT).then_some(Warning::LargeContact { ratio })
}

/// A number with three digits.
#[must_use]
pub fn readable(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
}

/// The warning on results outside the theory; `None` if all lie within. `what` names several
/// results.
#[must_use]
pub fn caution(excesses: &[Excess], what: &str) -> Option<String> {
    let mut worst = Worst::default();
    excesses.iter().for_each(|excess| worst.add(*excess));
    worst.caution(what)
}

/// The worst of many excesses, added one by one.
#[derive(Debug, Clone, Copy, Default)]
pub struct Worst {
    excess: Excess,
    concerned: usize,
    all: usize,
}

impl Worst {
    /// Adds a result.
    pub fn add(&mut self, excess: Excess) {
        self.excess = self.excess.and(excess);
        self.concerned += usize::from(excess.is_some());
        self.all += 1;
    }

    /// The warning as in [`caution`], for all of them.
    #[must_use]
    pub fn caution(&self, what: &str) -> Option<String> {
        if !self.excess.is_some() {
            return None;
        }
        let place = match self.all {
            1 => String::new(),
            all => format!(" at {} of {all} {what}", self.concerned),
        };
        let reasons = self.excess.reasons().join("; ");
        let advice = if self.excess.is_meaningless() { MEANINGLESS } else { APPROXIMATE };
        Some(format!("OUTSIDE THE THEORY{place}: {reasons}. {advice}"))
    }
}

/// Warnings of many results, added one by one: each kind once, in the order of occurrence, in its
/// worst form and with the number of results concerned.
#[derive(Debug, Clone, Default)]
pub struct Warnings {
    kinds: Vec<(Warning, String, usize)>,
    all: usize,
}

impl Warnings {
    /// Adds the warnings of one result; `place` names it, for example `at 5°`.
    pub fn add(&mut self, place: impl Fn() -> String, warnings: &[Warning]) {
        self.all += 1;
        for warning in warnings {
            let kind = std::mem::discriminant(warning);
            match self.kinds.iter_mut().find(|(known, ..)| std::mem::discriminant(known) == kind) {
                None => self.kinds.push((*warning, place(), 1)),
                Some((worst, at, count)) => {
                    *count += 1;
                    if severity(warning) > severity(worst) {
                        (*worst, *at) = (*warning, place());
                    }
                }
            }
        }
    }

    /// Number of results so far.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.all
    }

    /// The texts of the warnings; `what` names all results.
    #[must_use]
    pub fn told(self, what: &str) -> Vec<String> {
        let all = self.all;
        let told = self.kinds.into_iter().map(|(worst, place, count)| match all {
            1 => worst.to_string(),
            _ if severity(&worst).is_none() => format!("{worst} ({count} of {all} {what})"),
            _ => format!("{worst} ({count} of {all} {what} concerned, the worst {place})"),
        });
        told.collect()
    }
}

/// The number that makes a warning worse than another of its kind.
fn severity(warning: &Warning) -> Option<f64> {
    match warning {
        Warning::WaveLoss { share } | Warning::SpinLeftAlone { share } => Some(*share),
        Warning::LargeContact { ratio } => Some(*ratio),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kind_of_warning_is_told_once_in_its_worst_form() {
        let shares = [0.02, 0.05, 0.03].map(|share| vec![Warning::WaveLoss { share }]);
        let places = ["at 5°", "at 10°", "at 15°", "at 20°"].map(str::to_owned);
        let concerned = places.into_iter().zip(shares.iter().map(Vec::as_slice).chain([&[][..]]));
        let mut warnings = Warnings::default();
        concerned.for_each(|(place, shares)| warnings.add(|| place.clone(), shares));
        let told = warnings.told("angles");
        assert_eq!(
            told,
            [
                "elastic waves carry away about 5.00 % of the normal energy (3 of 4 angles concerned, \
              the worst at 10°)"
            ]
        );
    }

    #[test]
    fn what_lies_outside_the_theory_is_said_with_its_limit() {
        let within = Excess::of_contact(0.1, 1.0);
        let outside =
            Excess::of_contact(0.5, 2.0).and(Excess { approach: None, waves: Some(11.6) });
        assert_eq!(caution(&[within], "angles"), None);
        let text = caution(&[within, outside], "angles").unwrap();
        assert!(
            text.starts_with("OUTSIDE THE THEORY at 1 of 2 angles: the approach is 0.25 times")
        );
        assert!(text.contains("carry away 1160 % of the energy, more than 10 %"), "{text}");
        assert!(text.contains("Is a unit wrong?"), "{text}");
        let rough = Excess { approach: None, waves: Some(0.16) };
        assert!(caution(&[rough], "").unwrap().ends_with("The results are approximate."));
    }
}
