#![forbid(unsafe_code)]
//! `carom-verify`: computes tables and figures of the thesis and checks their claims.

use carom_verification::run::{Outcome, run};
use carom_verification::selection::{Selection, Slow};
use carom_verification::snapshot::Policy;
use carom_verification::{Entry, catalogue, files, terminal};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

mod flags {
    xflags::xflags! {
        /// Computes the tables and figures of the thesis and checks their claims. Writes SVG,
        /// CSV and one HTML report into target/verification/.
        cmd carom-verify {
            /// Only this figure or table, as 5.3 or table-13.1; may be repeated.
            repeated --figure id: String
            /// Only this chapter; may be repeated.
            repeated --chapter number: String
            /// Leave out the figures that take long.
            optional --quick
            /// Rewrite the snapshots that differ.
            optional --update
            /// List all tables and figures, done or missing, and stop.
            optional --list
        }
    }
}

fn main() -> ExitCode {
    let flags = flags::CaromVerify::from_env_or_exit();
    let catalogue = catalogue();
    if flags.list {
        print!("{}", terminal::list(&catalogue));
        return ExitCode::SUCCESS;
    }
    let policy = if flags.update { Policy::Update } else { Policy::Check };
    let slow = if flags.quick { Slow::Skip } else { Slow::Keep };
    let selection = Selection { ids: flags.figure, chapters: flags.chapter, slow };
    match selection.of(&catalogue) {
        Ok(entries) => verify(&catalogue, &entries, policy),
        Err(unknown) => {
            eprintln!("error: {unknown}");
            ExitCode::from(2)
        }
    }
}

fn verify(catalogue: &[Entry], entries: &[Entry], policy: Policy) -> ExitCode {
    let root = workspace();
    let done = entries.iter().filter(|entry| entry.is_done()).count();
    if done == 0 {
        eprintln!("error: none of the {} chosen tables and figures is done", entries.len());
        return ExitCode::FAILURE;
    }
    let snapshots = root.join("verification").join("snapshots");
    let outcomes = run_with_progress(entries, done, &snapshots, policy);
    println!("{}", terminal::table(&outcomes));
    print!("{}", terminal::failures(&outcomes));
    let folder = root.join("target").join("verification");
    let report = match files::write(&folder, catalogue, &outcomes) {
        Ok(report) => report,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    };
    let passed = outcomes.iter().filter(|outcome| outcome.passes()).count();
    let claims: usize = outcomes.iter().map(|outcome| outcome.score().total).sum();
    let held: usize = outcomes.iter().map(|outcome| outcome.score().passed).sum();
    println!("{passed} of {done} tables and figures pass, {held} of {claims} claims hold");
    println!("report: {}", report.display());
    if passed == done { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn run_with_progress(
    entries: &[Entry],
    count: usize,
    snapshots: &Path,
    policy: Policy,
) -> Vec<Outcome> {
    let bar = ProgressBar::new(count as u64);
    let template = "{bar:40} {pos}/{len} {msg} [{elapsed}]";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    // A panic is reported with its figure; its message must not tear the bar.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let outcomes = run(entries, snapshots, policy, |outcome| {
        bar.set_message(outcome.entry.name());
        bar.inc(1);
    });
    std::panic::set_hook(hook);
    bar.finish_and_clear();
    outcomes
}

/// The folder of the workspace: cargo tells it; else that of the build.
fn workspace() -> PathBuf {
    std::env::var_os("CAROM_WORKSPACE")
        .map_or_else(|| PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")), PathBuf::from)
}
