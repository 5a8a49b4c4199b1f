//! The programs beside which carom is measured, in environments below `target/bench/peers`.

use crate::lammps::{Host, pip, reaches_registry};
use crate::python::{call, interpreter};
use anyhow::Context as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A peer that Python's registry has.
struct Package {
    name: &'static str,
    /// Its environment: slippy wants packages of 2023.
    environment: &'static str,
    requirements: &'static [&'static str],
    /// Installed without what it says it needs, which contradicts the requirements.
    alone: Option<&'static str>,
}

const PACKAGES: &[Package] = &[
    // Built from its source, with a compiler of C++, CMake and Eigen 3.4.
    Package {
        name: "ASPHER",
        environment: "present",
        requirements: &["numpy", "aspher==0.1.3.post1"],
        alone: None,
    },
    Package {
        name: "ContactMechanics",
        environment: "present",
        requirements: &["numpy", "ContactMechanics==1.8.3"],
        alone: None,
    },
    Package {
        name: "tamaas",
        environment: "present",
        requirements: &["numpy", "tamaas==2.9.0"],
        alone: None,
    },
    Package {
        name: "slippy",
        environment: "of_2023",
        requirements: &[
            "numpy==1.23.5",
            "scipy==1.10.1",
            "numba==0.57.1",
            "pyfftw==0.13.1",
            "sympy",
            "scikit-image<0.22",
            "matplotlib<3.8",
            "tinydb",
        ],
        alone: Some("slippy==0.5.2"),
    },
    Package {
        name: "FFTW",
        environment: "present",
        requirements: &["numpy", "pyfftw"],
        alone: None,
    },
];

/// The variable that names the executable of CONTACT.
const CONTACT: &str = "CAROM_CONTACT";

/// Peers that can be run, by the Python that runs them, and those that cannot, with the reason.
#[derive(Default)]
pub(super) struct Peers {
    pub(super) present: Vec<(&'static str, PathBuf)>,
    pub(super) absent: Vec<(&'static str, String)>,
    pub(super) lammps: Option<(PathBuf, PathBuf)>,
}

impl Peers {
    /// Makes the environments, or takes those that are there.
    pub(super) fn place(folder: &Path) -> anyhow::Result<Self> {
        let python = interpreter().context(crate::python::NONE)?;
        let mut peers = Self::default();
        for package in PACKAGES {
            let environment = folder.join(package.environment);
            match package.install(python, &environment) {
                Ok(()) => peers.present.push((package.name, environment.join("bin/python"))),
                Err(_) if !reaches_registry(&environment) => {
                    peers.absent.push((package.name, "Python's registry was not reached".into()));
                }
                Err(_) => {
                    let named = package.alone.or(package.requirements.last().copied());
                    let reason = format!("{} was not installed", named.unwrap_or(package.name));
                    peers.absent.push((package.name, reason));
                }
            }
        }
        peers.add_contact(&folder.join("present"));
        peers.add_lammps()?;
        Ok(peers)
    }

    /// CONTACT is not in a registry: its script runs the executable that the user names.
    fn add_contact(&mut self, environment: &Path) {
        let named = std::env::var_os(CONTACT).map(PathBuf::from);
        match named.filter(|program| program.is_file()) {
            Some(_) => self.present.push(("CONTACT", environment.join("bin/python"))),
            None => self.absent.push(("CONTACT", format!("{CONTACT} names no executable"))),
        }
    }

    /// LAMMPS, if `cargo xtask lammps` has made its environment, with the plugin as it is now.
    fn add_lammps(&mut self) -> anyhow::Result<()> {
        let environment = crate::release::target().join("lammps/venv");
        let host = if environment.is_dir() { Host::place()? } else { None };
        match host {
            Some(host) => self.lammps = Some(host.built()?),
            None => self.absent.push(("LAMMPS", "`cargo xtask lammps` has not been run".into())),
        }
        Ok(())
    }
}

impl Package {
    fn install(&self, python: &str, environment: &Path) -> anyhow::Result<()> {
        if !environment.join("bin/python").exists() {
            call(Command::new(python).args(["-m", "venv"]).arg(environment))?;
        }
        call(pip(environment, "install").args(self.requirements))?;
        match self.alone {
            Some(alone) => call(pip(environment, "install").args(["--no-deps", alone])),
            None => Ok(()),
        }
    }
}
