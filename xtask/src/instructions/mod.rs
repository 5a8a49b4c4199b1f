//! Counts the instructions of the hot paths by callgrind and compares them with the recorded ones: a guard
//! against loss of speed that does not depend on the load of the machine. gungraun keeps what it compares with below
//! `target`; here it is in the repository, with the reason of each growth.

mod record;

use crate::bench;
use crate::cargo;
use crate::flags;
use crate::outcome::{Outcome, Part};
use crate::root::root;
use anyhow::{Context as _, bail, ensure};
use record::{Change, Conditions, Counts, Record};
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;

/// The recorded counts, below the root.
const RECORD: &str = "benches/instructions.toml";

/// The function of the example inside which instructions count.
const COUNTED: &str = "hot_paths::counted*";

/// Counts and compares; skipped without valgrind, or if compiler, valgrind or processor differ from those of the
/// record.
pub(crate) fn check() -> anyhow::Result<Outcome> {
    let Some((now, before)) = both()? else { return Ok(no_valgrind()) };
    let before = before.with_context(|| format!("cannot read {RECORD}"))?;
    let changes = before.changes(&now.counts)?;
    changes.iter().for_each(|change| println!("{}", change.told()));
    if now.conditions != before.conditions {
        return Ok(Outcome::skipped(Part::Instructions, not_comparable(&before, &now)));
    }
    let grown: Vec<_> = changes.iter().filter(|change| change.grew()).map(Change::told).collect();
    ensure!(
        grown.is_empty(),
        "more instructions than recorded:\n  {}\nMake it cheaper, or commit what \
         `cargo xtask instructions --record --because \"why\"` writes",
        grown.join("\n  ")
    );
    if !changes.is_empty() {
        println!("fewer instructions: `cargo xtask instructions --record` keeps the gain");
    }
    println!("{} hot paths within 3 % of {RECORD}", now.counts.len());
    Ok(Outcome::Passed)
}

/// Runs the task by its options.
pub(crate) fn run(options: &flags::Instructions) -> anyhow::Result<Outcome> {
    if options.record { write(options.because.as_deref()) } else { check() }
}

/// Writes the counts; those that have grown need a reason, if they can be compared.
fn write(because: Option<&str>) -> anyhow::Result<Outcome> {
    let Some((mut now, before)) = both()? else { return Ok(no_valgrind()) };
    if let Some(before) = before {
        now.because = before.because.clone();
        now.because.retain(|name, _| now.counts.contains_key(name));
        for change in grown(&before, &now) {
            println!("{}", change.told());
            let Some(why) = because else { bail!("{} grew: say --because \"why\"", change.name) };
            now.because.insert(change.name, why.to_owned());
        }
    }
    std::fs::write(root().join(RECORD), now.text())?;
    println!("{RECORD} is written anew: {} hot paths", now.counts.len());
    Ok(Outcome::Passed)
}

/// The paths of both records that have grown; none under other conditions.
fn grown(before: &Record, now: &Record) -> Vec<Change> {
    if before.conditions != now.conditions {
        println!("{}", not_comparable(before, now));
        return Vec::new();
    }
    let mut common = before.clone();
    common.counts.retain(|name, _| now.counts.contains_key(name));
    let mut counts = now.counts.clone();
    counts.retain(|name, _| common.counts.contains_key(name));
    let changes = common.changes(&counts).unwrap_or_default();
    changes.into_iter().filter(Change::grew).collect()
}

/// The counts now and those recorded; `None` without valgrind.
fn both() -> anyhow::Result<Option<(Record, Option<Record>)>> {
    let Ok(valgrind) = said("valgrind", &["--version"]) else { return Ok(None) };
    let compiler = said("rustc", &["--version"])?;
    let conditions = Conditions { compiler, valgrind, features: features() };
    let program = bench::example("hot_paths")?;
    let mut counts = Counts::new();
    for name in said(&program, &[])?.lines() {
        let count = count(&program, name)?;
        println!("{name}: {count}");
        counts.insert(name.to_owned(), count);
    }
    let text = std::fs::read_to_string(root().join(RECORD)).ok();
    let before = text.map(|text| Record::parse(&text).context(RECORD)).transpose()?;
    Ok(Some((Record { conditions, counts, because: Default::default() }, before)))
}

/// Instructions of one path.
fn count(program: &Path, name: &str) -> anyhow::Result<u64> {
    let out = bench::folder().join("callgrind.out");
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--quiet", "--collect-atstart=no"]);
    command.arg(format!("--toggle-collect={COUNTED}"));
    command.arg(format!("--callgrind-out-file={}", out.display())).arg(program).arg(name);
    let output = command.output().context("cannot start valgrind")?;
    let told = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{name} failed under valgrind:\n{told}");
    total(&std::fs::read_to_string(&out)?).with_context(|| format!("no count of {name}"))
}

/// The sum over the whole run in what callgrind has written.
fn total(text: &str) -> Option<u64> {
    let of = |key: &str| text.lines().find_map(|line| line.strip_prefix(key)?.trim().parse().ok());
    of("totals:").or_else(|| of("summary:")).filter(|count| *count > 0)
}

fn said(program: impl AsRef<OsStr>, arguments: &[&str]) -> anyhow::Result<String> {
    Ok(cargo::printed(Command::new(program).args(arguments))?.trim().to_owned())
}

/// The features by which the Fourier transforms and the C library choose their code, as far as valgrind passes
/// them on.
fn features() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let flags = info.lines().find(|line| line.starts_with("flags")).unwrap_or_default();
    let has = |name: &&str| flags.split_whitespace().any(|flag| flag == *name);
    let known = ["sse4_2", "avx", "fma", "avx2"].into_iter().filter(has).collect::<Vec<_>>();
    format!("{} {}", std::env::consts::ARCH, known.join(" "))
}

fn not_comparable(before: &Record, now: &Record) -> String {
    format!(
        "NOT COMPARED: the counts were recorded by {}, and these are by {}; `cargo xtask instructions \
         --record` records anew",
        before.conditions, now.conditions
    )
}

fn no_valgrind() -> Outcome {
    Outcome::skipped(Part::Instructions, "valgrind is not installed")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_total_of_callgrind_is_read() {
        let text = "events: Ir\nfn=(1) counted\n3 12\n\ntotals: 4711\n";
        assert_eq!(total(text), Some(4711));
        assert_eq!(total("events: Ir\nsummary: 5\n"), Some(5));
        assert_eq!(total("events: Ir\ntotals: 0\n"), None);
    }
}
