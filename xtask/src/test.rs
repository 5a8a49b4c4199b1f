//! All tests and documentation examples.
//!
//! They run optimised, so that tests, figures and the command share one build of the
//! dependencies.

use crate::cargo;
use anyhow::{Context as _, bail};
use std::io::{BufRead as _, BufReader};
use std::process::Stdio;

/// Runs all tests, then the documentation examples; prints their counts.
pub(crate) fn run() -> anyhow::Result<()> {
    if cargo::has("nextest") {
        // Prints its own count.
        cargo::run(&["nextest", "run", "--workspace", "--release"])?;
    } else {
        println!("cargo-nextest is not installed: using cargo test");
        let tests = counted(&["test", "--workspace", "--release", "--lib", "--bins", "--tests"])?;
        println!("tests: {tests} passed");
    }
    let examples = counted(&["test", "--workspace", "--release", "--doc"])?;
    println!("documentation examples: {examples} passed");
    Ok(())
}

/// Calls cargo, passing its output on, and adds up how many tests passed.
fn counted(arguments: &[&str]) -> anyhow::Result<u64> {
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
    if !status.success() {
        bail!("`cargo {}` failed ({status})", arguments.join(" "));
    }
    Ok(passed)
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
