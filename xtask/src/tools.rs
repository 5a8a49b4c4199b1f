//! Tools of cargo that a machine may lack.

use crate::cargo;
use anyhow::Context as _;
use std::process::Command;

/// A tool that `cargo install` installs.
pub(crate) struct Tool {
    name: &'static str,
    version: &'static str,
    options: &'static [&'static str],
}

/// Builds the pages of the book.
pub(crate) const MDBOOK: Tool = Tool {
    name: "mdbook",
    version: "0.5.4",
    options: &["--no-default-features", "--features=search"],
};

/// Checks licences, sources and advisories of the dependencies.
pub(crate) const CARGO_DENY: Tool = Tool { name: "cargo-deny", version: "0.20.2", options: &[] };

/// Builds and runs the targets of the fuzzer.
pub(crate) const CARGO_FUZZ: Tool = Tool { name: "cargo-fuzz", version: "0.13.2", options: &[] };

impl Tool {
    /// Whether the tool is installed. In continuous integration a missing one is installed, as by
    /// [`Self::brought`].
    ///
    /// # Errors
    /// If it cannot be installed.
    pub(crate) fn is_there(&self) -> anyhow::Result<bool> {
        if !self.answers() && std::env::var_os("CI").is_some() {
            self.install()?;
        }
        Ok(self.answers())
    }

    /// The program, which is installed into `target/tools` if it is missing, and kept there: `.ci/run` adds that folder
    /// to the path. It runs for seconds and is built without optimisation, which would take a minute more.
    ///
    /// # Errors
    /// If it cannot be installed.
    pub(crate) fn brought(&self) -> anyhow::Result<Command> {
        if self.answers() {
            return Ok(Command::new(self.name));
        }
        let own = folder().join("bin").join(self.name);
        if !own.is_file() {
            self.install()?;
        }
        Ok(Command::new(own))
    }

    /// The command with which a user installs it.
    pub(crate) fn advice(&self) -> String {
        format!("{0} is not installed; `cargo install {0} --locked` installs it", self.name)
    }

    fn answers(&self) -> bool {
        cargo::answers(self.name)
    }

    fn install(&self) -> anyhow::Result<()> {
        println!("installing {} {} into target/tools, some minutes", self.name, self.version);
        let tools = folder();
        let mut command = cargo::command(&["install", self.name, "--version", self.version]);
        command.args(["--locked", "--quiet"]).args(self.options);
        command.arg("--root").arg(&tools).arg("--target-dir").arg(tools.join("build"));
        for (name, value) in [("LTO", "off"), ("CODEGEN_UNITS", "256"), ("OPT_LEVEL", "0")] {
            command.env(format!("CARGO_PROFILE_RELEASE_{name}"), value);
        }
        let status = command.status().context("cannot start cargo")?;
        anyhow::ensure!(status.success(), "cannot install {}", self.name);
        Ok(())
    }
}

/// Where missing tools are installed.
fn folder() -> std::path::PathBuf {
    crate::root::root().join("target/tools")
}
