//! The report: one HTML page with everything in it. The same figures give the same bytes.

use crate::catalogue::Entry;
use crate::claim::{Claim, number};
use crate::figure::{Cell, Deviation, Input, Table};
use crate::run::{Drawn, Outcome};
use crate::snapshot::Comparison;
use crate::statistics::spread;
use std::fmt::Write as _;

const STYLE: &str = "
body{font:15px/1.5 Helvetica,Arial,sans-serif;color:#222;background:#fff;max-width:1300px;\
margin:2em auto;padding:0 1em}
h1{font-size:1.6em}h2{font-size:1.25em;margin-top:2.2em;border-top:1px solid #ddd;padding-top:1em}
h3{font-size:1em;margin-bottom:.3em}
table{border-collapse:collapse;font-size:.92em;margin:.4em 0 1em}
th,td{text-align:left;padding:.2em .7em;border-bottom:1px solid #e4e4e4;vertical-align:top}
th{border-bottom:2px solid #bbb}td.number{text-align:right;font-variant-numeric:tabular-nums}
svg{max-width:100%;height:auto}a{color:#0072B2;text-decoration:none}
.pass{color:#00734f}.fail{color:#b00020;font-weight:bold}.missing{color:#888}
";

/// The page for these outcomes, with a line for each entry of the catalogue.
#[must_use]
pub fn html(catalogue: &[Entry], outcomes: &[Outcome]) -> String {
    let mut page = String::new();
    let _ = write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\">\
         <title>carom: verification</title><style>{STYLE}</style></head><body>\n\
         <h1>carom: the tables and figures of “Elastic Impact with Friction”</h1>\n"
    );
    summary(&mut page, catalogue, outcomes);
    contents(&mut page, catalogue, outcomes);
    for outcome in outcomes {
        section(&mut page, outcome);
    }
    page.push_str("</body></html>\n");
    page
}

fn summary(page: &mut String, catalogue: &[Entry], outcomes: &[Outcome]) {
    let of_thesis = || catalogue.iter().filter(|entry| entry.is_in_thesis());
    let done = of_thesis().filter(|entry| entry.is_done()).count();
    let passed = outcomes.iter().filter(|outcome| outcome.passes()).count();
    let claims: usize = outcomes.iter().map(|outcome| outcome.score().total).sum();
    let held: usize = outcomes.iter().map(|outcome| outcome.score().passed).sum();
    let _ = writeln!(
        page,
        "<p>{passed} of {} verified entries pass; {held} of {claims} claims hold. {done} of {} \
         tables and figures of the thesis (J. Jaeger, TU Delft 1992) are computed.</p>\n\
         <p>Inputs are marked <em>stated</em> (the thesis gives them), <em>derived</em> (they \
         follow from what it gives) or <em>assumed</em> (our choice). A claim's deviation is \
         given over its tolerance: up to 1 it holds. For a bound it is the part used.</p>",
        outcomes.len(),
        of_thesis().count(),
    );
}

fn contents(page: &mut String, catalogue: &[Entry], outcomes: &[Outcome]) {
    page.push_str(
        "<table><tr><th>id</th><th>title</th><th>claims</th><th>worst deviation / \
                   tolerance</th><th>snapshot</th><th>status</th></tr>\n",
    );
    for entry in catalogue {
        let outcome = outcomes.iter().find(|outcome| outcome.entry.id == entry.id);
        match outcome {
            Some(outcome) => contents_row(page, outcome),
            None => {
                let status = if entry.is_done() { "not run" } else { "missing" };
                let _ = writeln!(
                    page,
                    "<tr class=\"missing\"><td>{}</td><td>{}</td><td></td><td></td><td></td>\
                     <td>{status}</td></tr>",
                    escape(&entry.name()),
                    escape(entry.title),
                );
            }
        }
    }
    page.push_str("</table>\n");
}

fn contents_row(page: &mut String, outcome: &Outcome) {
    let entry = outcome.entry;
    let score = outcome.score();
    let snapshot = match &outcome.result {
        Ok(drawn) => match drawn.snapshot {
            Comparison::Same | Comparison::Written => "agrees",
            Comparison::Missing => "none",
            Comparison::Differs(_) => "differs",
        },
        Err(_) => "",
    };
    let _ = writeln!(
        page,
        "<tr><td><a href=\"#{0}\">{1}</a></td><td>{2}</td><td class=\"number\">{3}/{4}</td>\
         <td class=\"number\">{5}</td><td>{snapshot}</td><td>{6}</td></tr>",
        entry.id,
        escape(&entry.name()),
        escape(entry.title),
        score.passed,
        score.total,
        outcome.worst_ratio().map_or_else(String::new, ratio),
        verdict(outcome.passes()),
    );
}

fn section(page: &mut String, outcome: &Outcome) {
    let entry = outcome.entry;
    let _ = writeln!(
        page,
        "<h2 id=\"{}\">{}: {}</h2>",
        entry.id,
        escape(&entry.name()),
        escape(entry.title)
    );
    match &outcome.result {
        Ok(drawn) => drawn_section(page, drawn),
        Err(error) => {
            let _ = writeln!(page, "<p class=\"fail\">failed: {}</p>", escape(error));
        }
    }
}

fn drawn_section(page: &mut String, drawn: &Drawn) {
    let figure = &drawn.figure;
    if let Some(svg) = &drawn.svg {
        page.push_str(svg);
    }
    figure.tables.iter().for_each(|table| data_table(page, table));
    inputs(page, &figure.inputs);
    claims(page, &figure.claims);
    statistics(page, &figure.claims);
    deviations(page, &figure.deviations);
    if let Comparison::Differs(difference) = &drawn.snapshot {
        let _ = writeln!(
            page,
            "<p class=\"fail\">snapshot differs at line {}: stored <code>{}</code>, now \
             <code>{}</code></p>",
            difference.line,
            escape(&difference.stored),
            escape(&difference.now)
        );
    }
}

fn data_table(page: &mut String, table: &Table) {
    let _ = write!(page, "<h3>{}</h3>\n<table>", escape(&table.title));
    head(page, table.columns.iter().map(String::as_str));
    for row in &table.rows {
        page.push_str("<tr>");
        for cell in row {
            let _ = match cell {
                Cell::Number(value) => {
                    write!(page, "<td class=\"number\">{}</td>", number(*value))
                }
                Cell::Text(text) | Cell::Remark(text) => write!(page, "<td>{}</td>", escape(text)),
            };
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</table>\n");
}

fn inputs(page: &mut String, inputs: &[Input]) {
    if inputs.is_empty() {
        return;
    }
    page.push_str("<h3>Inputs</h3>\n<table>");
    head(page, ["input", "value", "origin"]);
    for input in inputs {
        let cells = [&*input.name, &input.value, input.origin.word()];
        row(page, cells);
    }
    page.push_str("</table>\n");
}

fn claims(page: &mut String, claims: &[Claim]) {
    page.push_str("<h3>Claims</h3>\n<table>");
    head(page, ["claim", "measured", "expected", "deviation / tolerance", "source", ""]);
    for claim in claims {
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"number\">{}</td><td>{}</td>\
             <td>{}</td></tr>",
            escape(&claim.statement),
            escape(&claim.measured()),
            escape(&claim.expected()),
            ratio(claim.ratio()),
            escape(&claim.source),
            verdict(claim.passes()),
        );
    }
    page.push_str("</table>\n");
}

fn statistics(page: &mut String, claims: &[Claim]) {
    let spreads: Vec<_> = claims.iter().filter_map(|claim| Some((claim, spread(claim)?))).collect();
    if spreads.is_empty() {
        return;
    }
    page.push_str("<h3>Error statistics</h3>\n<table>");
    head(page, ["claim", "values", "mean", "rms", "95 %", "largest"]);
    for (claim, spread) in spreads {
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{:.2e}</td>\
             <td class=\"number\">{:.2e}</td><td class=\"number\">{:.2e}</td>\
             <td class=\"number\">{:.2e}</td></tr>",
            escape(&claim.statement),
            spread.count,
            spread.mean,
            spread.rms,
            spread.percentile_95,
            spread.max,
        );
    }
    page.push_str("</table>\n");
}

fn deviations(page: &mut String, deviations: &[Deviation]) {
    if deviations.is_empty() {
        return;
    }
    page.push_str("<h3>Deviations from the thesis</h3>\n<table>");
    head(page, ["printed", "correct", "cause"]);
    for deviation in deviations {
        row(page, [&*deviation.printed, &deviation.corrected, &deviation.cause]);
    }
    page.push_str("</table>\n");
}

fn head<'a>(page: &mut String, heads: impl IntoIterator<Item = &'a str>) {
    page.push_str("<tr>");
    for head in heads {
        let _ = write!(page, "<th>{}</th>", escape(head));
    }
    page.push_str("</tr>\n");
}

fn row<'a>(page: &mut String, cells: impl IntoIterator<Item = &'a str>) {
    page.push_str("<tr>");
    for cell in cells {
        let _ = write!(page, "<td>{}</td>", escape(cell));
    }
    page.push_str("</tr>\n");
}

fn verdict(passes: bool) -> &'static str {
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

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, Figure, FigureResult, Panel, Series, Tolerance};
    use std::time::Duration;

    fn drawn() -> Drawn {
        let mut figure = Figure::new();
        figure.assumed("nu", "< 0.5");
        figure.claim(Claim::all_close("near", [(1.0, 1.1), (2.0, 2.0)], Tolerance::Absolute(0.2)));
        figure.claim(Claim::at_most("not small", 2.0, 1.0));
        figure.deviation("3 %", "3.35 %", "rounded");
        let mut panel = Panel::new(Axis::linear("x"), Axis::linear("y"));
        panel.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
        figure.panel(panel);
        let svg = carom_plot::render("t", &figure.panels).ok();
        Drawn { figure, svg, snapshot: Comparison::Same }
    }

    fn nothing() -> FigureResult {
        Ok(Figure::new())
    }

    #[test]
    fn the_page_holds_everything() {
        let entries = [
            Entry::figure("1.1", "one & only").by(nothing),
            Entry::figure("1.2", "two").by(nothing),
            Entry::figure("1.3", "three"),
        ];
        let time = Duration::ZERO;
        let outcomes = [
            Outcome { entry: entries[0], result: Ok(drawn()), time },
            Outcome { entry: entries[1], result: Err("no root".to_owned()), time },
        ];
        let page = html(&entries, &outcomes);
        for part in [
            "one &amp; only",
            "&lt; 0.5",
            "assumed",
            "<svg",
            "3.35 %",
            "failed: no root",
            "missing",
            "1/2",
            "Error statistics",
        ] {
            assert!(page.contains(part), "{part}");
        }
        assert!(!page.contains("href=\"http") && !page.contains("src="), "not self-contained");
        assert_eq!(page, html(&entries, &outcomes));
    }
}
