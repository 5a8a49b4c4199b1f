//! Runs tests, documentation examples and example programs.
//!
//! They are built with optimisation, so that tests, figures and the command share one build of the
//! dependencies.

use crate::files::files;
use crate::outcome::{Outcome, Part};
use crate::root::root;
use crate::{cargo, changes, flags};
use anyhow::{Context as _, bail, ensure};
use std::io::{BufRead as _, BufReader};
use std::process::Stdio;
use std::time::Instant;

/// Build profile and selection of the tests.
#[derive(Clone, Copy)]
enum Which {
    /// All but the ignored tests, in the release profile.
    Usual,
    /// The same without optimisation of the workspace, for a few tests of one crate while it changes.
    Loop,
    /// Only the ignored tests, in the release profile.
    Ignored,
    /// All but the ignored tests, with overflow checks and debug assertions; without crates that
    /// compute nothing, whose dependencies would be built again.
    Checked,
}

impl Which {
    /// The arguments of cargo-nextest.
    fn nextest(self) -> &'static [&'static str] {
        match self {
            Self::Usual => &["--cargo-profile", "release"],
            Self::Loop => &["--cargo-profile", "loop"],
            Self::Ignored => {
                &["--cargo-profile", "release", "--profile", "long", "--run-ignored", "only"]
            }
            Self::Checked => &["--cargo-profile", "checked"],
        }
    }

    /// The arguments of `cargo test`, and those of the tests themselves.
    fn cargo(self) -> (&'static [&'static str], &'static [&'static str]) {
        match self {
            Self::Usual => (&["--profile", "release"], &[]),
            Self::Loop => (&["--profile", "loop"], &[]),
            Self::Ignored => (&["--profile", "release"], &["--ignored"]),
            Self::Checked => (&["--profile", "checked"], &[]),
        }
    }

    /// The packages with tests.
    fn workspace(self) -> &'static [&'static str] {
        match self {
            Self::Usual | Self::Loop | Self::Ignored => cargo::WITHOUT_BENCHES,
            Self::Checked => cargo::OF_LIBRARIES,
        }
    }
}

/// Runs the tests selected by the options: the whole workspace, one crate, or the changed crates.
pub(crate) fn chosen(options: &flags::Test) -> anyhow::Result<()> {
    ensure!(
        options.package.is_none() || !(options.changed || options.all),
        "name a crate without --changed and --all"
    );
    if let Some(name) = &options.package {
        let package = changes::package(name)?;
        let which = if options.name.is_some() { Which::Loop } else { Which::Usual };
        return tests(which, &["--package", &package], options.name.as_deref());
    }
    match (options.changed, options.all) {
        (true, _) => changed(),
        (false, true) => all(),
        (false, false) => run(),
    }
}

/// Runs all tests, documentation examples and example programs, and prints their numbers and what this machine lacks for
/// some of them. The examples run even if a test fails.
fn run() -> anyhow::Result<()> {
    let tests = usual();
    let shown = shown();
    lacking().accept()?;
    println!("tests of their own: cargo xtask python, lammps, doors, install-c, book");
    tests.and(shown)
}

/// The tools without which tests of the C interface leave out programs.
fn lacking() -> Outcome {
    let tools = ["cc", "c++", "gfortran", "valgrind"];
    let missing: Vec<&str> = tools.into_iter().filter(|tool| !cargo::answers(tool)).collect();
    match missing.as_slice() {
        [] => Outcome::Passed,
        missing => {
            let missing = missing.join(", ");
            let reason = format!(
                "programs in C, C++ and Fortran that need {missing}, which is not installed"
            );
            Outcome::skipped(Part::OwnTests, reason)
        }
    }
}

/// Runs the tests that are not ignored.
pub(crate) fn usual() -> anyhow::Result<()> {
    of_workspace(Which::Usual)
}

/// Runs the documentation examples and the example programs.
pub(crate) fn shown() -> anyhow::Result<()> {
    let examples = examples();
    examples.and(programs())
}

/// Also runs the tests that take minutes, and prints their duration.
fn all() -> anyhow::Result<()> {
    let usual = run();
    println!("== running the otherwise ignored tests, which take minutes");
    let start = Instant::now();
    let ignored = ignored();
    println!("== they took {:.0} s", start.elapsed().as_secs_f64());
    usual.and(ignored)
}

/// Runs the tests of the crates changed since the last published commit, and of those that depend
/// on them.
fn changed() -> anyhow::Result<()> {
    let packages = changes::packages()?;
    if packages.is_empty() {
        println!("no crate changed");
        return Ok(());
    }
    println!("changed crates and those that depend on them: {}", packages.join(", "));
    let arguments: Vec<&str> =
        packages.iter().flat_map(|package| ["--package", package.as_str()]).collect();
    tests(Which::Usual, &arguments, None)
}

/// Runs the tests that are otherwise ignored.
pub(crate) fn ignored() -> anyhow::Result<()> {
    of_workspace(Which::Ignored)
}

/// Runs the tests with overflow checks and debug assertions.
pub(crate) fn checked() -> anyhow::Result<()> {
    of_workspace(Which::Checked)
}

fn of_workspace(which: Which) -> anyhow::Result<()> {
    tests(which, which.workspace(), None)
}

/// Runs the tests of these packages; with `name`, those whose name contains it.
fn tests(which: Which, packages: &[&str], name: Option<&str>) -> anyhow::Result<()> {
    if cargo::has("nextest") {
        // cargo-nextest prints its own count.
        let name: Vec<&str> = name.into_iter().collect();
        return cargo::compile(&[&["nextest", "run"], packages, which.nextest(), &name].concat());
    }
    println!("cargo-nextest is not installed: using cargo test");
    let (build, run) = which.cargo();
    let usual = &["test", "--no-fail-fast", "--lib", "--bins", "--tests"];
    let run = [&["--"], run, name.as_slice()].concat();
    counted("tests", &[usual, packages, build, &run].concat())
}

fn examples() -> anyhow::Result<()> {
    let arguments = ["test", "--release", "--no-fail-fast", "--doc"];
    counted("documentation examples", &[&arguments, cargo::WITHOUT_BENCHES].concat())
}

/// Runs the example programs, one for each layer; each checks its results.
fn programs() -> anyhow::Result<()> {
    let programs = files(&root().join("crates/carom/examples"), "rs")?;
    for name in programs.iter().filter_map(|path| path.file_stem()?.to_str()) {
        cargo::run_built("--example", name, &[])?;
    }
    println!("example programs: {} passed", programs.len());
    Ok(())
}

/// Runs cargo, forwards its output, and prints how many tests passed.
fn counted(name: &str, arguments: &[&str]) -> anyhow::Result<()> {
    let mut child =
        cargo::compiling(arguments).stdout(Stdio::piped()).spawn().context("cannot start cargo")?;
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
