//! All tests and documentation examples.
//!
//! They run optimised, so that tests, figures and the command share one build of the
//! dependencies.

use crate::cargo;
use anyhow::{Context as _, bail};
use std::io::{BufRead as _, BufReader};
use std::process::Stdio;
use std::time::Instant;

/// Which tests run.
#[derive(Clone, Copy)]
enum Which {
    /// All but the ignored ones, as in a release.
    Usual,
    /// The ignored ones alone, as in a release.
    Ignored,
    /// All but the ignored ones, with overflow checks and debug assertions; without the crates
    /// that compute nothing, whose dependencies would be built once more.
    Checked,
}

impl Which {
    /// What cargo-nextest is called with.
    fn nextest(self) -> &'static [&'static str] {
        match self {
            Self::Usual => &["--cargo-profile", "release"],
            Self::Ignored => {
                &["--cargo-profile", "release", "--profile", "long", "--run-ignored", "only"]
            }
            Self::Checked => &["--cargo-profile", "checked"],
        }
    }

    /// The crates that are left out.
    fn without(self) -> &'static [&'static str] {
        match self {
            Self::Usual | Self::Ignored => &[],
            Self::Checked => {
                &["--exclude", "carom-benches", "--exclude", "carom-python", "--exclude", "xtask"]
            }
        }
    }

    /// What `cargo test` is called with.
    fn cargo(self) -> &'static [&'static str] {
        match self {
            Self::Usual => &["--profile", "release"],
            Self::Ignored => &["--profile", "release", "--", "--ignored"],
            Self::Checked => &["--profile", "checked"],
        }
    }
}

/// Runs all tests, the documentation examples and the example programs, and prints their counts;
/// the examples run even if a test fails.
pub(crate) fn run() -> anyhow::Result<()> {
    let tests = tests(Which::Usual);
    let examples = examples();
    tests.and(examples).and(programs())
}

/// Runs the tests that take minutes too, and says how long they took.
pub(crate) fn all() -> anyhow::Result<()> {
    let usual = run();
    println!("== the tests that are ignored otherwise take minutes");
    let start = Instant::now();
    let ignored = ignored();
    println!("== they took {:.0} s", start.elapsed().as_secs_f64());
    usual.and(ignored)
}

/// Runs the tests that are ignored otherwise.
pub(crate) fn ignored() -> anyhow::Result<()> {
    tests(Which::Ignored)
}

/// Runs the tests with overflow checks and debug assertions.
pub(crate) fn checked() -> anyhow::Result<()> {
    tests(Which::Checked)
}

fn tests(which: Which) -> anyhow::Result<()> {
    if cargo::has("nextest") {
        // Prints its own count.
        let run = &["nextest", "run", "--workspace"];
        return cargo::run(&[run, which.without(), which.nextest()].concat());
    }
    println!("cargo-nextest is not installed: using cargo test");
    let usual = ["test", "--workspace", "--no-fail-fast", "--lib", "--bins", "--tests"];
    counted("tests", &[&usual, which.without(), which.cargo()].concat())
}

fn examples() -> anyhow::Result<()> {
    let arguments = ["test", "--workspace", "--release", "--no-fail-fast", "--doc"];
    counted("documentation examples", &arguments)
}

/// Runs the example programs, one for each floor: each checks what it prints.
fn programs() -> anyhow::Result<()> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/carom/examples");
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).context("cannot list the example programs")? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
        }
    }
    names.sort();
    for name in &names {
        cargo::run(&["run", "--release", "--package", "carom", "--example", name])?;
    }
    println!("example programs: {} passed", names.len());
    Ok(())
}

/// Calls cargo, passing its output on, and prints how many tests passed.
fn counted(name: &str, arguments: &[&str]) -> anyhow::Result<()> {
    let mut child =
        cargo::command(arguments).stdout(Stdio::piped()).spawn().context("cannot start cargo")?;
    let stdout = child.stdout.take().context("no output of cargo")?;
    let mut passed = 0;
    for line in BufReader::new(stdout).lines() {
        let line = line?;
        println!("{line}");
        passed += passed_in(&line).unwrap_or(0);
    }
    let status = child.wait()?;
    println!("{name}: {passed} passed");
    if !status.success() {
        bail!("`cargo {}` failed ({status})", arguments.join(" "));
    }
    Ok(())
}

/// The count in `test result: ok. 3 passed; ...`.
fn passed_in(line: &str) -> Option<u64> {
    let counts = line.strip_prefix("test result: ")?;
    let before = counts.split_once(" passed")?.0;
    before.rsplit(' ').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_the_summary() {
        let line = "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out";
        assert_eq!(passed_in(line), Some(12));
        let line = "test result: FAILED. 3 passed; 1 failed; 0 ignored";
        assert_eq!(passed_in(line), Some(3));
        assert_eq!(passed_in("test special::gamma ... ok"), None);
    }
}
