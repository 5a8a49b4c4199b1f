//! Mutants of the Python layer and of the C++ code of the LAMMPS plugin.
//!
//! Each replaces a text in the installed module, or in a copy of the plugin that is then rebuilt,
//! both below `target/`, one at a time. The tests of the layer must fail.

use super::list::{Killers, Layer, LayerMutant};
use crate::lammps::{self, Host};
use crate::outcome::{Outcome, Part};
use crate::python;
use anyhow::{Context as _, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

impl Layer {
    /// The folder of its sources.
    fn sources(self) -> &'static str {
        match self {
            Self::Python => "crates/python/python/carom",
            Self::Lammps => "plugins/lammps/src",
        }
    }

    /// The folder of its tests.
    fn project(self) -> &'static str {
        match self {
            Self::Python => "crates/python",
            Self::Lammps => "plugins/lammps",
        }
    }
}

/// Checks that the text of every mutant occurs once in its file.
pub(super) fn check(root: &Path, mutants: &[LayerMutant]) -> anyhow::Result<()> {
    let wrong: Vec<String> = mutants
        .iter()
        .filter_map(|mutant| Some(format!("{}: {:#}", mutant.key(), replaced(root, mutant).err()?)))
        .collect();
    ensure!(wrong.is_empty(), "places of the list that are not found:\n  {}", wrong.join("\n  "));
    Ok(())
}

/// The file with the replaced text.
fn replaced(root: &Path, mutant: &LayerMutant) -> anyhow::Result<String> {
    let path = root.join(mutant.layer.sources()).join(&mutant.file);
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let count = text.matches(&mutant.find).count();
    ensure!(count == 1, "`{}` occurs {count} times", mutant.find);
    Ok(text.replace(&mutant.find, &mutant.replace))
}

/// Runs the mutants and records in `killers` which test fails; an error if a mutant survives. A
/// layer is skipped if its tests are.
pub(super) fn run(
    root: &Path,
    mutants: &[LayerMutant],
    killers: &mut Killers,
) -> anyhow::Result<Outcome> {
    let mut outcome = Outcome::Passed;
    let mut survivors = Vec::new();
    for layer in [Layer::Python, Layer::Lammps] {
        let of_layer: Vec<_> = mutants.iter().filter(|mutant| mutant.layer == layer).collect();
        if of_layer.is_empty() {
            continue;
        }
        let bench = match Bench::new(root, layer)? {
            Ok(bench) => bench,
            Err(skipped) => {
                outcome = outcome.and(skipped);
                continue;
            }
        };
        if let Some(test) = bench.failure(None)? {
            bail!("tests of {layer:?} fail without any mutant: {test}");
        }
        for mutant in of_layer {
            let key = mutant.key();
            match bench.noticed(root, mutant, killers.get(&key))? {
                Some(test) => {
                    println!("{key}\n    {test}");
                    killers.insert(key, test);
                }
                None => {
                    println!("{key}\n    SURVIVES: {} -> {}", mutant.find, mutant.replace);
                    killers.remove(&key);
                    survivors.push(mutant.key());
                }
            }
        }
    }
    ensure!(survivors.is_empty(), "mutants survive:\n  {}", survivors.join("\n  "));
    Ok(outcome)
}

/// A layer in which texts may be replaced, and how its tests run.
struct Bench {
    layer: Layer,
    /// The folder of the replaced files.
    copy: PathBuf,
    /// The folder of the test project.
    project: PathBuf,
    interpreter: PathBuf,
    host: Option<Host>,
    /// The working folder of the tests.
    work: PathBuf,
}

