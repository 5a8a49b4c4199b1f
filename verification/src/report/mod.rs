//! The report: one self-contained HTML page. Two runs of all pages give the same bytes; pages of
//! earlier runs have a date.

pub mod contents;
mod equations;
pub(crate) mod markup;
pub(crate) mod slim;
mod speed;
pub mod texts;

use crate::catalogue::{Entry, State};
use crate::page::Page;
use crate::snapshot::Comparison;
use crate::tally::Tally;
use markup::{escape, prose};
use std::fmt::Write as _;
use std::path::Path;

/// Colours and sliders are those of the page of `doors/carom-rebound`.
const STYLE: &str = concat!(
    include_str!("../../../doors/carom-rebound/page/theme.css"),
    include_str!("style.css"),
    include_str!("../../../doors/carom-rebound/page/play.css"),
);
const SCRIPT: &str = include_str!("script.js");

/// The contents of a report.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// All tables, figures and checks.
    pub catalogue: &'a [Entry],
    /// The pages computed in this run or an earlier one.
    pub pages: &'a [(Entry, Page)],
    /// The root of the workspace, for links to sources.
    pub workspace: &'a Path,
}

impl Report<'_> {
    /// The report, with a line for each entry of the catalogue; `is_fresh` tells whether a page is
    /// from this run.
    #[must_use]
    pub fn html(&self, is_fresh: impl Fn(&Entry) -> bool) -> String {
        let mut page = String::new();
        let _ = write!(
            page,
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
             <title>carom: verification</title>\n<style>\n{STYLE}</style></head><body>\n"
        );
        contents::bar(&mut page, self.catalogue);
        page.push_str("<div class=\"frame\">\n");
        contents::list(&mut page, self);
        page.push_str("<main>\n<p id=\"none\" class=\"none\" role=\"status\"></p>\n");
        self.summary(&mut page, &is_fresh);
        let _ = write!(
            page,
            "<section class=\"page\" id=\"play\" data-page=\"play\"><h2>An impact to play with</h2>\n{}</section>\n",
            crate::play::section()
        );
        for entry in self.catalogue {
            if let Some(record) = self.record(entry) {
                section(&mut page, entry, record, is_fresh(entry));
            }
        }
        page.push_str(&speed::section());
        let _ = write!(
            page,
            "<section class=\"page\" id=\"equations-page\" data-page=\"equations\">\
             <h2>Index of equations</h2>\n{}</section>\n",
            equations::page(self.workspace)
        );
        let _ = write!(page, "</main></div>\n<script>\n{SCRIPT}</script>\n</body></html>\n");
        page
    }

    fn record(&self, entry: &Entry) -> Option<&Page> {
        self.pages.iter().find(|(of, _)| of.id == entry.id).map(|(_, record)| record)
    }

    fn summary(&self, page: &mut String, is_fresh: impl Fn(&Entry) -> bool) {
        let tally = Tally::of(self.catalogue, self.pages);
        let _ = writeln!(
            page,
            "<section class=\"intro\"><h1>The tables and figures of “Elastic Impact with Friction”, \
             computed</h1>\n<p class=\"headline\">{tally}</p>"
        );
        let is_old = |(entry, _): &&(Entry, Page)| !is_fresh(entry);
        let old: Vec<&Page> = self.pages.iter().filter(is_old).map(|(_, record)| record).collect();
        if let Some(oldest) = old.iter().min_by_key(|record| record.computed) {
            let _ = writeln!(
                page,
                "<p class=\"old\">{} of these pages are from earlier runs, the oldest from {}: \
                 each bears its date.</p>",
                old.len(),
                oldest.date()
            );
        }
        page.push_str(INTRODUCTION);
    }
}

const INTRODUCTION: &str = "<p>What happens when two elastic bodies touch, slip, stick, twist and \
rebound: J. Jaeger's thesis (TU Delft 1992) answers in formulas, tables and figures. carom \
computes each of them again. Each page below gives its inputs, its results and the claims that check \
them.</p>\n\
<p>A page counts if its claims hold and its snapshot agrees. A <span class=\"partial\">partial</span> \
page lacks something that the thesis shows, and names it; missing pages are grey in the \
contents. Inputs are <span class=\"origin stated\">stated</span> if the source gives them, \
<span class=\"origin derived\">derived</span> if they follow from what it gives, and \
<span class=\"origin assumed\">assumed</span> if they were chosen here. The deviation of a claim is \
given over its tolerance: the claim holds up to 1. For a bound it is the share that is used. A \
claim that holds is true as it is worded; on the pages of measurements some state where theory and \
measurement differ. Each claim links to its line in the source. The search covers titles, texts, claims and equation numbers \
such as <kbd>7.48</kbd>; the key <kbd>/</kbd> opens it.</p></section>\n";

fn section(page: &mut String, entry: &Entry, record: &Page, is_fresh: bool) {
    let (id, title) = (entry.id, prose(entry.title));
    let heading = match entry.is_in_thesis() {
        true => format!("<a href=\"#{id}\">{}</a>{title}", escape(&entry.name())),
        false => format!("{title} <a class=\"id\" href=\"#{id}\">{id}</a>"),
    };
    let _ =
        writeln!(page, "<section class=\"page\" id=\"{id}\" data-page=\"{id}\"><h2>{heading}</h2>");
    tags(page, entry, record, is_fresh);
    if let Some(text) = texts::text(id) {
        let _ = writeln!(page, "<p class=\"why\">{}</p>", prose(text));
    }
    if let Some(lacks) = entry.lacks {
        let _ = writeln!(page, "<p class=\"partial\">Partial, without {}.</p>", prose(lacks));
    }
    if let Some(error) = &record.error {
        let _ = writeln!(page, "<p class=\"fail\">failed: {}</p>", escape(error));
    }
    page.push_str(&record.section);
    snapshot(page, entry, record);
    page.push_str("</section>\n");
}

