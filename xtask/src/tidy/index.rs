//! The index of equations as written in its file.

use super::{Number, quoted, read};
use anyhow::{Context as _, ensure};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The index.
pub(super) struct Index {
    /// The last equation of each chapter.
    equations: BTreeMap<u32, u32>,
    /// The last figure of each chapter.
    figures: BTreeMap<u32, u32>,
    lines: Vec<Line>,
    /// Formulas of propositions, without numbers of their own.
    propositions: Vec<Line>,
}

/// One line of the index.
pub(super) struct Line {
    /// A number such as `7.48`, or a range such as `7.11-7.15`.
    pub(super) name: String,
    first: Number,
    last: Number,
    by: Vec<String>,
}

impl Line {
    pub(super) fn has(&self, number: Number) -> bool {
        (self.first..=self.last).contains(&number)
    }
}

impl Index {
    pub(super) fn read(path: &Path) -> anyhow::Result<Self> {
        Self::parse(&read(path)?).with_context(|| path.display().to_string())
    }

    fn parse(text: &str) -> anyhow::Result<Self> {
        let table: toml::Table = text.parse()?;
        let lines = table.get("equation").and_then(toml::Value::as_array).context("no equation")?;
        let propositions = table.get("proposition").and_then(toml::Value::as_array);
        let propositions = propositions.map_or(&[][..], Vec::as_slice);
        Ok(Self {
            equations: last(&table, "equations")?,
            figures: last(&table, "figures")?,
            lines: lines.iter().map(line).collect::<anyhow::Result<_>>()?,
            propositions: propositions.iter().map(proposition).collect::<anyhow::Result<_>>()?,
        })
    }

    /// The numbers of the line.
    fn numbers(&self) -> impl Iterator<Item = Number> {
        let range = |line: &Line| {
            let chapter = line.first.0;
            (line.first.1..=line.last.1).map(move |place| (chapter, place))
        };
        self.lines.iter().flat_map(range)
    }

    pub(super) fn count(&self) -> usize {
        self.numbers().count()
    }

    pub(super) fn has(&self, number: Number) -> bool {
        self.numbers().any(|one| one == number)
    }

    /// The items that it names, each with its lines.
    pub(super) fn by_item(&self) -> BTreeMap<&str, Vec<&Line>> {
        let mut items: BTreeMap<&str, Vec<&Line>> = BTreeMap::new();
        for line in self.lines.iter().chain(&self.propositions) {
            for item in &line.by {
                items.entry(item).or_default().push(line);
            }
        }
        items
    }

    /// Equations that are missing, occur twice, or do not exist in the thesis.
    pub(super) fn gaps(&self) -> Vec<String> {
        let mut found: Vec<_> = self.numbers().collect();
        found.sort_unstable();
        let twice = found.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]);
        let twice: Vec<_> = twice.map(|(c, n)| format!("({c}.{n}) is there twice")).collect();
        let found: BTreeSet<_> = found.into_iter().collect();
        differences(&found, &self.equations, "equation").into_iter().chain(twice).collect()
    }

    /// Figures that are missing in the catalogue, or do not exist in the thesis.
    pub(super) fn figure_gaps(&self, catalogue: &BTreeSet<Number>) -> Vec<String> {
        differences(catalogue, &self.figures, "figure")
    }
}

/// Missing numbers from 1 to the last of each chapter, and numbers above the last.
fn differences(found: &BTreeSet<Number>, last: &BTreeMap<u32, u32>, what: &str) -> Vec<String> {
    let all = last.iter().flat_map(|(chapter, last)| (1..=*last).map(|place| (*chapter, place)));
    let all: BTreeSet<Number> = all.collect();
    let missing = all.difference(found).map(|(c, n)| format!("{what} {c}.{n} is missing"));
    let strange = found.difference(&all).map(|(c, n)| format!("the thesis has no {what} {c}.{n}"));
    missing.chain(strange).collect()
}

fn last(table: &toml::Table, name: &str) -> anyhow::Result<BTreeMap<u32, u32>> {
    let last = table.get(name).and_then(toml::Value::as_table);
    let last = last.with_context(|| format!("no table `{name}`"))?;
    let pair = |(chapter, last): (&String, &toml::Value)| {
        let last = last.as_integer().context("a count is an integer")?;
        Ok((chapter.parse()?, u32::try_from(last)?))
    };
    last.iter().map(pair).collect()
}

