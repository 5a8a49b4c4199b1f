//! The tests and pages of the copy with mutants, each run in its own process.

use super::weave::CRATES;
use crate::cargo;
use anyhow::{Context as _, bail};
use std::collections::BTreeSet;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const PAGES_PACKAGE: &str = "carom-mutant-pages";
/// The package of the pages themselves.
const PAGES: &str = "carom-verification";

/// Packages that compute little themselves: they are built without optimisation.
const COMPUTES_LITTLE: [&str; 5] = ["carom-cases", "carom-capi", "carom-cli", "carom-plot", PAGES];

/// The seed of the property tests, so that a detection is reproducible.
const PROPERTY_SEED: &str = "7";

/// A test, or the claims of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Trial {
    /// `carom-laws::hertz a_test`, as cargo-nextest writes it, or `page 5.3`.
    pub(super) name: String,
    /// Whether it is the claims of a page.
    pub(super) is_page: bool,
    executable: PathBuf,
    folder: PathBuf,
    test: String,
}

/// The end of a trial.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Passed,
    Failed,
    TimedOut,
}

/// The switch in the environment of the code with mutants.
#[derive(Debug, Clone, Copy)]
pub(super) enum Switch<'a> {
    /// No mutant; each one reached writes a file to this folder.
    Reach(&'a Path),
    /// This mutant is active.
    On(usize),
    /// No mutant is active.
    Off,
}

impl Trial {
    /// Runs the trial; stops it after `limit`.
    pub(super) fn run(
        &self,
        switch: Switch<'_>,
        limit: Duration,
    ) -> anyhow::Result<(End, Duration)> {
        let mut command = Command::new(&self.executable);
        command.args(["--exact", &self.test]).current_dir(&self.folder);
        command.env("PROPTEST_RNG_SEED", PROPERTY_SEED);
        command.env("PROPTEST_MAX_SHRINK_ITERS", "0");
        command.env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "true");
        // A snapshot guards against change and does not prove correctness.
        command.env("INSTA_FORCE_PASS", "1").env("INSTA_UPDATE", "no");
        match switch {
            Switch::Reach(folder) => command.env("CAROM_MUTANT_REACH", folder),
            Switch::On(number) => command.env("CAROM_MUTANT", number.to_string()),
            Switch::Off => command.env("CAROM_MUTANT", "0"),
        };
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        let start = Instant::now();
        let mut child = command.spawn().with_context(|| format!("cannot start {}", self.name))?;
        let mut pause = Duration::from_millis(1);
        loop {
            if let Some(status) = child.try_wait()? {
                let end = if status.success() { End::Passed } else { End::Failed };
                return Ok((end, start.elapsed()));
            }
            if start.elapsed() > limit {
                child.kill()?;
                child.wait()?;
                return Ok((End::TimedOut, start.elapsed()));
            }
            std::thread::sleep(pause);
            pause = (pause * 2).min(Duration::from_millis(20));
        }
    }
}

/// The tests to build.
#[derive(Debug, Default)]
pub(super) struct Selection {
    is_all: bool,
    packages: BTreeSet<String>,
    targets: BTreeSet<String>,
    with_units: bool,
}

/// The package in a folder of the workspace.
fn package_of(folder: &str) -> String {
    folder.replacen("crates/", "carom-", 1)
}

impl Selection {
    /// All tests of the crates with mutants, and the pages.
    pub(super) fn all() -> Self {
        let packages = CRATES.map(package_of).into_iter().chain([PAGES_PACKAGE.to_owned()]);
        Self { is_all: true, packages: packages.collect(), ..Self::default() }
    }

    /// The targets of the trials with these names; all if there are none.
    pub(super) fn of<'a>(names: impl Iterator<Item = &'a String>) -> Self {
        let mut chosen = Self::default();
        for name in names {
            let binary = name.split(' ').next().unwrap_or(name);
            match binary.split_once("::") {
                _ if binary == "page" => {
                    chosen.packages.insert(PAGES_PACKAGE.to_owned());
                    chosen.targets.insert("pages".to_owned());
                }
                Some((package, target)) => {
                    chosen.packages.insert(package.to_owned());
                    chosen.targets.insert(target.to_owned());
                }
                None => {
                    chosen.packages.insert(binary.to_owned());
                    chosen.with_units = true;
                }
            }
        }
        if chosen.packages.is_empty() { Self::all() } else { chosen }
    }

    fn arguments(&self) -> Vec<&str> {
        let mut arguments = Vec::new();
        if self.is_all || self.with_units {
            arguments.push("--lib");
        }
        if self.is_all {
            arguments.push("--tests");
        }
        arguments.extend(self.targets.iter().flat_map(|target| ["--test", target.as_str()]));
        arguments.extend(self.packages.iter().flat_map(|package| ["--package", package.as_str()]));
        arguments
    }
}

