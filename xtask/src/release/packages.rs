//! The crates published to the registry, and checks of their descriptions: a dry run of `cargo publish` asks no registry
//! whether it takes them.

use crate::cargo;
use anyhow::ensure;
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

    /// The published crates, in the order of their names; cargo itself publishes each after those it needs.
    pub(crate) fn public(&self) -> Vec<Package> {
        let public = self.all.iter().filter(|package| is_public(package));
        let mut public: Vec<Package> = public.map(package).collect();
        public.sort_by(|one, other| one.name.cmp(&other.name));
        public
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
        let public = self.public();
        ensure!(!public.is_empty(), "no crate is published");
        for Package { name, folder, version, .. } in &public {
            for licence in LICENCES {
                let there = std::fs::read(folder.join(licence)).ok();
                let root = std::fs::read(crate::root::root().join(licence))?;
                if there != Some(root) {
                    faults.push(format!("{name}: no {licence} as at the root"));
                }
            }
            if *version != public[0].version {
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
    faults
}

fn is_public(package: &Value) -> bool {
    package["publish"].is_null()
}

fn package(package: &Value) -> Package {
    Package {
        name: text(package, "name").to_owned(),
        version: text(package, "version").to_owned(),
        folder: folder(package),
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

    #[test]
    fn what_is_missing_is_named() {
        let keywords = ["a-keyword-of-many-letters"];
        let bare = json!({ "name": "bare", "keywords": keywords, "categories": ["mechanics"] });
        let expected = [
            "no description",
            "another licence",
            "no readme",
            "no rust-version",
            "no settings for docs.rs",
            "a keyword of more than 20 letters",
            "a category that the registry does not know",
        ];
        assert_eq!(lacks(&bare), expected);
    }
}
