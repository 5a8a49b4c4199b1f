//! Runs cargo.

use crate::root::root;
use anyhow::{Context as _, bail};
use serde_json::Value;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};

/// All packages but the benches, whose framework only those who measure need to compile. Tasks select these packages
/// even for one program: alone it might select other features of a dependency, and all above that would be compiled
/// once more.
pub(crate) const WITHOUT_BENCHES: &[&str] = &["--workspace", "--exclude", "carom-benches"];

/// Those of them whose tests need nothing but Rust, without the tasks.
pub(crate) const OF_LIBRARIES: &[&str] = &[
    "--workspace",
    "--exclude",
    "carom-benches",
    "--exclude",
    "carom-python",
    "--exclude",
    "xtask",
];

/// Whether there is a [`Lints`].
static LINTS: AtomicBool = AtomicBool::new(false);

/// While it exists, cargo lints the crates of the workspace as [`compile`] compiles them and documents them as it tests
/// the examples of their documentation; warnings are errors. Steps of their own would check every dependency once more.
pub(crate) struct Lints(());

impl Lints {
    pub(crate) fn with_builds() -> Self {
        LINTS.store(true, Ordering::Relaxed);
        Self(())
    }

    /// Whether cargo lints what it compiles now.
    pub(crate) fn exist() -> bool {
        LINTS.load(Ordering::Relaxed)
    }

    /// Sets the compiler and the documentation tool of a command that calls cargo.
    pub(crate) fn set(command: &mut Command) {
        if Self::exist() {
            let tools = root().join(".ci");
            command.env("RUSTC_WORKSPACE_WRAPPER", tools.join("rustc"));
            command.env("RUSTDOC", tools.join("rustdoc"));
        }
    }
}

impl Drop for Lints {
    fn drop(&mut self) {
        LINTS.store(false, Ordering::Relaxed);
    }
}

/// A cargo command at the root of the workspace, with the cargo that runs this task.
pub(crate) fn command(arguments: &[&str]) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(arguments).current_dir(root());
    command
}

/// The same for a command that compiles the workspace, with [`Lints`] if there are.
pub(crate) fn compiling(arguments: &[&str]) -> Command {
    let mut command = command(arguments);
    Lints::set(&mut command);
    command
}

/// What a command prints; an exit code other than 0 is an error.
pub(crate) fn printed(command: &mut Command) -> anyhow::Result<String> {
    let output = command.output();
    let output = output.with_context(|| format!("cannot start {command:?}"))?;
    if !output.status.success() {
        bail!("{command:?} failed: {}", String::from_utf8_lossy(&output.stderr));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// What git prints at the root of the workspace.
pub(crate) fn git(arguments: &[&str]) -> anyhow::Result<String> {
    printed(Command::new("git").args(arguments).current_dir(root()))
}

/// The packages that `cargo metadata` knows.
pub(crate) fn packages(arguments: &[&str]) -> anyhow::Result<Vec<Value>> {
    let asked = &["metadata", "--format-version", "1"];
    let metadata: Value =
        serde_json::from_str(&printed(&mut command(&[asked, arguments].concat()))?)?;
    Ok(metadata["packages"].as_array().context("no packages")?.clone())
}

/// Whether a program is there and tells its version.
pub(crate) fn answers(program: &str) -> bool {
    printed(Command::new(program).arg("--version")).is_ok()
}

/// Runs cargo; an exit code other than 0 is an error.
pub(crate) fn run(arguments: &[&str]) -> anyhow::Result<()> {
    finish(&mut command(arguments), arguments)
}

/// Runs cargo to compile the workspace, with [`Lints`] if there are.
pub(crate) fn compile(arguments: &[&str]) -> anyhow::Result<()> {
    finish(&mut compiling(arguments), arguments)
}

/// Runs cargo with an additional environment variable.
pub(crate) fn run_with(arguments: &[&str], name: &str, value: &str) -> anyhow::Result<()> {
    finish(command(arguments).env(name, value), arguments)
}

fn finish(command: &mut Command, arguments: &[&str]) -> anyhow::Result<()> {
    let shown = format!("{} {}", command.get_program().display(), arguments.join(" "));
    let status = command.status().with_context(|| format!("cannot start `{shown}`"))?;
    if !status.success() {
        bail!("`{shown}` failed ({status})");
    }
    Ok(())
}

/// Builds and runs a binary or example with the dependencies already built for the tests of the
/// workspace; an exit code other than 0 is an error. Built alone, the package might select other
/// features of a dependency, which would then be compiled again.
pub(crate) fn run_built(kind: &str, name: &str, arguments: &[&str]) -> anyhow::Result<()> {
    let mut program = Command::new(built(kind, name)?);
    finish(program.args(arguments).current_dir(root()), &[&[name], arguments].concat())
}

/// The path of a binary or example, built as by [`run_built`].
pub(crate) fn built(kind: &str, name: &str) -> anyhow::Result<PathBuf> {
    compile(&[&["build", "--release", kind, name], WITHOUT_BENCHES].concat())?;
    let folder = if kind == "--example" { "release/examples" } else { "release" };
    Ok(crate::release::target().join(folder).join(name))
}

/// Runs carom-verify with these arguments at the root of the workspace; returns its exit code.
pub(crate) fn verify(arguments: impl IntoIterator<Item = OsString>) -> anyhow::Result<u8> {
    let mut command = Command::new(built("--bin", "carom-verify")?);
    let status = command.args(arguments).current_dir(root()).status();
    let status = status.context("cannot start carom-verify")?;
    Ok(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1))
}

/// Whether `cargo <tool>` is installed.
pub(crate) fn has(tool: &str) -> bool {
    printed(&mut command(&[tool, "--version"])).is_ok()
}
