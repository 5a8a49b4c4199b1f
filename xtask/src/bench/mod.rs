//! The benchmarks: all of them by criterion, or the page of the book that sets carom beside its peers.

mod page;
mod peers;

use crate::cargo;
use crate::flags;
use crate::release;
use std::path::PathBuf;

/// Runs what the options ask for.
pub(crate) fn run(options: &flags::Bench) -> anyhow::Result<()> {
    if options.page {
        return page::make(options.rounds.unwrap_or(3), options.minutes.unwrap_or(12));
    }
    let mut arguments = vec!["bench", "--package", "carom-benches"];
    if let Some(filter) = &options.filter {
        arguments.extend(["--", filter]);
    }
    cargo::run(&arguments)
}

/// A folder below that of the builds, for programs of the benches: built alone they select other features of
/// common dependencies than tests and programs do.
pub(crate) fn folder() -> PathBuf {
    release::target().join("bench")
}

/// Builds an example of the benches, in release mode; returns its path.
pub(crate) fn example(name: &str) -> anyhow::Result<PathBuf> {
    let folder = folder();
    let target = folder.to_string_lossy().into_owned();
    let arguments = ["build", "--release", "--quiet", "--package", "carom-benches"];
    cargo::run(&[&arguments[..], &["--example", name, "--target-dir", &target]].concat())?;
    Ok(folder.join("release/examples").join(name))
}
