//! Mutants: deliberate faults in the code that a test or a claim must detect.
//!
//! `xtask/mutants.toml` lists them: a function, an expression in it, and its replacement. They are
//! identified by the function, so that code may move between files; a mutant whose place no longer
//! exists is an error. All mutants are woven into a copy of the workspace below `target/mutants/`,
//! each behind a switch set by the environment, and the copy is built once. Sources and releases
//! contain none; but the programs in `target/release` are those of the copy until the next build.
//!
//! First, every test and every page runs without mutants, each in its own process, and records the
//! mutants it reaches. Then, for each mutant, the tests that reach it run until one fails, and so
//! do the claims of the pages that reach it; snapshots do not count. A mutant that nothing detects
//! is a gap in the tests: the task fails, unless the list explains it.
//!
//! With `--record`, the detecting test is recorded in `xtask/mutants-noticed.toml`. With `--quick`,
//! that test runs first, and the others only if it no longer detects the mutant; only the required
//! test targets are built.
//!
//! The Python layer and the LAMMPS plugin have mutants of their own, see [`layers`].

mod layers;
mod list;
mod place;
mod report;
mod round;
mod sample;
mod trial;
mod weave;

use crate::flags;
use crate::outcome::Outcome;
use crate::root::root;
use anyhow::ensure;
use list::{Killers, Mutant};
use round::Verdict;
pub(crate) use sample::seed_of_commit;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use trial::{Selection, Trial};

/// Runs the mutants selected by the options.
pub(crate) fn run(options: &flags::Mutants) -> anyhow::Result<Outcome> {
    let root = root();
    let list = list::read(&root.join("xtask/mutants.toml"))?;
    let killers_path = root.join("xtask/mutants-noticed.toml");
    let mut killers = list::read_killers(&killers_path)?;
    let keys = list.mutants.iter().map(Mutant::key);
    let keys: Vec<String> = keys.chain(list.layers.iter().map(|mutant| mutant.key())).collect();
    killers.retain(|key, _| keys.contains(key));
    let result = if options.layers {
        let mut chosen = list.layers;
        chosen.retain(|mutant| is_chosen(&mutant.key(), options));
        ensure!(!chosen.is_empty(), "no mutant of the list has that name");
        layers::run(&root, &chosen, &mut killers)
    } else {
        run_woven(&root, &list.mutants, options, &mut killers).map(|()| Outcome::Passed)
    };
    if options.record {
        list::write_killers(&killers_path, &killers)?;
    }
    result
}

/// Runs the mutants in Rust code.
fn run_woven(
    root: &Path,
    mutants: &[Mutant],
    options: &flags::Mutants,
    killers: &mut Killers,
) -> anyhow::Result<()> {
    let chosen = chosen(mutants, options)?;
    let place = Place::new(root);
    weave::weave(root, &place.tree, mutants)?;
    let verdicts = if options.quick {
        quickly(&chosen, mutants, killers, &place)?
    } else {
        thoroughly(&chosen, place.build(&Selection::all())?, &place.reach)?
    };
    for (number, verdict) in chosen.iter().zip(&verdicts) {
        let key = mutants[number - 1].key();
        match verdict.test.as_ref().or(verdict.page.as_ref()) {
            Some(name) => killers.insert(key, name.clone()),
            None => killers.remove(&key),
        };
    }
    let judged: Vec<_> = chosen.iter().map(|number| &mutants[number - 1]).zip(verdicts).collect();
    if !options.quick {
        report::table(&judged);
    }
    report::survivors(&judged)
}

/// The folders of the copy and of the records of its tests.
struct Place {
    root: PathBuf,
    tree: PathBuf,
    reach: PathBuf,
}

impl Place {
    fn new(root: &Path) -> Self {
        let folder = root.join("target/mutants");
        Self { root: root.to_owned(), tree: folder.join("tree"), reach: folder.join("reach") }
    }

    fn build(&self, selection: &Selection) -> anyhow::Result<Vec<Trial>> {
        let clock = Instant::now();
        let trials = trial::build(&self.root, &self.tree, selection)?;
        println!("built with all mutants in {:.0} s", clock.elapsed().as_secs_f64());
        Ok(trials)
    }
}

const ALL: flags::Mutants = flags::Mutants {
    only: None,
    sample: None,
    seed: None,
    quick: false,
    record: false,
    layers: false,
};

/// All mutants, each against all tests and pages, for the long run.
pub(crate) fn all() -> anyhow::Result<Outcome> {
    let of_rust = run(&ALL)?;
    Ok(of_rust.and(run(&flags::Mutants { layers: true, ..ALL })?))
}

