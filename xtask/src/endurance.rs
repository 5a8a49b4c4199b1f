//! Runs the long checks of `crates/numerical/examples/endurance` on request, and records what was run.

use anyhow::{Context as _, ensure};
use std::fmt::Write as _;
use std::process::{Command, Stdio};

use crate::cargo;
use crate::flags;
use crate::root::root;

/// The record, below the root.
const RECORD: &str = "benches/endurance.toml";

/// What stands above all runs.
const HEAD: &str = "\
# Runs of crates/numerical/examples/endurance, as `cargo xtask endurance` has made them: steps of the memories, impacts
# and contact problems, with the worst value that each invariant had. A run that violates one is not recorded.
";

/// The jobs, with the counts that they have unless given.
const JOBS: [(&str, u64); 5] = [
    ("line", 1_000_000_000),
    ("fixed-direction", 1_000_000_000),
    ("coulomb", 1_000_000_000),
    ("impacts", 1_000_000),
    ("contacts", 100_000),
];

/// Runs the chosen job, or each, and appends what it says to the record.
pub(crate) fn run(options: &flags::Endurance) -> anyhow::Result<()> {
    let chosen = options.job.as_deref();
    let jobs: Vec<_> =
        JOBS.iter().filter(|(name, _)| chosen.is_none_or(|own| own == *name)).collect();
    ensure!(!jobs.is_empty(), "the jobs are {}", JOBS.map(|(name, _)| name).join(", "));
    // The commit that is built, not one made meanwhile.
    let head = head()?;
    let example = ["build", "--release", "--package", "carom-numerical", "--example", "endurance"];
    cargo::run(&example)?;
    for (name, usual) in jobs {
        let (count, seed) = (options.count.unwrap_or(*usual), options.seed.unwrap_or(1));
        println!("== {name}, {count} from seed {seed}");
        let found = found(name, count, seed)?;
        print!("{found}");
        let today = cargo::printed(Command::new("date").args(["-u", "+%F"]))?;
        append(&record(name, [count, seed], [&head, today.trim()], &found))?;
    }
    Ok(())
}

/// What a job prints; one that meets a violation fails.
fn found(name: &str, count: u64, seed: u64) -> anyhow::Result<String> {
    let mut program = Command::new(root().join("target/release/examples/endurance"));
    program.args([name, "--count", &count.to_string(), "--seed", &seed.to_string()]);
    let output = program.stderr(Stdio::inherit()).output().context("cannot start endurance")?;
    ensure!(output.status.success(), "{name}: an invariant is violated");
    Ok(String::from_utf8(output.stdout)?)
}

/// The commit, and whether files differ from it.
fn head() -> anyhow::Result<String> {
    let told = cargo::git(&["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])?;
    Ok(told.trim().to_owned())
}

fn record(name: &str, [count, seed]: [u64; 2], [head, date]: [&str; 2], found: &str) -> String {
    let mut text = String::from("\n[[run]]\n");
    let _ = writeln!(text, "job = \"{name}\"\ndate = {date}");
    let _ = writeln!(text, "head = \"{head}\"\ncount = {count}\nseed = {seed}");
    text + found
}

fn append(run: &str) -> anyhow::Result<()> {
    let path = root().join(RECORD);
    let before = std::fs::read_to_string(&path).unwrap_or_else(|_| HEAD.to_owned());
    std::fs::write(&path, before + run).with_context(|| format!("cannot write {RECORD}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_record_is_toml_with_known_jobs() {
        let text = std::fs::read_to_string(root().join(RECORD)).unwrap_or_default();
        let table: toml::Table = text.parse().unwrap();
        for run in table.get("run").and_then(|runs| runs.as_array()).into_iter().flatten() {
            let job = run.get("job").and_then(|job| job.as_str()).unwrap();
            assert!(JOBS.iter().any(|(name, _)| *name == job), "{job}");
            assert!(run.get("count").and_then(|count| count.as_integer()).unwrap() > 0);
        }
        let run = record("line", [7, 1], ["abc", "2024-10-04"], "seconds = 0\nmerges = 0.000e0\n");
        assert!(run.parse::<toml::Table>().is_ok(), "{run}");
    }
}
