//! The crates published to the registry, in the order of publication, and checks of their
//! descriptions.

use crate::cargo;
use anyhow::{bail, ensure};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Suitable categories of the registry, which rejects unknown ones only at publication.
const CATEGORIES: &[&str] = &[
    "command-line-utilities",
    "external-ffi-bindings",
    "mathematics",
    "science",
    "simulation",
    "visualization",
];
/// Licence files of each crate.
const LICENCES: [&str; 2] = ["LICENSE-MIT", "LICENSE-APACHE"];

/// A crate published to the registry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Package {
    pub(crate) name: String,
    pub(crate) version: String,
    folder: PathBuf,
    /// Crates of this workspace that must be published before it.
    needs: Vec<String>,
}

impl Package {
    /// The name of its archive.
    pub(super) fn archive(&self) -> String {
        format!("{}.crate", self.unpacked())
    }

    /// The folder in the archive.
    pub(super) fn unpacked(&self) -> String {
        format!("{}-{}", self.name, self.version)
    }
}

/// All crates of the workspace, from `cargo metadata`.
#[derive(Debug)]
pub(crate) struct Packages {
    all: Vec<Value>,
}

impl Packages {
    /// Runs `cargo metadata`.
    pub(crate) fn read() -> anyhow::Result<Self> {
        Ok(Self { all: cargo::packages(&["--no-deps"])? })
    }

    /// The published crates, each after those it needs.
    pub(crate) fn in_order(&self) -> anyhow::Result<Vec<Package>> {
        let mut waiting: Vec<Package> =
            self.all.iter().filter(|package| is_public(package)).map(package).collect();
        waiting.sort_by(|one, other| one.name.cmp(&other.name));
        let mut ordered: Vec<Package> = Vec::new();
        while !waiting.is_empty() {
            let is_ready = |package: &Package| {
                let is_there = |need: &String| ordered.iter().any(|there| there.name == *need);
                package.needs.iter().all(is_there)
            };
            let Some(place) = waiting.iter().position(is_ready) else {
                let names: Vec<&str> =
                    waiting.iter().map(|package| package.name.as_str()).collect();
                bail!(
                    "no order of publication: {} depend on each other, or on unpublished crates",
                    names.join(", ")
                );
            };
            ordered.push(waiting.remove(place));
        }
        Ok(ordered)
    }

    /// The names of the crates that are not published.
    pub(crate) fn private(&self) -> Vec<String> {
        let private = self.all.iter().filter(|package| !is_public(package));
        private.map(|package| text(package, "name").to_owned()).collect()
    }

    /// Faults in the descriptions of the published crates.
    pub(crate) fn faults(&self) -> anyhow::Result<Vec<String>> {
        let mut faults = Vec::new();
        for package in self.all.iter().filter(|package| is_public(package)) {
            let name = text(package, "name");
            faults.extend(lacks(package).into_iter().map(|what| format!("{name}: {what}")));
        }
        let ordered = self.in_order()?;
        ensure!(!ordered.is_empty(), "no crate is published");
        for Package { name, folder, version, .. } in &ordered {
            for licence in LICENCES {
                let there = std::fs::read(folder.join(licence)).ok();
                let root = std::fs::read(crate::root::root().join(licence))?;
                if there != Some(root) {
                    faults.push(format!("{name}: no {licence} as at the root"));
                }
            }
            if *version != ordered[0].version {
                faults.push(format!("{name}: version {version} is not that of the others"));
            }
        }
        Ok(faults)
    }
}

/// Faults in the description of a crate.
fn lacks(package: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    let mut must = |holds: bool, what: &str| {
        if !holds {
            faults.push(what.to_owned());
        }
    };
    must(text(package, "description").len() >= 20, "no description");
    must(text(package, "license") == "MIT OR Apache-2.0", "another licence");
    let folder = folder(package);
    must(folder.join(text(package, "readme")).is_file(), "no readme");
    must(!text(package, "rust_version").is_empty(), "no rust-version");
    must(!package["metadata"]["docs"]["rs"].is_null(), "no settings for docs.rs");
    let words = |field: &str| -> Vec<String> {
        let words = package[field].as_array().into_iter().flatten();
        words.filter_map(Value::as_str).map(str::to_owned).collect()
    };
    let keywords = words("keywords");
    must((1..=5).contains(&keywords.len()), "one to five keywords");
    must(keywords.iter().all(|word| word.len() <= 20), "a keyword of more than 20 letters");
    let categories = words("categories");
    must((1..=5).contains(&categories.len()), "one to five categories");
    let is_known = |category: &String| CATEGORIES.contains(&category.as_str());
    must(categories.iter().all(is_known), "a category that the registry does not know");
    let without = of_workspace(package).filter(|dependency| text(dependency, "req") == "*");
    faults.extend(without.map(|dependency| format!("no version of {}", text(dependency, "name"))));
    faults
}