/// Checks that every place of the list exists in the code, without a build.
pub(crate) fn check(root: &Path) -> anyhow::Result<()> {
    let list = list::read(&root.join("xtask/mutants.toml"))?;
    weave::check(root, &list.mutants)?;
    layers::check(root, &list.layers)?;
    println!("{} mutants: in place", list.mutants.len() + list.layers.len());
    Ok(())
}

/// The numbers, from 1, of the mutants selected by the options.
fn chosen(mutants: &[Mutant], options: &flags::Mutants) -> anyhow::Result<Vec<usize>> {
    let is_chosen = |number: &usize| is_chosen(&mutants[number - 1].key(), options);
    let mut chosen: Vec<usize> = (1..=mutants.len()).filter(is_chosen).collect();
    ensure!(!chosen.is_empty(), "no mutant of the list has that name");
    if let Some(count) = options.sample {
        let seed = options.seed.unwrap_or_else(seed_of_commit);
        println!("a sample of {count} of {} mutants, --seed {seed}", chosen.len());
        chosen = sample::draw(chosen, count, seed);
    }
    Ok(chosen)
}

fn is_chosen(key: &str, options: &flags::Mutants) -> bool {
    options.only.as_ref().is_none_or(|text| key.contains(text))
}

/// Runs all tests and pages that reach a mutant, until one of each detects it.
fn thoroughly(chosen: &[usize], trials: Vec<Trial>, reach: &Path) -> anyhow::Result<Vec<Verdict>> {
    let clock = Instant::now();
    let count = trials.len();
    let known = round::reach(trials, reach)?;
    println!("{count} tests and pages without a mutant in {:.0} s", clock.elapsed().as_secs_f64());
    let clock = Instant::now();
    let verdicts = round::judge(chosen, &known, &[false, true])?;
    println!("{} mutants in {:.0} s", chosen.len(), clock.elapsed().as_secs_f64());
    Ok(verdicts)
}

/// Runs the known test, and all others only if it does not detect the mutant.
fn quickly(
    chosen: &[usize],
    mutants: &[Mutant],
    killers: &Killers,
    place: &Place,
) -> anyhow::Result<Vec<Verdict>> {
    let names = chosen.iter().filter_map(|number| killers.get(&mutants[number - 1].key()));
    // If a target no longer exists, the build fails; then all tests are built.
    let trials = place.build(&Selection::of(names)).or_else(|_| place.build(&Selection::all()))?;
    let clock = Instant::now();
    let known_to = |number: usize| {
        let name = killers.get(&mutants[number - 1].key());
        trials.iter().find(|trial| Some(&trial.name) == name)
    };
    round::all_pass(trials.iter().filter(|t| chosen.iter().any(|n| known_to(*n) == Some(t))))?;
    let mut verdicts = round::side_by_side(chosen, |_, &number| {
        let Some(trial) = known_to(number) else { return Ok(None) };
        let noticed = round::notices(number, trial, Duration::from_secs(4))?;
        Ok(noticed.then(|| by(trial)))
    })?;
    let known = verdicts.iter().flatten().count();
    println!("{known} detected by the known tests in {:.0} s", clock.elapsed().as_secs_f64());
    let open: Vec<usize> = (0..chosen.len())
        .filter(|i| verdicts[*i].is_none() && !explained(mutants, chosen[*i]))
        .collect();
    if !open.is_empty() {
        println!("{} need other tests: record them by `cargo xtask mutants --record`", open.len());
        open.iter().for_each(|i| println!("  {}", mutants[chosen[*i] - 1].key()));
        let numbers: Vec<usize> = open.iter().map(|i| chosen[*i]).collect();
        let trials = place.build(&Selection::all())?;
        for (i, verdict) in open.into_iter().zip(thoroughly(&numbers, trials, &place.reach)?) {
            verdicts[i] = Some(verdict);
        }
    }
    Ok(verdicts.into_iter().map(Option::unwrap_or_default).collect())
}

fn explained(mutants: &[Mutant], number: usize) -> bool {
    mutants[number - 1].explained.is_some()
}

/// The verdict of one detecting trial.
fn by(trial: &Trial) -> Verdict {
    let name = Some(trial.name.clone());
    let verdict = Verdict { is_reached: true, ..Verdict::default() };
    if trial.is_page {
        Verdict { page: name, ..verdict }
    } else {
        Verdict { test: name, ..verdict }
    }
}
