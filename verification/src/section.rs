//! The section of a page in the report: picture, tables, inputs, claims, deviations.

use crate::claim::{Claim, number, significant};
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
    picture(&mut page, &drawn.panels);
    figure.tables.iter().for_each(|table| data_table(&mut page, table));
    claims(&mut page, &figure.claims);
    deviations(&mut page, &figure.deviations);
    inputs(&mut page, &figure.inputs);
    statistics(&mut page, &figure.claims);
    page
}

/// The panels side by side, as far as there is room for letters that can be read.
fn picture(page: &mut String, panels: &[String]) {
    if panels.is_empty() {
        return;
    }
    page.push_str("<div class=\"picture\" tabindex=\"0\">");
    for svg in panels {
        let width = svg.split(" width=\"").nth(1).and_then(|rest| rest.split('"').next());
        let width = width.unwrap_or_default();
        let _ = write!(page, "<div class=\"panel\" style=\"--width:{width}\">{}</div>", slim(svg));
    }
    page.push_str("</div>\n");
}

/// The most columns that fit on a narrow screen beside each other.
const FEW_COLUMNS: usize = 4;

fn data_table(page: &mut String, table: &Table) {
    let has_words =
        |row: &Vec<Cell>| row.iter().skip(1).any(|cell| !matches!(cell, Cell::Number(_)));
    let is_wide = table.columns.len() > FEW_COLUMNS && table.rows.iter().any(has_words);
    let class = if is_wide { "data cards" } else { "data" };
    open(page, class, &table.title, table.columns.iter().map(String::as_str));
    for row in &table.rows {
        page.push_str("<tr>");
        for (cell, head) in row.iter().zip(&table.columns) {
            // On a narrow screen each row is a card, each cell with the head of its column.
            let head =
                if is_wide { format!(" data-head=\"{}\"", escape(head)) } else { String::new() };
            let _ = match cell {
                Cell::Number(value) => {
                    let value = shown(*value, table.digits);
                    write!(page, "<td class=\"number\"{head}>{value}</td>")
                }
                Cell::Text(text) | Cell::Remark(text) => {
                    write!(page, "<td{head}>{}</td>", prose(text))
                }
            };
        }
        page.push_str("</tr>\n");
    }
    close(page);
}

/// A number of a table; counts in full.
fn shown(value: f64, digits: usize) -> String {
    if value.fract() == 0.0 { number(value) } else { significant(value, digits) }
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
            unbroken(&claim.measured()),
            unbroken(&claim.expected()),
            ratio(claim.ratio()),
            meter(claim.ratio()),
            if claim.has_source() { prose(&claim.source) } else { NO_SOURCE.to_owned() },
            source_line(claim),
        );
    }
    close(page);
}

/// A number and its tolerance, which stay in one line.
fn unbroken(text: &str) -> String {
    escape(text).replace(" ±", "&nbsp;±").replace("± ", "±&nbsp;").replace(" %", "&nbsp;%")
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
        let panels = carom_plot::render_each("t", &figure.panels).unwrap();
        let section = html(&Drawn { figure, svg: None, panels, snapshot: Comparison::Same });
        for part in [
            "&lt; 0.5",
            "assumed",
            "<div class=\"panel\" style=\"--width:540\"><svg",
            "3.35 %",
            "Error statistics",
            "(5.3)",
            "none given",
            "section.rs#L",
        ] {
            assert!(section.contains(part), "{part}");
        }
    }

    #[test]
    fn wide_tables_with_words_become_cards_and_numbers_are_rounded() {
        let of = |columns: &[&str], digits| {
            let mut table = Table::new("", columns.iter().copied()).shown_to(digits);
            let numbers = (2..columns.len()).map(|_| Cell::from(1.0 / 3.0));
            table.row([Cell::from("a"), Cell::from("F_x")].into_iter().chain(numbers));
            let mut page = String::new();
            data_table(&mut page, &table);
            page
        };
        let wide = of(&["equation", "printed", "c", "d", "e_x"], 3);
        assert!(wide.contains("class=\"data cards\""), "{wide}");
        assert!(wide.contains("<td class=\"number\" data-head=\"e_x\">0.333</td>"), "{wide}");
        assert!(wide.contains("<td data-head=\"printed\">F<sub>x</sub></td>"), "{wide}");
        let narrow = of(&["equation", "printed", "c"], 6);
        assert!(narrow.contains("class=\"data\"") && !narrow.contains("data-head"), "{narrow}");
        assert!(narrow.contains(">0.333333<"), "{narrow}");
        assert_eq!(shown(12_345_678.0, 3), "1.2345678e7");
    }
}