impl Bench {
    /// The layer, or the reason why it is not available.
    fn new(root: &Path, layer: Layer) -> anyhow::Result<Result<Self, Outcome>> {
        let folder = root.join("target/mutants").join(layer.project());
        if folder.exists() {
            std::fs::remove_dir_all(&folder)?;
        }
        std::fs::create_dir_all(&folder)?;
        let project = root.join(layer.project());
        let work = folder.join("work");
        std::fs::create_dir_all(&work)?;
        match layer {
            Layer::Python => {
                let Some(place) = python::place()? else {
                    return Ok(Err(Outcome::skipped(Part::Python, python::NONE)));
                };
                if let skipped @ Outcome::Skipped(..) = place.install_optional() {
                    return Ok(Err(skipped));
                }
                place.install()?;
                let interpreter = place.python();
                let ask = "import carom, os; print(os.path.dirname(carom.__file__))";
                let output =
                    Command::new(&interpreter).args(["-c", ask]).current_dir(&work).output()?;
                let installed = String::from_utf8_lossy(&output.stdout).trim().to_owned();
                let copy = PathBuf::from(installed);
                Ok(Ok(Self { layer, copy, project, interpreter, host: None, work }))
            }
            Layer::Lammps => {
                let Some(host) = Host::place()? else {
                    return Ok(Err(Outcome::skipped(Part::Lammps, lammps::UNREACHED)));
                };
                // A workspace of links except for the plugin, whose build script finds the rest
                // beside it.
                let tree = folder.join("tree");
                copied(&project, &tree.join(layer.project()))?;
                for entry in std::fs::read_dir(root)? {
                    let name = entry?.file_name();
                    if name != "plugins" && name != ".git" {
                        std::os::unix::fs::symlink(root.join(&name), tree.join(&name))?;
                    }
                }
                let copy = tree.join(layer.sources());
                Ok(Ok(Self {
                    layer,
                    copy,
                    project,
                    interpreter: PathBuf::new(),
                    host: Some(host),
                    work,
                }))
            }
        }
    }

    /// The test that fails: the known one, or the first of all.
    fn noticed(
        &self,
        root: &Path,
        mutant: &LayerMutant,
        known: Option<&String>,
    ) -> anyhow::Result<Option<String>> {
        let path = self.copy.join(&mutant.file);
        std::fs::write(&path, replaced(root, mutant)?)?;
        let mut failure = None;
        if let Some(test) = known {
            failure = self.failure(Some(test))?;
        }
        if failure.is_none() {
            failure = self.failure(None)?;
        }
        std::fs::copy(root.join(mutant.layer.sources()).join(&mutant.file), &path)?;
        Ok(failure)
    }

    /// The first failing test, of all or of the one named.
    fn failure(&self, test: Option<&str>) -> anyhow::Result<Option<String>> {
        let mut pytest = match &self.host {
            None => {
                let mut pytest = Command::new(&self.interpreter);
                pytest.args(["-m", "pytest", "-q", "-p", "no:cacheprovider"]);
                pytest
            }
            Some(host) => {
                let plugin = self.work.join("caromplugin.so");
                let plugins = self.copy.parent().context("no folder")?;
                if host.build(plugins, &plugin).is_err() {
                    bail!("the plugin does not build with its mutant");
                }
                let mut pytest = host.pytest(&plugin);
                pytest.args(["-m", "not slow"]);
                pytest
            }
        };
        pytest.current_dir(&self.work).args(["-x", "--tb=no", "--rootdir"]).arg(&self.project);
        match test {
            Some(test) => pytest.arg(self.project.join(test)),
            None => pytest.arg(self.project.join("tests")),
        };
        let output = pytest.output()?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        match output.status.code() {
            Some(0) => Ok(None),
            Some(1) => Ok(Some(failed_in(&text).context("pytest names no failure")?.to_owned())),
            _ => bail!("the tests of {:?} do not run:\n{text}", self.layer),
        }
    }
}

/// `tests/test_a.py::test_b` in `FAILED tests/test_a.py::test_b - reason`.
fn failed_in(text: &str) -> Option<&str> {
    let line = text.lines().find_map(|line| line.strip_prefix("FAILED "))?;
    let name = line.split(" - ").next()?.trim();
    Some(name.find("tests/").map_or(name, |at| &name[at..]))
}

/// Copies a folder without files compiled by Python.
fn copied(from: &Path, to: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(to)?;
    let entries = std::fs::read_dir(from).with_context(|| from.display().to_string())?;
    for entry in entries {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if !entry.file_type()?.is_dir() {
            std::fs::copy(entry.path(), target)?;
        } else if entry.file_name() != "__pycache__" {
            copied(&entry.path(), &target)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_test_that_failed_is_read() {
        let text = "F\n== short test summary info ==\n\
                    FAILED ../../crates/python/tests/test_a.py::test_b[1] - assert 1 == 2\n";
        assert_eq!(failed_in(text), Some("tests/test_a.py::test_b[1]"));
        assert_eq!(failed_in("1 passed"), None);
    }
}
