//! The page of the book with carom beside its peers: one run, from which all its numbers come.

use super::peers::Peers;
use super::{example, folder};
use crate::python::{NONE, call, interpreter};
use crate::root::root;
use anyhow::Context as _;
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

/// The page, below the root.
const PAGE: &str = "docs/book/src/bench.md";

/// Measures in several rounds, on the finest grid what so many minutes allow; writes
/// `target/bench/page.json` and from it the page.
pub(super) fn make(rounds: u32, minutes: u32) -> anyhow::Result<()> {
    let program = example("one_contact")?;
    let folder = std::path::absolute(folder())?;
    let peers = Peers::place(&folder.join("peers"))?;
    for (name, reason) in &peers.absent {
        println!("{name} is absent: {reason}");
    }
    let answers = folder.join("page.json");
    let mut measure = script("rounds.py")?;
    measure.arg(std::path::absolute(program)?).arg(&answers);
    measure.args(["--rounds", &rounds.to_string(), "--minutes", &minutes.to_string()]);
    for (name, python) in &peers.present {
        measure.arg("--peer").arg(pair(name, python));
    }
    for (name, reason) in &peers.absent {
        measure.args(["--absent", &format!("{name}={reason}")]);
    }
    if let Some((python, plugin)) = &peers.lammps {
        measure.arg("--lammps").arg(pair(&std::path::absolute(python)?.to_string_lossy(), plugin));
    }
    call(&mut measure)?;
    call(script("page.py")?.arg(&answers).arg(root().join(PAGE)))?;
    println!("{PAGE} is written anew, from {}", answers.display());
    Ok(())
}

fn script(name: &str) -> anyhow::Result<Command> {
    let mut command = Command::new(interpreter().context(NONE)?);
    command.arg(root().join("benches/peers").join(name));
    Ok(command)
}

fn pair(name: &str, path: &Path) -> OsString {
    let mut pair = OsString::from(format!("{name}="));
    pair.push(std::path::absolute(path).as_deref().unwrap_or(path));
    pair
}
