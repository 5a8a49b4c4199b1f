//! Finds which tests reach which mutants, and which detect them.

use super::trial::{End, Switch, Trial};
use anyhow::{Context as _, ensure};
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// A trial that passes without mutants, and the mutants it reaches.
#[derive(Debug, Clone)]
pub(super) struct Known {
    pub(super) trial: Trial,
    time: Duration,
    reached: BTreeSet<usize>,
}

/// What detects a mutant.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Verdict {
    /// A failing test.
    pub(super) test: Option<String>,
    /// A page with failing claims.
    pub(super) page: Option<String>,
    /// Whether any trial reaches it.
    pub(super) is_reached: bool,
}

impl Verdict {
    pub(super) fn survives(&self) -> bool {
        self.test.is_none() && self.page.is_none()
    }
}

/// Time limit of a trial without mutants.
const TIME_LIMIT: Duration = Duration::from_secs(300);

/// Runs all trials without mutants and records the mutants they reach and their durations. A trial
/// that fails is omitted with a message: a test may not run in the copy, which has another version.
pub(super) fn reach(trials: Vec<Trial>, folder: &Path) -> anyhow::Result<Vec<Known>> {
    let known = side_by_side(&trials, |index, trial| {
        let notes = folder.join(index.to_string());
        if notes.exists() {
            std::fs::remove_dir_all(&notes)?;
        }
        std::fs::create_dir_all(&notes)?;
        let (end, time) = trial.run(Switch::Reach(&notes), TIME_LIMIT)?;
        // Recording may disturb a test that counts allocations.
        if end != End::Passed && trial.run(Switch::Off, TIME_LIMIT)?.0 != End::Passed {
            println!("omitted, since it fails without mutants: {}", trial.name);
            return Ok(None);
        }
        let reached = std::fs::read_dir(&notes)?
            .map(|entry| entry?.file_name().to_string_lossy().parse().context("a note of reach"))
            .collect::<anyhow::Result<_>>()?;
        Ok(Some(Known { trial: trial.clone(), time, reached }))
    })?;
    let mut known: Vec<Known> = known.into_iter().flatten().collect();
    known.sort_by_key(|known| known.time);
    Ok(known)
}

/// Runs the trials without mutants; an error if one fails.
pub(super) fn all_pass<'a>(trials: impl Iterator<Item = &'a Trial>) -> anyhow::Result<()> {
    let trials: Vec<&Trial> = trials.collect();
    side_by_side(&trials, |_, trial| pass(trial)).map(drop)
}

/// An error if the trial fails without mutants.
fn pass(trial: &Trial) -> anyhow::Result<()> {
    let (end, _) = trial.run(Switch::Off, TIME_LIMIT)?;
    ensure!(end == End::Passed, "fails without mutants: {}", trial.name);
    Ok(())
}

/// Runs the tests and pages that reach each mutant, fastest first, until one of each kind detects
/// it.
pub(super) fn judge(
    numbers: &[usize],
    known: &[Known],
    is_page: &[bool],
) -> anyhow::Result<Vec<Verdict>> {
    side_by_side(numbers, |_, &number| {
        let mut verdict = Verdict::default();
        for &is_page in is_page {
            let found = first(number, known.iter().filter(|k| k.trial.is_page == is_page))?;
            if is_page { verdict.page = found } else { verdict.test = found }
        }
        verdict.is_reached = known.iter().any(|known| known.reached.contains(&number));
        Ok(verdict)
    })
}

/// The first trial that detects the mutant.
fn first<'a>(
    number: usize,
    known: impl Iterator<Item = &'a Known>,
) -> anyhow::Result<Option<String>> {
    for known in known.filter(|known| known.reached.contains(&number)) {
        if notices(number, &known.trial, known.time)? {
            return Ok(Some(known.trial.name.clone()));
        }
    }
    Ok(None)
}

/// Whether the trial fails with the mutant, or takes much longer than the `time` without it.
pub(super) fn notices(number: usize, trial: &Trial, time: Duration) -> anyhow::Result<bool> {
    let limit = Duration::from_secs(20) + 10 * time;
    Ok(trial.run(Switch::On(number), limit)?.0 != End::Passed)
}

/// Applies `work` to all items on all cores; results in the order of the items.
pub(super) fn side_by_side<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(usize, &T) -> anyhow::Result<R> + Sync,
) -> anyhow::Result<Vec<R>> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::new());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(index) else { break };
                    let result = work(index, item);
                    if let Ok(mut done) = done.lock() {
                        done.push((index, result));
                    }
                }
            });
        }
    });
    let mut done = done.into_inner().map_err(|_| anyhow::anyhow!("a worker panicked"))?;
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}
