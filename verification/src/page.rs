//! The record of a page: the result of an entry as plain data, passed between processes and runs.

use crate::catalogue::Entry;
use crate::claim::Claim;
use crate::run::Outcome;
use crate::snapshot::{self, Comparison};
use serde::{Deserialize, Serialize};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// The result of an entry of the catalogue.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Page {
    /// The entry's id.
    pub id: String,
    /// Time of computation, in seconds since 1970.
    pub computed: u64,
    /// Duration of the computation, in seconds.
    pub seconds: f64,
    /// Why there is no figure, if there is none.
    pub error: Option<String>,
    /// The decided claims.
    pub claims: Vec<Verdict>,
    /// Comparison with the snapshot; `None` without a figure.
    pub snapshot: Option<Comparison>,
    /// The new snapshot, if it differs.
    pub text: Option<String>,
    /// Number of deviations from the thesis.
    pub deviations: usize,
    /// Its section of the report, in HTML.
    pub section: String,
}

/// A decided claim.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The statement.
    pub statement: String,
    /// Source of the expected value.
    pub source: String,
    /// What was measured.
    pub measured: String,
    /// What was expected.
    pub expected: String,
    /// Deviation over tolerance; `None` if it is not a number or has no bound.
    pub ratio: Option<f64>,
    /// Whether it holds.
    pub holds: bool,
    /// The source file of the claim.
    pub file: String,
    /// The line in it.
    pub line: u32,
}

impl From<&Claim> for Verdict {
    fn from(claim: &Claim) -> Self {
        Self {
            statement: claim.statement.clone(),
            source: claim.source.clone(),
            measured: claim.measured(),
            expected: claim.expected(),
            ratio: Some(claim.ratio()).filter(|ratio| ratio.is_finite()),
            holds: claim.passes(),
            file: claim.place.file().to_owned(),
            line: claim.place.line(),
        }
    }
}

impl Verdict {
    /// Whether the claim has a source.
    #[must_use]
    pub fn has_source(&self) -> bool {
        !self.source.trim().is_empty()
    }

    /// Deviation over tolerance; infinite if it is not a number.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.ratio.unwrap_or(f64::INFINITY)
    }
}

impl Page {
    /// The record of an outcome; `section` is its section of the report.
    #[must_use]
    pub fn new(outcome: &Outcome, section: String) -> Self {
        let drawn = outcome.result.as_ref().ok();
        let text = drawn
            .filter(|drawn| !drawn.snapshot.agrees())
            .map(|drawn| snapshot::text(&drawn.figure));
        Self {
            error: outcome.result.as_ref().err().cloned(),
            claims: outcome.claims().iter().map(Verdict::from).collect(),
            snapshot: drawn.map(|drawn| drawn.snapshot.clone()),
            text,
            deviations: drawn.map_or(0, |drawn| drawn.figure.deviations.len()),
            section,
            ..Self::failed(outcome.entry, String::new(), outcome.time)
        }
    }

    /// The record of an entry whose process ended without a record.
    #[must_use]
    pub fn failed(entry: Entry, error: String, time: Duration) -> Self {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        Self {
            id: entry.id.to_owned(),
            computed: now.as_secs(),
            seconds: time.as_secs_f64(),
            error: Some(error),
            claims: Vec::new(),
            snapshot: None,
            text: None,
            deviations: 0,
            section: String::new(),
        }
    }

    /// Whether it was computed and every claim holds.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.error.is_none() && self.claims.iter().all(|claim| claim.holds)
    }

    /// Whether every claim holds and the snapshot agrees.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.holds() && self.snapshot.as_ref().is_some_and(Comparison::agrees)
    }

    /// How many claims hold.
    #[must_use]
    pub fn claims_that_hold(&self) -> usize {
        self.claims.iter().filter(|claim| claim.holds).count()
    }

    /// The largest deviation over tolerance of its claims; `None` without claims.
    #[must_use]
    pub fn worst(&self) -> Option<f64> {
        self.claims.iter().map(Verdict::deviation).reduce(f64::max)
    }

    /// The time of computation, as `2026-11-21 20:32 UTC`.
    #[must_use]
    pub fn date(&self) -> String {
        let (days, seconds) = (self.computed / 86_400, self.computed % 86_400);
        let (year, month, day) = civil(days);
        format!("{year}-{month:02}-{day:02} {:02}:{:02} UTC", seconds / 3600, seconds / 60 % 60)
    }
}

/// Year, month and day of the Gregorian calendar, `days` days after 1 January 1970.
const fn civil(days: u64) -> (u64, u64, u64) {
    // Years from 1 March on, so that the leap day is the last.
    let days = days + 719_468;
    let (era, of_era) = (days / 146_097, days % 146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let from_march = (5 * of_year + 2) / 153;
    let day = of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    (era * 400 + year + (month <= 2) as u64, month, day)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Figure;
    use crate::run::Drawn;

    fn outcome(bound: f64, snapshot: Comparison) -> Outcome {
        let mut figure = Figure::new();
        figure.at_most("small", 3.0, bound).source("given");
        let drawn = Drawn { figure, svg: None, panels: Vec::new(), snapshot };
        let entry = Entry::figure("5.3", "Hertz");
        Outcome { entry, result: Ok(drawn), time: Duration::from_millis(1500) }
    }

    #[test]
    fn a_page_passes_with_its_claims_and_its_snapshot() {
        let page = |bound, snapshot| Page::new(&outcome(bound, snapshot), String::new());
        let good = page(4.0, Comparison::Same);
        assert!(good.passes() && good.text.is_none());
        assert_eq!((good.claims_that_hold(), good.worst(), good.seconds), (1, Some(0.75), 1.5));
        let wrong = page(2.0, Comparison::Same);
        assert!(!wrong.holds() && !wrong.passes() && wrong.claims_that_hold() == 0);
        let new = page(4.0, Comparison::Missing);
        assert!(new.holds() && !new.passes());
        assert!(new.text.unwrap().contains("claim:\tsmall"));
        let failed = Page::failed(Entry::figure("1", ""), "hangs".to_owned(), Duration::ZERO);
        assert!(!failed.holds() && failed.worst().is_none());
    }

    #[test]
    fn a_page_survives_its_file() {
        let mut page = Page::new(&outcome(f64::INFINITY, Comparison::Missing), "<p>".to_owned());
        page.computed = 1_795_293_158;
        assert_eq!(page.claims[0].ratio, None);
        assert_eq!(page.claims[0].deviation(), f64::INFINITY);
        let text = serde_json::to_string(&page).unwrap();
        assert_eq!(serde_json::from_str::<Page>(&text).unwrap(), page);
    }

    #[test]
    fn dates() {
        for (computed, date) in [
            (0, "1970-01-01 00:00 UTC"),
            (951_782_399, "2000-02-28 23:59 UTC"),
            (951_782_400, "2000-02-29 00:00 UTC"),
            (1_709_251_200, "2024-03-01 00:00 UTC"),
            (1_735_689_599, "2024-12-31 23:59 UTC"),
        ] {
            let entry = Entry::figure("1", "");
            let page = Page { computed, ..Page::failed(entry, String::new(), Duration::ZERO) };
            assert_eq!(page.date(), date);
        }
    }
}
