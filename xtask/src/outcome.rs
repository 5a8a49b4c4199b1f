//! Outcome of a task that did not fail: passed, or with skipped parts and their reasons.
//!
//! In continuous integration (`CI` is set) a skipped part is a failure unless [`ALLOWED`] contains
//! it.

use anyhow::bail;

/// The parts that continuous integration may skip, and why.
const ALLOWED: &[(Part, &str)] = &[
    (
        Part::Advisories,
        "the database of advisories is fetched from a host that not every machine of CI can reach; \
         where it can be fetched, an advisory fails the step",
    ),
    (Part::Rapier, OTHERS_CRATES),
    (
        Part::Fuzz,
        "the fuzzer needs the nightly Rust of .ci/nightly, cargo-fuzz and the registry of crates; what it found is a \
         test of the crate concerned",
    ),
    (
        Part::Taplo,
        "taplo is fetched from the registry of Python's packages; tests of the command and of the Python \
         module check the examples against the schemas too",
    ),
    (
        Part::Instructions,
        "counts compare only by the compiler, valgrind and kind of processor that recorded them; \
         with these, growth fails the step",
    ),
];

/// Why a door to an engine in Rust may be skipped.
const OTHERS_CRATES: &str = "the engine is fetched from the registry of crates, which a machine without network \
                             cannot reach; nothing in the workspace depends on it";

/// A part of a task that requires something a machine may lack.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// The C interface under the address sanitizer.
    AddressSanitizer,
    /// Advisories on the dependencies.
    Advisories,
    /// Licences, bans and sources of the dependencies.
    Dependencies,
    /// The targets of the fuzzer.
    Fuzz,
    /// The examples in C and Fortran, with the installed library.
    CInstalled,
    /// The pages of the book.
    BookPages,
    /// The report or the book in a browser.
    Browser,
    /// The instructions of hot paths, compared with the recorded ones.
    Instructions,
    /// The public interfaces, compared with those of the last release.
    Interfaces,
    /// The LAMMPS plugin.
    Lammps,
    /// The JavaScript module of the rebound.
    Node,
    /// Tests that skip themselves.
    OwnTests,
    /// The build with the oldest supported Rust.
    OldestRust,
    /// The strategy of pooltool.
    Pooltool,
    /// The Python module and its wheel.
    Python,
    /// Tests of the Python module that need optional packages.
    PythonWishes,
    /// The hook for the engine Rapier.
    Rapier,
    /// The examples, by taplo.
    Taplo,
    /// Whether all changes are committed.
    Commits,
}

/// A part that was skipped.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Skip {
    part: Part,
    reason: String,
}

/// Outcome of a task that did not fail.
#[derive(Debug, Clone, PartialEq, Eq)]
#[must_use]
pub(crate) enum Outcome {
    Passed,
    /// At least one part did not run.
    Skipped(Vec<Skip>),
}

impl Outcome {
    pub(crate) fn skipped(part: Part, reason: impl Into<String>) -> Self {
        Self::Skipped(vec![Skip { part, reason: reason.into() }])
    }

    /// Both outcomes together.
    pub(crate) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Passed, one) | (one, Self::Passed) => one,
            (Self::Skipped(mut one), Self::Skipped(other)) => {
                one.extend(other);
                Self::Skipped(one)
            }
        }
    }

    /// Prints the skipped parts and returns their number; an error in continuous integration if
    /// [`ALLOWED`] does not contain one.
    pub(crate) fn accept(self) -> anyhow::Result<usize> {
        self.accept_if(std::env::var("CI").is_ok_and(|ci| !ci.is_empty() && ci != "false"))
    }

    fn accept_if(self, is_ci: bool) -> anyhow::Result<usize> {
        let Self::Skipped(skips) = self else { return Ok(0) };
        let mut refused = Vec::new();
        for Skip { part, reason } in &skips {
            println!("SKIPPED {part:?}: {reason}");
            match ALLOWED.iter().find(|(allowed, _)| allowed == part) {
                Some((_, why)) if is_ci => println!("  allowed in CI: {why}"),
                None if is_ci => refused.push(format!("{part:?}: {reason}")),
                _ => {}
            }
        }
        if !refused.is_empty() {
            bail!("skipped parts that CI does not allow:\n  {}", refused.join("\n  "));
        }
        Ok(skips.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ci_refuses_a_skipped_part_that_is_not_listed() {
        let skipped = Outcome::skipped(Part::Browser, "no browser");
        let both = Outcome::Passed.and(skipped.clone()).and(skipped);
        assert_eq!(both.clone().accept_if(false).unwrap(), 2);
        assert!(both.accept_if(true).unwrap_err().to_string().contains("Browser: no browser"));
        assert_eq!(Outcome::Passed.accept_if(true).unwrap(), 0);
    }

    #[test]
    fn ci_allows_a_skipped_part_that_is_listed() {
        let (part, why) = ALLOWED[0];
        assert!(!why.is_empty());
        assert_eq!(Outcome::skipped(part, "no database").accept_if(true).unwrap(), 1);
    }
}
