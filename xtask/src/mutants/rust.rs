//! Mutants of the crates: a copy of the workspace contains all of them, each behind a switch that the environment sets,
//! so that it is built once.

use super::Mutant;
use crate::cargo;
use crate::files::files_below;
use anyhow::{Context as _, bail};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Output;

const SWITCH: &str = include_str!("switch.rs");

/// The seed of the property tests, so that a detection is reproducible.
const PROPERTY_SEED: &str = "7";

/// The copy.
pub(super) struct Bench<'a> {
    tree: PathBuf,
    /// Its mutants, numbered from 1.
    mutants: &'a [&'a Mutant],
}

impl<'a> Bench<'a> {
    pub(super) fn new(root: &Path, mutants: &'a [&'a Mutant]) -> anyhow::Result<Self> {
        let tree = root.join("target/mutants/tree");
        let mut woven = woven(root, mutants)?;
        let mut written = BTreeSet::new();
        for path in cargo::git(&["ls-files", "--cached", "--others", "--exclude-standard"])?.lines()
        {
            // A file may be deleted that git still lists.
            let Ok(bytes) = std::fs::read(root.join(path)) else { continue };
            let bytes = woven.remove(path).map_or(bytes, String::into_bytes);
            written.insert(write(tree.join(path), &bytes)?);
        }
        for (path, text) in woven {
            written.insert(write(tree.join(path), text.as_bytes())?);
        }
        for path in files_below(&tree, "rs")?.iter().filter(|path| !written.contains(*path)) {
            std::fs::remove_file(path)?;
        }
        Ok(Self { tree, mutants })
    }

    /// Runs the tests that the arguments choose.
    fn nextest(&self, mutant: Option<&Mutant>, chosen: &[&str]) -> anyhow::Result<Output> {
        let run = ["nextest", "run", "--cargo-profile", "release", "--cargo-quiet", "--fail-fast"];
        let targets = ["--lib", "--bins", "--tests"];
        let shown = ["--status-level", "fail", "--final-status-level", "none", "--color", "never"];
        let mut command =
            cargo::command(&[&run[..], &targets, &shown, cargo::OF_LIBRARIES, chosen].concat());
        command.args(["--failure-output", "never", "--no-tests", "pass"]).current_dir(&self.tree);
        let number = self.mutants.iter().position(|one| Some(*one) == mutant).map_or(0, |i| i + 1);
        command.env("CAROM_MUTANT", number.to_string());
        command.env("CARGO_TARGET_DIR", self.tree.with_file_name("built"));
        command.env("PROPTEST_RNG_SEED", PROPERTY_SEED).env("PROPTEST_MAX_SHRINK_ITERS", "0");
        command.env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "true");
        // A snapshot guards against change and does not prove correctness.
        command.env("INSTA_FORCE_PASS", "1").env("INSTA_UPDATE", "no");
        command.output().context("cannot start cargo nextest")
    }
}

impl super::Bench for Bench<'_> {
    fn failure(&self, mutant: Option<&Mutant>, tests: &[&str]) -> anyhow::Result<Option<String>> {
        let named = |test: &&str| {
            let (binary, name) = test.split_once(' ')?;
            Some(format!("(binary_id(={binary}) & test(={name}))"))
        };
        let filter = tests.iter().filter_map(named).collect::<Vec<_>>().join(" | ");
        let chosen: &[&str] = if filter.is_empty() { &[] } else { &["-E", &filter] };
        let output = self.nextest(mutant, chosen)?;
        let text = String::from_utf8_lossy(&output.stderr);
        match (output.status.success(), failed_in(&text)) {
            (true, _) => Ok(None),
            (false, Some(test)) => Ok(Some(test)),
            (false, None) => bail!("the tests with mutants do not run:\n{text}"),
        }
    }
}

/// `carom-laws::it hertz::a_test` in `FAIL [   0.012s] (3/9) carom-laws::it hertz::a_test`.
fn failed_in(text: &str) -> Option<String> {
    let has_failed = |line: &&str| {
        ["FAIL", "TIMEOUT", "SIG"].iter().any(|word| line.trim_start().starts_with(word))
    };
    let mut words = text.lines().find(has_failed)?.split_whitespace().rev();
    let name = words.next()?;
    Some(format!("{} {name}", words.next()?))
}

/// The texts with mutants and switches, by their paths.
fn woven(root: &Path, mutants: &[&Mutant]) -> anyhow::Result<BTreeMap<String, String>> {
    let mut texts: BTreeMap<String, (String, Vec<(usize, usize)>)> = BTreeMap::new();
    let mut crates = BTreeSet::new();
    for (i, mutant) in mutants.iter().enumerate() {
        let (text, at) = mutant.place(root).with_context(|| mutant.key())?;
        texts.entry(mutant.file.clone()).or_insert((text, Vec::new())).1.push((at, i));
        crates.extend(mutant.file.split_once("/src/").map(|(folder, _)| folder));
    }
    let with_switches = |(file, (text, places))| (file, switched(text, places, mutants));
    let mut texts: BTreeMap<String, String> = texts.into_iter().map(with_switches).collect();
    for folder in crates {
        texts.insert(format!("{folder}/src/mutant.rs"), SWITCH.to_owned());
        let lib = format!("{folder}/src/lib.rs");
        let text = match texts.remove(&lib) {
            Some(text) => text,
            None => std::fs::read_to_string(root.join(&lib))?,
        };
        texts.insert(lib, text + "\nmod mutant;\n");
    }
    Ok(texts)
}

/// The text with a switch at each of these places, where the mutants of these indices begin.
fn switched(mut text: String, mut places: Vec<(usize, usize)>, mutants: &[&Mutant]) -> String {
    // From the end, so that the other places do not move.
    places.sort_by(|one, other| other.cmp(one));
    for (at, i) in places {
        let (number, Mutant { find, replace, .. }) = (i + 1, mutants[i]);
        let both = format!("(if crate::mutant::is_on({number}) {{ {replace} }} else {{ {find} }})");
        text.replace_range(at..at + find.len(), &both);
    }
    text
}

/// Writes a file, unless it exists with the same content: cargo would build it again.
fn write(path: PathBuf, bytes: &[u8]) -> anyhow::Result<PathBuf> {
    if std::fs::read(&path).is_ok_and(|old| old == bytes) {
        return Ok(path);
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(&path, bytes).with_context(|| path.display().to_string())?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mutants_of_one_file_stand_behind_switches() {
        let one = |find: &str, replace: &str| Mutant {
            find: find.to_owned(),
            replace: replace.to_owned(),
            ..Mutant::default()
        };
        let (b, a) = (one("b", "2"), one("a", "1"));
        assert_eq!(
            switched("a * b".to_owned(), vec![(4, 0), (0, 1)], &[&b, &a]),
            "(if crate::mutant::is_on(2) { 1 } else { a }) * (if crate::mutant::is_on(1) { 2 } else { b })"
        );
    }

    #[test]
    fn the_test_that_failed_is_read() {
        let text = "   Compiling x\n  FAIL [   0.012s] (3/9) carom-laws::it hertz::a_test\n";
        assert_eq!(failed_in(text).as_deref(), Some("carom-laws::it hertz::a_test"));
        assert_eq!(failed_in("error: could not compile"), None);
    }
}
