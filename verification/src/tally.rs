//! Counts of passing tables and figures of the thesis, of checks of carom, and of claims.

use crate::catalogue::{Entry, State};
use crate::page::Page;
use serde::Serialize;
use std::fmt;

/// Counts of passing entries.
///
/// A page counts if it was computed and passes. Partial pages are included and also counted
/// separately.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// Passing tables and figures of the thesis.
    pub thesis: usize,
    /// Those of them that are partial.
    pub partial: usize,
    /// Tables and figures of the thesis.
    pub thesis_total: usize,
    /// Passing checks of carom.
    pub checks: usize,
    /// Checks of carom.
    pub checks_total: usize,
    /// Claims that hold.
    pub claims: usize,
    /// Claims.
    pub claims_total: usize,
}

impl Tally {
    /// Counts these pages against the whole catalogue.
    #[must_use]
    pub fn of(catalogue: &[Entry], pages: &[(Entry, Page)]) -> Self {
        let mut tally = Self::default();
        for entry in catalogue {
            let page = pages.iter().find(|(of, _)| of.id == entry.id).map(|(_, page)| page);
            let stands = usize::from(page.is_some_and(Page::passes));
            if entry.is_in_thesis() {
                tally.thesis += stands;
                tally.thesis_total += 1;
                tally.partial += if entry.state() == State::Partial { stands } else { 0 };
            } else {
                tally.checks += stands;
                tally.checks_total += 1;
            }
            tally.claims += page.map_or(0, Page::claims_that_hold);
            tally.claims_total += page.map_or(0, |page| page.claims.len());
        }
        tally
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {} of the thesis", self.thesis, self.thesis_total)?;
        if self.partial > 0 {
            write!(f, " ({} of them partial)", self.partial)?;
        }
        write!(f, "; {} of {} own checks", self.checks, self.checks_total)?;
        write!(f, "; {} of {} claims", self.claims, self.claims_total)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Figure;
    use crate::snapshot::Comparison;
    use std::time::Duration;

    #[test]
    fn the_missing_the_partial_and_the_own_are_told_apart() {
        let draw = || Ok(Figure::new());
        let catalogue = [
            Entry::figure("1.1", "").by(draw),
            Entry::figure("1.2", "").by(draw).partial("markers"),
            Entry::figure("1.3", "").by(draw).partial("markers"),
            Entry::figure("1.4", ""),
            Entry::check("own", "").by(draw),
        ];
        let page = |entry: Entry, snapshot| {
            let page = Page::failed(entry, String::new(), Duration::ZERO);
            (entry, Page { error: None, snapshot: Some(snapshot), ..page })
        };
        let pages = [
            page(catalogue[0], Comparison::Same),
            page(catalogue[1], Comparison::Written),
            page(catalogue[2], Comparison::Missing),
            page(catalogue[4], Comparison::Same),
        ];
        let text = Tally::of(&catalogue, &pages).to_string();
        assert_eq!(
            text,
            "2 of 4 of the thesis (1 of them partial); 1 of 1 own checks; 0 of 0 claims"
        );
        let text = Tally::of(&catalogue, &[]).to_string();
        assert_eq!(text, "0 of 4 of the thesis; 0 of 1 own checks; 0 of 0 claims");
    }
}
