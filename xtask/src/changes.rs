//! The changes since the last published commit, and the crates that depend on them.

use crate::cargo::{self, git};
use crate::root::root;
use anyhow::{Context as _, bail};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

/// Environment variable with the base commit of the changes, instead of the default.
const BASE: &str = "CAROM_BASE";

/// The package of a crate name or folder: `laws` is `carom-laws`.
pub(crate) fn package(name: &str) -> anyhow::Result<String> {
    let packages = Package::all()?;
    let full = format!("carom-{name}");
    match packages.iter().find(|package| [name, &full].contains(&package.name.as_str())) {
        Some(package) => Ok(package.name.clone()),
        None => {
            let names: Vec<_> =
                packages.iter().map(|package| package.name.trim_start_matches("carom-")).collect();
            bail!("there is no crate `{name}`; the crates are {}", names.join(", "))
        }
    }
}

/// The changed packages and those that depend on them, sorted; all packages if a file of the
/// workspace changed that affects every build.
pub(crate) fn packages() -> anyhow::Result<Vec<String>> {
    Ok(affected(&Package::all()?, &paths()?))
}

/// The paths changed since the base commit, relative to the root of the workspace.
pub(crate) fn paths() -> anyhow::Result<Vec<String>> {
    let base = base()?;
    println!("== changes since {base}");
    paths_since(&base)
}

/// The base commit: that of the environment variable; otherwise the point where this branch left
/// `origin/main`, if it has commits since; otherwise the last commit but one.
fn base() -> anyhow::Result<String> {
    if let Ok(base) = std::env::var(BASE) {
        return Ok(base);
    }
    let head = git(&["rev-parse", "HEAD"])?;
    let merged = git(&["merge-base", "HEAD", "origin/main"]).ok();
    let base = match merged.filter(|merged| *merged != head) {
        Some(merged) => merged,
        None => git(&["rev-parse", "HEAD^"]).unwrap_or(head),
    };
    Ok(base.trim().to_owned())
}

fn paths_since(base: &str) -> anyhow::Result<Vec<String>> {
    let changed = git(&["diff", "--name-only", base])?;
    let new = git(&["ls-files", "--others", "--exclude-standard"])?;
    Ok(changed.lines().chain(new.lines()).map(str::to_owned).collect())
}

/// A package of the workspace.
struct Package {
    name: String,
    /// Folder relative to the root of the workspace, with a slash at its end.
    folder: String,
    dependencies: BTreeSet<String>,
}

impl Package {
    fn all() -> anyhow::Result<Vec<Self>> {
        let (packages, root) =
            (cargo::packages(&["--no-deps", "--offline"])?, root().canonicalize()?);
        packages.iter().map(|package| Self::read(package, &root)).collect()
    }

    fn read(package: &Value, root: &Path) -> anyhow::Result<Self> {
        let manifest = package["manifest_path"].as_str().context("a package without a path")?;
        let folder = Path::new(manifest).parent().context("a package without a folder")?;
        let folder = folder.strip_prefix(root)?.to_string_lossy().into_owned() + "/";
        let name = |value: &Value| value["name"].as_str().map(str::to_owned);
        let dependencies = package["dependencies"].as_array().into_iter().flatten();
        Ok(Self {
            name: name(package).context("a package without a name")?,
            folder,
            dependencies: dependencies.filter_map(name).collect(),
        })
    }
}

/// The packages of these paths, and all that depend on them.
fn affected(packages: &[Package], paths: &[String]) -> Vec<String> {
    let builds_all = |path: &String| {
        ["Cargo.toml", "Cargo.lock", "rust-toolchain.toml"].contains(&path.as_str())
            || path.starts_with(".cargo/")
    };
    if paths.iter().any(builds_all) {
        return packages.iter().map(|package| package.name.clone()).collect();
    }
    let is_in = |package: &&Package| paths.iter().any(|path| path.starts_with(&package.folder));
    let mut found: BTreeSet<String> =
        packages.iter().filter(is_in).map(|package| package.name.clone()).collect();
    loop {
        let depends =
            |package: &&Package| package.dependencies.iter().any(|name| found.contains(name));
        let more: Vec<_> = packages
            .iter()
            .filter(depends)
            .filter(|package| !found.contains(&package.name))
            .map(|package| package.name.clone())
            .collect();
        if more.is_empty() {
            return found.into_iter().collect();
        }
        found.extend(more);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packages() -> Vec<Package> {
        let package = |name: &str, folder: &str, dependencies: &[&str]| Package {
            name: name.to_owned(),
            folder: folder.to_owned(),
            dependencies: dependencies.iter().map(|&name| name.to_owned()).collect(),
        };
        vec![
            package("carom-special", "crates/special/", &["libm"]),
            package("carom-laws", "crates/laws/", &["carom-special"]),
            package("carom-impact", "crates/impact/", &["carom-laws"]),
            package("carom-plot", "crates/plot/", &[]),
        ]
    }

    fn affected_by(path: &str) -> Vec<String> {
        affected(&packages(), &[path.to_owned()])
    }

    #[test]
    fn dependent_crates_are_affected() {
        assert_eq!(affected_by("crates/laws/src/hertz.rs"), ["carom-impact", "carom-laws"]);
        assert_eq!(affected_by("crates/plot/src/lib.rs"), ["carom-plot"]);
        assert!(affected_by("README.md").is_empty());
        assert_eq!(affected_by("Cargo.lock").len(), 4);
    }

    #[test]
    fn crates_are_found_by_their_short_names() {
        assert_eq!(package("laws").unwrap(), "carom-laws");
        assert_eq!(package("xtask").unwrap(), "xtask");
        let error = package("lows").unwrap_err().to_string();
        assert!(error.starts_with("there is no crate `lows`; the crates are "), "{error}");
    }
}
