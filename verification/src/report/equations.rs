//! The index of the numbered equations of the thesis: the items that implement each, or why none
//! does.

use super::markup::{escape, prose};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::LazyLock;

static INDEX: LazyLock<Index> =
    LazyLock::new(|| toml::from_str(include_str!("../../equations.toml")).unwrap_or_default());

#[derive(Default, Deserialize)]
struct Index {
    equation: Vec<Equation>,
    proposition: Vec<Formula>,
}

/// A formula of a proposition.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Formula {
    /// The number of the proposition.
    number: u32,
    /// Its meaning.
    what: String,
    /// The items that implement it.
    by: Vec<String>,
}

/// A numbered equation.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Equation {
    /// Its number, such as `7.48`, or a range with one line, such as `7.11-7.14`.
    pub(crate) number: String,
    /// Its meaning.
    pub(crate) what: String,
    /// The items that implement it, such as `laws/hertz.rs::Hertz::force`.
    #[serde(default)]
    pub(crate) by: Vec<String>,
    /// Why no item implements it.
    pub(crate) none: Option<String>,
    /// The correction, if the print is wrong.
    pub(crate) corrected: Option<String>,
}

impl Equation {
    /// The first and the last number of the line.
    fn ends(&self) -> Option<[(u32, u32); 2]> {
        let (first, last) = self.number.split_once('-').unwrap_or((&self.number, &self.number));
        Some([parse(first)?, parse(last)?])
    }
}

/// `7.65a` as (7, 65).
fn parse(number: &str) -> Option<(u32, u32)> {
    let (chapter, rest) = number.split_once('.')?;
    let rest = rest.trim_end_matches(|c: char| ('a'..='h').contains(&c));
    let is_digits = |text: &str| text.len() <= 2 && text.bytes().all(|byte| byte.is_ascii_digit());
    (is_digits(chapter) && is_digits(rest)).then_some((chapter.parse().ok()?, rest.parse().ok()?))
}

/// The line of the index with this number, such as `7.65a`.
pub(crate) fn line_of(number: &str) -> Option<&'static str> {
    static LINES: LazyLock<BTreeMap<(u32, u32), &str>> = LazyLock::new(|| {
        let lines = INDEX.equation.iter().filter_map(|equation| Some((equation, equation.ends()?)));
        let numbers = lines.flat_map(|(equation, [(chapter, first), (_, last)])| {
            (first..=last).map(move |n| ((chapter, n), equation.number.as_str()))
        });
        numbers.collect()
    });
    LINES.get(&parse(number)?).copied()
}

/// The page of the index, with links to the sources below `workspace`.
pub(crate) fn page(workspace: &Path) -> String {
    let count =
        |is: fn(&Equation) -> bool| INDEX.equation.iter().filter(|one| is(one)).map(numbers).sum();
    let (all, by): (u32, u32) = (count(|_| true), count(|one| !one.by.is_empty()));
    let wrong = INDEX.equation.iter().filter(|one| one.corrected.is_some()).count();
    let mut page = String::new();
    let _ = writeln!(
        page,
        "<p>Of the thesis's {all} numbered equations {by} are in the code; for each of the others \
         the index says why not. The print is corrected in {wrong} lines. <code>cargo xtask tidy</code> holds the \
         index against the sources.</p>\n<div class=\"wide\" tabindex=\"0\"><table id=\"equations\">\
         <thead><tr><th>equation</th><th>says</th><th>in the code</th><th>the print</th></tr></thead>\
         <tbody>"
    );
    INDEX.equation.iter().for_each(|equation| row(&mut page, equation, workspace));
    page.push_str("</tbody></table></div>\n");
    page.push_str(
        "<p>The propositions have no numbered equations. Their formulas are in these items.</p>\n\
         <div class=\"wide\" tabindex=\"0\"><table><thead><tr><th>proposition</th><th>says</th>\
         <th>in the code</th></tr></thead><tbody>",
    );
    for Formula { number, what, by } in &INDEX.proposition {
        let _ = write!(page, "<tr><td class=\"name\">{number}</td><td>{}</td><td>", prose(what));
        links(&mut page, by, workspace);
        page.push_str("</td></tr>\n");
    }
    page.push_str("</tbody></table></div>\n");
    page
}

