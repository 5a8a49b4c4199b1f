//! Tests of the C interface under sanitizers.

use crate::outcome::{Outcome, Part};
use anyhow::{Context as _, ensure};
use std::io::{BufRead as _, BufReader};
use std::process::{Command, Stdio};

/// Output of the script if the nightly Rust of `.ci/nightly` is not installed.
const NO_SANITIZER: &str = "no address sanitizer";

/// Calls the C interface with random arguments under the address sanitizer and valgrind.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    let script = crate::root::root().canonicalize()?.join("crates/capi/sanitize.sh");
    let mut child = Command::new(&script)
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot start {}", script.display()))?;
    let mut is_without = false;
    for line in BufReader::new(child.stdout.take().context("no output of the script")?).lines() {
        let line = line?;
        is_without |= line.contains(NO_SANITIZER);
        println!("{line}");
    }
    let status = child.wait()?;
    ensure!(status.success(), "the C border under sanitizers failed ({status})");
    Ok(match is_without {
        false => Outcome::Passed,
        true => {
            let reason = "the nightly Rust of .ci/nightly is not installed";
            Outcome::skipped(Part::AddressSanitizer, reason)
        }
    })
}
