//! Checks that the crates can be built from their packages.

use super::packages::Package;
use super::{root, target};
use crate::cargo;
use anyhow::{Context as _, ensure};
use std::process::Command;

/// Checks the packed crates as a workspace of their own, each against the others as packed. This is
/// faster than the build of `cargo package`.
pub(super) fn check(packages: &[Package]) -> anyhow::Result<()> {
    let place = target().join("packed");
    if place.exists() {
        std::fs::remove_dir_all(&place)?;
    }
    std::fs::create_dir_all(&place)?;
    for package in packages {
        let archive = target().join("package").join(package.archive());
        // Unpacked as of now: packages carry one old time, by which cargo takes what it built of earlier ones for theirs.
        let status =
            Command::new("tar").arg("-xzmf").arg(&archive).arg("-C").arg(&place).status()?;
        ensure!(status.success(), "cannot unpack {}", archive.display());
    }
    std::fs::write(place.join("Cargo.toml"), manifest(packages))?;
    std::fs::copy(root().join("Cargo.lock"), place.join("Cargo.lock"))?;
    let manifest = place.join("Cargo.toml").canonicalize()?;
    let target = target().canonicalize()?;
    let mut command = cargo::command(&["check", "--release", "--workspace", "--quiet"]);
    command.arg("--manifest-path").arg(manifest).arg("--target-dir").arg(target);
    let status = command.status().context("cannot start cargo")?;
    ensure!(status.success(), "the crates cannot be built from their packages");
    println!("{} crates build from their packages", packages.len());
    Ok(())
}

fn manifest(packages: &[Package]) -> String {
    let mut text = "[workspace]\nresolver = \"3\"\nmembers = [\"*-*.*.*\"]\n\n".to_owned();
    text += "[patch.crates-io]\n";
    for package in packages {
        text += &format!("{} = {{ path = \"{}\" }}\n", package.name, package.unpacked());
    }
    text
}
