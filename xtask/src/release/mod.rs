//! What a release needs, gone through without releasing anything.

mod oldest;
pub(crate) mod packages;
mod packed;
mod wheel;

use crate::outcome::{Outcome, Part};
use crate::{cargo, flags};
use anyhow::{Context as _, ensure};
use packages::Packages;
use std::path::PathBuf;
use std::process::Command;

/// Bytes of a packed crate that the registry takes, at most.
const MOST: u64 = 10 << 20;
/// What each packed crate must hold.
const FILES: [&str; 4] = ["Cargo.toml", "README.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// The root of the workspace.
pub(crate) fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// Where cargo builds.
fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Goes through the list; fails at the first point that does not hold.
pub(crate) fn run(options: &flags::Release) -> anyhow::Result<Outcome> {
    ensure!(
        options.dry_run,
        "only --dry-run: what goes to a registry goes by hand, see CONTRIBUTING"
    );
    let packages = whole()?;
    let commits = say_changes()?;
    match options.quick {
        true => pack_and_check(&packages)?,
        false => pack(&packages, &[])?,
    }
    let outcome = commits.and(semver(&packages)?);
    if options.quick {
        println!("the oldest Rust and the wheel: left out (--quick)");
        return Ok(outcome);
    }
    let outcome = outcome.and(oldest::check()?);
    Ok(outcome.and(wheel::check(&packages.in_order()?[0].version)?))
}

/// That all crates can be packed, in their order, and checked as they are packed.
pub(crate) fn pack_quickly() -> anyhow::Result<()> {
    pack_and_check(&whole()?)
}

fn pack_and_check(packages: &Packages) -> anyhow::Result<()> {
    pack(packages, &["--no-verify"])?;
    packed::check(&packages.in_order()?)
}

/// Whether what the crates, the wheel and the citation say of themselves is whole and of one version.
pub(crate) fn whole() -> anyhow::Result<Packages> {
    let packages = Packages::read()?;
    let mut faults = packages.faults()?;
    let order = packages.in_order()?;
    let version = &order[0].version;
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
    let names: Vec<&str> = order.iter().map(|package| package.name.as_str()).collect();
    println!("{} crates of version {version}, in their order: {}", names.len(), names.join(", "));
    Ok(packages)
}

/// What the changelog still calls unreleased, and changes that are in no commit.
fn say_changes() -> anyhow::Result<Outcome> {
    let text = std::fs::read_to_string(root().join("CHANGELOG.md")).context("no CHANGELOG.md")?;
    let open = text.lines().skip_while(|line| *line != "## [Unreleased]").skip(1);
    let open =
        open.take_while(|line| !line.starts_with("## ")).filter(|line| line.starts_with("- "));
    println!(
        "{} lines of the changelog under Unreleased: head them with the version",
        open.count()
    );
    let status = Command::new("git").args(["status", "--porcelain"]).current_dir(root()).output();
    match status {
        Ok(output) if output.status.success() && output.stdout.is_empty() => {
            println!("every change is in a commit");
        }
        Ok(output) if output.status.success() => {
            println!("there are changes in no commit: a release is made of none");
        }
        _ => return Ok(Outcome::skipped(Part::Commits, "`git status` cannot be run")),
    }
    Ok(Outcome::Passed)
}

/// Packs all crates that go to the registry. Cargo takes them in their order, each against those packed
/// before, as if they were in the registry.
fn pack(packages: &Packages, how: &[&str]) -> anyhow::Result<()> {
    let private = packages.private();
    let mut arguments = vec!["package", "--workspace", "--locked", "--allow-dirty", "--quiet"];
    for name in &private {
        arguments.extend(["--exclude", name]);
    }
    arguments.extend(how);
    cargo::run(&arguments)?;
    for package in packages.in_order()? {
        let name = &package.name;
        let packed = target().join("package").join(package.archive());
        let size = packed.metadata().with_context(|| format!("no {}", packed.display()))?.len();
        ensure!(size <= MOST, "{name}: {size} bytes are more than the registry takes");
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

/// Whether the interfaces changed as the version says, where the tool is installed.
fn semver(packages: &Packages) -> anyhow::Result<Outcome> {
    if !cargo::has("semver-checks") {
        return Ok(Outcome::skipped(Part::Interfaces, "cargo-semver-checks is not installed"));
    }
    let names: Vec<String> = packages.in_order()?.into_iter().map(|package| package.name).collect();
    let mut arguments = vec!["semver-checks"];
    for name in &names {
        arguments.extend(["--package", name]);
    }
    cargo::run(&arguments)?;
    Ok(Outcome::Passed)
}
