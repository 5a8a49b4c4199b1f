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
#[derive(Clone, Copy, PartialEq, Eq)]
enum Which {
    /// All but the ignored ones.
    Usual,
    /// The ignored ones alone.
    Ignored,
}

/// Runs all tests and the documentation examples, and prints their counts; the examples run
/// even if a test fails.
pub(crate) fn run() -> anyhow::Result<()> {
    tests("release", Which::Usual).and(examples())
}

/// Runs the tests that take minutes too, and says how long they took.
pub(crate) fn all() -> anyhow::Result<()> {
    let usual = run();
    println!("== the tests that are ignored otherwise: about six minutes on two cores");
    let start = Instant::now();
    let ignored = tests("release", Which::Ignored);
    println!("== they took {:.0} s", start.elapsed().as_secs_f64());
    usual.and(ignored)
}

/// Runs the tests with overflow checks and debug assertions.
pub(crate) fn checked() -> anyhow::Result<()> {
    tests("checked", Which::Usual)
}

fn tests(profile: &str, which: Which) -> anyhow::Result<()> {
    if cargo::has("nextest") {
        // Prints its own count.
        let mut arguments = vec!["nextest", "run", "--workspace", "--cargo-profile", profile];
        if which == Which::Ignored {
            arguments.extend(["--run-ignored", "only"]);
        }
        return cargo::run(&arguments);
    }
    println!("cargo-nextest is not installed: using cargo test");
    let mut arguments = vec!["test", "--workspace", "--profile", profile, "--no-fail-fast"];
    arguments.extend(["--lib", "--bins", "--tests"]);
    if which == Which::Ignored {
        arguments.extend(["--", "--ignored"]);
    }
    counted("tests", &arguments)
}

fn examples() -> anyhow::Result<()> {
    let arguments = ["test", "--workspace", "--release", "--no-fail-fast", "--doc"];
    counted("documentation examples", &arguments)
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