/// Links to items, each on a line of its own.
fn links(page: &mut String, items: &[String], workspace: &Path) {
    for (i, item) in items.iter().enumerate() {
        let end = if i > 0 { "<br>" } else { "" };
        let _ = write!(page, "{end}{}", link(item, workspace));
    }
}

fn numbers(equation: &Equation) -> u32 {
    equation.ends().map_or(0, |[(_, first), (_, last)]| last - first + 1)
}

fn row(page: &mut String, equation: &Equation, workspace: &Path) {
    let number = &equation.number;
    let spelled = match equation.ends() {
        Some([(chapter, first), (_, last)]) if last > first => {
            let all: Vec<_> = (first..=last).map(|n| format!("({chapter}.{n})")).collect();
            format!(" data-all=\"{}\"", all.join(" "))
        }
        _ => String::new(),
    };
    let _ = write!(
        page,
        "<tr id=\"eq-{number}\" data-equation=\"{number}\"{spelled}><td class=\"name\">{number}</td>\
         <td>{}</td><td>",
        prose(&equation.what)
    );
    links(page, &equation.by, workspace);
    if let Some(reason) = &equation.none {
        let _ = write!(page, "<span class=\"missing\">{}</span>", prose(reason));
    }
    let corrected = equation.corrected.as_deref().unwrap_or("");
    let _ = writeln!(page, "</td><td>{}</td></tr>", prose(corrected));
}

/// A link to the line of an item `crate/file.rs::Type::function`.
fn link(item: &str, workspace: &Path) -> String {
    let (file, path) = item.split_once("::").unwrap_or((item, ""));
    let (folder, below) = file.split_once('/').unwrap_or(("", file));
    let crates = if folder == "verification" { "" } else { "crates/" };
    let source = format!("{crates}{folder}/src/{below}");
    let line = line_in(&workspace.join(&source), path);
    let line = line.map_or_else(String::new, |line| format!("#L{line}"));
    let modules = file.trim_end_matches(".rs").trim_end_matches("/mod").replace('/', "::");
    format!("<a href=\"../../{source}{line}\"><code>{}::{path}</code></a>", escape(&modules))
}

/// The line of the file at which the item begins.
fn line_in(file: &Path, path: &str) -> Option<usize> {
    let text = std::fs::read_to_string(file).ok()?;
    let (owner, name) = path.rsplit_once("::").map_or((None, path), |(o, n)| (Some(o), n));
    let lines = || text.lines().enumerate();
    let begins = |line: &str| {
        let heads = ["fn ", "struct ", "enum ", "trait ", "const ", "type ", "static "];
        let end = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
        heads.iter().any(|head| {
            line.split_once(&format!("{head}{name}")).is_some_and(|(_, rest)| end(rest))
        })
    };
    let within = |line: &str| {
        owner.is_none_or(|owner| {
            let is_head = ["impl", "trait", "pub trait"].iter().any(|head| line.starts_with(head));
            is_head && line.contains(owner.rsplit("::").next().unwrap_or(owner))
        })
    };
    let start = if owner.is_some() { lines().find(|(_, line)| within(line))?.0 } else { 0 };
    lines().skip(start).find(|(_, line)| begins(line)).map(|(n, _)| n + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_index_is_read_and_each_line_answers() {
        let text = include_str!("../../equations.toml");
        let index: Index = toml::from_str(text).unwrap();
        assert!(index.equation.len() > 100);
        let mut last = (0, 0);
        for equation in &index.equation {
            let [first, end] = equation.ends().unwrap_or_else(|| panic!("{equation:?}"));
            let next = if first.0 == last.0 { last.1 + 1 } else { 1 };
            assert_eq!(first.1, next, "not in order, or a gap: {}", equation.number);
            assert!(end.0 == first.0 && end.1 >= first.1, "{}", equation.number);
            assert!(equation.by.is_empty() == equation.none.is_some(), "{}", equation.number);
            assert!(equation.what.len() > 2, "{}", equation.number);
            last = end;
        }
    }

    #[test]
    fn a_number_finds_its_line() {
        assert_eq!(line_of("7.65a"), line_of("7.65"));
        assert!(line_of("7.65").is_some());
        assert!(line_of("99.1").is_none() && line_of("0.5").is_none() && line_of("x").is_none());
    }
}
