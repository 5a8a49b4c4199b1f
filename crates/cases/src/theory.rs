//! Checks whether results lie within the theory and reports the worst case once.

use carom_impact::{Rebound, Warning};
use carom_laws::validity::{Limit, Validity};
use carom_table::short;

const APPROXIMATE: &str = "The results are approximate.";
const MEANINGLESS: &str = "The results are meaningless. Is a unit wrong? Plain numbers are SI; in a case file \
                      texts such as \"380 GPa\" or \"2.5 mm\" have their own.";

/// A number with three digits.
#[must_use]
pub fn readable(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
}

/// What many results exceed, added one by one: the worst of all, and their warnings, each kind once, in the order of
/// occurrence, in its worst form and with the number of results concerned.
#[derive(Debug, Clone, Default)]
pub struct ValidityReport {
    kinds: Vec<Kind>,
    validity: Validity,
    /// Number of results outside the theory.
    outside: usize,
    all: usize,
}

/// A kind of warning and the results concerned.
#[derive(Debug, Clone)]
struct Kind {
    worst: Warning,
    /// Where it is worst.
    place: String,
    count: usize,
    /// Whether its number differs between results.
    varies: bool,
}

impl ValidityReport {
    /// Adds a contact; `place` names it, for example `at step 5`.
    pub fn add(&mut self, place: impl Fn() -> String, validity: Validity) {
        self.add_warned(place, &Warning::of(validity).collect::<Vec<_>>(), validity);
    }

    /// Adds an impact with its warnings; `place` gets its number, from 1.
    pub fn add_impact(&mut self, place: impl Fn(usize) -> String, rebound: &Rebound) {
        let number = self.all + 1;
        self.add_warned(|| place(number), &rebound.warnings, rebound.validity);
    }

