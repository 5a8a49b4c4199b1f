//! Tests the doors to other engines: a JavaScript module, and strategies for pooltool. They stand outside the
//! workspace, each with a lock file of its own.

use anyhow::{Context as _, bail};
use std::path::Path;
use std::process::Command;

use crate::lammps::{UNREACHED, pip, reaches_registry};
use crate::outcome::{Outcome, Part};
use crate::python::{self, call, interpreter};
use crate::root::root;

/// Tests all doors.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    Ok(rebound()?.and(pooltool()?))
}

/// Tests the JavaScript module, its package, and that its table is that of the library; skipped without Node or npm.
pub(crate) fn rebound() -> anyhow::Result<Outcome> {
    for tool in ["node", "npm"] {
        if !answers(tool) {
            return Ok(Outcome::skipped(Part::Node, format!("{tool} is not installed")));
        }
    }
    let folder = root().join("doors/carom-rebound");
    call(Command::new("node").arg("--test").current_dir(folder))?;
    Ok(Outcome::Passed)
}

/// Tests the strategies of pooltool with a wheel of this module, in an environment below target/; skipped without Python
/// or if its package registry cannot be reached.
fn pooltool() -> anyhow::Result<Outcome> {
    let (Some(python), Some(place)) = (interpreter(), python::place()?) else {
        return Ok(Outcome::skipped(Part::Python, python::NONE));
    };
    let wheel = python::build(&place)?;
    let root = root().canonicalize()?;
    let (door, folder) = (root.join("doors/pooltool"), root.join("target/doors"));
    let venv = folder.join("venv");
    if !venv.join("bin/python").exists() {
        call(Command::new(python).args(["-m", "venv"]).arg(&venv))?;
    }
    if !installs(&venv, &door.join("requirements.lock"))? {
        return Ok(Outcome::skipped(Part::Pooltool, UNREACHED));
    }
    let again = ["--no-index", "--force-reinstall", "--no-deps"];
    call(pip(&venv, "install").args(again).arg(wheel))?;
    let mut pytest = Command::new(venv.join("bin/python"));
    pytest.args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir"]).arg(&door);
    python::pytest(pytest.arg(door.join("tests")), &folder).context("the tests of doors/pooltool")
}

/// Installs exactly the packages of a lock file; false if the registry cannot be reached.
fn installs(venv: &Path, lock: &Path) -> anyhow::Result<bool> {
    // pooltool wants a development version of its graphics, which the registry does not have and tests do not need.
    match call(pip(venv, "install").args(["--no-deps", "--requirement"]).arg(lock)) {
        Ok(()) => Ok(true),
        Err(error) if reaches_registry(venv) => bail!("{}: {error:#}", lock.display()),
        Err(_) => Ok(false),
    }
}

fn answers(tool: &str) -> bool {
    Command::new(tool).arg("--version").output().is_ok_and(|output| output.status.success())
}
