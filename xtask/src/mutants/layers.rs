//! Mutants of the Python layer and of the C++ code of the LAMMPS plugin.
//!
//! Each replaces a text in the installed module, or in a copy of the plugin that is then rebuilt,
//! both below `target/`, one at a time.

use super::Mutant;
use crate::lammps::{self, Host};
use crate::outcome::{Outcome, Part};
use crate::python::{self, call};
use anyhow::{Context as _, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A layer outside the crates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layer {
    /// What is written in Python.
    Python,
    /// The C++ code of the LAMMPS plugin.
    Lammps,
}

impl Layer {
    /// The layer of a file; `None` in a crate.
    pub(super) fn of(file: &str) -> Option<Self> {
        [Self::Python, Self::Lammps].into_iter().find(|layer| file.starts_with(layer.sources()))
    }

    /// The folder of its sources.
    fn sources(self) -> &'static str {
        match self {
            Self::Python => "crates/python/python/carom/",
            Self::Lammps => "plugins/lammps/src/",
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

/// A layer in which texts may be replaced, and how its tests run.
pub(super) struct Bench {
    root: PathBuf,
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
    pub(super) fn new(root: &Path, layer: Layer) -> anyhow::Result<Result<Self, Outcome>> {
        let folder = root.join("target/mutants").join(layer.project());
        if folder.exists() {
            std::fs::remove_dir_all(&folder)?;
        }
        std::fs::create_dir_all(&folder)?;
        let (root, project) = (root.to_owned(), root.join(layer.project()));
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
                Ok(Ok(Self { root, layer, copy, project, interpreter, host: None, work }))
            }
            Layer::Lammps => {
                let Some(host) = Host::place()? else {
                    return Ok(Err(Outcome::skipped(Part::Lammps, lammps::UNREACHED)));
                };
                // A workspace of links except for the plugin, whose build script finds the rest
                // beside it.
                let tree = folder.join("tree");
                std::fs::create_dir_all(tree.join("plugins"))?;
                call(Command::new("cp").arg("-r").arg(&project).arg(tree.join("plugins")))?;
                for entry in std::fs::read_dir(&root)? {
                    let name = entry?.file_name();
                    if name != "plugins" && name != ".git" {
                        std::os::unix::fs::symlink(root.join(&name), tree.join(&name))?;
                    }
                }
                let copy = tree.join(layer.sources());
                let (interpreter, host) = (PathBuf::new(), Some(host));
                Ok(Ok(Self { root, layer, copy, project, interpreter, host, work }))
            }
        }
    }

    /// The first failing test, of all or of those named.
    fn failing(&self, tests: &[&str]) -> anyhow::Result<Option<String>> {
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
        let tests = if tests.is_empty() { &["tests"] } else { tests };
        pytest.args(tests.iter().map(|test| self.project.join(test)));
        let output = pytest.output()?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        match output.status.code() {
            Some(0) => Ok(None),
            Some(1) => Ok(Some(failed_in(&text).context("pytest names no failure")?.to_owned())),
            _ => bail!("the tests of {:?} do not run:\n{text}", self.layer),
        }
    }
}

impl super::Bench for Bench {
    fn failure(&self, mutant: Option<&Mutant>, tests: &[&str]) -> anyhow::Result<Option<String>> {
        let Some(mutant) = mutant else { return self.failing(tests) };
        let (text, _) = mutant.place(&self.root)?;
        let path = self.copy.join(mutant.file.replacen(self.layer.sources(), "", 1));
        std::fs::write(&path, text.replace(&mutant.find, &mutant.replace))?;
        let failure = self.failing(tests)?;
        std::fs::write(&path, text)?;
        Ok(failure)
    }
}

/// `tests/test_a.py::test_b` in `FAILED tests/test_a.py::test_b - reason`.
fn failed_in(text: &str) -> Option<&str> {
    let line = text.lines().find_map(|line| line.strip_prefix("FAILED "))?;
    let name = line.split(" - ").next()?.trim();
    Some(name.find("tests/").map_or(name, |at| &name[at..]))
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
