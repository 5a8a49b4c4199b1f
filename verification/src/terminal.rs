//! What the terminal shows: the table of outcomes, failures in full, the list of entries.

use crate::catalogue::Entry;
use crate::claim::Claim;
use crate::report::ratio;
use crate::run::Outcome;
use crate::snapshot::Comparison;
use comfy_table::{CellAlignment, Table, presets::UTF8_FULL_CONDENSED};
use std::fmt::Write as _;

/// One line an outcome: id, title, claims passed, worst deviation against tolerance, time.
#[must_use]
pub fn table(outcomes: &[Outcome]) -> String {
    let mut table = Table::new();
    table.load_style(UTF8_FULL_CONDENSED);
    table.set_header(["id", "title", "claims passed", "worst dev./tol.", "time", ""]);
    for outcome in outcomes {
        let score = outcome.score();
        table.add_row([
            outcome.entry.id.to_owned(),
            outcome.entry.title.to_owned(),
            format!("{}/{}", score.passed, score.total),
            outcome.worst_ratio().map_or_else(|| "-".to_owned(), ratio),
            format!("{:.2} s", outcome.time.as_secs_f64()),
            if outcome.passes() { "ok" } else { "FAILED" }.to_owned(),
        ]);
    }
    for index in 2..5 {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.to_string()
}

/// Why each outcome that does not pass fails, in full.
#[must_use]
pub fn failures(outcomes: &[Outcome]) -> String {
    let mut text = String::new();
    for outcome in outcomes.iter().filter(|outcome| !outcome.passes()) {
        let _ = writeln!(text, "{} fails:", outcome.entry.name());
        match &outcome.result {
            Err(error) => {
                let _ = writeln!(text, "  {error}");
            }
            Ok(drawn) => {
                drawn
                    .figure
                    .claims
                    .iter()
                    .filter(|claim| !claim.passes())
                    .for_each(|claim| refuted(&mut text, claim));
                snapshot(&mut text, outcome.entry, &drawn.snapshot);
            }
        }
    }
    text
}

fn refuted(text: &mut String, claim: &Claim) {
    let _ = writeln!(
        text,
        "  claim `{}`: measured {}, expected {} (deviation/tolerance {})",
        claim.statement,
        claim.measured(),
        claim.expected(),
        ratio(claim.ratio()),
    );
}

fn snapshot(text: &mut String, entry: Entry, comparison: &Comparison) {
    let _ = match comparison {
        Comparison::Same | Comparison::Written => Ok(()),
        Comparison::Missing => writeln!(
            text,
            "  no snapshot; `cargo xtask verify --figure {} --update` writes it",
            entry.id
        ),
        Comparison::Differs(difference) => writeln!(
            text,
            "  snapshot differs at line {}: stored `{}`, now `{}`",
            difference.line, difference.stored, difference.now
        ),
    };
}

/// One line an entry: number, title, done or missing.
#[must_use]
pub fn list(catalogue: &[Entry]) -> String {
    let mut text = String::new();
    let width = catalogue.iter().map(|entry| entry.title.chars().count()).max().unwrap_or(0);
    let entries = || catalogue.iter().filter(|entry| entry.is_in_thesis());
    for entry in entries() {
        let state = if entry.is_done() { "done" } else { "missing" };
        let _ = writeln!(text, "{:<12}  {:<width$}  {state}", entry.name(), entry.title);
    }
    let done = entries().filter(|entry| entry.is_done()).count();
    let _ = writeln!(text, "{done} of {} tables and figures", entries().count());
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::Drawn;
    use crate::snapshot::Difference;
    use crate::{Figure, FigureResult};
    use std::time::Duration;

    fn draw() -> FigureResult {
        Ok(Figure::new())
    }

    fn outcomes() -> [Outcome; 3] {
        let entry = Entry::figure("5.3", "Hertz").by(draw);
        let mut figure = Figure::new();
        figure.claim(Claim::at_most("below 1", 0.25, 1.0));
        let snapshot = Comparison::Same;
        let good = Drawn { figure: figure.clone(), svg: None, snapshot };
        figure.claim(Claim::at_most("below 2", 3.0, 2.0));
        let difference =
            Difference { line: 4, stored: "1.0\t2.0".to_owned(), now: "1.0\t2.5".to_owned() };
        let bad = Drawn { figure, svg: None, snapshot: Comparison::Differs(difference) };
        let time = Duration::from_millis(1234);
        [
            Outcome { entry, result: Ok(good), time },
            Outcome { entry, result: Ok(bad), time },
            Outcome { entry, result: Err("no root".to_owned()), time },
        ]
    }

    #[test]
    fn one_line_an_outcome() {
        insta::assert_snapshot!(table(&outcomes()));
    }

    #[test]
    fn failures_in_full() {
        insta::assert_snapshot!(failures(&outcomes()), @r"
        Fig. 5.3 fails:
          claim `below 2`: measured 3, expected ≤ 2 (deviation/tolerance 1.500)
          snapshot differs at line 4: stored `1.0	2.0`, now `1.0	2.5`
        Fig. 5.3 fails:
          no root
        ");
    }

    #[test]
    fn one_line_an_entry() {
        let entries = [Entry::figure("5.3", "Hertz").by(draw), Entry::table("table-13.1", "Sums")];
        insta::assert_snapshot!(list(&entries), @r"
        Fig. 5.3      Hertz  done
        Table 13.1    Sums   missing
        1 of 2 tables and figures
        ");
    }
}
