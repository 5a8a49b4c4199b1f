//! What continuous integration checks.

use crate::{book, browse, cargo, lammps, mutants, python, release, test, tidy};
use anyhow::{Context as _, bail};
use std::time::Instant;

type Step = fn() -> anyhow::Result<()>;

const STEPS: &[(&str, Step)] = &[
    ("form", form),
    ("index of equations, places of mutants, descriptions of packages", tidy::run),
    ("lints", lints),
    ("documentation", documentation),
    ("tests, with the examples of README and documentation", test::run),
    ("tests with overflow checks and debug assertions", test::checked),
    ("quick figures", quick_figures),
    ("the report in a browser", browse::run),
    ("the Python module, in an environment of its own", python::run),
    ("the book", book::run),
    ("packages", release::pack_quickly),
    ("the LAMMPS plugin, in the pinned release", lammps::quick),
    ("mutants, each against the test known to notice it", mutants::quick),
];

/// Runs every step; stops at the first that fails.
pub(crate) fn run() -> anyhow::Result<()> {
    let start = Instant::now();
    for (i, (name, step)) in STEPS.iter().enumerate() {
        println!("== {}/{} {name}", i + 1, STEPS.len());
        let step_start = Instant::now();
        step().with_context(|| format!("step `{name}`"))?;
        println!("== {name}: passed in {:.0} s", step_start.elapsed().as_secs_f64());
    }
    println!("== all {} steps passed in {:.0} s", STEPS.len(), start.elapsed().as_secs_f64());
    Ok(())
}

fn form() -> anyhow::Result<()> {
    cargo::run(&["fmt", "--all", "--check"])
}

fn lints() -> anyhow::Result<()> {
    let clippy = ["clippy", "--workspace", "--all-targets", "--release", "--", "-D", "warnings"];
    cargo::run(&clippy)
}

fn documentation() -> anyhow::Result<()> {
    let doc = ["doc", "--workspace", "--no-deps", "--release"];
    cargo::run_with(&doc, "RUSTDOCFLAGS", "-D warnings")
}

fn quick_figures() -> anyhow::Result<()> {
    match cargo::verify(&["--quick".to_owned()])? {
        0 => Ok(()),
        code => bail!("carom-verify ended with code {code}"),
    }
}
