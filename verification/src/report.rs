//! The report: one HTML page with everything in it. A run of all pages gives the same bytes
//! every time; what a run left as it was bears its date.

use crate::catalogue::{Entry, State};
use crate::page::Page;
use crate::snapshot::Comparison;
use crate::tally::Tally;
use std::fmt::Write as _;
use std::path::Path;

const STYLE: &str = "
body{font:15px/1.5 Helvetica,Arial,sans-serif;color:#222;background:#fff;max-width:1300px;\
margin:2em auto;padding:0 1em}
h1{font-size:1.6em}h2{font-size:1.25em;margin-top:2.2em;border-top:1px solid #ddd;padding-top:1em}
h3{font-size:1em;margin-bottom:.3em}
.headline{font-size:1.15em;font-weight:bold}
.wide{overflow-x:auto}
table{border-collapse:collapse;font-size:.92em;margin:.4em 0 1em}
th,td{text-align:left;padding:.2em .7em;border-bottom:1px solid #e4e4e4;vertical-align:top}
th{border-bottom:2px solid #bbb}\
td.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
td.name{white-space:nowrap}
svg{max-width:100%;height:auto}a{color:#0072B2;text-decoration:none}
.pass{color:#00734f}.fail{color:#b00020;font-weight:bold}.missing,.old{color:#666}\
.partial{color:#8a5a00}
@media(max-width:700px){body{margin:1em auto;padding:0 .6em}th,td{padding:.2em .35em}\
.wide svg{min-width:560px}\
.contents td:nth-child(4),.contents th:nth-child(4),\
.contents td:nth-child(5),.contents th:nth-child(5){display:none}.contents td.name{white-space:normal}}
";

/// The report of these pages, with a line for each entry of the catalogue; `is_fresh` says which
/// pages are of this run.
#[must_use]
pub fn html(
    catalogue: &[Entry],
    pages: &[(Entry, Page)],
    is_fresh: impl Fn(&Entry) -> bool,
) -> String {
    let mut page = String::new();
    let _ = write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\">\
         <title>carom: verification</title><style>{STYLE}</style></head><body>\n\
         <h1>carom: the tables and figures of “Elastic Impact with Friction”</h1>\n"
    );
    summary(&mut page, catalogue, pages, &is_fresh);
    contents(&mut page, catalogue, pages, &is_fresh);
    for (entry, record) in pages {
        section(&mut page, entry, record, is_fresh(entry));
    }
    page.push_str("</body></html>\n");
    page
}

fn summary(
    page: &mut String,
    catalogue: &[Entry],
    pages: &[(Entry, Page)],
    is_fresh: impl Fn(&Entry) -> bool,
) {
    let tally = Tally::of(catalogue, pages);
    let _ = writeln!(page, "<p class=\"headline\">{tally}</p>");
    let old: Vec<&Page> =
        pages.iter().filter(|(entry, _)| !is_fresh(entry)).map(|(_, record)| record).collect();
    if let Some(oldest) = old.iter().min_by_key(|record| record.computed) {
        let _ = writeln!(
            page,
            "<p class=\"old\">{} of these pages are from earlier runs, the oldest from {}: each \
             bears its date.</p>",
            old.len(),
            oldest.date()
        );
    }
    let _ = writeln!(
        page,
        "<p>A page counts if its claims hold and its snapshot agrees. A <em>partial</em> page \
         lacks something that the thesis shows; it says what. The rest of the thesis (J. Jaeger, \
         TU Delft 1992) is <em>missing</em>. Inputs are marked <em>stated</em> (the thesis gives \
         them), <em>derived</em> (they follow from what it gives) or <em>assumed</em> (our \
         choice). A claim's deviation is given over its tolerance: up to 1 it holds. For a bound \
         it is the part used.</p>"
    );
}

fn contents(
    page: &mut String,
    catalogue: &[Entry],
    pages: &[(Entry, Page)],
    is_fresh: impl Fn(&Entry) -> bool,
) {
    page.push_str(
        "<div class=\"wide\"><table class=\"contents\"><tr><th>id</th><th>title</th><th>claims</th><th>worst \
         deviation / tolerance</th><th>snapshot</th><th>status</th></tr>\n",
    );
    for entry in catalogue {
        match pages.iter().find(|(of, _)| of.id == entry.id) {
            Some((_, record)) => contents_row(page, entry, record, is_fresh(entry)),
            None => {
                let status = if entry.is_computed() { "not run" } else { "missing" };
                let _ = writeln!(
                    page,
                    "<tr class=\"missing\"><td class=\"name\">{}</td><td>{}</td><td></td><td></td><td></td>\
                     <td>{status}</td></tr>",
                    escape(&entry.name()),
                    escape(entry.title),
                );
            }
        }
    }
    page.push_str("</table></div>\n");
}

fn contents_row(page: &mut String, entry: &Entry, record: &Page, is_fresh: bool) {
    let mut status = verdict(record.passes()).to_owned();
    if entry.state() == State::Partial {
        status.push_str(" <span class=\"partial\">partial</span>");
    }
    if !is_fresh {
        let _ = write!(status, " <span class=\"old\">{}</span>", record.date());
    }
    let _ = writeln!(
        page,
        "<tr><td class=\"name\"><a href=\"#{0}\">{1}</a></td><td>{2}</td>\
         <td class=\"number\">{3}/{4}</td>\
         <td class=\"number\">{5}</td><td>{6}</td><td>{status}</td></tr>",
        entry.id,
        escape(&entry.name()),
        escape(entry.title),
        record.held(),
        record.claims.len(),
        record.worst().map_or_else(String::new, ratio),
        record.snapshot.as_ref().map_or("", Comparison::word),
    );
}

fn section(page: &mut String, entry: &Entry, record: &Page, is_fresh: bool) {
    let (name, title) = (escape(&entry.name()), escape(entry.title));
    let _ = writeln!(page, "<h2 id=\"{}\">{name}: {title}</h2>", entry.id);
    if let Some(lacks) = entry.lacks {
        let _ = writeln!(page, "<p class=\"partial\">Partial, without {}.</p>", escape(lacks));
    }
    if !is_fresh {
        let _ = writeln!(page, "<p class=\"old\">Computed {}.</p>", record.date());
    }
    if let Some(error) = &record.error {
        let _ = writeln!(page, "<p class=\"fail\">failed: {}</p>", escape(error));
    }
    page.push_str(&record.section);
    snapshot(page, entry, record);
}

fn snapshot(page: &mut String, entry: &Entry, record: &Page) {
    let Some(Comparison::Differs(difference)) = &record.snapshot else { return };
    let file = crate::snapshot::path(Path::new("verification/snapshots"), entry.id);
    let _ = writeln!(
        page,
        "<p class=\"fail\">snapshot {} differs in {} rows</p>\n<div class=\"wide\"><table><tr>\
         <th>line</th><th>of</th><th>stored</th><th>now</th><th>relative change</th></tr>",
        escape(&file.display().to_string()),
        difference.rows,
    );
    for change in difference.changes.iter().take(20) {
        let _ = writeln!(
            page,
            "<tr><td class=\"number\">{}</td><td>{}</td><td><code>{}</code></td>\
             <td><code>{}</code></td><td class=\"number\">{}</td></tr>",
            change.line,
            escape(&change.place),
            escape(&change.stored),
            escape(&change.now),
            change.relative.map_or_else(String::new, |relative| format!("{relative:.1e}")),
        );
    }
    page.push_str("</table></div>\n");
}

/// The word for a claim or page that passes or not.
pub(crate) fn verdict(passes: bool) -> &'static str {
    if passes { "<span class=\"pass\">holds</span>" } else { "<span class=\"fail\">FAILS</span>" }
}

/// A ratio with three digits.
#[must_use]
pub fn ratio(ratio: f64) -> String {
    if ratio == 0.0 {
        "0".to_owned()
    } else if ratio.is_infinite() {
        "∞".to_owned()
    } else if (0.01..1e4).contains(&ratio) {
        format!("{ratio:.3}")
    } else {
        format!("{ratio:.1e}")
    }
}

pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FigureResult;
    use crate::snapshot::{Change, Difference};
    use std::time::Duration;

    fn nothing() -> FigureResult {
        Ok(crate::Figure::new())
    }

    fn catalogue() -> [Entry; 4] {
        [
            Entry::figure("1.1", "one & only").by(nothing).partial("markers"),
            Entry::figure("1.2", "two").by(nothing),
            Entry::figure("1.3", "three"),
            Entry::figure("1.4", "four").by(nothing),
        ]
    }

    fn pages() -> Vec<(Entry, Page)> {
        let [first, second, ..] = catalogue();
        let failed = |entry| Page::failed(entry, "no root".to_owned(), Duration::ZERO);
        let change = Change {
            place: "series: curve".to_owned(),
            line: 4,
            stored: "1.0".to_owned(),
            now: "1.5".to_owned(),
            relative: Some(0.5),
        };
        let difference = Difference { line: 4, rows: 7, count: 9, changes: vec![change] };
        let snapshot = Some(Comparison::Differs(difference));
        let section = "<p>the picture</p>".to_owned();
        let drawn = Page { error: None, snapshot, section, computed: 951_782_400, ..failed(first) };
        vec![(first, drawn), (second, failed(second))]
    }

    #[test]
    fn the_page_holds_everything() {
        let page = html(&catalogue(), &pages(), |_| true);
        for part in [
            "0 of 4 of the thesis",
            "one &amp; only",
            "Partial, without markers.",
            "the picture",
            "failed: no root",
            "missing</td>",
            "not run</td>",
            "verification/snapshots/1.1.txt differs in 7 rows",
            "5.0e-1",
        ] {
            assert!(page.contains(part), "{part}");
        }
        assert!(!page.contains("href=\"http") && !page.contains("src="), "not self-contained");
        assert!(!page.contains("2000-02-29"), "fresh pages bear no date");
    }

    #[test]
    fn what_is_not_of_this_run_bears_its_date() {
        let page = html(&catalogue(), &pages(), |entry| entry.id == "1.2");
        assert!(page.contains("1 of these pages are from earlier runs"));
        assert_eq!(page.matches("2000-02-29 00:00 UTC").count(), 3);
    }
}
