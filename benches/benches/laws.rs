//! Cost of a contact step: 10 000 contacts times 200 steps, one thread.
//!
//! Each law runs contact by contact (all steps of one contact, then the next) and step by step
//! (one step of every contact, then the next), on smooth paths and with a reversal at every other
//! step. The throughput counts contact steps.

use std::hint::black_box;
use std::time::Duration;

use carom_laws::accounted::Accounted;
use carom_laws::coulomb::{CoulombMemory, FixedCurve, Tolerance};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::memory::{Fixed, Growing, Lateral, Memory, VertexStack};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::history::TwistHistory;
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};

const CONTACTS: usize = 10_000;
const STEPS: usize = 200;
/// Different paths, shared by the contacts.
const PATHS: usize = 97;

type Path<V> = Vec<(f64, V)>;

fn smooth(path: usize) -> Path<[f64; 2]> {
    let phase = path as f64;
    (0..STEPS)
        .map(|step| {
            let t = 0.08 * step as f64;
            let zeta = 1.0 + 0.3 * (t + phase).sin();
            let x = 0.55 * (0.7 * t + 2.0 * phase).sin() + 0.2 * (1.9 * t + phase).cos();
            let y = 0.45 * (0.6 * t + 3.0 * phase).cos() + 0.2 * (1.7 * t + phase).sin();
            (zeta, [x, y])
        })
        .collect()
}

fn reversing(path: usize) -> Path<[f64; 2]> {
    let mut path = smooth(path);
    for (step, (_, x)) in path.iter_mut().enumerate() {
        let kick = if step / 2 % 2 == 0 { 0.06 } else { -0.06 };
        *x = [x[0] + kick, x[1] - 0.5 * kick];
    }
    path
}

fn paths<V: Lateral>(make: fn(usize) -> Path<[f64; 2]>) -> Vec<Path<V>> {
    (0..PATHS)
        .map(|i| make(i).into_iter().map(|(z, x)| (z, V::from_components(x))).collect())
        .collect()
}

fn contact_by_contact<V: Lateral, S: VertexStack<V>>(paths: &[Path<V>]) -> V {
    let mut sum = V::default();
    for contact in 0..CONTACTS {
        let mut memory = Memory::<V, S>::new();
        for &(zeta, x) in &paths[contact % PATHS] {
            if let Ok(force) = memory.advance(zeta, x) {
                sum = sum.plus(force);
            }
        }
    }
    sum
}

#[expect(clippy::needless_range_loop, reason = "every contact takes a step before the next")]
fn step_by_step<V: Lateral, S: VertexStack<V>>(
    memories: &mut [Memory<V, S>],
    paths: &[Path<V>],
) -> V {
    let mut sum = V::default();
    for step in 0..STEPS {
        for (contact, memory) in memories.iter_mut().enumerate() {
            let (zeta, x) = paths[contact % PATHS][step];
            if let Ok(force) = memory.advance(zeta, x) {
                sum = sum.plus(force);
            }
        }
    }
    sum
}

fn law<V: Lateral, S: VertexStack<V>>(c: &mut Criterion, name: &str) {
    let mut group = c.benchmark_group(name);
    group
        .throughput(Throughput::Elements((CONTACTS * STEPS) as u64))
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    for (kind, make) in [("smooth", smooth as fn(usize) -> _), ("reversing", reversing)] {
        let paths = paths::<V>(make);
        group.bench_function(format!("{kind}/contact by contact"), |b| {
            b.iter(|| contact_by_contact::<V, S>(black_box(&paths)));
        });
        let mut memories = vec![Memory::<V, S>::new(); CONTACTS];
        group.bench_function(format!("{kind}/step by step"), |b| {
            b.iter(|| step_by_step(&mut memories, black_box(&paths)));
        });
    }
    group.finish();
}

/// A law in SI units on the paths of the memories, which it converts to normalised shifts.
fn shift_law<V: Lateral, S: VertexStack<V>>() -> ShiftLaw<V, S> {
    let stiffness = ContactStiffness { c_x: 2e9, c_y: 2e9, c_z: 2.5e9 };
    ShiftLaw::new(stiffness, Friction::new(0.3).unwrap_or(Friction::NONE))
}

fn in_si_units<V: Lateral>(paths: &[Path<V>]) -> Vec<Vec<Shift>> {
    let (length, per_shift) = (1e-6, 0.3 * 2.5e9 / 2e9);
    let shift = |&(zeta, x): &(f64, V)| {
        let [xi, eta] = x.times(length * per_shift).components();
        Shift { zeta: length * zeta, xi, eta, omega: 0.0 }
    };
    paths.iter().map(|path| path.iter().map(shift).collect()).collect()
}

