//! The steps of continuous integration.

use crate::cargo::Lints;
use crate::lammps::Which;
use crate::outcome::Outcome;
use crate::{
    book, browse, cargo, changes, deny, doors, fuzz, install_c, instructions, lammps, mutants,
    python, release, sanitize, sdist, taplo, test, tidy,
};
use anyhow::Context as _;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

type Step = fn() -> anyhow::Result<Outcome>;

/// Duration of the search for a path with a large error of Coulomb's law, in seconds.
const ADVERSARY: &str = "60";

/// Steps that every change must pass, each test once. Cargo lints and documents what they compile, as [`Lints`] says.
const STEPS: &[(&str, Step)] = &[
    ("form", form),
    ("index of equations, lock files, places of mutants, descriptions of packages", || {
        passed(tidy::run())
    }),
    ("lints and tests", || passed(test::usual())),
];

/// Steps beside these: they fetch packages and hardly compute.
const FETCHED: &[(&str, Step)] = &[("the packages of the tests in Python", python::packages)];

/// One more of them, for [`LAMMPS`].
const HOST: (&str, Step) = ("the pinned release of LAMMPS", lammps::packages);

/// The first of the steps after these, which run two at a time, each busy on one core.
const PYTHON: (&str, Step) =
    ("the Python module and its tests", || Ok(python::install()?.and(python::test(&[])?)));

/// In its place if no path of [`WRITTEN`] changed.
const PYTHON_AS_IT_WAS: (&str, Step) =
    ("the Python module and its tests, but for those of types and notebooks", || {
        Ok(python::install()?.and(python::test(python::WRITTEN)?))
    });

/// What is written in Python.
const WRITTEN: &[&str] = &["crates/python", "docs/book/src"];

/// The second of them.
const SHOWN: (&str, Step) =
    ("documentation, its examples and the example programs", || passed(test::shown()));

/// One of [`WHERE_CHANGED`], and of every long run.
const BENCHES: (&str, Step) = ("the benches, checked and linted", benches);

/// The last of them, after those of [`WHERE_CHANGED`].
const LAST: &[(&str, Step)] = &[("the quick figures, and the report in a browser", report)];

/// Paths of the manifests of all packages.
const MANIFESTS: &[&str] = &[
    "Cargo.toml",
    "Cargo.lock",
    "deny.toml",
    "crates/*/Cargo.toml",
    "fuzz/Cargo.lock",
    "doors/rapier/Cargo.lock",
];

/// The LAMMPS plugin, and what it calls.
const PLUGIN: &[&str] =
    &["plugins", "crates/capi/Cargo.toml", "crates/capi/include", "crates/capi/src"];

/// What its C library is built of.
const BELOW: &[&str] = &[
    "Cargo.lock",
    "crates/geometry/src",
    "crates/halfspace/src",
    "crates/impact/src",
    "crates/laws/Cargo.toml",
    "crates/laws/src",
    "crates/special/src",
];

/// The tests of the plugin, if one of these paths changed; the first that applies. They take longest: before other
/// steps they do not wait for what those compile.
const LAMMPS: [Changed; 2] = [
    (PLUGIN, "the LAMMPS plugin, in the pinned release", || lammps::run(Which::Short)),
    (BELOW, "the contacts of the LAMMPS plugin, in the pinned release", || {
        lammps::run(Which::OfLaws)
    }),
];

/// A step that runs if one of these paths changed, and in every long run.
type Changed = (&'static [&'static str], &'static str, Step);

/// Such steps.
const WHERE_CHANGED: &[Changed] = &[
    (MANIFESTS, "packages", || passed(release::pack_quickly())),
    (
        &[
            "Cargo.toml",
            "crates/capi/Cargo.toml",
            "crates/capi/examples",
            "crates/capi/include",
            "crates/capi/install",
            "xtask/src/install_c",
        ],
        "the installed C library, by pkg-config and CMake",
        install_c::check,
    ),
    (MANIFESTS, "licences, sources and advisories of the dependencies", deny::run),
    (&["docs"], "the book", book::run),
    (&["Cargo.toml", "benches", "crates/*/Cargo.toml", "crates/*/src"], BENCHES.0, BENCHES.1),
    (
        &["Cargo.toml", "crates/*/Cargo.toml", "crates/halfspace/src", "crates/impact/src"],
        "half-space and impacts without threads and operators",
        || passed(without_threads(&[""])),
    ),
    (
        &["doors/carom-rebound", "docs/book/src/drawings", "crates/impact/src/restitution/table"],
        "the JavaScript module of the rebound",
        doors::rebound,
    ),
];

