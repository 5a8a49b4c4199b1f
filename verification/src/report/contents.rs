//! The search bar and the table of contents of the report.

use super::Report;
use super::markup::{escape, prose};
use crate::catalogue::{Entry, State};
use crate::page::Page;
use std::fmt::Write as _;

/// Titles of the chapters of the thesis.
const CHAPTERS: &[(&str, &str)] = &[
    ("3", "Survey of the theories"),
    ("4", "The elastic half-space"),
    ("5", "Hertz, shift and torsion"),
    ("6", "Histories along a line"),
    ("7", "Histories in all directions"),
    ("8", "Equations of motion"),
    ("9", "Impact without torsion"),
    ("10", "Torsional impact"),
    ("11", "The numerical method"),
    ("12", "Gauss-Seidel with friction"),
    ("13", "Convergence"),
    ("14", "Numerical load histories"),
    ("15", "Coefficients of restitution"),
];

/// Titles of the groups of other pages, by the first part of their names.
const GROUPS: &[(&str, &str)] = &[
    ("errata", "Corrections of the print"),
    ("measured", "What measurement says"),
    ("rebound", "The oblique impact as a whole"),
    ("particles", "Tests of particle codes"),
    ("convergence", "Rates of convergence"),
    ("accuracy", "Accuracy"),
    ("rolling", "Rolling contact"),
    ("contact", "Cases of the program CONTACT"),
    ("proposition", "Propositions"),
];

/// The group of a page, and its title.
#[must_use]
pub fn group(entry: &Entry) -> (&'static str, String) {
    let chapter = entry.chapter();
    if let Some((number, title)) = CHAPTERS.iter().find(|(of, _)| *of == chapter) {
        return (number, format!("{number} · {title}"));
    }
    let known = GROUPS.iter().find(|(name, _)| chapter.starts_with(name));
    known.map_or((chapter, chapter.to_owned()), |(name, title)| (name, (*title).to_owned()))
}

/// The search bar above the pages.
pub(super) fn bar(page: &mut String, catalogue: &[Entry]) {
    page.push_str(
        "<header class=\"bar\"><a class=\"name\" href=\"#\">carom</a>\
         <input id=\"query\" type=\"search\" placeholder=\"Search: words, or an equation as 7.48\" \
         aria-label=\"Search\"><select id=\"chapter\" aria-label=\"Chapter\">\
         <option value=\"all\">all chapters</option>",
    );
    let mut last = String::new();
    for entry in catalogue {
        let (name, title) = group(entry);
        if name != last {
            let _ = write!(page, "<option value=\"{name}\">{}</option>", escape(&title));
            name.clone_into(&mut last);
        }
    }
    page.push_str(
        "<option value=\"index\">Index of equations</option></select>\
         <select id=\"state\" aria-label=\"State\"><option value=\"all\">all states</option>\
         <option value=\"done\">done</option><option value=\"partial\">partial</option>\
         <option value=\"missing\">missing</option><option value=\"failing\">failing</option>\
         <option value=\"deviations\">the print is corrected</option></select>\
         <button id=\"clear\" type=\"button\">all</button>\
         <output id=\"found\" aria-live=\"polite\"></output>\
         <button class=\"theme\" type=\"button\" title=\"light, dark, or as the system\">theme</button>\
         </header>\n",
    );
}

/// The table of contents.
pub(super) fn list(page: &mut String, report: &Report<'_>) {
    page.push_str("<nav aria-label=\"Contents\"><details open><summary>Contents</summary>\n");
    page.push_str(
        "<section><ol><li data-page=\"play\" data-chapter=\"play\" data-state=\"done\" data-fails=\"0\" \
         data-deviates=\"0\"><a href=\"#play\"><b>▶</b> An impact to play with</a></li></ol></section>\n",
    );
    let mut last = String::new();
    for entry in report.catalogue {
        let (name, title) = group(entry);
        if name != last {
            let end = if last.is_empty() { "" } else { "</ol></section>\n" };
            let _ = writeln!(page, "{end}<section><h2>{}</h2><ol>", escape(&title));
            name.clone_into(&mut last);
        }
        line(page, entry, name, report.record(entry));
    }
    page.push_str(
        "</ol></section>\n<section><h2>Index</h2><ol><li data-page=\"equations\" \
         data-chapter=\"index\" data-state=\"done\" data-fails=\"0\" data-deviates=\"1\">\
         <a href=\"#equations-page\"><b>(1)…</b> Equations and the functions that implement them\
         </a></li><li data-page=\"speed\" data-chapter=\"index\" data-state=\"done\" data-fails=\"0\" \
         data-deviates=\"0\"><a href=\"#speed\">Speed beside other programs</a></li></ol></section>\
         </details></nav>\n",
    );
}

fn line(page: &mut String, entry: &Entry, group: &str, record: Option<&Page>) {
    let id = entry.id;
    let state = if record.is_some() { entry.state() } else { State::Missing }.word();
    let fails = u8::from(record.is_some_and(|record| !record.passes()));
    let deviates = u8::from(record.is_some_and(|record| record.deviations > 0));
    let class = if record.is_some() { "" } else { " class=\"missing\"" };
    let _ = write!(
        page,
        "<li{class} data-page=\"{id}\" data-chapter=\"{group}\" data-state=\"{state}\" \
         data-fails=\"{fails}\" data-deviates=\"{deviates}\">"
    );
    let number = match id.strip_prefix("table-") {
        Some(number) => format!("<b>Table {}</b> ", escape(number)),
        None if entry.is_in_thesis() => format!("<b>{}</b> ", escape(id)),
        None => String::new(),
    };
    let words = format!("{number}{}", prose(entry.title));
    let _ = match record {
        Some(record) => {
            let mark = match (record.passes(), entry.state()) {
                (false, _) => "<span class=\"fail\" title=\"fails\">✗</span>",
                (true, State::Partial) => "<span class=\"partial\" title=\"partial\">◐</span>",
                (true, _) => "<span class=\"pass\" title=\"holds\">✓</span>",
            };
            writeln!(page, "<a href=\"#{id}\">{words}</a>{mark}</li>")
        }
        None => {
            let word = if entry.is_computed() { "not run" } else { "missing" };
            writeln!(page, "<span class=\"title\">{words}</span><small>{word}</small></li>")
        }
    };
}