    /// Adds a result with its warnings; `place` names it.
    pub fn add_warned(
        &mut self,
        place: impl Fn() -> String,
        warnings: &[Warning],
        validity: Validity,
    ) {
        self.validity = self.validity.and(validity);
        self.outside += usize::from(validity.is_outside());
        self.all += 1;
        // The caution tells of the approach.
        let is_told = |warning: &&Warning| warning.ratio(Limit::LargeApproach).is_none();
        for warning in warnings.iter().filter(is_told) {
            match self.kinds.iter_mut().find(|kind| is_alike(&kind.worst, warning)) {
                None => {
                    let (worst, place) = (*warning, place());
                    self.kinds.push(Kind { worst, place, count: 1, varies: false });
                }
                Some(kind) => {
                    kind.count += 1;
                    kind.varies |= severity(warning) != severity(&kind.worst);
                    if severity(warning) > severity(&kind.worst) {
                        (kind.worst, kind.place) = (*warning, place());
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

    /// The worst of all, in each ratio.
    #[must_use]
    pub const fn validity(&self) -> Validity {
        self.validity
    }

    /// The warning on results outside the theory, if any are, and the texts of all other warnings; `what` names
    /// several results.
    #[must_use]
    pub fn told(self, what: &str) -> (Option<String>, Vec<String>) {
        let (all, caution) = (self.all, self.caution(what));
        let told = self.kinds.into_iter().map(|Kind { worst, place, count, varies }| match all {
            1 => worst.to_string(),
            _ if count == all && !varies => worst.to_string(),
            _ if severity(&worst).is_none() => format!("{worst} ({count} of {all} {what})"),
            _ => format!("{worst} ({count} of {all} {what} concerned, the worst {place})"),
        });
        (caution, told.collect())
    }

    fn caution(&self, what: &str) -> Option<String> {
        if !self.validity.is_outside() {
            return None;
        }
        let place = match self.all {
            1 => String::new(),
            all => format!(" at {} of {all} {what}", self.outside),
        };
        let reasons = self.validity.reasons().join("; ");
        let advice = if self.validity.is_meaningless() { MEANINGLESS } else { APPROXIMATE };
        Some(format!("OUTSIDE THE THEORY{place}: {reasons}. {advice}"))
    }
}

/// Whether two warnings are of the same kind.
fn is_alike(one: &Warning, other: &Warning) -> bool {
    match (one, other) {
        (Warning::Exceeds(one), Warning::Exceeds(other)) => one.limit == other.limit,
        _ => std::mem::discriminant(one) == std::mem::discriminant(other),
    }
}

/// The number that makes a warning worse than another of its kind.
fn severity(warning: &Warning) -> Option<f64> {
    match warning {
        Warning::Exceeds(excess) => Some(excess.value),
        Warning::UnknownLoss { share } => Some(*share),
        Warning::NotSettled { error_estimate, .. } => Some(*error_estimate),
        Warning::PointSampled => None,
    }
}

#[cfg(test)]
mod tests {
    use carom_laws::validity::Excess;

    use super::*;

    #[test]
    fn a_kind_of_warning_is_told_once_in_its_worst_form() {
        let shares = [0.02, 0.05, 0.03]
            .map(|value| vec![Warning::Exceeds(Excess { limit: Limit::Waves, value })]);
        let places = ["at 5°", "at 10°", "at 15°", "at 20°"].map(str::to_owned);
        let concerned = places.into_iter().zip(shares.iter().map(Vec::as_slice).chain([&[][..]]));
        let mut report = ValidityReport::default();
        concerned.for_each(|(place, shares)| {
            report.add_warned(|| place.clone(), shares, Validity::default())
        });
        let (_, told) = report.told("angles");
        assert_eq!(
            told,
            ["elastic waves would carry away more than 1 % of the normal energy: about 5 % \
                 (3 of 4 angles concerned, the worst at 10°)"]
        );
    }

    #[test]
    fn each_kind_of_warning_is_counted_and_told_in_its_worst_form() {
        let (sampled, mut report) = (Warning::PointSampled, ValidityReport::default());
        let unknown = |share| Warning::UnknownLoss { share };
        let unsettled = |error_estimate| Warning::NotSettled { error_estimate, tolerance: 1e-9 };
        for (place, warnings) in [
            ("at a", vec![sampled, unknown(0.02), unsettled(1e-3)]),
            ("at b", vec![sampled, unknown(0.05), unsettled(1e-5)]),
            ("at c", vec![unknown(0.03)]),
        ] {
            report.add_warned(|| place.to_owned(), &warnings, Validity::default());
        }
        let (_, told) = report.told("angles");
        assert!(told.len() == 3 && told[0].ends_with("(2 of 3 angles)"), "{told:?}");
        let ends = "(3 of 3 angles concerned, the worst at b)";
        assert!(told[1].starts_with("the rebound depends") && told[1].ends_with(ends), "{told:?}");
        assert!(told[1].contains("0.05") || told[1].contains("5 %"), "{told:?}");
        assert!(told[2].contains("1.0e-3") && told[2].contains("(2 of 3 angles"), "{told:?}");
    }

    #[test]
    fn what_is_the_same_in_all_results_is_told_without_places() {
        let of = |coupling, semi_axis_over_radius| Validity {
            coupling,
            semi_axis_over_radius,
            ..Validity::default()
        };
        let mut report = ValidityReport::default();
        for (place, value) in [("at a", 0.0), ("at b", 0.2), ("at c", 0.2)] {
            report.add(|| place.to_owned(), of(0.3, value));
        }
        let (caution, told) = report.told("steps");
        assert_eq!(caution, None);
        assert!(
            told[0].ends_with("is neglected: R_x of an impact changes by up to 0.3"),
            "{told:?}"
        );
        assert!(
            told[1].ends_with("it is 0.2 (2 of 3 steps concerned, the worst at b)"),
            "{told:?}"
        );
        assert_eq!(told.len(), 2);
    }

    #[test]
    fn what_lies_outside_the_theory_is_said_with_its_limit() {
        let of = |approach_over_radius, wave_share| Validity {
            approach_over_radius,
            wave_share,
            ..Validity::default()
        };
        let caution = |validities: &[Validity], what: &str| {
            let mut report = ValidityReport::default();
            validities.iter().for_each(|validity| report.add(String::new, *validity));
            report.told(what).0
        };
        let [within, outside] = [of(0.1, 0.0), of(0.25, 0.0).and(of(0.0, 11.6))];
        assert_eq!(caution(&[within], "angles"), None);
        let text = caution(&[within, outside], "angles").unwrap();
        assert!(
            text.starts_with("OUTSIDE THE THEORY at 1 of 2 angles: the approach exceeds a tenth")
        );
        assert!(text.contains("it is 0.25 times the radius; elastic waves"), "{text}");
        assert!(text.contains("more than 10 % of the normal energy: about 1160 %"), "{text}");
        assert!(text.contains("Is a unit wrong?"), "{text}");
        assert!(caution(&[of(0.0, 0.16)], "").unwrap().ends_with("The results are approximate."));
    }
}
