//! The oldest Rust that these crates support: `rust-version`. Unlike cargo-hack this tells dependencies that need a newer
//! one without the old one at hand.

use super::root;
use crate::cargo;
use crate::outcome::{Outcome, Part};
use anyhow::{Context as _, ensure};
use serde_json::Value;
use std::process::Command;

/// Dependencies that require a newer Rust than the workspace states. Clippy checks what the code
/// itself requires of the standard library.
pub(super) fn faults() -> anyhow::Result<Vec<String>> {
    let host = host()?;
    // Dependencies for other platforms need not be present.
    newer(&cargo::packages(&["--locked", "--filter-platform", &host])?, &ours()?)
}

/// The version stated by the workspace.
fn ours() -> anyhow::Result<String> {
    let manifest: toml::Table = std::fs::read_to_string(root().join("Cargo.toml"))?.parse()?;
    let version = &manifest["workspace"]["package"]["rust-version"];
    Ok(version.as_str().context("the workspace has no rust-version")?.to_owned())
}

fn host() -> anyhow::Result<String> {
    let text = cargo::printed(Command::new("rustc").arg("-vV"))?;
    let host = text.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(host.context("rustc does not name its host")?.to_owned())
}

fn newer(packages: &[Value], ours: &str) -> anyhow::Result<Vec<String>> {
    let oldest = parts(ours)?;
    let mut faults = Vec::new();
    for package in packages {
        let Some(asks) = package["rust_version"].as_str() else { continue };
        if parts(asks)? > oldest {
            let [name, version] = ["name", "version"].map(|field| package[field].as_str());
            let [name, version] = [name, version].map(Option::unwrap_or_default);
            faults.push(format!("{name} {version} asks for Rust {asks}, the workspace for {ours}"));
        }
    }
    Ok(faults)
}

/// Parses a version; `1.89` is `1.89.0`.
fn parts(version: &str) -> anyhow::Result<[u32; 3]> {
    let mut parts = [0; 3];
    for (place, part) in parts.iter_mut().zip(version.split('.')) {
        *place = part.parse().with_context(|| format!("{version} is not a version of Rust"))?;
    }
    Ok(parts)
}

/// Checks all crates with that version of Rust, if rustup has it.
pub(super) fn check() -> anyhow::Result<Outcome> {
    let version = ours()?;
    let there = Command::new("rustup").args(["run", &version, "cargo", "--version"]).output();
    if !there.is_ok_and(|output| output.status.success()) {
        let reason = format!("no Rust {version}; `rustup toolchain install {version}` installs it");
        return Ok(Outcome::skipped(Part::OldestRust, reason));
    }
    // Chosen by rustup, not by the cargo that runs this task.
    let mut command = Command::new("rustup");
    command.args(["run", &version, "cargo", "check", "--workspace", "--all-targets", "--locked"]);
    command.args(["--quiet", "--target-dir", "target/oldest"]).current_dir(root());
    let status = command.env_remove("RUSTC").env_remove("CARGO").status()?;
    ensure!(status.success(), "Rust {version} cannot build the workspace");
    println!("Rust {version} builds all crates");
    Ok(Outcome::Passed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn who_asks_for_more_is_named() {
        let packages = [
            json!({ "name": "old", "version": "1.0.0", "rust_version": "1.9" }),
            json!({ "name": "new", "version": "2.0.0", "rust_version": "1.89.1" }),
            json!({ "name": "silent", "version": "3.0.0", "rust_version": null }),
        ];
        let faults = newer(&packages, "1.89").unwrap();
        assert_eq!(faults, ["new 2.0.0 asks for Rust 1.89.1, the workspace for 1.89"]);
        assert_eq!(newer(&packages, "1.90").unwrap(), Vec::<String>::new());
        assert!(newer(&packages, "latest").is_err());
    }
}