fn laws_contact_by_contact<L: ContactLaw>(fresh: &L, paths: &[Vec<Shift>]) -> f64 {
    let mut sum = 0.0;
    for contact in 0..CONTACTS {
        let mut law = fresh.clone();
        for &shift in &paths[contact % PATHS] {
            if let Ok(load) = law.advance(shift) {
                sum += load.f_x + load.f_y + load.f_z;
            }
        }
    }
    sum
}

/// The memory and the law in SI units on the same paths, contact by contact.
fn against_memory<V: Lateral + Send + Sync, S: VertexStack<V> + Send + Sync>(
    c: &mut Criterion,
    name: &str,
) {
    let mut group = c.benchmark_group(name);
    group
        .throughput(Throughput::Elements((CONTACTS * STEPS) as u64))
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    let normalised = paths::<V>(smooth);
    let shifts = in_si_units(&normalised);
    group.bench_function("memory", |b| {
        b.iter(|| contact_by_contact::<V, S>(black_box(&normalised)));
    });
    let law = shift_law::<V, S>();
    group.bench_function("law", |b| {
        b.iter(|| laws_contact_by_contact(&law, black_box(&shifts)));
    });
    let mut memories = vec![Memory::<V, S>::new(); CONTACTS];
    group.bench_function("memory, step by step", |b| {
        b.iter(|| step_by_step(&mut memories, black_box(&normalised)));
    });
    group.throughput(Throughput::Elements((PATHS * STEPS) as u64));
    let accounted = Accounted::new(law);
    group.bench_function("law with heat", |b| {
        b.iter(|| {
            let mut sum = 0.0;
            for path in black_box(&shifts) {
                let mut law = accounted.clone();
                for &shift in path {
                    sum += law.advance(shift).map_or(0.0, |load| load.f_x);
                }
            }
            sum
        });
    });
    group.finish();
}

/// An oscillating twist, at constant load and with an oscillating load, as radius and twist.
fn twists(depth: f64) -> Vec<Path<f64>> {
    (0..PATHS)
        .map(|path| {
            let phase = path as f64;
            (0..STEPS)
                .map(|step| {
                    let t = 0.08 * step as f64;
                    (1.0 + depth * (0.3 * t + phase).sin(), 0.7 * (t + 2.0 * phase).sin())
                })
                .collect()
        })
        .collect()
}

fn twist(c: &mut Criterion) {
    let mut group = c.benchmark_group("twist");
    group.throughput(Throughput::Elements((CONTACTS * STEPS) as u64)).sample_size(10);
    for (name, depth) in [("constant load", 0.0), ("swinging load", 0.2)] {
        let paths = twists(depth);
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut sum = 0.0;
                for contact in 0..CONTACTS {
                    let mut history = TwistHistory::new();
                    for &(radius, twist) in &black_box(&paths)[contact % PATHS] {
                        sum += history.advance(radius, twist).unwrap_or(0.0);
                    }
                }
                sum
            });
        });
    }
    group.finish();
}

/// Paths that turn, and some straight ones.
fn turning_paths(kind: &str) -> Vec<Path<[f64; 2]>> {
    (0..PATHS)
        .map(|path| {
            let phase = path as f64;
            (0..STEPS)
                .map(|step| {
                    let (i, t) = (step as f64, 0.12 * step as f64);
                    let wander = |a: f64, b: f64| (a * t + phase).sin() + 0.5 * (b * t).cos();
                    let smooth = [0.6 * wander(1.3, 3.1), 0.6 * wander(1.7, 2.3)];
                    match kind {
                        "adhesion" => (0.01 * (i + 1.0), [0.004 * (i + t.sin()), 0.004 * i]),
                        "collinear" => (1.0 + 0.2 * t.sin(), [smooth[0], 0.5 * smooth[0]]),
                        "noise" => {
                            let tremble = |a: f64| 0.3 + 0.01 * (a * i + phase).sin();
                            (1.0 + 0.01 * (7.7 * i).sin(), [tremble(12.9), tremble(78.2)])
                        }
                        "corners" => {
                            let (leg, way) = ((i / 6.0).floor(), (i / 6.0).fract());
                            let corner = |leg: f64| {
                                let angle = 2.4 * leg + phase;
                                [0.5 * angle.cos() + 0.1 * leg, 0.5 * angle.sin()]
                            };
                            let (from, to) = (corner(leg), corner(leg + 1.0));
                            (1.0, [0, 1].map(|k| from[k] + way * (to[k] - from[k])))
                        }
                        "collision" => {
                            let fall = std::f64::consts::PI * (0.02 * i).fract();
                            (fall.sin() + 1e-3, smooth)
                        }
                        _ => (1.0, smooth),
                    }
                })
                .collect()
        })
        .collect()
}

