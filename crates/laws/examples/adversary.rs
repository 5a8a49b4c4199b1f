//! A search for paths on which the error of Coulomb's law in two directions exceeds its estimate.
//!
//! A hill climb over paths of approach and shift: points of the worst path so far are moved, added,
//! removed or repeated, and a change is kept if it increases the error of the last force over
//! `CoulombMemory::error_estimate`. The reference force is that of independent sliders, advanced in small
//! steps along the whole path; they share no code with the law.
//!
//! `cargo run --release -p carom-laws --example adversary -- --seconds 60 --seed 1` visits the
//! tolerances 1e-2, 1e-3 and 1e-5 in storage that grows and in 8, 12, 16 and 32 vertices in turn;
//! `--tolerance 1e-3` and `--vertices 12` (or `growing`) keep to one. It prints the worst path of each
//! and fails when an error exceeds its estimate.

#[allow(dead_code)] // the tests use the rest
#[path = "../tests/it/common/rings.rs"]
mod rings;

use std::process::ExitCode;
use std::time::{Duration, Instant};

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::{Fixed, VertexStack};

type Point = (f64, [f64; 2]);

/// Number of sliders that confirm a result.
const CONFIRMING: usize = 40_000;
/// The error of the reference over the limit, times the square of the number of sliders.
const ORACLE: f64 = 2.0;
/// Number of changes without improvement after which a climb restarts.
const PATIENCE: u32 = 1500;

/// The result of a path: the error of the law over its limit, the law's own estimate, and the error over
/// the estimate.
#[derive(Debug, Clone, Copy, Default)]
struct Finding {
    error: f64,
    estimate: f64,
    ratio: f64,
}

fn try_path<S: VertexStack<[f64; 2]>>(
    path: &[Point],
    tolerance: Tolerance,
    count: usize,
) -> Finding {
    let mut law = CoulombMemory::<[f64; 2], S::Curve>::new(tolerance);
    for &(zeta, x) in path {
        if law.advance(zeta, x).is_err() {
            return Finding::default();
        }
    }
    let limit = law.normal_force();
    let (got, want) = (law.force(), rings::force_at_end(path, count));
    let error = (got[0] / limit - want[0]).hypot(got[1] / limit - want[1]);
    let estimate = law.error_estimate();
    let seen = error - ORACLE / (count * count) as f64;
    Finding { error, estimate, ratio: seen / estimate }
}

fn random_path(random: &mut Splitmix) -> Vec<Point> {
    let mut path = vec![(random.between(0.1, 1.5), [0.0; 2])];
    for _ in 0..2 + random.below(12) {
        let at = random.below(path.len() + 1);
        insert(&mut path, at, random);
    }
    path
}

/// A point beside another: in all directions, along the cone, along the last step, or back.
fn near(path: &[Point], at: usize, random: &mut Splitmix) -> Point {
    let (zeta, x) = path[at];
    let size = 10_f64.powf(random.between(-4.0, 0.2));
    let angle = random.between(0.0, std::f64::consts::TAU);
    let moved = [x[0] + size * angle.cos(), x[1] + size * angle.sin()];
    let (old, other) = path[random.below(path.len())];
    match random.below(8) {
        0 => (zeta, moved),
        1 => (zeta + size * random.between(-1.0, 1.0), x),
        2 => (zeta + size * (1.0 + 1e-2 * random.between(-1.0, 1.0)), moved),
        3 => (zeta - size, moved),
        4 => (zeta, other),
        5 => (old, x),
        6 => {
            let part = random.between(-1.0, 2.0);
            let mix = |a: f64, b: f64| a + part * (b - a);
            (mix(zeta, old), [mix(x[0], other[0]), mix(x[1], other[1])])
        }
        _ => (zeta + size * random.between(-1.0, 1.0), moved),
    }
}

fn within((zeta, x): Point) -> Point {
    (zeta.clamp(1e-3, 1.5), x.map(|x| x.clamp(-1.5, 1.5)))
}

fn insert(path: &mut Vec<Point>, at: usize, random: &mut Splitmix) {
    let point = near(path, at.min(path.len() - 1), random);
    path.insert(at, within(point));
}

