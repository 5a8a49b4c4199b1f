//! Machine-readable results of a run: JSON, and annotations of source lines.

use crate::catalogue::{Entry, Kind};
use crate::page::Page;
use crate::tally::Tally;
use crate::terminal::{refuted, snapshot_fault};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;

/// A run as JSON: counts, pages with their claims, and snapshots without a page.
#[must_use]
pub fn json(tally: &Tally, pages: &[(Entry, Page)], orphans: &[PathBuf]) -> Value {
    let passes = orphans.is_empty() && pages.iter().all(|(_, page)| page.passes());
    json!({
        "passes": passes,
        "tally": tally,
        "pages": pages.iter().map(|(entry, page)| page_json(entry, page)).collect::<Vec<_>>(),
        "orphans": orphans,
    })
}

fn page_json(entry: &Entry, page: &Page) -> Value {
    let kind = match entry.kind {
        Kind::Figure => "figure",
        Kind::Table => "table",
        Kind::Check => "check",
    };
    json!({
        "id": entry.id,
        "name": entry.name(),
        "title": entry.title,
        "kind": kind,
        "state": entry.state().word(),
        "lacks": entry.lacks,
        "passes": page.passes(),
        "error": page.error,
        "seconds": page.seconds,
        "claims": page.claims,
        "snapshot": page.snapshot,
    })
}

/// The failures as annotations of the source lines of the claims, one per line:
/// `::error file=...,line=...::...`.
#[must_use]
pub fn annotations(pages: &[(Entry, Page)], orphans: &[PathBuf]) -> String {
    let mut text = String::new();
    let mut add = |file: &str, line: u32, title: &str, message: &str| {
        let (file, title) = (property(file), property(title));
        let message = data(message);
        let _ = writeln!(text, "::error file={file},line={line},title={title}::{message}");
    };
    for (entry, page) in pages {
        let name = entry.name();
        if let Some(error) = &page.error {
            add(entry.place.file(), entry.place.line(), &name, error);
        }
        for claim in page.claims.iter().filter(|claim| !claim.holds) {
            add(&claim.file, claim.line, &name, &refuted(claim));
        }
        if let Some(fault) = snapshot_fault(entry, page) {
            use crate::snapshot::Comparison::Differs;
            match &page.snapshot {
                Some(Differs(difference)) => {
                    let file = format!("verification/snapshots/{}.txt", entry.id);
                    add(&file, u32::try_from(difference.line).unwrap_or(1), &name, &fault);
                }
                _ => add(entry.place.file(), entry.place.line(), &name, &fault),
            }
        }
    }
    for path in orphans {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let file = format!("verification/snapshots/{name}");
        add(&file, 1, "Snapshots", "a snapshot without a page");
    }
    text
}

fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Figure;
    use crate::page::Verdict;
    use crate::snapshot::Comparison;
    use std::time::Duration;

    fn pages() -> Vec<(Entry, Page)> {
        let entry = Entry::figure("5.3", "Hertz").by(|| Ok(Figure::new())).partial("the markers");
        let failed = Page::failed(entry, "panicked: 3 % off".to_owned(), Duration::from_secs(1));
        let claim = Verdict {
            statement: "a < b & \"c\"".to_owned(),
            source: "(5.3)".to_owned(),
            measured: "3".to_owned(),
            expected: "≤ 2".to_owned(),
            ratio: Some(1.5),
            holds: false,
            file: "verification/src/figures/ch05.rs".to_owned(),
            line: 7,
        };
        let snapshot = Some(Comparison::Missing);
        let refuted = Page { error: None, claims: vec![claim], snapshot, ..failed.clone() };
        vec![(entry, failed), (entry, refuted)]
    }

    fn orphans() -> [PathBuf; 1] {
        ["/home/carom/verification/snapshots/9.9.txt".into()]
    }

    #[test]
    fn every_failure_is_an_annotation() {
        let text = annotations(&pages(), &orphans());
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines.len(), 4, "{text}");
        let place = pages()[0].0.place;
        let head = format!("::error file={},line={},title=Fig. 5.3::", place.file(), place.line());
        assert_eq!(lines[0], format!("{head}panicked: 3 %25 off"));
        assert!(lines[1].starts_with("::error file=verification/src/figures/ch05.rs,line=7,"));
        assert!(lines[2].starts_with(&head) && lines[2].contains("no snapshot"));
        assert!(lines[3].starts_with("::error file=verification/snapshots/9.9.txt,line=1,"));
    }

    #[test]
    fn json_holds_the_count_the_pages_and_the_claims() {
        let pages = pages();
        let tally = Tally::of(&[pages[0].0], &pages[1..]);
        let value = json(&tally, &pages, &[]);
        assert_eq!(value["passes"], false);
        assert_eq!(value["tally"]["thesis_total"], 1);
        assert_eq!(value["pages"][0]["error"], "panicked: 3 % off");
        assert_eq!(value["pages"][1]["state"], "partial");
        assert_eq!(value["pages"][1]["claims"][0]["ratio"], 1.5);
        assert_eq!(value["pages"][1]["snapshot"], "missing");
    }
}
