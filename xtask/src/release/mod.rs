//! Checks everything that a release needs, without releasing anything.

mod oldest;
pub(crate) mod packages;
mod packed;
mod wheel;

use crate::outcome::{Outcome, Part};
use crate::root::root;
use crate::{cargo, flags};
use anyhow::{Context as _, ensure};
use packages::Packages;
use std::path::PathBuf;
use std::process::Command;

/// Largest size of a packed crate that the registry accepts, in bytes.
const MAX_PACKED_BYTES: u64 = 10 << 20;
/// Files that each packed crate must contain.
const FILES: [&str; 4] = ["Cargo.toml", "README.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// The build folder of cargo.
pub(crate) fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Runs all checks; fails at the first that does not hold.
pub(crate) fn run(options: &flags::Release) -> anyhow::Result<Outcome> {
    ensure!(options.dry_run, "only --dry-run is supported: publish by hand, see CONTRIBUTING");
    let packages = whole()?;
    let commits = say_changes()?;
    match options.quick {
        true => pack_and_check(&packages)?,
        false => pack(&packages, &[])?,
    }
    let outcome = commits.and(semver(&packages)?);
    if options.quick {
        println!("the oldest Rust and the wheel: skipped (--quick)");
        return Ok(outcome);
    }
    let outcome = outcome.and(oldest::check()?);
    Ok(outcome.and(wheel::check(&packages.public()[0].version)?))
}

/// Checks that all crates can be packed, and builds them as packed.
pub(crate) fn pack_quickly() -> anyhow::Result<()> {
    pack_and_check(&whole()?)
}

fn pack_and_check(packages: &Packages) -> anyhow::Result<()> {
    pack(packages, &["--no-verify"])?;
    packed::check(&packages.public())
}

/// Checks that the descriptions of crates, wheel and citation are complete and have one version.
pub(crate) fn whole() -> anyhow::Result<Packages> {
    let packages = Packages::read()?;
    let mut faults = packages.faults()?;
    let public = packages.public();
    let version = &public[0].version;
    let citation = std::fs::read_to_string(root().join("CITATION.cff"))?;
    if !citation.lines().any(|line| line == format!("version: {version}")) {
        faults.push(format!("CITATION.cff: not of version {version}"));
    }
    faults.extend(wheel::faults()?);
    faults.extend(oldest::faults()?);
    ensure!(
        faults.is_empty(),
        "{} faults in the packages:\n  {}",
        faults.len(),
        faults.join("\n  ")
    );
    println!("{} crates of version {version}", public.len());
    Ok(packages)
}

/// Prints unreleased lines of the changelog and uncommitted changes.
fn say_changes() -> anyhow::Result<Outcome> {
    let text = std::fs::read_to_string(root().join("CHANGELOG.md")).context("no CHANGELOG.md")?;
    let open = text.lines().skip_while(|line| *line != "## [Unreleased]").skip(1);
    let open =
        open.take_while(|line| !line.starts_with("## ")).filter(|line| line.starts_with("- "));
    println!(
        "{} lines of the changelog are under Unreleased: move them under the version",
        open.count()
    );
    let status = Command::new("git").args(["status", "--porcelain"]).current_dir(root()).output();
    match status {
        Ok(output) if output.status.success() && output.stdout.is_empty() => {
            println!("all changes are committed");
        }
        Ok(output) if output.status.success() => {
            println!("there are uncommitted changes, which a release does not contain");
        }
        _ => return Ok(Outcome::skipped(Part::Commits, "`git status` cannot be run")),
    }
    Ok(Outcome::Passed)
}

/// Packs all crates for the registry; cargo packs each against those packed before as if they were in the registry.
fn pack(packages: &Packages, how: &[&str]) -> anyhow::Result<()> {
    let private = packages.private();
    let mut arguments = vec!["package", "--workspace", "--locked", "--allow-dirty", "--quiet"];
    for name in &private {
        arguments.extend(["--exclude", name]);
    }
    arguments.extend(how);
    cargo::run(&arguments)?;
    for package in packages.public() {
        let name = &package.name;
        let packed = target().join("package").join(package.archive());
        let size = packed.metadata().with_context(|| format!("no {}", packed.display()))?.len();
        ensure!(size <= MAX_PACKED_BYTES, "{name}: {size} bytes exceed the limit of the registry");
        let listed = cargo::command(&["package", "--list", "--allow-dirty", "--package", name])
            .output()
            .context("cannot start cargo")?;
        let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
        for file in FILES {
            ensure!(listed.lines().any(|line| line == file), "{name}: {file} is not packed");
        }
        println!("{name}: {} files, {} kB packed", listed.lines().count(), size >> 10);
    }
    Ok(())
}

/// Checks that the interfaces changed as the version number says, if the tool is installed.
fn semver(packages: &Packages) -> anyhow::Result<Outcome> {
    if !cargo::has("semver-checks") {
        return Ok(Outcome::skipped(Part::Interfaces, "cargo-semver-checks is not installed"));
    }
    let names: Vec<String> = packages.public().into_iter().map(|package| package.name).collect();
    let mut arguments = vec!["semver-checks"];
    for name in &names {
        arguments.extend(["--package", name]);
    }
    cargo::run(&arguments)?;
    Ok(Outcome::Passed)
}
