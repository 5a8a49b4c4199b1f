//! Generated files of the repository: written, or compared with what would be written.

use crate::outcome::{Outcome, Part};
use crate::python::{self, NONE};
use crate::root::root;
use crate::{book, cargo};
use anyhow::{Context as _, ensure};
use std::process::Command;

/// Makes the result classes without the package, which needs them.
const MAKE_RECORDS: &str = "import sys, sysconfig, types; package = types.ModuleType('carom'); \
    package.__path__ = [sysconfig.get_paths()['platlib'] + '/carom']; sys.modules['carom'] = package; \
    from carom import _make_records; print(_make_records.made(), end='')";

/// Whether files are written or compared.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    Write,
    Check,
}

/// A generator: the description of its files, and its function.
type Generator = (&'static str, fn(Mode) -> anyhow::Result<Outcome>);

const GENERATORS: &[Generator] = &[
    ("the C header crates/capi/include/carom.h", |mode| by_test("carom-capi", "header::", mode)),
    ("the schemas of cases, docs/schema", |mode| by_test("carom-cli", "schema::", mode)),
    ("pictures and case reference of the book", |mode| by_test("carom-cli", "book::", mode)),
    ("copies of sources on pages", book::copies),
    ("the result classes of Python, crates/python/python/carom/_records.py", records),
];

/// The file of Python's result classes.
const RECORDS: &str = "crates/python/python/carom/_records.py";

/// Runs all generators; in [`Mode::Check`] it fails if a file differs from what its generator writes.
pub(crate) fn run(mode: Mode) -> anyhow::Result<Outcome> {
    let mut outcome = Outcome::Passed;
    for (what, generate) in GENERATORS {
        println!("== {what}");
        outcome = outcome.and(generate(mode)?);
    }
    Ok(outcome)
}

/// The table of R_x of dissimilar spheres, which takes a quarter of an hour, and then the tables in `reference/`, which
/// read it; in [`Mode::Check`] some entries of the former and all of the latter.
pub(crate) fn tables(mode: Mode) -> anyhow::Result<()> {
    let arguments: &[&str] = if mode == Mode::Check { &["--check"] } else { &[] };
    cargo::run_built("--example", "dissimilar_table", arguments)?;
    cargo::run_built("--example", "reference_tables", arguments)
}

/// Runs the test that compares the file with what the sources give; with `CAROM_GENERATE` set it writes the file first.
fn by_test(package: &str, name: &str, mode: Mode) -> anyhow::Result<Outcome> {
    let test = ["test", "--release", "--package", package, "--test", "it", name];
    match mode {
        Mode::Write => cargo::run_with(&test, "CAROM_GENERATE", "1")?,
        Mode::Check => cargo::run(&test)?,
    }
    Ok(Outcome::Passed)
}

/// Builds the module and generates the result classes from its columns.
fn records(mode: Mode) -> anyhow::Result<Outcome> {
    let Some(place) = python::place()? else { return Ok(Outcome::skipped(Part::Python, NONE)) };
    place.install()?;
    let output = Command::new(place.python()).args(["-c", MAKE_RECORDS]).output()?;
    let message = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "carom._make_records failed: {message}");
    let path = root().join(RECORDS);
    if mode == Mode::Write {
        std::fs::write(&path, &output.stdout).with_context(|| path.display().to_string())?;
    }
    let kept = std::fs::read(&path).with_context(|| path.display().to_string())?;
    ensure!(kept == output.stdout, "{RECORDS} is not current: cargo xtask generate");
    Ok(Outcome::Passed)
}