/// Additional steps of a long run, before a release and on request.
const LONG: &[(&str, Step)] = &[
    ("all figures", || passed(cargo::run_built("--bin", "carom-verify", &[]))),
    ("documentation of all packages", documentation),
    ("tests with overflow checks and debug assertions", || passed(test::checked())),
    ("the tests that are ignored otherwise", || passed(test::ignored())),
    ("licences, sources and advisories of the dependencies", deny::run),
    ("packages", || passed(release::pack_quickly())),
    ("the book", book::run),
    ("the LAMMPS plugin, in the pinned release, all tests", || lammps::run(Which::All)),
    ("the installed C library, by pkg-config and CMake", install_c::check),
    ("the doors to other engines", doors::run),
    ("the examples, by the checker of editors", taplo::run),
    ("the C border under sanitizers", sanitize::run),
    ("the fuzzer, a minute for each target", || fuzz::run(None, fuzz::SECONDS)),
    ("a Python wheel from its source distribution", sdist::check),
    ("instructions of hot paths", instructions::check),
    ("half-space and impacts without threads, with operators and without", || {
        passed(without_threads(&["", "carom-halfspace/operators"]))
    }),
    ("a search for a bad path of Coulomb's law", adversary),
    ("mutants, those of Python and LAMMPS too", mutants::all),
];

/// Those of which a path changed.
fn changed(all: &[Changed], paths: &[String]) -> Vec<(&'static str, Step)> {
    let mut steps = Vec::new();
    for &(decisive, name, step) in all {
        if paths.iter().any(|path| is_among(path, decisive)) {
            steps.push((name, step));
        } else {
            println!("== skipped, since none of its paths changed: {name}");
        }
    }
    steps
}

/// Whether the path is one of these or lies below one; `*` matches any name.
fn is_among(path: &str, decisive: &[&str]) -> bool {
    decisive.iter().any(|decisive| {
        let mut parts = path.split('/');
        decisive.split('/').all(|part| parts.next().is_some_and(|own| part == "*" || part == own))
    })
}

/// Runs every step. Stops at the first that fails or, in continuous integration, that skips a part
/// that must not be skipped.
pub(crate) fn run(is_long: bool) -> anyhow::Result<()> {
    let start = Instant::now();
    let (mut fetched, mut together) = (FETCHED.to_vec(), Vec::new());
    if is_long {
        together.extend([PYTHON, SHOWN, BENCHES]);
    } else {
        let paths = changes::paths()?;
        let is_written = paths.iter().any(|path| is_among(path, WRITTEN));
        together.extend([if is_written { PYTHON } else { PYTHON_AS_IT_WAS }, SHOWN]);
        if let Some(lammps) = changed(&LAMMPS, &paths).into_iter().next() {
            fetched.push(HOST);
            together.push(lammps);
        }
        together.extend(changed(WHERE_CHANGED, &paths));
    }
    together.extend(LAST);
    let lints = Lints::with_builds();
    let mut skipped = both(&fetched, STEPS)? + two_at_a_time(&together)?;
    drop(lints);
    let mut count = fetched.len() + STEPS.len() + together.len();
    if is_long {
        skipped += all(LONG)?;
        count += LONG.len();
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("== all {count} steps in {seconds:.0} s, {skipped} parts skipped");
    Ok(())
}

/// Runs two lists of steps beside each other, and counts the parts that they skip.
fn both(ours: &[(&str, Step)], others: &[(&str, Step)]) -> anyhow::Result<usize> {
    let (ours, others) = std::thread::scope(|scope| {
        let others = scope.spawn(|| all(others));
        (all(ours), others.join())
    });
    sum(ours, others)
}

/// Runs steps, each as soon as one of two threads has ended its last, and counts the parts that they skip.
fn two_at_a_time(steps: &[(&str, Step)]) -> anyhow::Result<usize> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut skipped = 0;
        while let Some(&(name, step)) = steps.get(next.fetch_add(1, Ordering::Relaxed)) {
            skipped += one(name, step)?;
        }
        Ok(skipped)
    };
    let (ours, others) = std::thread::scope(|scope| {
        let others = scope.spawn(work);
        (work(), others.join())
    });
    sum(ours, others)
}

