//! Checks the dependencies against `deny.toml` by cargo-deny.

use crate::cargo;
use crate::outcome::{Outcome, Part};
use crate::tools::CARGO_DENY;
use std::path::PathBuf;
use std::process::Stdio;

/// The packages outside the workspace, each with a lock file of its own.
const OTHERS: [&str; 2] = ["fuzz/Cargo.toml", "doors/rapier/Cargo.toml"];

/// Checks licences, bans and sources; also advisories, if their database can be fetched.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    if !CARGO_DENY.is_there()? {
        return Ok(Outcome::skipped(Part::Dependencies, CARGO_DENY.advice()));
    }
    // An allowance for one of them that the others do not need is no fault.
    let quiet = ["check", "--hide-inclusion-graph", "-D", "warnings", "licenses", "sources"];
    let unused = ["-A", "license-exception-not-encountered"];
    cargo::run(&[&["deny", "--locked"], &quiet[..], &["bans"], &unused].concat())?;
    for manifest in OTHERS {
        let own = ["deny", "--locked", "--manifest-path", manifest, "--config", "deny.toml"];
        let fewer = ["-A", "license-not-encountered"];
        cargo::run(&[&own[..], &quiet[..], &unused, &fewer].concat())?;
    }
    // Fetched separately, to distinguish a failure to fetch from an advisory.
    let mut fetch = cargo::command(&["deny", "--locked", "fetch", "db"]);
    let is_fetched = fetch.stdout(Stdio::null()).status()?.success();
    if !is_fetched && !has_database() {
        let reason = "the database of advisories cannot be fetched (the error is above)";
        return Ok(Outcome::skipped(Part::Advisories, reason));
    }
    cargo::run(&["deny", "--locked", "--offline", "check", "advisories"])?;
    Ok(Outcome::Passed)
}

/// Whether a database was fetched before.
fn has_database() -> bool {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cargo")));
    let folder = home.and_then(|home| std::fs::read_dir(home.join("advisory-dbs")).ok());
    folder.is_some_and(|folder| folder.flatten().any(|entry| entry.path().join(".git").exists()))
}