/// A formula of a proposition; it has no number of a chapter.
fn proposition(value: &toml::Value) -> anyhow::Result<Line> {
    let number = value.get("number").and_then(toml::Value::as_integer);
    let number = number.with_context(|| format!("no number in {value}"))?;
    ensure!((1..=8).contains(&number), "the thesis has no proposition {number}");
    let name = format!("proposition {number}");
    let by = items(value);
    ensure!(!by.is_empty(), "{name}: no item");
    ensure!(has_meaning(value), "{name}: `what` is missing or empty");
    Ok(Line { name, first: (0, 0), last: (0, 0), by })
}

fn items(value: &toml::Value) -> Vec<String> {
    let by = value.get("by").and_then(toml::Value::as_array).map_or(&[][..], Vec::as_slice);
    by.iter().filter_map(toml::Value::as_str).map(str::to_owned).collect()
}

fn has_meaning(value: &toml::Value) -> bool {
    value.get("what").and_then(toml::Value::as_str).is_some_and(|what| !what.is_empty())
}

fn line(value: &toml::Value) -> anyhow::Result<Line> {
    let text = |name| value.get(name).and_then(toml::Value::as_str);
    let name = text("number").with_context(|| format!("no number in {value}"))?.to_owned();
    let (first, last) = name.split_once('-').unwrap_or((&name, &name));
    let parse = |text| quoted::number(text).with_context(|| format!("`{name}` is not a number"));
    let (first, last) = (parse(first)?, parse(last)?);
    ensure!(first.0 == last.0 && first.1 <= last.1, "`{name}` is not a range");
    let by = items(value);
    ensure!(by.is_empty() != text("none").is_none(), "{name}: either `by` or `none`");
    ensure!(has_meaning(value), "{name}: `what` is missing or empty");
    Ok(Line { name, first, last, by })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn index(lines: &str) -> anyhow::Result<Index> {
        let head = "equations = { 3 = 2, 4 = 1 }\nfigures = { 3 = 1 }\n";
        Index::parse(&format!("{head}equation = [{lines}]"))
    }

    #[test]
    fn gaps_and_repetitions_are_named() {
        let line =
            |number: &str| format!("{{ number = \"{number}\", what = \"w\", none = \"n\" }},");
        let full = index(&(line("3.1-3.2") + &line("4.1"))).unwrap();
        assert!(full.gaps().is_empty() && full.count() == 3 && full.has((3, 2)));
        let gaps = index(&(line("3.1") + &line("3.1") + &line("4.2"))).unwrap().gaps();
        let expected = [
            "equation 3.2 is missing",
            "equation 4.1 is missing",
            "the thesis has no equation 4.2",
            "(3.1) is there twice",
        ];
        assert_eq!(gaps, expected);
        assert_eq!(full.figure_gaps(&BTreeSet::new()), ["figure 3.1 is missing"]);
    }

    #[test]
    fn a_proposition_has_an_item_and_no_number_of_a_chapter() {
        let with = |line: &str| {
            Index::parse(&format!(
                "equations = {{}}\nfigures = {{}}\nequation = []\nproposition = [{line}]"
            ))
        };
        let one = with("{ number = 3, what = \"w\", by = [\"a.rs::b\"] }").unwrap();
        assert_eq!(one.by_item()["a.rs::b"][0].name, "proposition 3");
        assert!(one.gaps().is_empty() && one.count() == 0);
        assert!(with("{ number = 9, what = \"w\", by = [\"a.rs::b\"] }").is_err());
        assert!(with("{ number = 3, what = \"w\" }").is_err());
    }

    #[test]
    fn a_line_has_an_item_or_a_reason() {
        assert!(index("{ number = \"3.1\", what = \"w\" }").is_err());
        assert!(
            index("{ number = \"3.1\", what = \"w\", by = [\"a.rs::b\"], none = \"n\" }").is_err()
        );
        assert!(index("{ number = \"3.2-3.1\", what = \"w\", none = \"n\" }").is_err());
        let one = index("{ number = \"3.1\", what = \"w\", by = [\"a.rs::b\"] }").unwrap();
        let items = one.by_item();
        assert!(items["a.rs::b"][0].has((3, 1)) && !items["a.rs::b"][0].has((3, 2)));
    }
}