/// Sums what two threads skipped.
fn sum(
    ours: anyhow::Result<usize>,
    others: std::thread::Result<anyhow::Result<usize>>,
) -> anyhow::Result<usize> {
    Ok(ours? + others.map_err(|_| anyhow::anyhow!("a step panicked"))??)
}

/// Runs steps one after the other, and counts the parts that they skip.
fn all(steps: &[(&str, Step)]) -> anyhow::Result<usize> {
    steps.iter().map(|&(name, step)| one(name, step)).sum()
}

/// Runs a step, and counts the parts that it skips.
fn one(name: &str, step: Step) -> anyhow::Result<usize> {
    println!("== {name}");
    let start = Instant::now();
    let outcome = step().and_then(Outcome::accept).with_context(|| format!("step `{name}`"));
    if let Err(error) = &outcome {
        println!("== {name}: FAILED: {error:#}");
        print_new_regressions();
    }
    let count = outcome?;
    let end = if count == 0 { "passed".to_owned() } else { format!("{count} parts SKIPPED") };
    println!("== {name}: {end} in {:.0} s", start.elapsed().as_secs_f64());
    Ok(count)
}

fn passed(result: anyhow::Result<()>) -> anyhow::Result<Outcome> {
    result.map(|()| Outcome::Passed)
}

/// Prints the seeds of failed property tests, so that they can be committed from a temporary
/// machine.
fn print_new_regressions() {
    let root = crate::root::root();
    let pattern = "*/proptest-regressions/*.txt";
    let all = ["ls-files", "--modified", "--others", "--exclude-standard", "--", pattern];
    for path in cargo::git(&all).unwrap_or_default().lines() {
        if let Ok(text) = std::fs::read_to_string(root.join(path)) {
            println!("== commit these seeds as {path}:\n{text}");
        }
    }
}

fn form() -> anyhow::Result<Outcome> {
    passed(cargo::run(&["fmt", "--all", "--check"]))
}

/// Checks the benches, the only package without tests, with the lints of [`Lints`].
fn benches() -> anyhow::Result<Outcome> {
    let benches = ["build", "--release", "--workspace", "--bench", "*", "--example", "*"];
    passed(cargo::compile(&benches))
}

/// Checks the crates that can do without rayon or without operators. Carom as a whole has both, so that no other step
/// does.
fn without_threads(with: &[&str]) -> anyhow::Result<()> {
    let packages = ["--package", "carom-halfspace", "--package", "carom-impact"];
    for features in with {
        let lints =
            ["clippy", "--release", "--lib", "--no-default-features", "--features", features];
        cargo::run(&[&lints[..], &packages, &["--", "-D", "warnings"]].concat())?;
    }
    Ok(())
}

fn documentation() -> anyhow::Result<Outcome> {
    let doc = ["doc", "--workspace", "--no-deps", "--release"];
    passed(cargo::run_with(&doc, "RUSTDOCFLAGS", "-D warnings"))
}

fn report() -> anyhow::Result<Outcome> {
    cargo::run_built("--bin", "carom-verify", &["--quick"])?;
    browse::run()
}

/// Searches for a path whose error exceeds the estimate of the law, with a seed from this commit.
fn adversary() -> anyhow::Result<Outcome> {
    // The first digits of the commit; 0 without a history.
    let commit = cargo::git(&["rev-parse", "HEAD"]).unwrap_or_default();
    let seed = commit.get(..8).and_then(|digits| u64::from_str_radix(digits, 16).ok());
    let seed = seed.unwrap_or(0).to_string();
    let example = ["run", "--release", "--package", "carom-laws", "--example", "adversary"];
    let options = ["--", "--seconds", ADVERSARY, "--seed", &seed];
    passed(cargo::run(&[&example[..], &options[..]].concat()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_decide_by_their_folders() {
        let manifests = &["Cargo.toml", "crates/*/Cargo.toml"];
        assert!(is_among("crates/laws/Cargo.toml", manifests));
        assert!(is_among("Cargo.toml", manifests));
        assert!(!is_among("crates/laws/src/lib.rs", manifests));
        assert!(is_among("plugins/lammps/src/host.h", &["plugins"]));
        assert!(!is_among("docs/book/src/plugins.md", &["plugins"]));
    }
}
