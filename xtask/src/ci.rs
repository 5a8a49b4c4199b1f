//! What continuous integration checks.

use crate::outcome::Outcome;
use crate::{book, browse, cargo, deny, lammps, mutants, python, release, test, tidy};
use anyhow::{Context as _, bail};
use std::process::Command;
use std::time::Instant;

type Step = fn() -> anyhow::Result<Outcome>;

const STEPS: &[(&str, Step)] = &[
    ("form", form),
    ("index of equations, places of mutants, descriptions of packages", tidy_up),
    ("licences, sources and advisories of the dependencies", deny::run),
    ("lints", lints),
    ("documentation", documentation),
    ("tests, with the examples of README and documentation", || passed(test::run())),
    ("tests with overflow checks and debug assertions", || passed(test::checked())),
    ("quick figures", quick_figures),
    ("the report in a browser", browse::run),
    ("the Python module, in an environment of its own", python::run),
    ("the book", book::run),
    ("packages", || passed(release::pack_quickly())),
    ("the LAMMPS plugin, in the pinned release", || lammps::run(true)),
    ("mutants, each against the test known to notice it", || passed(mutants::quick())),
];

/// Runs every step; stops at the first that fails, or in continuous integration at the first that skips
/// what may not be skipped.
pub(crate) fn run() -> anyhow::Result<()> {
    let start = Instant::now();
    let mut skipped = 0;
    for (i, (name, step)) in STEPS.iter().enumerate() {
        println!("== {}/{} {name}", i + 1, STEPS.len());
        let step_start = Instant::now();
        let outcome = step().and_then(Outcome::accept).with_context(|| format!("step `{name}`"));
        if outcome.is_err() {
            print_new_regressions();
        }
        let count = outcome?;
        let end = if count == 0 { "passed".to_owned() } else { format!("{count} parts SKIPPED") };
        println!("== {name}: {end} in {:.0} s", step_start.elapsed().as_secs_f64());
        skipped += count;
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("== all {} steps in {seconds:.0} s, {skipped} parts skipped", STEPS.len());
    Ok(())
}

fn passed(result: anyhow::Result<()>) -> anyhow::Result<Outcome> {
    result.map(|()| Outcome::Passed)
}

/// Prints the seeds with which property tests failed, so that they can be committed from a machine that
/// is not kept.
fn print_new_regressions() {
    let root = release::root();
    let git = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).current_dir(&root).output();
        output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let pattern = "*.proptest-regressions";
    let all = ["ls-files", "--modified", "--others", "--exclude-standard", "--", pattern];
    for path in git(&all).unwrap_or_default().lines() {
        if let Ok(text) = std::fs::read_to_string(root.join(path)) {
            println!("== commit these seeds as {path}:\n{text}");
        }
    }
}

fn form() -> anyhow::Result<Outcome> {
    passed(cargo::run(&["fmt", "--all", "--check"]))
}

fn tidy_up() -> anyhow::Result<Outcome> {
    passed(tidy::run())
}

fn lints() -> anyhow::Result<Outcome> {
    let clippy = ["clippy", "--workspace", "--all-targets", "--release", "--", "-D", "warnings"];
    passed(cargo::run(&clippy))
}

fn documentation() -> anyhow::Result<Outcome> {
    let doc = ["doc", "--workspace", "--no-deps", "--release"];
    passed(cargo::run_with(&doc, "RUSTDOCFLAGS", "-D warnings"))
}

fn quick_figures() -> anyhow::Result<Outcome> {
    match cargo::verify(&["--quick".to_owned()])? {
        0 => Ok(Outcome::Passed),
        code => bail!("carom-verify ended with code {code}"),
    }
}
