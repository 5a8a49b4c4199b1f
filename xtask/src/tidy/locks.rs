//! Checks that the lock files outside the workspace list every dependency of its crates. Cargo updates the workspace's
//! own lock file; steps of the long run read these as they are, and fail if a manifest has changed since.

use super::read;
use anyhow::Context as _;
use std::collections::BTreeMap;
use std::path::Path;
use toml::{Table, Value};

/// The lock files.
const LOCKS: &[&str] = &["doors/rapier/Cargo.lock", "fuzz/Cargo.lock"];

/// A fault for each dependency of a crate that one of the lock files lacks.
pub(super) fn faults(root: &Path) -> anyhow::Result<Vec<String>> {
    let manifests = manifests(root)?;
    let mut faults = Vec::new();
    for path in LOCKS {
        let lock: Table = read(&root.join(path))?.parse().context(*path)?;
        let lacking = lacking(&lock, &manifests);
        faults.extend(lacking.into_iter().map(|(package, name)| {
            format!("{path}: `{package}` depends on `{name}` by now: run cargo fetch in its folder")
        }));
    }
    Ok(faults)
}

/// The dependencies of each crate of the workspace, by its name.
fn manifests(root: &Path) -> anyhow::Result<BTreeMap<String, Vec<String>>> {
    let mut all = BTreeMap::new();
    for entry in std::fs::read_dir(root.join("crates")).context("cannot list the crates")? {
        let path = entry?.path().join("Cargo.toml");
        let manifest: Table = read(&path)?.parse().with_context(|| path.display().to_string())?;
        let name = manifest.get("package").and_then(|package| package.get("name")?.as_str());
        let dependencies = manifest.get("dependencies").and_then(Value::as_table);
        if let (Some(name), Some(dependencies)) = (name, dependencies) {
            all.insert(name.to_owned(), dependencies.keys().cloned().collect());
        }
    }
    Ok(all)
}

/// Crates and dependencies of theirs that a lock file lacks. Of crates that it does not know it says nothing.
fn lacking(lock: &Table, manifests: &BTreeMap<String, Vec<String>>) -> Vec<(String, String)> {
    let packages = lock.get("package").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let mut lacking = Vec::new();
    for package in packages.iter().filter(|package| package.get("source").is_none()) {
        let Some(name) = package.get("name").and_then(Value::as_str) else { continue };
        let Some(needed) = manifests.get(name) else { continue };
        let known = package.get("dependencies").and_then(Value::as_array);
        let known = known.map_or(&[][..], Vec::as_slice);
        // "name", or "name version" where there are several.
        let is_known = |needed: &str| {
            let name = |one: &Value| Some(one.as_str()?.split(' ').next()? == needed);
            known.iter().any(|one| name(one) == Some(true))
        };
        let unknown = needed.iter().filter(|needed| !is_known(needed));
        lacking.extend(unknown.map(|needed| (name.to_owned(), needed.clone())));
    }
    lacking
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dependency_that_a_lock_file_lacks_is_found() {
        let lock = "[[package]]\nname = \"carom-laws\"\ndependencies = [\"libm\", \"wide 1.2.0\"]\n\
                    [[package]]\nname = \"libm\"\nsource = \"registry\"\n";
        let needed = |names: &[&str]| {
            let names = names.iter().map(|name| (*name).to_owned()).collect();
            BTreeMap::from([("carom-laws".to_owned(), names)])
        };
        let lock: Table = lock.parse().unwrap();
        assert!(lacking(&lock, &needed(&["libm", "wide"])).is_empty());
        let expected = vec![("carom-laws".to_owned(), "either".to_owned())];
        assert_eq!(lacking(&lock, &needed(&["libm", "either"])), expected);
    }
}