/// The crates of this workspace that its package names: of those for its tests, the ones with a version.
fn of_workspace(package: &Value) -> impl Iterator<Item = &Value> {
    let dependencies = package["dependencies"].as_array().into_iter().flatten();
    dependencies.filter(|dependency| {
        let is_left_out = text(dependency, "kind") == "dev" && text(dependency, "req") == "*";
        dependency["path"].is_string() && !is_left_out
    })
}

fn is_public(package: &Value) -> bool {
    package["publish"].is_null()
}

fn package(package: &Value) -> Package {
    Package {
        name: text(package, "name").to_owned(),
        version: text(package, "version").to_owned(),
        folder: folder(package),
        needs: of_workspace(package)
            .map(|dependency| text(dependency, "name").to_owned())
            .collect(),
    }
}

fn folder(package: &Value) -> PathBuf {
    Path::new(text(package, "manifest_path")).parent().unwrap_or(Path::new("")).to_owned()
}

fn text<'a>(value: &'a Value, field: &str) -> &'a str {
    value[field].as_str().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn packages(all: &Value) -> Packages {
        Packages { all: all.as_array().unwrap().clone() }
    }

    fn named(name: &str, needs: &[&str]) -> Value {
        let needs = needs.iter().map(|need| json!({ "name": need, "path": "/x", "req": "^1" }));
        json!({ "name": name, "version": "1.0.0", "dependencies": needs.collect::<Vec<_>>() })
    }

    #[test]
    fn a_crate_goes_after_what_it_needs() {
        let mut stays = named("tasks", &["top"]);
        stays["publish"] = json!([]);
        let all = json!([named("top", &["a", "b"]), named("b", &["a"]), named("a", &[]), stays]);
        let all = packages(&all);
        let names: Vec<_> =
            all.in_order().unwrap().into_iter().map(|package| package.name).collect();
        assert_eq!(names, ["a", "b", "top"]);
        assert_eq!(all.private(), ["tasks"]);
    }

    #[test]
    fn circles_and_what_stays_here_stand_in_the_way() {
        let circle = packages(&json!([named("a", &["b"]), named("b", &["a"])]));
        assert!(circle.in_order().unwrap_err().to_string().contains("a, b depend on each other"));
        assert!(packages(&json!([named("a", &["hidden"])])).in_order().is_err());
    }

    #[test]
    fn what_only_tests_need_may_stay_here_without_a_version() {
        let mut tested = named("tested", &["hidden"]);
        tested["dependencies"][0]["req"] = json!("*");
        assert!(lacks(&tested).contains(&"no version of hidden".to_owned()));
        tested["dependencies"][0]["kind"] = json!("dev");
        assert!(!lacks(&tested).contains(&"no version of hidden".to_owned()));
        assert_eq!(packages(&json!([tested])).in_order().unwrap()[0].needs, [""; 0]);
    }

    #[test]
    fn what_is_missing_is_named() {
        let mut bare = named("bare", &["free"]);
        bare["dependencies"][0]["req"] = json!("*");
        bare["keywords"] = json!(["a-keyword-of-many-letters"]);
        bare["categories"] = json!(["mechanics"]);
        let expected = [
            "no description",
            "another licence",
            "no readme",
            "no rust-version",
            "no settings for docs.rs",
            "a keyword of more than 20 letters",
            "a category that the registry does not know",
            "no version of free",
        ];
        assert_eq!(lacks(&bare), expected);
    }

    #[test]
    fn the_crates_here_are_whole() {
        let packages = Packages::read().unwrap();
        assert_eq!(packages.faults().unwrap(), Vec::<String>::new());
        let order = packages.in_order().unwrap();
        assert!(order.iter().any(|package| package.name == "carom"));
    }
}
