//! The Python module: builds its wheel, installs it into a fresh environment and tests it there.

use crate::cargo::Lints;
use crate::files::files;
use crate::outcome::{Outcome, Part};
use crate::root::root;
use anyhow::{Context as _, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Packages required by the tests.
const REQUIRED_PACKAGES: &[&str] = &["maturin>=1.9,<2", "numpy>=1.26", "pytest>=8"];
/// Optional packages of the tests.
const OPTIONAL_PACKAGES: &[&str] = &[
    "astropy",
    "distributed",
    "ipykernel",
    "jsonschema",
    "matplotlib",
    "mypy",
    "nbclient",
    "pandas",
    "pandas-stubs",
    "pint",
    "pyright[nodejs]",
    "unyt",
    "xarray",
];

/// Why there is no environment.
pub(crate) const NONE: &str = "there is no Python 3.10 or later with venv";

/// A virtual environment below target/.
pub(crate) struct Place {
    folder: PathBuf,
}

impl Place {
    /// Its interpreter.
    pub(crate) fn python(&self) -> PathBuf {
        self.folder.join("venv/bin/python")
    }

    /// Builds and installs the wheel.
    pub(crate) fn install(&self) -> anyhow::Result<()> {
        let wheel = build(self)?.to_string_lossy().into_owned();
        call(&mut self.uv(&["--no-index", "--force-reinstall", "--no-deps", &wheel]))
    }

    /// Installs the packages of tests that are skipped without them.
    pub(crate) fn install_optional(&self) -> Outcome {
        match call(&mut self.uv(OPTIONAL_PACKAGES)) {
            Ok(()) => Outcome::Passed,
            Err(_) => {
                let reason = format!("{} cannot be installed", OPTIONAL_PACKAGES.join(", "));
                Outcome::skipped(Part::PythonWishes, reason)
            }
        }
    }

    /// A command that installs packages by uv, in a tenth of pip's time.
    fn uv(&self, arguments: &[&str]) -> Command {
        let mut uv = Command::new(self.folder.join("venv/bin/uv"));
        uv.args(["pip", "install", "--quiet", "--python"]).arg(self.python()).args(arguments);
        uv
    }
}

/// Builds the wheel and tests it in an environment below target/; skipped without Python 3.10 or
/// later.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    Ok(packages()?.and(install()?).and(test(&[])?))
}

/// Makes the environment below target/, with the packages that the tests of the module use.
pub(crate) fn packages() -> anyhow::Result<Outcome> {
    let Some(place) = place()? else { return Ok(Outcome::skipped(Part::Python, NONE)) };
    Ok(place.install_optional())
}

/// Builds the wheel and installs it in the environment of [`packages`].
pub(crate) fn install() -> anyhow::Result<Outcome> {
    let Some(place) = made() else { return Ok(Outcome::skipped(Part::Python, NONE)) };
    place.install()?;
    Ok(Outcome::Passed)
}

/// The environment that [`packages`] has made.
fn made() -> Option<Place> {
    let place = Place { folder: root().join("target/python") };
    place.python().exists().then_some(place)
}

/// Tests of what is written in Python: type checkers read the package, the examples and the pages of the book, and the
/// notebooks run.
pub(crate) const WRITTEN: &[&str] = &["test_types.py", "test_notebook.py"];

/// Tests the module in the environment of [`install`], without the files of these names. Builds nothing.
pub(crate) fn test(left_out: &[&str]) -> anyhow::Result<Outcome> {
    let Some(place) = made() else { return Ok(Outcome::skipped(Part::Python, NONE)) };
    // In another folder, so that the installed module is tested and not its sources.
    let project = project();
    let mut pytest = Command::new(place.python());
    pytest.args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir"]).arg(&project);
    let tests = project.join("tests");
    for name in left_out {
        pytest.arg("--ignore").arg(tests.join(name));
    }
    pytest.arg(tests);
    self::pytest(&mut pytest, &place.folder)
}

/// Runs pytest in `folder`. Tests that skip themselves count as a skipped part.
pub(crate) fn pytest(pytest: &mut Command, folder: &Path) -> anyhow::Result<Outcome> {
    let report = folder.join("pytest.xml");
    pytest.current_dir(folder).args(["-rs", "--durations=10", "--junit-xml"]).arg(&report);
    call(pytest)?;
    let text = std::fs::read_to_string(&report).with_context(|| report.display().to_string())?;
    let skipped = skipped_in(&text).context("pytest's report has no count of skipped tests")?;
    Ok(match skipped {
        0 => Outcome::Passed,
        _ => Outcome::skipped(Part::OwnTests, format!("{skipped} tests of Python, named above")),
    })
}

/// The count in `<testsuite ... skipped="2" ...>`.
fn skipped_in(report: &str) -> Option<u64> {
    let suite = report.split_once("<testsuite ")?.1.split_once('>')?.0;
    suite.split_once("skipped=\"")?.1.split_once('"')?.0.parse().ok()
}

/// A fresh environment with the required packages; `None` without Python 3.10 or later.
pub(crate) fn place() -> anyhow::Result<Option<Place>> {
    let Some(python) = interpreter() else { return Ok(None) };
    let place = Place { folder: root().join("target/python") };
    let venv = place.folder.join("venv");
    if venv.exists() {
        std::fs::remove_dir_all(&venv).with_context(|| venv.display().to_string())?;
    }
    call(Command::new(python).args(["-m", "venv"]).arg(venv))?;
    let mut pip = Command::new(place.python());
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
    call(pip.args(["--no-compile", "uv"]))?;
    call(&mut place.uv(REQUIRED_PACKAGES))?;
    Ok(Some(place))
}

/// Builds the wheel.
pub(crate) fn build(place: &Place) -> anyhow::Result<PathBuf> {
    let wheels = place.folder.join("wheels");
    if wheels.exists() {
        std::fs::remove_dir_all(&wheels).with_context(|| wheels.display().to_string())?;
    }
    let mut maturin = Command::new(place.folder.join("venv/bin/maturin"));
    maturin.current_dir(project()).args(["build", "--release", "--quiet", "--out"]).arg(&wheels);
    maturin.arg("--target-dir").arg(crate::release::target());
    Lints::set(&mut maturin);
    call(&mut maturin)?;
    only(&wheels, "whl")
}

/// The folder of the Python module.
pub(crate) fn project() -> PathBuf {
    root().join("crates/python")
}

/// The first Python that is new enough and can create environments.
pub(crate) fn interpreter() -> Option<&'static str> {
    let probe = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))";
    let works = |name: &&str| {
        Command::new(name).args(["-c", probe]).output().is_ok_and(|output| output.status.success())
    };
    ["python3", "python"].into_iter().find(works)
}

/// The file with this ending in a folder.
pub(crate) fn only(folder: &Path, ending: &str) -> anyhow::Result<PathBuf> {
    let found = files(folder, ending)?.pop();
    found.with_context(|| format!("no file .{ending} in {}", folder.display()))
}

pub(crate) fn call(command: &mut Command) -> anyhow::Result<()> {
    let status = command.status().with_context(|| format!("cannot start {command:?}"))?;
    if !status.success() {
        bail!("{command:?} failed ({status})");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_of_skipped_tests_is_read() {
        let report = "<?xml?><testsuites><testsuite name=\"pytest\" errors=\"0\" skipped=\"2\" \
                      tests=\"9\"><testcase/></testsuite></testsuites>";
        assert_eq!(skipped_in(report), Some(2));
        assert_eq!(skipped_in("<testsuites/>"), None);
    }
}
