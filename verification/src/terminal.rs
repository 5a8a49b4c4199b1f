//! Terminal output: the table of pages, failures in full, results of `--update`, the list of
//! entries.

use crate::catalogue::{Entry, State};
use crate::page::{Page, Verdict};
use crate::report::ratio;
use crate::snapshot::{Change, Comparison, Difference};
use comfy_table::{CellAlignment, Table, presets::UTF8_FULL_CONDENSED};
use std::fmt::Write as _;

/// Largest number of changes shown for a page.
const MAX_CHANGES_SHOWN: usize = 12;

/// One line per page: id, title, number of claims that hold, largest deviation over tolerance,
/// time.
#[must_use]
pub fn table(pages: &[(Entry, Page)]) -> String {
    let mut table = Table::new();
    table.load_style(UTF8_FULL_CONDENSED);
    table.set_header(["id", "title", "claims passed", "worst dev./tol.", "time", ""]);
    for (entry, page) in pages {
        let state = match (page.passes(), entry.state()) {
            (false, _) => "FAILED",
            (true, State::Partial) => "partial",
            (true, _) => "ok",
        };
        table.add_row([
            entry.id.to_owned(),
            entry.title.to_owned(),
            format!("{}/{}", page.claims_that_hold(), page.claims.len()),
            page.worst().map_or_else(|| "-".to_owned(), ratio),
            format!("{:.2} s", page.seconds),
            state.to_owned(),
        ]);
    }
    for index in 2..5 {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.to_string()
}

/// The failures of each page that does not pass, in full.
#[must_use]
pub fn failures(pages: &[(Entry, Page)]) -> String {
    let mut text = String::new();
    for (entry, page) in pages.iter().filter(|(_, page)| !page.passes()) {
        let _ = writeln!(text, "{} fails:", entry.name());
        if let Some(error) = &page.error {
            let _ = writeln!(text, "  {error}");
        }
        page.claims.iter().filter(|claim| !claim.holds).for_each(|claim| {
            let _ = writeln!(text, "  {}", refuted(claim));
        });
        snapshot(&mut text, entry, page);
    }
    text
}

/// The failure of a claim, in one line.
#[must_use]
pub fn refuted(claim: &Verdict) -> String {
    let lack = if claim.has_source() { "" } else { "it names no source; " };
    format!(
        "claim `{}`: {lack}measured {}, expected {} (deviation/tolerance {})",
        claim.statement,
        claim.measured,
        claim.expected,
        ratio(claim.deviation()),
    )
}

/// The fault of a page's snapshot, in one line; `None` if there is none.
#[must_use]
pub fn snapshot_fault(entry: &Entry, page: &Page) -> Option<String> {
    let found = match page.snapshot.as_ref()? {
        Comparison::Same | Comparison::Written => return None,
        Comparison::Missing => "there is no snapshot".to_owned(),
        Comparison::Differs(difference) => format!(
            "the snapshot verification/snapshots/{}.txt differs in {} rows, first in line {}{}",
            entry.id,
            difference.rows,
            difference.line,
            difference
                .largest()
                .map_or_else(String::new, |change| format!(", by up to {}", percent(change))),
        ),
    };
    let how = if page.holds() {
        format!(
            "if that is right, accept it with `cargo xtask verify --figure {} --update`",
            entry.id
        )
    } else {
        "it cannot be accepted while a claim fails".to_owned()
    };
    Some(format!("{found}; {how}"))
}

fn snapshot(text: &mut String, entry: &Entry, page: &Page) {
    if let Some(fault) = snapshot_fault(entry, page) {
        let _ = writeln!(text, "  {fault}");
    }
    if let Some(Comparison::Differs(difference)) = &page.snapshot {
        changes(text, difference);
    }
}

/// The largest changes, one per line.
fn changes(text: &mut String, difference: &Difference) {
    let mut place = "";
    for change in difference.changes.iter().take(MAX_CHANGES_SHOWN) {
        if change.place != place {
            place = &change.place;
            let _ = writeln!(text, "    {place}");
        }
        let _ = writeln!(text, "    line {}: {}", change.line, words(change));
    }
    let shown = difference.changes.len().min(MAX_CHANGES_SHOWN);
    if difference.count > shown {
        let _ = writeln!(text, "    and {} more", difference.count - shown);
    }
}

fn words(change: &Change) -> String {
    let Change { stored, now, relative, .. } = change;
    let cells = |text: &str| text.replace('\t', " | ");
    match (&**stored, &**now, relative) {
        ("", now, _) => format!("new: {}", cells(now)),
        (stored, "", _) => format!("gone: {}", cells(stored)),
        (stored, now, Some(relative)) => format!("{stored} -> {now} ({})", percent(*relative)),
        (stored, now, None) => format!("`{}` -> `{}`", cells(stored), cells(now)),
    }
}

fn percent(relative: f64) -> String {
    let percent = 100.0 * relative;
    if (0.001..1e6).contains(&percent) {
        format!("{} %", crate::claim::number(format!("{percent:.1e}").parse().unwrap_or(percent)))
    } else {
        format!("{percent:.1e} %")
    }
}

/// The result of updating a page's snapshot; `before` is the comparison before it.
#[must_use]
pub fn rewritten(entry: &Entry, before: &Comparison) -> String {
    let mut text = String::new();
    match before {
        Comparison::Same | Comparison::Written => {}
        Comparison::Missing => {
            let _ = writeln!(text, "{}: snapshot written, the first", entry.name());
        }
        Comparison::Differs(difference) => {
            let (name, count) = (entry.name(), difference.count);
            let _ = writeln!(text, "{name}: snapshot rewritten, {count} values changed");
            changes(&mut text, difference);
        }
    }
    text
}

/// One line per entry: number, title, and done, partial (with what is missing) or missing.
#[must_use]
pub fn list(catalogue: &[Entry]) -> String {
    let mut text = String::new();
    let width = catalogue.iter().map(|entry| entry.title.chars().count()).max().unwrap_or(0);
    let name_width = catalogue.iter().map(|entry| entry.name().len()).max().unwrap_or(0);
    for entry in catalogue {
        let (name, state) = (entry.name(), entry.state().word());
        let lacks = entry.lacks.map_or_else(String::new, |lacks| format!(": without {lacks}"));
        let title = entry.title;
        let _ = writeln!(text, "{name:<name_width$}  {title:<width$}  {state}{lacks}");
    }
    let count = |is_in_thesis: bool, state: Option<State>| {
        let of = |entry: &&Entry| state.is_none_or(|state| entry.state() == state);
        let here = |entry: &&Entry| entry.is_in_thesis() == is_in_thesis;
        catalogue.iter().filter(here).filter(of).count()
    };
    let (done, partial) = (count(true, Some(State::Done)), count(true, Some(State::Partial)));
    let _ = writeln!(
        text,
        "{} of {} of the thesis ({partial} of them partial); {} of {} own checks",
        done + partial,
        count(true, None),
        count(false, Some(State::Done)),
        count(false, None),
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Figure, FigureResult};
    use std::time::Duration;

    fn draw() -> FigureResult {
        Ok(Figure::new())
    }

    fn verdict(statement: &str, ratio: Option<f64>, source: &str) -> Verdict {
        Verdict {
            statement: statement.to_owned(),
            source: source.to_owned(),
            measured: "3".to_owned(),
            expected: "≤ 2".to_owned(),
            ratio,
            holds: ratio.is_some_and(|ratio| ratio <= 1.0) && !source.is_empty(),
            file: "verification/src/figures/ch05.rs".to_owned(),
            line: 7,
        }
    }

    fn difference() -> Difference {
        let change = |line, stored: &str, now: &str, relative| Change {
            place: if line > 3 { "series: curve | 9 points" } else { "" }.to_owned(),
            line,
            stored: stored.to_owned(),
            now: now.to_owned(),
            relative,
        };
        let changes = vec![
            change(3, "claim:\tbelow 2\tholds\tCoulomb", "", None),
            change(2, "stated:", "assumed:", None),
            change(8, "2.0", "2.5", Some(0.25)),
            change(5, "1.00000", "1.00001", Some(1e-5)),
        ];
        Difference { line: 2, rows: 4, count: 14, changes }
    }

    fn pages() -> Vec<(Entry, Page)> {
        let entry = Entry::figure("5.3", "Hertz").by(draw);
        let failed = Page::failed(entry, "no root".to_owned(), Duration::from_millis(1234));
        let below = verdict("below 1", Some(0.25), "(5.3)");
        let good = Page {
            error: None,
            claims: vec![below.clone()],
            snapshot: Some(Comparison::Same),
            ..failed.clone()
        };
        let above = verdict("below 2", Some(1.5), "(5.3)");
        let unsourced = verdict("because", Some(0.5), "");
        let differs = Some(Comparison::Differs(difference()));
        let bad = Page {
            claims: vec![below, above, unsourced],
            snapshot: differs.clone(),
            ..good.clone()
        };
        let changed = Page { snapshot: differs, ..good.clone() };
        vec![
            (entry, good.clone()),
            (entry.partial("markers"), good),
            (entry, bad),
            (entry, changed),
            (entry, failed),
        ]
    }

    #[test]
    fn one_line_a_page() {
        insta::assert_snapshot!(table(&pages()));
    }

    #[test]
    fn failures_in_full() {
        insta::assert_snapshot!(failures(&pages()));
    }

    #[test]
    fn what_was_rewritten() {
        let entry = Entry::figure("5.3", "Hertz");
        insta::assert_snapshot!(rewritten(&entry, &Comparison::Differs(difference())));
        assert_eq!(rewritten(&entry, &Comparison::Same), "");
    }

    #[test]
    fn one_line_an_entry() {
        let entries = [
            Entry::figure("5.3", "Hertz").by(draw),
            Entry::figure("5.4", "Deformed").by(draw).partial("the markers"),
            Entry::table("table-13.1", "Sums"),
            Entry::check("own", "Ours").by(draw),
        ];
        insta::assert_snapshot!(list(&entries));
    }
}
