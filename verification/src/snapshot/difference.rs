//! Differences between a snapshot and a figure: rows are matched, then compared cell by cell.

use super::lines::{Line, SnapshotCell};
use similar::DiffTag;
use similar::algorithms::{Capture, Replace, lcs};

/// Largest number of changes that are stored; the largest changes are.
const MAX_CHANGES: usize = 200;

/// The differences between a snapshot and a figure.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Difference {
    /// The first line of the snapshot that differs, from 1.
    pub line: usize,
    /// Number of rows that differ.
    pub rows: usize,
    /// Number of values and words that differ.
    pub count: usize,
    /// The changes, largest first: added or removed rows, words, then numbers; at most 200.
    pub changes: Vec<Change>,
}

/// A value or word that differs.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Change {
    /// The head above it.
    pub place: String,
    /// Its line in the snapshot, from 1.
    pub line: usize,
    /// The value in the snapshot; empty if the row is new.
    pub stored: String,
    /// The value in the figure; empty if the row was removed.
    pub now: String,
    /// For a number: the change over the largest value of its curve, or over the stored value.
    pub relative: Option<f64>,
}

impl Difference {
    /// The largest relative change of a number.
    #[must_use]
    pub fn largest(&self) -> Option<f64> {
        self.changes.iter().filter_map(|change| change.relative).reduce(f64::max)
    }
}

/// The differences between the stored text and the new lines, if there are any.
pub(super) fn find(stored: &str, now: &[Line]) -> Option<Difference> {
    let stored: Vec<&str> = stored.lines().collect();
    let mut changes = Vec::new();
    let mut rows = 0;
    for (old, new) in gaps(&stored, now) {
        rows += old.len().max(new.len());
        for i in 0..old.len().max(new.len()) {
            let line = (old.start + i).min(old.end);
            let place = head(&stored[..line]);
            let (was, is) = (stored[old.clone()].get(i), now[new.clone()].get(i));
            changes.extend(row(was.copied(), is).into_iter().map(|(stored, now, relative)| {
                Change { place: place.clone(), line: line + 1, stored, now, relative }
            }));
        }
    }
    let line = changes.iter().map(|change| change.line).min()?;
    let count = changes.len();
    let size = |change: &Change| change.relative.unwrap_or(f64::INFINITY);
    changes.sort_by(|a, b| size(b).total_cmp(&size(a)).then(a.line.cmp(&b.line)));
    changes.truncate(MAX_CHANGES);
    Some(Difference { line, rows, count, changes })
}

/// The last head of these lines.
fn head(lines: &[&str]) -> String {
    let is_head =
        |line: &&&str| ["panel: ", "series: ", "table: "].iter().any(|s| line.starts_with(s));
    lines.iter().rev().find(is_head).map_or_else(String::new, |line| (*line).to_owned())
}

type Found = (String, String, Option<f64>);

/// The differences between two rows: cell by cell if they have equally many, otherwise as a whole.
fn row(stored: Option<&str>, now: Option<&Line>) -> Vec<Found> {
    let (Some(old), Some(new)) = (stored, now) else {
        let now = now.map_or_else(String::new, Line::written);
        return vec![(stored.unwrap_or_default().to_owned(), now, None)];
    };
    let Line::Row(cells) = new else { return vec![(old.to_owned(), new.written(), None)] };
    let words: Vec<&str> = old.split('\t').collect();
    if words.len() != cells.len() {
        return vec![(old.to_owned(), new.written(), None)];
    }
    let differ = words.iter().zip(cells).filter(|(word, cell)| !cell.agrees(word));
    differ.map(|(word, cell)| ((*word).to_owned(), cell.written(), relative(word, cell))).collect()
}

fn relative(stored: &str, now: &SnapshotCell) -> Option<f64> {
    let (SnapshotCell::Number(now), Ok(stored)) = (now, stored.parse()) else { return None };
    Some(now.relative(stored)).filter(|relative| relative.is_finite())
}

type Range = std::ops::Range<usize>;

/// The ranges of both that a longest common subsequence does not match.
fn gaps(stored: &[&str], now: &[Line]) -> Vec<(Range, Range)> {
    let mut found = Replace::new(Capture::new());
    let Ok(()) = lcs::diff(&mut found, stored, 0..stored.len(), now, 0..now.len());
    let all = found.into_inner().into_ops();
    let gaps = all.iter().filter(|part| part.tag() != DiffTag::Equal);
    gaps.map(|gap| (gap.old_range(), gap.new_range())).collect()
}

#[cfg(test)]
mod tests {
    use super::super::lines::{of, tests::figure, text};
    use super::*;
    use crate::claim::Claim;

    #[test]
    fn last_bits_never_show_and_changes_do() {
        let stored = text(&of(&figure(1.0)));
        assert_eq!(find(&stored, &of(&figure(1.0 + 1e-12))), None);
        let found = find(&stored, &of(&figure(1.0 + 1e-4))).unwrap();
        approx::assert_abs_diff_eq!(found.largest().unwrap(), 1e-4, epsilon = 5e-6);
        let first = &found.changes[0];
        assert_eq!((&*first.stored, &*first.now), ("1400.14", "1400.28"));
        assert_eq!(first.place, "series: curve | 100 points");
        assert!(stored.lines().nth(first.line - 1).unwrap().ends_with("\t1400.14"));
        // 19 values but 0, and two means.
        assert!(found.rows == 2 && (15..=21).contains(&found.count), "{}", found.count);
        assert!(found.changes.windows(2).all(|pair| pair[0].relative >= pair[1].relative));
    }

    #[test]
    fn a_change_between_the_points_shows_in_the_means() {
        let stored = text(&of(&figure(1.0)));
        let mut other = figure(1.0);
        other.panels[0].series[0].points[50].y += 14.0; // a hundredth of the largest
        let found = find(&stored, &of(&other)).unwrap();
        assert_eq!(found.rows, 1);
        assert!(stored.lines().nth(found.line - 1).unwrap().starts_with("means"));
    }

    #[test]
    fn a_row_that_comes_or_goes_does_not_shift_the_rest() {
        let stored = text(&of(&figure(1.0)));
        let mut longer = figure(1.0);
        longer.tables[0].row([crate::Cell::from("b"), crate::Cell::from(0.0)]);
        let found = find(&stored, &of(&longer)).unwrap();
        assert_eq!((found.rows, found.count), (1, 1));
        assert_eq!((&*found.changes[0].stored, &*found.changes[0].now), ("", "b\t0.000000"));
        let mut shorter = figure(1.0);
        shorter.panels[0].series[0].points.truncate(0);
        let found = find(&stored, &of(&shorter)).unwrap();
        assert_eq!(found.rows, 4);
    }

    #[test]
    fn a_deleted_or_loosened_claim_is_seen() {
        let stored = text(&of(&figure(1.0)));
        let mut deleted = figure(1.0);
        deleted.claims.remove(0);
        let found = find(&stored, &of(&deleted)).unwrap();
        assert_eq!((found.rows, found.line), (1, 3));
        assert!(found.changes[0].stored.starts_with("claim:\ta third"));
        let mut loosened = figure(1.0);
        loosened.claims[1] = Claim::at_most("small", 0.0, 2.0).source("Coulomb");
        let found = find(&stored, &of(&loosened)).unwrap();
        assert_eq!(found.changes[0].relative, Some(1.0));
        let mut assumed = figure(1.0);
        assumed.inputs.clear();
        assumed.stated("ν", "0.3");
        let found = find(&stored, &of(&assumed)).unwrap();
        assert_eq!((&*found.changes[0].stored, &*found.changes[0].now), ("assumed:", "stated:"));
    }
}
