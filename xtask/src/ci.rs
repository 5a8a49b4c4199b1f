//! The steps of continuous integration.

use crate::cargo::Lints;
use crate::outcome::Outcome;
use crate::{
    book, browse, cargo, changes, deny, doors, fuzz, install_c, instructions, lammps, mutants,
    python, release, sanitize, sdist, taplo, test, tidy,
};
use anyhow::Context as _;
use std::process::Command;
use std::time::Instant;

type Step = fn() -> anyhow::Result<Outcome>;

/// Duration of the search for a path with a large error of Coulomb's law, in seconds.
const ADVERSARY: &str = "60";

/// Steps that every change must pass, each test once. Cargo lints and documents what they compile, as [`Lints`] says.
const STEPS: &[(&str, Step)] = &[
    ("form", form),
    ("index of equations, places of mutants, descriptions of packages", || passed(tidy::run())),
    ("tests, with lints, documentation and its examples", || passed(test::run())),
    ("quick figures", quick_figures),
];

/// Steps beside these: they fetch packages and hardly compute.
const FETCHED: &[(&str, Step)] = &[("the packages of the tests in Python", python::packages)];

/// The same for steps of [`WHERE_CHANGED`].
const FETCHED_WHERE_CHANGED: &[Changed] =
    &[(LAMMPS, "the pinned release of LAMMPS", lammps::packages)];

/// The steps after these.
const AFTER: &[(&str, Step)] = &[("the Python module", python::install)];

/// The steps that every change must pass after those of [`WHERE_CHANGED`].
const LAST: &[(&str, Step)] = &[("the report in a browser", browse::run)];

/// The steps that every change must pass beside these, each busy on one core.
const BESIDE: &[(&str, Step)] = &[("the tests of the Python module", python::test)];

/// Paths of the manifests of all packages.
const MANIFESTS: &[&str] = &["Cargo.toml", "Cargo.lock", "deny.toml", "crates/*/Cargo.toml"];

/// What the LAMMPS plugin is built of.
const LAMMPS: &[&str] = &[
    "plugins",
    "crates/*/Cargo.toml",
    "crates/capi/include",
    "crates/capi/src",
    "crates/laws/src",
    "crates/halfspace/src",
    "crates/special/src",
    "crates/geometry/src",
    "crates/impact/src",
];

/// A step that runs if one of these paths changed, and in every long run.
type Changed = (&'static [&'static str], &'static str, Step);

/// Those that use no program of this workspace: after the tests of the Python module.
const BESIDE_WHERE_CHANGED: &[Changed] = &[
    (
        &["Cargo.toml", "benches", "crates/*/Cargo.toml", "crates/*/src"],
        "lints of the benches",
        lints,
    ),
    (
        &[
            "Cargo.toml",
            "crates/*/Cargo.toml",
            "crates/halfspace/src",
            "crates/laws/src",
            "crates/impact/src",
        ],
        "half-space and impacts without threads and operators",
        || passed(without_threads(&[""])),
    ),
    (MANIFESTS, "licences, sources and advisories of the dependencies", deny::run),
    (MANIFESTS, "packages", || passed(release::pack_quickly())),
    (&["docs"], "the book", book::run),
];

/// Those that build it in other ways.
const WHERE_CHANGED: &[Changed] = &[
    (
        &["doors/carom-rebound", "crates/impact/src/restitution/table"],
        "the JavaScript module of the rebound",
        doors::rebound,
    ),
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
    (LAMMPS, "the LAMMPS plugin, in the pinned release", || lammps::run(true)),
];

/// Additional steps of a long run, before a release and on request.
const LONG: &[(&str, Step)] = &[
    ("lints of the benches", lints),
    ("documentation of all packages", documentation),
    ("tests with overflow checks and debug assertions", || passed(test::checked())),
    ("the tests that are ignored otherwise", || passed(test::ignored())),
    ("licences, sources and advisories of the dependencies", deny::run),
    ("packages", || passed(release::pack_quickly())),
    ("the book", book::run),
    ("the LAMMPS plugin, in the pinned release, all tests", || lammps::run(false)),
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
    ("mutants, each against all tests and pages, those of Python and LAMMPS too", mutants::all),
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
    let mut fetched = FETCHED.to_vec();
    let (mut beside, mut building) = (BESIDE.to_vec(), Vec::new());
    if !is_long {
        let paths = changes::paths()?;
        fetched.extend(changed(FETCHED_WHERE_CHANGED, &paths));
        beside.extend(changed(BESIDE_WHERE_CHANGED, &paths));
        building = changed(WHERE_CHANGED, &paths);
    }
    building.extend(LAST);
    let lints = Lints::with_builds();
    let mut skipped = both(&fetched, STEPS)? + all(AFTER)? + both(&beside, &building)?;
    drop(lints);
    let mut count = fetched.len() + STEPS.len() + AFTER.len() + beside.len() + building.len();
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
    let others = others.map_err(|_| anyhow::anyhow!("a step panicked"))?;
    Ok(ours? + others?)
}

/// Runs steps one after the other, and counts the parts that they skip.
fn all(steps: &[(&str, Step)]) -> anyhow::Result<usize> {
    let mut skipped = 0;
    for (name, step) in steps {
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
        skipped += count;
    }
    Ok(skipped)
}

fn passed(result: anyhow::Result<()>) -> anyhow::Result<Outcome> {
    result.map(|()| Outcome::Passed)
}

/// Prints the seeds of failed property tests, so that they can be committed from a temporary
/// machine.
fn print_new_regressions() {
    let root = crate::root::root();
    let git = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).current_dir(&root).output();
        output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let pattern = "*/proptest-regressions/*.txt";
    let all = ["ls-files", "--modified", "--others", "--exclude-standard", "--", pattern];
    for path in git(&all).unwrap_or_default().lines() {
        if let Ok(text) = std::fs::read_to_string(root.join(path)) {
            println!("== commit these seeds as {path}:\n{text}");
        }
    }
}

fn form() -> anyhow::Result<Outcome> {
    passed(cargo::run(&["fmt", "--all", "--check"]))
}

/// Lints the benches, the only package without tests.
fn lints() -> anyhow::Result<Outcome> {
    let benches = ["clippy", "--package", "carom-benches", "--all-targets", "--release"];
    passed(cargo::run(&[&benches[..], &["--", "-D", "warnings"]].concat()))
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

fn quick_figures() -> anyhow::Result<Outcome> {
    passed(cargo::run_built("--bin", "carom-verify", &["--quick"]))
}

/// Searches for a path whose error exceeds the estimate of the law, with a seed from this commit.
fn adversary() -> anyhow::Result<Outcome> {
    let seed = mutants::seed_of_commit(&crate::root::root()).to_string();
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