fn tags(page: &mut String, entry: &Entry, record: &Page, is_fresh: bool) {
    let (claims_that_hold, all) = (record.claims_that_hold(), record.claims.len());
    let verdict = if record.passes() { "pass" } else { "fail" };
    let word = if record.passes() { "holds" } else { "FAILS" };
    let _ = write!(page, "<p class=\"tags\"><span class=\"{verdict}\">{word}</span>");
    if entry.state() == State::Partial {
        page.push_str("<span class=\"partial\">partial</span>");
    }
    let _ = write!(page, "<span>{claims_that_hold} of {all} claims</span>");
    if let Some(worst) = record.worst() {
        let _ = write!(page, "<span>worst deviation {} of its tolerance</span>", ratio(worst));
    }
    if let Some(comparison) = &record.snapshot {
        let _ = write!(page, "<span>snapshot {}</span>", comparison.word());
    }
    if record.deviations > 0 {
        let plural = if record.deviations == 1 { "" } else { "s" };
        let _ = write!(page, "<span>{} correction{plural} of the print</span>", record.deviations);
    }
    if !is_fresh {
        let _ = write!(page, "<span class=\"old\">Computed {}.</span>", record.date());
    }
    page.push_str("</p>\n");
}

fn snapshot(page: &mut String, entry: &Entry, record: &Page) {
    let Some(Comparison::Differs(difference)) = &record.snapshot else { return };
    let file = crate::snapshot::path(Path::new("verification/snapshots"), entry.id);
    let _ = writeln!(
        page,
        "<p class=\"fail\">snapshot {} differs in {} rows</p>\n<div class=\"wide\" tabindex=\"0\"><table>\
         <thead><tr><th>line</th><th>of</th><th>stored</th><th>now</th><th>relative change</th></tr>\
         </thead><tbody>",
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
    page.push_str("</tbody></table></div>\n");
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
            Entry::check("own", "five").by(nothing),
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
        let drawn = Page {
            error: None,
            snapshot,
            section,
            deviations: 2,
            computed: 951_782_400,
            ..failed(first)
        };
        vec![(first, drawn), (second, failed(second))]
    }

    fn report(is_fresh: impl Fn(&Entry) -> bool) -> String {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let (catalogue, pages) = (catalogue(), pages());
        Report { catalogue: &catalogue, pages: &pages, workspace: &workspace }.html(is_fresh)
    }

    #[test]
    fn the_page_holds_everything() {
        let page = report(|_| true);
        for part in [
            "0 of 3 of the thesis",
            "<h2><a href=\"#1.1\">Fig. 1.1</a>one &amp; only</h2>",
            "Partial, without markers.",
            "the picture",
            "failed: no root",
            "<li class=\"missing\" data-page=\"1.3\"",
            "not run",
            "corrections of the print",
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
        let page = report(|entry| entry.id == "1.2");
        assert!(page.contains("1 of these pages are from earlier runs"));
        assert_eq!(page.matches("2000-02-29 00:00 UTC").count(), 2);
    }

    #[test]
    fn a_title_is_said_once_and_a_check_s_name_stands_beside_it() {
        let mut page = String::new();
        let entry = Entry::check("rebound.regimes", "Which regimes there are").by(nothing);
        let record = Page::failed(entry, String::new(), Duration::ZERO);
        section(&mut page, &entry, &record, true);
        let heading = page.split("<h2>").nth(1).unwrap().split("</h2>").next().unwrap();
        let name = "<a class=\"id\" href=\"#rebound.regimes\">rebound.regimes</a>";
        assert_eq!(heading, format!("Which regimes there are {name}"));
    }

    /// The colours of the style by name, light and dark.
    fn colours() -> Vec<(&'static str, [[f64; 3]; 2])> {
        let parse = |hex: &str| -> [f64; 3] {
            let hex = hex.trim().trim_start_matches('#');
            [0, 2, 4].map(|i| f64::from(u8::from_str_radix(&hex[i..i + 2], 16).unwrap()) / 255.0)
        };
        let lines = STYLE.lines().filter_map(|line| line.trim().strip_prefix("--"));
        let pairs = lines.filter_map(|line| line.split_once(": light-dark("));
        pairs
            .map(|(name, rest)| {
                let (light, dark) = rest.trim_end_matches(");").split_once(',').unwrap();
                (name, [parse(light), parse(dark)])
            })
            .collect()
    }

    /// Relative luminance, as the guidelines for accessible pages (WCAG 2) define it.
    fn luminance(colour: [f64; 3]) -> f64 {
        let linear = colour
            .map(|c| if c <= 0.040_45 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    #[test]
    fn words_stand_out_from_their_ground_in_both_themes() {
        let colours = colours();
        let of = |name: &str| colours.iter().find(|(of, _)| *of == name).unwrap().1;
        for words in ["ink", "soft", "link", "good", "bad", "half"] {
            for ground in ["page", "card", "sunk"] {
                for theme in [0, 1] {
                    let [one, other] = [of(words)[theme], of(ground)[theme]].map(luminance);
                    let contrast = (one.max(other) + 0.05) / (one.min(other) + 0.05);
                    assert!(contrast >= 4.5, "{words} on {ground}, theme {theme}: {contrast:.2}");
                }
            }
        }
    }
}