fn mutated(path: &[Point], random: &mut Splitmix) -> Vec<Point> {
    let mut path = path.to_vec();
    for _ in 0..1 + random.below(2) {
        let at = random.below(path.len());
        match random.below(10) {
            0 if path.len() < 24 => insert(&mut path, at + 1, random),
            1 if path.len() > 2 => {
                path.remove(at);
            }
            2 if path.len() > 2 => path.truncate(at.max(2)),
            3 => {
                let by = random.between(0.8, 1.25);
                let point = path[at];
                path[at] = within((point.0 * by, point.1));
            }
            4 => {
                // All later points move with it.
                let (from, to) = (path[at], within(near(&path, at, random)));
                for (zeta, x) in &mut path[at..] {
                    let moved = (*zeta + to.0 - from.0, [0, 1].map(|k| x[k] + to.1[k] - from.1[k]));
                    (*zeta, *x) = within(moved);
                }
            }
            _ => {
                let point = near(&path, at, random);
                path[at] = within(point);
            }
        }
    }
    path
}

/// The worst path found within the time, and its result.
fn climb<S: VertexStack<[f64; 2]>>(
    tolerance: Tolerance,
    time: Duration,
    random: &mut Splitmix,
) -> (Finding, Vec<Point>, u64) {
    let start = Instant::now();
    let (mut worst, mut tried) = ((Finding::default(), Vec::new()), 0);
    let rings = ((ORACLE / (0.01 * tolerance.get())).sqrt() as usize).clamp(200, 3000);
    while start.elapsed() < time {
        let mut path = random_path(random);
        let mut best = try_path::<S>(&path, tolerance, rings);
        let mut idle = 0;
        while idle < PATIENCE && start.elapsed() < time {
            let other = mutated(&path, random);
            let mut found = try_path::<S>(&other, tolerance, rings);
            tried += 1;
            if found.ratio > 1.0 && found.ratio > worst.0.ratio {
                found = try_path::<S>(&other, tolerance, CONFIRMING);
            }
            if found.ratio > best.ratio {
                (path, best, idle) = (other, found, 0);
            } else {
                idle += 1;
            }
        }
        if best.ratio > worst.0.ratio {
            worst = (best, path);
        }
    }
    (worst.0, worst.1, tried)
}

/// The value of an argument.
fn argument(name: &str) -> Option<String> {
    let mut arguments = std::env::args();
    arguments.find(|argument| argument == name)?;
    arguments.next()
}

/// The largest allowed ratio of error to estimate.
const STATED: f64 = 1.0;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let number = |name: &str, or: f64| argument(name).map_or(Ok(or), |value| value.parse::<f64>());
    let (seconds, seed) = (number("--seconds", 60.0)?, number("--seed", 1.0)?);
    let tolerances = match argument("--tolerance") {
        Some(value) => vec![value.parse::<f64>()?],
        None => vec![1e-2, 1e-3, 1e-5],
    };
    let storage = match argument("--vertices") {
        Some(value) => vec![value],
        None => ["growing", "8", "12", "16", "32"].map(String::from).to_vec(),
    };
    let mut random = Splitmix(seed as u64);
    let time = Duration::from_secs_f64(seconds / (tolerances.len() * storage.len()) as f64);
    let mut holds = true;
    for storage in &storage {
        for &tolerance in &tolerances {
            let allowed = Tolerance::new(tolerance)?;
            let climb = match storage.as_str() {
                "growing" => climb::<carom_laws::memory::Growing<[f64; 2]>>,
                "8" => climb::<Fixed<[f64; 2], 8>>,
                "12" => climb::<Fixed<[f64; 2], 12>>,
                "16" => climb::<Fixed<[f64; 2], 16>>,
                "32" => climb::<Fixed<[f64; 2], 32>>,
                _ => return Err("--vertices: growing, 8, 12, 16 or 32".into()),
            };
            let (worst, path, tried) = climb(allowed, time, &mut random);
            let Finding { error, estimate, ratio } = worst;
            println!(
                "{storage} at {tolerance:e}: error {error:.2e}, estimate {estimate:.2e}, ratio {ratio:.2} \
                 ({tried} paths)"
            );
            println!("  {path:?}");
            holds &= ratio <= STATED;
        }
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
