//! The Python module: its wheel, built, installed into a fresh environment and tested there.

use anyhow::{Context as _, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What the tests need beside the wheel.
const TOOLS: &[&str] = &["maturin>=1.9,<2", "numpy>=1.26", "pytest>=8"];
/// What they use where it can be had.
const WISHES: &[&str] = &["distributed", "matplotlib", "pandas", "xarray"];

/// Builds the wheel and tests it in an environment below target/; skipped, and it says so, where there is
/// no Python 3.11 or later.
pub(crate) fn run() -> anyhow::Result<()> {
    let Some(python) = interpreter() else {
        println!("skipped: there is no Python 3.11 or later with venv");
        return Ok(());
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let (project, place) = (root.join("crates/python"), root.join("target/python"));
    let wheels = place.join("wheels");
    for old in [place.join("venv"), wheels.clone()] {
        if old.exists() {
            std::fs::remove_dir_all(&old).with_context(|| old.display().to_string())?;
        }
    }
    call(Command::new(python).args(["-m", "venv"]).arg(place.join("venv")))?;
    let bin = place.join("venv/bin");
    let pip = |arguments: &[&str]| {
        let mut pip = Command::new(bin.join("python"));
        pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        pip.args(arguments);
        pip
    };
    call(&mut pip(TOOLS))?;
    if call(&mut pip(WISHES)).is_err() {
        println!("without {}: their tests are skipped", WISHES.join(", "));
    }
    let mut maturin = Command::new(bin.join("maturin"));
    maturin.current_dir(&project).args(["build", "--release", "--quiet", "--out"]).arg(&wheels);
    call(maturin.arg("--target-dir").arg(target(&root)))?;
    let wheel = wheel(&wheels)?;
    call(&mut pip(&["--no-index", "--force-reinstall", "--no-deps", &wheel.to_string_lossy()]))?;
    // From elsewhere, so that the installed module is tested, not its sources.
    let mut pytest = Command::new(bin.join("python"));
    pytest.current_dir(&place).args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir"]);
    pytest.arg(&project).arg(project.join("tests"));
    call(&mut pytest)
}

/// The first Python that is new enough and can make environments.
pub(crate) fn interpreter() -> Option<&'static str> {
    let probe = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))";
    let works = |name: &&str| {
        Command::new(name).args(["-c", probe]).output().is_ok_and(|output| output.status.success())
    };
    ["python3", "python"].into_iter().find(works)
}

/// The folder of the builds, so that what is built is not built again.
fn target(root: &Path) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from)
}

/// The one wheel in a folder.
fn wheel(folder: &Path) -> anyhow::Result<PathBuf> {
    let entries = std::fs::read_dir(folder).context("no wheel was built")?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut wheels = paths.filter(|path| path.extension().is_some_and(|end| end == "whl"));
    wheels.next().context("no wheel was built")
}

pub(crate) fn call(command: &mut Command) -> anyhow::Result<()> {
    let status = command.status().with_context(|| format!("cannot start {command:?}"))?;
    if !status.success() {
        bail!("{command:?} failed ({status})");
    }
    Ok(())
}
