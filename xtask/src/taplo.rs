//! Checks the examples against the schemas of cases by taplo, the program with which editors complete TOML.

use anyhow::{Context as _, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::files::files;
use crate::lammps::{UNREACHED, pip, reaches_registry};
use crate::outcome::{Outcome, Part};
use crate::python::{self, call, interpreter};
use crate::root::root;

/// The distribution with the program, which need not be built.
const TAPLO: &str = "taplo==0.9.3";
/// Mistakes that every schema must tell.
const MISTAKES: &str = "crates/cli/tests/it/schema/mistakes.toml";
/// Examples of this kind are not named after it.
const IMPACT: &str = "impact";

/// Checks that taplo takes every example and refuses every mistake; skipped without Python or if its package registry
/// cannot be reached.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    let Some(python) = interpreter() else {
        return Ok(Outcome::skipped(Part::Python, python::NONE));
    };
    let root = root().canonicalize()?;
    let Some(taplo) = Taplo::place(python, &root)? else {
        return Ok(Outcome::skipped(Part::Taplo, UNREACHED));
    };
    let kinds = kinds(&root)?;
    let mut examples = files(&root.join("examples"), "toml")?;
    examples.extend(files(&root.join("examples/fit"), "toml")?);
    for kind in &kinds {
        let own: Vec<_> = examples.iter().filter(|path| kind_of(path, &kinds) == kind).collect();
        ensure!(!own.is_empty(), "no example of the kind {kind}");
        let output = taplo.check(kind, &own)?;
        let told = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.success(), "taplo refuses an example of {kind}:\n{told}");
    }
    let count = taplo.refuses_mistakes(&kinds)?;
    println!("taplo takes {} examples and refuses {count} mistakes", examples.len());
    Ok(Outcome::Passed)
}

/// The program and the folder of its environment.
struct Taplo {
    folder: PathBuf,
    root: PathBuf,
}

impl Taplo {
    /// In an environment below target/; `None` if the registry cannot be reached.
    fn place(python: &str, root: &Path) -> anyhow::Result<Option<Self>> {
        let folder = root.join("target/taplo");
        let venv = folder.join("venv");
        if !venv.join("bin/python").exists() {
            call(Command::new(python).args(["-m", "venv"]).arg(&venv))?;
        }
        match call(pip(&venv, "install").arg(TAPLO)) {
            Ok(()) => Ok(Some(Self { folder, root: root.to_owned() })),
            Err(error) if reaches_registry(&venv) => bail!("{TAPLO}: {error:#}"),
            Err(_) => Ok(None),
        }
    }

    fn check(&self, kind: &str, paths: &[impl AsRef<Path>]) -> anyhow::Result<Output> {
        let mut taplo = Command::new(self.folder.join("venv/bin/taplo"));
        taplo.args(["check", "--no-auto-config", "--colors", "never", "--schema"]);
        taplo.arg(format!("file://{}/docs/schema/{kind}.json", self.root.display()));
        taplo.args(paths.iter().map(AsRef::as_ref)).current_dir(&self.root);
        taplo.output().context("cannot start taplo")
    }

    /// Checks each mistake in its example; returns their number.
    fn refuses_mistakes(&self, kinds: &[String]) -> anyhow::Result<usize> {
        let text = std::fs::read_to_string(self.root.join(MISTAKES)).context(MISTAKES)?;
        let table: toml::Table = text.parse()?;
        let mistakes = table["mistake"].as_array().context("no mistakes")?;
        let wrong = self.folder.join("wrong.toml");
        for mistake in mistakes {
            let word = |name: &str| mistake[name].as_str().context("a mistake without words");
            let example = self.root.join("examples").join(word("example")?);
            let source = std::fs::read_to_string(&example)?;
            std::fs::write(&wrong, source.replacen(word("old")?, word("new")?, 1))?;
            let output = self.check(kind_of(&example, kinds), &[&wrong])?;
            ensure!(!output.status.success(), "taplo takes {}", word("what")?);
        }
        Ok(mistakes.len())
    }
}

/// The kinds of cases, by their schemas.
fn kinds(root: &Path) -> anyhow::Result<Vec<String>> {
    let schemas = files(&root.join("docs/schema"), "json")?;
    Ok(schemas.iter().filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect())
}

/// The kind of an example: the first word of its name.
fn kind_of<'a>(example: &Path, kinds: &'a [String]) -> &'a str {
    let name = example.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
    let word = name.split('_').next().unwrap_or_default();
    kinds.iter().find(|kind| *kind == word).map_or(IMPACT, String::as_str)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_example_tells_its_kind_by_its_name() {
        let kinds = kinds(&root()).unwrap();
        let kind = |name: &str| kind_of(Path::new(name), &kinds).to_owned();
        assert_eq!(kind("examples/scene_book.toml"), "scene");
        assert_eq!(kind("examples/steel_balls.toml"), "impact");
        assert!(kinds.iter().any(|kind| kind == IMPACT));
    }
}
