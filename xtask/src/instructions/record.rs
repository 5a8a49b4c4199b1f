//! The recorded counts, `benches/instructions.toml`, and how new ones compare with them.

use anyhow::{Context as _, ensure};
use std::collections::BTreeMap;
use std::fmt::{self, Write as _};

/// Growth of a count that fails.
const TOLERANCE: f64 = 0.03;

const HEAD: &str = "\
# Instructions of the hot paths of benches/examples/hot_paths, each with fixed work, by callgrind.
# `cargo xtask instructions --record` writes this file. A count that grows by more than 3 % fails, unless it is
# recorded with --because, whose words are kept below.
";

/// On what the counts depend beside the sources.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Conditions {
    pub(super) compiler: String,
    pub(super) valgrind: String,
    /// Features of the processor by which libraries choose their code.
    pub(super) features: String,
}

impl fmt::Display for Conditions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}, {}", self.compiler, self.valgrind, self.features)
    }
}

pub(super) type Counts = BTreeMap<String, u64>;

/// Counts with their conditions, and why some have grown.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Record {
    pub(super) conditions: Conditions,
    pub(super) counts: Counts,
    pub(super) because: BTreeMap<String, String>,
}

/// A change beyond the tolerance.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Change {
    pub(super) name: String,
    pub(super) before: u64,
    pub(super) after: u64,
}

impl Change {
    /// Name, before, after, and the change in percent.
    pub(super) fn told(&self) -> String {
        let percent = 100.0 * (self.after as f64 / self.before as f64 - 1.0);
        format!("{}: {} before, {} after, {percent:+.1} %", self.name, self.before, self.after)
    }

    pub(super) fn grew(&self) -> bool {
        self.after > self.before
    }
}

impl Record {
    pub(super) fn parse(text: &str) -> anyhow::Result<Self> {
        let table: toml::Table = text.parse()?;
        let word = |name: &str| {
            let word = table.get(name).and_then(toml::Value::as_str);
            word.map(str::to_owned).with_context(|| format!("no `{name}`"))
        };
        let conditions = Conditions {
            compiler: word("compiler")?,
            valgrind: word("valgrind")?,
            features: word("features")?,
        };
        let section = |name: &str| table.get(name).and_then(toml::Value::as_table);
        let mut counts = Counts::new();
        for (name, count) in section("counts").context("no [counts]")? {
            let count = count.as_integer().and_then(|count| u64::try_from(count).ok());
            let count = count.filter(|count| *count > 0);
            counts.insert(name.clone(), count.with_context(|| format!("{name} is no count"))?);
        }
        let because = section("because").into_iter().flatten();
        let because = because.filter_map(|(name, why)| Some((name.clone(), why.as_str()?.into())));
        Ok(Self { conditions, counts, because: because.collect() })
    }

    pub(super) fn text(&self) -> String {
        let Conditions { compiler, valgrind, features } = &self.conditions;
        let mut text = format!(
            "{HEAD}compiler = {compiler:?}\nvalgrind = {valgrind:?}\nfeatures = {features:?}\n\n[counts]\n"
        );
        for (name, count) in &self.counts {
            let _ = writeln!(text, "{name} = {count}");
        }
        if !self.because.is_empty() {
            text.push_str("\n[because]\n");
        }
        for (name, why) in &self.because {
            let _ = writeln!(text, "{name} = {why:?}");
        }
        text
    }

    /// The counts that changed by more than the tolerance, up or down.
    ///
    /// # Errors
    /// If a path is on one side only.
    pub(super) fn changes(&self, now: &Counts) -> anyhow::Result<Vec<Change>> {
        let names = |counts: &Counts| counts.keys().cloned().collect::<Vec<_>>();
        ensure!(
            names(&self.counts) == names(now),
            "the recorded paths are {:?}, those of the program {:?}: `cargo xtask instructions --record`",
            names(&self.counts),
            names(now)
        );
        let both = self.counts.iter().zip(now.values());
        let all =
            both.map(|((name, &before), &after)| Change { name: name.clone(), before, after });
        let is_large =
            |change: &Change| (change.after as f64 / change.before as f64 - 1.0).abs() > TOLERANCE;
        Ok(all.filter(is_large).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(count: u64) -> Record {
        let conditions = Conditions {
            compiler: "rustc 1".into(),
            valgrind: "valgrind-3".into(),
            features: "avx2 fma".into(),
        };
        let because = [("step".to_owned(), "it \"checks\" more".to_owned())].into();
        Record { conditions, counts: [("step".to_owned(), count)].into(), because }
    }

    #[test]
    fn a_record_is_read_as_it_was_written() {
        let one = record(1000);
        assert_eq!(Record::parse(&one.text()).unwrap(), one);
    }

    #[test]
    fn growth_beyond_three_percent_is_told_with_both_counts() {
        let before = record(1000);
        assert!(before.changes(&record(1029).counts).unwrap().is_empty());
        let grown = before.changes(&record(1031).counts).unwrap();
        assert!(grown[0].grew());
        assert_eq!(grown[0].told(), "step: 1000 before, 1031 after, +3.1 %");
        assert!(!before.changes(&record(900).counts).unwrap()[0].grew());
    }

    #[test]
    fn paths_on_one_side_only_are_an_error() {
        assert!(record(1000).changes(&Counts::new()).is_err());
    }
}
