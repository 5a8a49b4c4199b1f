//! Checks whether results lie within the theory and reports the worst case once.

use carom_impact::{Rebound, Warning};
use carom_laws::validity::Validity;
use carom_table::short;

const APPROXIMATE: &str = "The results are approximate.";
const MEANINGLESS: &str = "The results are meaningless. Is a unit wrong? Plain numbers are SI, others are \
                      texts such as \"380 GPa\" or \"2.5 mm\".";

/// A number with three digits.
#[must_use]
pub fn readable(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
}

/// The warning on results outside the theory; `None` if all lie within. `what` names several
/// results.
#[must_use]
pub fn caution(validities: &[Validity], what: &str) -> Option<String> {
    let mut worst = Worst::default();
    validities.iter().for_each(|validity| worst.add(*validity));
    worst.caution(what)
}

/// The worst of many results, added one by one.
#[derive(Debug, Clone, Copy, Default)]
pub struct Worst {
    validity: Validity,
    concerned: usize,
    all: usize,
}

impl Worst {
    /// Adds a result.
    pub fn add(&mut self, validity: Validity) {
        self.validity = self.validity.and(validity);
        self.concerned += usize::from(validity.is_outside());
        self.all += 1;
    }

    /// The worst of all, in each ratio.
    #[must_use]
    pub const fn validity(&self) -> Validity {
        self.validity
    }

    /// The warning as in [`caution`], for all of them.
    #[must_use]
    pub fn caution(&self, what: &str) -> Option<String> {
        if !self.validity.is_outside() {
            return None;
        }
        let place = match self.all {
            1 => String::new(),
            all => format!(" at {} of {all} {what}", self.concerned),
        };
        let reasons = self.validity.reasons().join("; ");
        let advice = if self.validity.is_meaningless() { MEANINGLESS } else { APPROXIMATE };
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

/// What many contacts exceed, added one by one.
#[derive(Debug, Clone, Default)]
pub struct Heed {
    warnings: Warnings,
    worst: Worst,
}

impl Heed {
    /// Adds a contact; `place` names it, for example `at step 5`.
    pub fn add(&mut self, place: impl Fn() -> String, validity: Validity) {
        self.warnings.add(place, &Warning::of(validity).collect::<Vec<_>>());
        self.worst.add(validity);
    }

    /// Adds an impact with its warnings; `place` gets its number, from 1.
    pub fn add_impact(&mut self, place: impl Fn(usize) -> String, rebound: &Rebound) {
        let number = self.warnings.count() + 1;
        self.warnings.add(|| place(number), &rebound.warnings);
        self.worst.add(rebound.validity);
    }

    /// The worst of all, in each ratio.
    #[must_use]
    pub const fn validity(&self) -> Validity {
        self.worst.validity()
    }

    /// The warning on results outside the theory, and the texts of all other warnings; `what` names all.
    #[must_use]
    pub fn told(self, what: &str) -> (Option<String>, Vec<String>) {
        (self.worst.caution(what), self.warnings.told(what))
    }
}

/// The number that makes a warning worse than another of its kind.
fn severity(warning: &Warning) -> Option<f64> {
    match warning {
        Warning::WaveLoss { share } | Warning::SpinLeftAlone { share } => Some(*share),
        Warning::LargeContact { ratio } | Warning::Yields { ratio } => Some(*ratio),
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
        let of = |approach_over_radius, wave_share| Validity {
            approach_over_radius,
            wave_share,
            ..Validity::default()
        };
        let [within, outside] = [of(0.1, 0.0), of(0.25, 0.0).and(of(0.0, 11.6))];
        assert_eq!(caution(&[within], "angles"), None);
        let text = caution(&[within, outside], "angles").unwrap();
        assert!(
            text.starts_with("OUTSIDE THE THEORY at 1 of 2 angles: the approach is 0.25 times")
        );
        assert!(text.contains("carry away 1160 % of the energy, more than 10 %"), "{text}");
        assert!(text.contains("Is a unit wrong?"), "{text}");
        assert!(caution(&[of(0.0, 0.16)], "").unwrap().ends_with("The results are approximate."));
    }
}
