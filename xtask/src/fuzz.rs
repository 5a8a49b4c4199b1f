//! Runs the targets of the fuzzer in `fuzz/`, a crate outside the workspace.
//!
//! What reaches new code is collected below `target/`; the seeds in `fuzz/corpus` are only read.

use anyhow::{Context as _, bail, ensure};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use crate::cargo;
use crate::doors::{NO_CRATES, fetches};
use crate::files::files;
use crate::outcome::{Outcome, Part};
use crate::python::call;
use crate::root::root;
use crate::tools::CARGO_FUZZ;

/// How long each target runs by default, in seconds.
pub(crate) const SECONDS: u64 = 60;
const MANIFEST: &str = "fuzz/Cargo.toml";
/// Rust alone checks its memory; the C interface runs under the address sanitizer by `sanitize.rs`.
const PLAIN: [&str; 2] = ["--sanitizer", "none"];
/// An input that takes longer is a hang, in seconds; one that needs more memory is a fault, in MiB.
const LIMITS: [&str; 2] = ["-timeout=20", "-rss_limit_mb=4096"];

/// Runs the chosen target, or each, so many seconds. Skipped without the pinned nightly Rust, cargo-fuzz or the
/// registry of crates.
pub(crate) fn run(chosen: Option<&str>, seconds: u64) -> anyhow::Result<Outcome> {
    let root = root().canonicalize()?;
    let mut targets = targets(&root)?;
    if let Some(chosen) = chosen {
        ensure!(targets.iter().any(|own| own == chosen), "the targets are {}", targets.join(", "));
        targets.retain(|own| own == chosen);
    }
    let Some(toolchain) = toolchain(&root)? else {
        return Ok(Outcome::skipped(
            Part::Fuzz,
            "the nightly Rust of .ci/nightly is not installed",
        ));
    };
    if !CARGO_FUZZ.is_there().unwrap_or(false) {
        return Ok(Outcome::skipped(Part::Fuzz, CARGO_FUZZ.advice()));
    }
    if !fetches(MANIFEST)? {
        return Ok(Outcome::skipped(Part::Fuzz, NO_CRATES));
    }
    cargo::run(&["fmt", "--check", "--manifest-path", MANIFEST])?;
    let fuzzer = Fuzzer { toolchain, root };
    call(&mut fuzzer.command("build")).context("the targets of the fuzzer")?;
    for target in &targets {
        fuzzer.run(target, seconds)?;
    }
    println!("no fault in {} targets, {seconds} s each", targets.len());
    Ok(Outcome::Passed)
}

/// Where the fuzzer runs, and with which Rust.
struct Fuzzer {
    toolchain: String,
    root: std::path::PathBuf,
}

impl Fuzzer {
    fn command(&self, task: &str) -> Command {
        let mut command = Command::new("rustup");
        command.args(["run", &self.toolchain, "cargo", "fuzz", task]).args(PLAIN);
        command.arg("--fuzz-dir").arg(self.root.join("fuzz"));
        command.arg("--target-dir").arg(self.root.join("target/fuzz"));
        command.current_dir(&self.root);
        command
    }

    fn run(&self, target: &str, seconds: u64) -> anyhow::Result<()> {
        let found = self.root.join("target/fuzz-corpus").join(target);
        std::fs::create_dir_all(&found)?;
        let mut command = self.command("run");
        command.arg(target).arg(found).arg(self.root.join("fuzz/corpus").join(target)).arg("--");
        command.arg(format!("-max_total_time={seconds}")).args(LIMITS).arg("-print_final_stats=1");
        let forms = self.root.join(format!("fuzz/{target}.dict"));
        if forms.exists() {
            let words = self.root.join(format!("target/{target}.dict"));
            std::fs::write(&words, std::fs::read_to_string(forms)? + &words_of_cases(&self.root)?)?;
            command.arg(format!("-dict={}", words.display()));
        }
        println!("== target {target}, {seconds} s");
        call(&mut command).with_context(|| {
            format!("target {target}: the input is in fuzz/artifacts/{target}; make it a test of the crate at fault")
        })
    }
}

/// The name by which rustup has the nightly Rust of `.ci/nightly`, if it has it.
fn toolchain(root: &Path) -> anyhow::Result<Option<String>> {
    let script = root.join(".ci/toolchain");
    let output = Command::new(&script).output().with_context(|| script.display().to_string())?;
    let name = String::from_utf8(output.stdout)?.trim().to_owned();
    Ok((!name.is_empty()).then_some(name))
}

/// The names and words of all kinds of cases, from their schemas, as lines of a dictionary.
fn words_of_cases(root: &Path) -> anyhow::Result<String> {
    let mut words = BTreeSet::new();
    for schema in files(&root.join("docs/schema"), "json")? {
        collect(&serde_json::from_str(&std::fs::read_to_string(schema)?)?, &mut words);
    }
    Ok(words.into_iter().map(|word| format!("\"{word}\"\n")).collect())
}

fn collect(part: &Value, words: &mut BTreeSet<String>) {
    match part {
        Value::Object(own) => {
            for (name, value) in own {
                match (name.as_str(), value) {
                    ("properties", Value::Object(fields)) => words.extend(fields.keys().cloned()),
                    ("enum", Value::Array(all)) => {
                        words.extend(all.iter().filter_map(Value::as_str).map(str::to_owned));
                    }
                    _ => {}
                }
                collect(value, words);
            }
        }
        Value::Array(all) => all.iter().for_each(|one| collect(one, words)),
        _ => {}
    }
}

/// The names of all targets.
fn targets(root: &Path) -> anyhow::Result<Vec<String>> {
    let manifest: toml::Table = std::fs::read_to_string(root.join(MANIFEST))?.parse()?;
    let Some(toml::Value::Array(all)) = manifest.get("bin") else {
        bail!("{MANIFEST}: no targets")
    };
    let name = |one: &toml::Value| one.get("name")?.as_str().map(str::to_owned);
    all.iter().map(name).collect::<Option<_>>().context("a target without a name")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fuzzer_knows_names_and_words_of_all_kinds_of_cases() {
        let words = words_of_cases(&root()).unwrap();
        for word in
            ["body_1", "normal_restitution", "rolling_resistance", "ellipsoid", "half-space"]
        {
            assert!(words.contains(&format!("\"{word}\"\n")), "{word}");
        }
        assert!(words.lines().count() > 200, "{words}");
    }

    #[test]
    fn every_target_has_seeds() {
        let root = root();
        let targets = targets(&root).unwrap();
        assert_eq!(targets.len(), 5);
        for target in targets {
            let seeds = root.join("fuzz/corpus").join(&target);
            assert!(seeds.read_dir().unwrap().count() > 2, "{target}");
        }
    }
}
