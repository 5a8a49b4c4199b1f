//! The speed beside other programs: the first table of the book's page, which a run of the benches has written.

use super::markup::prose;
use std::fmt::Write as _;

const PAGE: &str = include_str!("../../../docs/book/src/bench.md");
/// The page, for a reader of the report.
const PATH: &str = "docs/book/src/bench.md";

/// The section: when and where it was measured, and the table.
pub(super) fn section() -> String {
    let mut html = String::new();
    let _ = write!(
        html,
        "<section class=\"page\" id=\"speed\" data-page=\"speed\"><h2>Beside other programs</h2>\n\
         <p>The processor's time of other programs for the same problem, over carom's, as <code>cargo xtask bench \
         --page</code> measured and wrote it to <code>{PATH}</code>, where errors, times and memory are. {}</p>\n{}</section>\n",
        prose(run()),
        table()
    );
    html
}

/// Date, machine and load of the run.
fn run() -> &'static str {
    PAGE.split("\n\n").find(|part| part.starts_with("The run of ")).unwrap_or_default()
}

/// The first table of the page.
fn table() -> String {
    let mut rows = PAGE.lines().skip_while(|line| !line.starts_with('|'));
    let mut html = String::from("<div class=\"wide\" tabindex=\"0\"><table><thead>");
    if let Some(head) = rows.next() {
        html += &row(head, "th");
    }
    html += "</thead><tbody>";
    for line in rows.skip(1).take_while(|line| line.starts_with('|')) {
        html += &row(line, "td");
    }
    html + "</tbody></table></div>\n"
}

fn row(line: &str, cell: &str) -> String {
    let cells = line.trim().trim_matches('|').split('|');
    let cells: String =
        cells.map(|words| format!("<{cell}>{}</{cell}>", prose(words.trim()))).collect();
    format!("<tr>{cells}</tr>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_run_has_a_date_and_the_table_a_row_for_each_peer() {
        assert!(run().contains(" UTC took ") && run().contains(" cores"), "{}", run());
        let table = table();
        for peer in ["ContactMechanics", "tamaas", "slippy"] {
            assert!(table.contains(&format!("<td>{peer}</td>")), "{peer}");
        }
        assert!(!table.contains("---") && table.matches("<th>").count() > 3, "{table}");
    }
}