/// Builds the tests of the copy at `tree`, once for all mutants, with the dependencies already
/// built for the workspace.
pub(super) fn build(root: &Path, tree: &Path, selection: &Selection) -> anyhow::Result<Vec<Trial>> {
    let mut command = cargo::command(&["test", "--release", "--no-run", "--quiet"]);
    command.arg("--message-format=json-render-diagnostics").args(selection.arguments());
    command.arg("--target-dir").arg(root.join("target"));
    // Each test runs once, so that less optimisation takes less time in all.
    for package in CRATES.map(package_of).into_iter().chain([PAGES.to_owned()]) {
        let level = u8::from(!COMPUTES_LITTLE.contains(&package.as_str()));
        let profile = format!("profile.release.package.{package}.opt-level={level}");
        command.arg("--config").arg(profile);
    }
    let mut child =
        command.current_dir(tree).stdout(Stdio::piped()).spawn().context("cannot start cargo")?;
    let mut messages = String::new();
    child.stdout.take().context("no output of cargo")?.read_to_string(&mut messages)?;
    if !child.wait()?.success() {
        bail!("the workspace with its mutants does not build; see the errors above");
    }
    let mut trials = Vec::new();
    for line in messages.lines() {
        let message: serde_json::Value = serde_json::from_str(line)?;
        if let Some(binary) = Binary::of(&message) {
            trials.extend(binary.trials()?);
        }
    }
    Ok(trials)
}

/// A test executable.
struct Binary {
    executable: PathBuf,
    folder: PathBuf,
    name: String,
}

impl Binary {
    /// The executable in a message of cargo, if the message is about one.
    fn of(message: &serde_json::Value) -> Option<Self> {
        let is_test = message["profile"]["test"].as_bool()?;
        let executable = PathBuf::from(message["executable"].as_str()?);
        let folder = Path::new(message["manifest_path"].as_str()?).parent()?.to_owned();
        let package = format!("carom-{}", folder.file_name()?.to_str()?);
        let name = match message["target"]["kind"][0].as_str()? {
            "test" => format!("{package}::{}", message["target"]["name"].as_str()?),
            _ => package,
        };
        is_test.then_some(Self { executable, folder, name })
    }

    /// Its tests, except ignored ones.
    fn trials(&self) -> anyhow::Result<Vec<Trial>> {
        let listed = |arguments: &[&str]| -> anyhow::Result<Vec<String>> {
            let output = Command::new(&self.executable).args(arguments).output()?;
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            Ok(text
                .lines()
                .filter_map(|line| line.strip_suffix(": test"))
                .map(str::to_owned)
                .collect())
        };
        let is_page = self.name.starts_with(PAGES_PACKAGE);
        let ignored = if is_page { Vec::new() } else { listed(&["--list", "--ignored"])? };
        let mut tests = listed(&["--list"])?;
        tests.retain(|test| !ignored.contains(test));
        let trial = |test: String| Trial {
            name: if is_page { format!("page {test}") } else { format!("{} {test}", self.name) },
            is_page,
            executable: self.executable.clone(),
            folder: self.folder.clone(),
            test,
        };
        Ok(tests.into_iter().map(trial).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_targets_that_hold_the_trials_are_built() {
        let names = ["carom-laws::hertz a_test", "carom-cli unit::test", "page 5.3"];
        let names = names.map(str::to_owned);
        let expected = "--lib --test hertz --test pages --package carom-cli --package carom-laws \
                        --package carom-mutant-pages";
        assert_eq!(Selection::of(names.iter()).arguments().join(" "), expected);
        assert!(Selection::all().arguments().join(" ").starts_with("--lib --tests --package"));
    }
}
