//! What results exceed of the theory, as the command tells it.

use carom::impact::Outcome;
use carom::laws::validity::Validity;
use carom_cases::theory::Heed;

/// The texts of warnings, and whether results leave the theory.
pub(crate) type Told = (Vec<String>, bool);

/// The warnings of many impacts: whether they lie outside the theory, then each kind once, in its worst form.
pub(crate) fn of_impacts(outcomes: &[Outcome]) -> Told {
    let mut heed = Heed::default();
    for (i, outcome) in outcomes.iter().enumerate() {
        match outcome.rebound() {
            Some(rebound) => heed.add_impact(|_| format!("at entry {i}"), rebound),
            None => heed.add(String::new, Validity::default()),
        }
    }
    heeded(heed, "impacts")
}

/// The warnings of one contact.
pub(crate) fn of_contact(validity: Validity) -> Told {
    let mut heed = Heed::default();
    heed.add(String::new, validity);
    heeded(heed, "contacts")
}

/// The warnings of many contacts.
pub(crate) fn heeded(heed: Heed, what: &str) -> Told {
    let worst = heed.validity();
    let (caution, warnings) = heed.told(what);
    (caution.into_iter().chain(warnings).collect(), !worst.holds())
}
