//! Checks the description of the Python wheel.

use super::root;
use crate::outcome::{Outcome, Part};
use crate::python;
use anyhow::{Context as _, ensure};
use std::path::Path;
use std::process::Command;

/// Required fields of `pyproject.toml`.
const FIELDS: [&str; 8] = [
    "name",
    "description",
    "readme",
    "requires-python",
    "license",
    "license-files",
    "keywords",
    "classifiers",
];
/// Python program that prints the metadata of a wheel.
const PRINT: &str = "import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); \
     print(*z.namelist(), sep='\\n'); \
     print(next(z.read(n).decode() for n in z.namelist() if n.endswith('.dist-info/METADATA')))";

/// Faults of `pyproject.toml`.
pub(super) fn faults() -> anyhow::Result<Vec<String>> {
    let folder = root().join("crates/python");
    let project = std::fs::read_to_string(folder.join("pyproject.toml"))?;
    let project: toml::Table = project.parse().context("pyproject.toml is not valid TOML")?;
    let said = project.get("project").and_then(toml::Value::as_table);
    let said = said.context("pyproject.toml has no table [project]")?;
    let missing = FIELDS.iter().filter(|field| !said.contains_key(**field));
    let mut faults: Vec<String> =
        missing.map(|field| format!("pyproject.toml: no {field}")).collect();
    for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
        let read = |folder: &Path| std::fs::read(folder.join(licence)).ok();
        if read(&folder) != read(&root()) {
            faults.push(format!("crates/python: no {licence} as at the root"));
        }
    }
    Ok(faults)
}

/// Builds the wheel and checks its metadata.
pub(super) fn check(version: &str) -> anyhow::Result<Outcome> {
    let Some(place) = python::place()? else {
        return Ok(Outcome::skipped(Part::Python, python::NONE));
    };
    let wheel = python::build(&place)?;
    let output = Command::new(place.python()).args(["-c", PRINT]).arg(&wheel).output()?;
    ensure!(output.status.success(), "cannot read {}", wheel.display());
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let has = |line: &str| text.lines().any(|other| other == line);
    let version_line = format!("Version: {version}");
    for line in [
        "Name: carom",
        &version_line,
        "License-Expression: MIT OR Apache-2.0",
        "License-File: LICENSE-MIT",
        "License-File: LICENSE-APACHE",
        "Requires-Python: >=3.10",
        "Description-Content-Type: text/markdown; charset=UTF-8; variant=GFM",
        "carom/py.typed",
        "carom/_carom.pyi",
    ] {
        ensure!(has(line), "the wheel lacks `{line}`:\n{text}");
    }
    println!("{}: complete", wheel.display());
    Ok(Outcome::Passed)
}