/// Coulomb's law at several tolerances, the law of chapter 7, and that of one direction, which uses x only,
/// contact by contact.
fn turning(c: &mut Criterion) {
    for kind in ["adhesion", "collinear", "noise", "corners", "turning", "collision"] {
        let mut group = c.benchmark_group(format!("turning, {kind}"));
        group
            .throughput(Throughput::Elements((PATHS * STEPS) as u64))
            .sample_size(20)
            .warm_up_time(Duration::from_millis(200))
            .measurement_time(Duration::from_millis(600));
        let paths = turning_paths(kind);
        group.bench_function("one direction", |b| {
            b.iter(|| {
                let mut sum = 0.0;
                for path in black_box(&paths) {
                    let mut memory = Memory::<f64>::new();
                    for &(zeta, [x, _]) in path {
                        sum += memory.advance(zeta, x).unwrap_or_default();
                    }
                }
                sum
            });
        });
        group.bench_function("fixed-direction", |b| {
            b.iter(|| {
                let mut sum = [0.0; 2];
                for path in black_box(&paths) {
                    let mut memory = Memory::<[f64; 2]>::new();
                    for &(zeta, x) in path {
                        sum = sum.plus(memory.advance(zeta, x).unwrap_or_default());
                    }
                }
                sum
            });
        });
        for tolerance in [1e-2, 1e-3] {
            let Ok(allowed) = Tolerance::new(tolerance) else { continue };
            group.bench_function(format!("Coulomb, {tolerance:e}"), |b| {
                b.iter(|| {
                    let mut sum = [0.0; 2];
                    for path in black_box(&paths) {
                        let mut memory = CoulombMemory::<[f64; 2]>::new(allowed);
                        for &(zeta, x) in path {
                            sum = sum.plus(memory.advance(zeta, x).unwrap_or_default());
                        }
                    }
                    sum
                });
            });
        }
        group.finish();
    }
}

/// Each step in equal parts.
fn in_parts(path: &Path<[f64; 2]>, parts: usize) -> Path<[f64; 2]> {
    let steps = path.windows(2).flat_map(|ends| {
        let [(zeta, x), (to, end)] = [ends[0], ends[1]];
        (1..=parts).map(move |part| {
            let t = part as f64 / parts as f64;
            (zeta + t * (to - zeta), x.plus(end.minus(x).times(t)))
        })
    });
    path.first().copied().into_iter().chain(steps).collect()
}

fn in_storage<const N: usize>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    (size, paths): (&str, &[Path<[f64; 2]>]),
) {
    group.bench_function(format!("{size} steps, Coulomb, {N} vertices"), |b| {
        b.iter(|| {
            let mut sum = [0.0; 2];
            for path in black_box(paths) {
                let mut memory =
                    CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], N>>::new(Tolerance::PARTICLES);
                for &(zeta, x) in path {
                    sum = sum.plus(memory.advance(zeta, x).unwrap_or_default());
                }
            }
            sum
        });
    });
    group.bench_function(format!("{size} steps, fixed-direction, {N} vertices"), |b| {
        b.iter(|| {
            let mut sum = [0.0; 2];
            for path in black_box(paths) {
                let mut memory = Memory::<[f64; 2], Fixed<[f64; 2], N>>::new();
                for &(zeta, x) in path {
                    sum = sum.plus(memory.advance(zeta, x).unwrap_or_default());
                }
            }
            sum
        });
    });
}

/// Cost of fixed storage, in both laws, with whole steps and with each divided into 16.
fn capacity(c: &mut Criterion) {
    for kind in ["noise", "corners", "turning", "collision"] {
        let mut group = c.benchmark_group(format!("storage, {kind}"));
        group
            .sample_size(20)
            .warm_up_time(Duration::from_millis(200))
            .measurement_time(Duration::from_millis(600));
        let whole = turning_paths(kind);
        for (size, parts) in [("whole", 1), ("tiny", 16)] {
            let paths: Vec<_> = whole.iter().take(24).map(|path| in_parts(path, parts)).collect();
            let steps: usize = paths.iter().map(Vec::len).sum();
            group.throughput(Throughput::Elements(steps as u64));
            in_storage::<8>(&mut group, (size, &paths));
            in_storage::<12>(&mut group, (size, &paths));
            in_storage::<16>(&mut group, (size, &paths));
        }
        group.finish();
    }
}

fn benches(c: &mut Criterion) {
    turning(c);
    capacity(c);
    twist(c);
    against_memory::<f64, Growing<f64>>(c, "SI units, one direction");
    against_memory::<[f64; 2], Growing<[f64; 2]>>(c, "SI units, two directions");
    against_memory::<f64, Fixed<f64, 16>>(c, "SI units, one direction, 16 vertices");
    law::<f64, Growing<f64>>(c, "scalar, exact");
    law::<f64, Fixed<f64, 16>>(c, "scalar, 16 vertices");
    law::<[f64; 2], Growing<[f64; 2]>>(c, "vector, exact");
    law::<[f64; 2], Fixed<[f64; 2], 16>>(c, "vector, 16 vertices");
}

criterion_group!(group, benches);
criterion_main!(group);
