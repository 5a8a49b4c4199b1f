//! Mutants: deliberate faults in the code that a test must detect.
//!
//! `xtask/mutants.toml` lists them: a text in a file, its replacement, and the test that notices it. That test runs
//! first, all others only if it does not notice the mutant any more; snapshots do not count. A mutant that no test
//! notices is a gap in the tests: the task fails. Sources and releases contain none: they stand in copies below
//! `target/mutants/`, and in the Python module that is installed there.

mod layers;
mod rust;

use crate::flags;
use crate::outcome::Outcome;
use crate::root::root;
use anyhow::{Context as _, ensure};
use layers::Layer;
use std::path::Path;

/// Largest number of mutants in the list.
const MAX_MUTANTS: usize = 80;

/// A deliberate fault.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Mutant {
    /// Path from the root of the workspace.
    file: String,
    /// What the fault is.
    name: String,
    /// A text that occurs once in the file, in Rust an expression.
    find: String,
    /// Its replacement.
    replace: String,
    /// The test that notices it; empty if none is known.
    test: String,
}

impl Mutant {
    fn key(&self) -> String {
        format!("{}: {}", self.file, self.name)
    }

    /// The file, and where the text begins in it.
    fn place(&self, root: &Path) -> anyhow::Result<(String, usize)> {
        let path = root.join(&self.file);
        let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        let places: Vec<usize> = text.match_indices(&self.find).map(|(at, _)| at).collect();
        ensure!(places.len() == 1, "`{}` occurs {} times", self.find, places.len());
        Ok((text, places[0]))
    }
}

/// A copy in which mutants may be switched on, and its tests.
trait Bench {
    /// The first test that fails with the mutant, or without any; of all tests, or of those named.
    fn failure(&self, mutant: Option<&Mutant>, tests: &[&str]) -> anyhow::Result<Option<String>>;
}

/// Runs the mutants selected by the options.
pub(crate) fn run(options: &flags::Mutants) -> anyhow::Result<Outcome> {
    let root = root().canonicalize()?;
    let all = read(&root)?;
    let is_chosen = |mutant: &&Mutant| match &options.only {
        Some(text) => mutant.key().contains(text),
        None => true,
    };
    let chosen: Vec<&Mutant> = all.iter().filter(is_chosen).collect();
    ensure!(!chosen.is_empty(), "no mutant of the list has that name");
    let mut outcome = Outcome::Passed;
    let mut survivors = Vec::new();
    for layer in [None, Some(Layer::Python), Some(Layer::Lammps)] {
        let here: Vec<_> = chosen.iter().copied().filter(|m| Layer::of(&m.file) == layer).collect();
        if here.is_empty() {
            continue;
        }
        let bench: Box<dyn Bench> = match layer {
            None => Box::new(rust::Bench::new(&root, &here)?),
            Some(layer) => match layers::Bench::new(&root, layer)? {
                Ok(bench) => Box::new(bench),
                Err(skipped) => {
                    outcome = outcome.and(skipped);
                    continue;
                }
            },
        };
        survivors.extend(survivors_of(bench.as_ref(), &here)?);
    }
    println!("{} mutants, {} survivors", chosen.len(), survivors.len());
    ensure!(survivors.is_empty(), "mutants survive:\n  {}", survivors.join("\n  "));
    Ok(outcome)
}

/// The mutants that no test notices.
fn survivors_of(bench: &dyn Bench, mutants: &[&Mutant]) -> anyhow::Result<Vec<String>> {
    let known: Vec<&str> =
        mutants.iter().map(|m| m.test.as_str()).filter(|t| !t.is_empty()).collect();
    if let Some(test) = bench.failure(None, &known)? {
        anyhow::bail!("fails without any mutant: {test}");
    }
    let mut survivors = Vec::new();
    for mutant in mutants {
        println!("{}", mutant.key());
        let is_known = !mutant.test.is_empty();
        if is_known && bench.failure(Some(mutant), &[&mutant.test])?.is_some() {
            continue;
        }
        match bench.failure(Some(mutant), &[])? {
            Some(test) => println!("    write in the list: test = '{test}'"),
            None => survivors.push(mutant.key()),
        }
    }
    Ok(survivors)
}

/// All mutants, for the long run.
pub(crate) fn all() -> anyhow::Result<Outcome> {
    run(&flags::Mutants { only: None })
}

/// Checks that every place of the list exists in the code, without a build.
pub(crate) fn check(root: &Path) -> anyhow::Result<()> {
    let mutants = read(root)?;
    let fault = |m: &Mutant| Some(format!("{}: {:#}", m.key(), m.place(root).err()?));
    let wrong: Vec<String> = mutants.iter().filter_map(fault).collect();
    ensure!(wrong.is_empty(), "places of the list that are not found:\n  {}", wrong.join("\n  "));
    println!("{} mutants: in place", mutants.len());
    Ok(())
}

fn read(root: &Path) -> anyhow::Result<Vec<Mutant>> {
    let path = root.join("xtask/mutants.toml");
    parse(&std::fs::read_to_string(&path)?).with_context(|| path.display().to_string())
}

fn parse(text: &str) -> anyhow::Result<Vec<Mutant>> {
    let table: toml::Table = text.parse()?;
    let entries = table.get("mutant").and_then(toml::Value::as_array).context("no [[mutant]]")?;
    ensure!(entries.len() <= MAX_MUTANTS, "{} mutants; at most {MAX_MUTANTS}", entries.len());
    let mutant = |entry: &toml::Value| {
        let text = |key: &str| {
            let text = entry.get(key).and_then(toml::Value::as_str).map(str::to_owned);
            text.with_context(|| format!("no `{key}` in {entry}"))
        };
        let (file, name, find) = (text("file")?, text("name")?, text("find")?);
        Ok(Mutant { file, name, find, replace: text("replace")?, test: text("test")? })
    };
    entries.iter().map(mutant).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_read_and_a_slip_in_it_named() {
        let good = "[[mutant]]\nfile = 'a.rs'\nname = 'n'\nfind = '1'\nreplace = '2'\ntest = ''\n";
        assert_eq!(parse(good).unwrap()[0].key(), "a.rs: n");
        let error = parse(&good.replace("find", "fine")).unwrap_err().to_string();
        assert!(error.starts_with("no `find` in"), "{error}");
    }
}
