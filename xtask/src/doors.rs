//! Tests the doors to other engines: a JavaScript module, strategies for pooltool, a hook for Rapier.
//! They stand outside the workspace, each with a lock file of its own.

use anyhow::{Context as _, bail};
use std::path::Path;
use std::process::Command;

use crate::cargo;
use crate::lammps::{UNREACHED, pip, reaches_registry};
use crate::outcome::{Outcome, Part};
use crate::python::{self, call, interpreter};
use crate::root::root;

/// Why a crate is not tested.
pub(crate) const NO_CRATES: &str = "the registry of crates cannot be reached";

/// Tests all doors.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    chosen(None)
}

type Door = (&'static str, fn() -> anyhow::Result<Outcome>);

const DOORS: &[Door] = &[("carom-rebound", rebound), ("pooltool", pooltool), ("rapier", rapier)];

/// Tests the door of this name, or all.
pub(crate) fn chosen(name: Option<&str>) -> anyhow::Result<Outcome> {
    let chosen = DOORS.iter().filter(|(own, _)| name.is_none_or(|name| name == *own));
    let mut outcomes = chosen.map(|(_, test)| test());
    let Some(first) = outcomes.next() else {
        let names: Vec<_> = DOORS.iter().map(|(name, _)| *name).collect();
        bail!("no door of this name; there are {}", names.join(", "));
    };
    outcomes.try_fold(first?, |all, one| Ok(all.and(one?)))
}

/// Tests the JavaScript module, its package, and that its table is that of the library; skipped without Node or npm.
pub(crate) fn rebound() -> anyhow::Result<Outcome> {
    for tool in ["node", "npm"] {
        if !cargo::answers(tool) {
            return Ok(Outcome::skipped(Part::Node, format!("{tool} is not installed")));
        }
    }
    let folder = root().join("doors/carom-rebound");
    // The table of R_x and the page are not stored.
    call(Command::new("node").arg("build.mjs").arg("--check").current_dir(&folder))?;
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

/// Tests the hook for Rapier.
fn rapier() -> anyhow::Result<Outcome> {
    crate_door("rapier", Part::Rapier)
}

/// Tests a door that is a crate, with its own lock file and build folder; skipped if the registry of crates cannot be
/// reached.
fn crate_door(name: &str, part: Part) -> anyhow::Result<Outcome> {
    let manifest = format!("doors/{name}/Cargo.toml");
    if !fetches(&manifest)? {
        return Ok(Outcome::skipped(part, NO_CRATES));
    }
    let own = ["--locked", "--manifest-path", &manifest];
    cargo::run(&["fmt", "--check", "--manifest-path", &manifest])?;
    let target = root().join("target/doors").join(name);
    for (task, options) in
        [("clippy", &["--no-deps", "--all-targets", "--", "-D", "warnings"][..]), ("test", &[])]
    {
        let mut command = cargo::command(&[&[task, "--release"], &own[..], options].concat());
        call(command.env("CARGO_TARGET_DIR", &target)).with_context(|| format!("doors/{name}"))?;
    }
    Ok(Outcome::Passed)
}

/// Fetches exactly the crates of a lock file; false if the registry cannot be reached.
pub(crate) fn fetches(manifest: &str) -> anyhow::Result<bool> {
    if cargo::run(&["fetch", "--locked", "--manifest-path", manifest]).is_ok() {
        return Ok(true);
    }
    // A small crate tells a lock file that does not fit from a registry that does not answer.
    if cargo::run(&["info", "--registry", "crates-io", "--quiet", "autocfg"]).is_ok() {
        bail!("{manifest}: its lock file, as it is, does not fetch its crates");
    }
    Ok(false)
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
