//! The section of a page in the report: picture, tables, inputs, claims, deviations.

use crate::claim::{Claim, number};
use crate::figure::{Cell, Deviation, Figure, Input, Table};
use crate::report::markup::{escape, prose};
use crate::report::ratio;
use crate::report::slim::slim;
use crate::run::Drawn;
use crate::statistics::spread;
use std::fmt::Write as _;

/// The section of a computed figure, without its heading.
#[must_use]
pub fn html(drawn: &Drawn) -> String {
    let figure: &Figure = &drawn.figure;
    let mut page = String::new();
    if let Some(svg) = &drawn.svg {
        let _ = writeln!(page, "<div class=\"picture\" tabindex=\"0\">{}</div>", slim(svg));
    }
    figure.tables.iter().for_each(|table| data_table(&mut page, table));
    claims(&mut page, &figure.claims);
    deviations(&mut page, &figure.deviations);
    inputs(&mut page, &figure.inputs);
    statistics(&mut page, &figure.claims);
    page
}

fn data_table(page: &mut String, table: &Table) {
    open(page, "data", &table.title, table.columns.iter().map(String::as_str));
    for row in &table.rows {
        page.push_str("<tr>");
        for cell in row {
            let _ = match cell {
                Cell::Number(value) => {
                    write!(page, "<td class=\"number\">{}</td>", number(*value))
                }
                Cell::Text(text) | Cell::Remark(text) => write!(page, "<td>{}</td>", prose(text)),
            };
        }
        page.push_str("</tr>\n");
    }
    close(page);
}

fn inputs(page: &mut String, inputs: &[Input]) {
    if inputs.is_empty() {
        return;
    }
    open(page, "inputs", "Inputs", ["input", "value", "origin"]);
    for input in inputs {
        let origin = input.origin.word();
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td>{}</td><td><span class=\"origin {origin}\">{origin}</span></td></tr>",
            prose(&input.name),
            prose(&input.value),
        );
    }
    close(page);
}

fn claims(page: &mut String, claims: &[Claim]) {
    let heads = ["", "claim", "measured", "expected", "deviation / tolerance", "source"];
    open(page, "claims", "Claims", heads);
    for claim in claims {
        let _ = writeln!(
            page,
            "<tr><td class=\"mark\">{}</td><td>{}</td><td>{}</td><td>{}</td>\
             <td class=\"number\">{}{}</td><td>{} {}</td></tr>",
            mark(claim.passes()),
            prose(&claim.statement),
            escape(&claim.measured()),
            escape(&claim.expected()),
            ratio(claim.ratio()),
            meter(claim.ratio()),
            if claim.has_source() { prose(&claim.source) } else { NO_SOURCE.to_owned() },
            source_line(claim),
        );
    }
    close(page);
}

fn mark(passes: bool) -> &'static str {
    if passes {
        "<span class=\"pass\">✓ holds</span>"
    } else {
        "<span class=\"fail\">✗ FAILS</span>"
    }
}

/// The share of the tolerance that is used, as a bar.
fn meter(ratio: f64) -> String {
    let part = (100.0 * ratio).clamp(0.0, 100.0);
    format!("<span class=\"meter\" aria-hidden=\"true\"><i style=\"width:{part:.0}%\"></i></span>")
}

/// A link from `target/verification/report.html` to the source line of a claim.
fn source_line(claim: &Claim) -> String {
    let (file, line) = (claim.place.file().replace('\\', "/"), claim.place.line());
    let name = file.strip_prefix("verification/src/figures/").unwrap_or(&file);
    format!(
        "<a class=\"line\" href=\"../../{}#L{line}\">{}:{line}</a>",
        escape(&file),
        escape(name)
    )
}

const NO_SOURCE: &str = "<span class=\"fail\">none given</span>";

fn statistics(page: &mut String, claims: &[Claim]) {
    let spreads: Vec<_> = claims.iter().filter_map(|claim| Some((claim, spread(claim)?))).collect();
    if spreads.is_empty() {
        return;
    }
    page.push_str("<details><summary>Error statistics</summary>\n");
    open(page, "statistics", "", ["claim", "values", "mean", "rms", "95 %", "largest"]);
    for (claim, spread) in spreads {
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{:.2e}</td>\
             <td class=\"number\">{:.2e}</td><td class=\"number\">{:.2e}</td>\
             <td class=\"number\">{:.2e}</td></tr>",
            prose(&claim.statement),
            spread.count,
            spread.mean,
            spread.rms,
            spread.percentile_95,
            spread.max,
        );
    }
    close(page);
    page.push_str("</details>\n");
}

fn deviations(page: &mut String, deviations: &[Deviation]) {
    if deviations.is_empty() {
        return;
    }
    let heads = ["printed", "correct", "cause"];
    open(page, "deviations", "Deviations from what is printed", heads);
    for deviation in deviations {
        row(page, [&*deviation.printed, &deviation.corrected, &deviation.cause]);
    }
    close(page);
}

fn open<'a>(page: &mut String, class: &str, title: &str, heads: impl IntoIterator<Item = &'a str>) {
    if !title.is_empty() {
        let _ = writeln!(page, "<h3>{}</h3>", prose(title));
    }
    let _ = write!(page, "<div class=\"wide\" tabindex=\"0\"><table class=\"{class}\"><thead><tr>");
    for head in heads {
        let _ = write!(page, "<th>{}</th>", prose(head));
    }
    page.push_str("</tr></thead><tbody>\n");
}

fn row<'a>(page: &mut String, cells: impl IntoIterator<Item = &'a str>) {
    page.push_str("<tr>");
    for cell in cells {
        let _ = write!(page, "<td>{}</td>", prose(cell));
    }
    page.push_str("</tr>\n");
}

fn close(page: &mut String) {
    page.push_str("</tbody></table></div>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::snapshot::Comparison;
    use crate::{Panel, Series, Tolerance};

    #[test]
    fn a_section_holds_everything() {
        let mut figure = Figure::new();
        figure.assumed("nu", "< 0.5");
        let near = [(1.0, 1.1), (2.0, 2.0)];
        figure.claim(Claim::all_close("near", near, Tolerance::Absolute(0.2)).source("(5.3)"));
        figure.claim(Claim::at_most("not small", 2.0, 1.0));
        figure.deviation("3 %", "3.35 %", "rounded");
        let mut panel = Panel::new("x", "y");
        panel.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
        figure.panel(panel);
        let svg = carom_plot::render("t", &figure.panels).ok();
        let section = html(&Drawn { figure, svg, snapshot: Comparison::Same });
        for part in [
            "&lt; 0.5",
            "assumed",
            "<svg",
            "3.35 %",
            "Error statistics",
            "(5.3)",
            "none given",
            "section.rs#L",
        ] {
            assert!(section.contains(part), "{part}");
        }
    }
}
