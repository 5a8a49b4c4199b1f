//! Cost of the law of rings: a small and a large step beside a step of Coulomb's law, a new pair of materials, and
//! an impact beside the analytic one.

use std::hint::black_box;
use std::time::Duration;

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, RingImpact};
use carom_laws::coulomb::{CoulombMemory, FixedCurve, Tolerance as CurveTolerance};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, Shift};
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};

const PATHS: usize = 12;
const FRICTION: f64 = 0.1;
/// The tangential compliance over the normal one.
const KAPPA: f64 = 1.2;

/// A smooth path at an approach about 1; shifts over f.
fn path(number: usize, steps: usize) -> Vec<[f64; 4]> {
    let phase = number as f64;
    (0..steps)
        .map(|step| {
            let t = 16.0 * step as f64 / steps as f64;
            let x = 0.55 * (0.7 * t + 2.0 * phase).sin() + 0.2 * (1.9 * t + phase).cos();
            let y = 0.45 * (0.6 * t + 3.0 * phase).cos() + 0.2 * (1.7 * t + phase).sin();
            [1.0 + 0.3 * (t + phase).sin(), x, y, 0.6 * (0.9 * t + phase).sin()]
        })
        .collect()
}

fn shifts(steps: usize, twist: f64) -> Vec<Vec<Shift>> {
    let shift = |[zeta, x, y, turn]: [f64; 4]| Shift {
        zeta,
        xi: FRICTION * x,
        eta: FRICTION * y,
        omega: FRICTION * twist * turn,
    };
    (0..PATHS).map(|number| path(number, steps).into_iter().map(shift).collect()).collect()
}

fn law(gamma: f64) -> Result<RingLaw, Box<dyn std::error::Error>> {
    let constants = RingConstants { c_z: 4.0, radius: 1.0, kappa: KAPPA, gamma };
    Ok(RingLaw::from_constants(constants, Friction::new(FRICTION)?, Tolerance::PARTICLES)?)
}

fn timed<'a>(c: &'a mut Criterion, name: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = c.benchmark_group(name);
    group
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(2));
    group
}

fn steps(c: &mut Criterion) {
    let Ok(fresh) = law(0.2) else { return };
    let mut group = timed(c, "step");
    for (name, steps) in [("large", 100), ("small", 800)] {
        group.throughput(Throughput::Elements((PATHS * steps) as u64));
        for (kind, twist) in [("shift", 0.0), ("shift and twist", 1.0)] {
            let paths = shifts(steps, twist);
            group.bench_function(format!("rings, {name}, {kind}"), |b| {
                b.iter(|| {
                    let mut sum = 0.0;
                    for path in black_box(&paths) {
                        let mut law = fresh.clone();
                        for &shift in path {
                            sum += law.advance(shift).map_or(0.0, |load| load.f_x);
                        }
                    }
                    sum
                });
            });
        }
        let paths: Vec<Vec<[f64; 4]>> = (0..PATHS).map(|number| path(number, steps)).collect();
        group.bench_function(format!("Coulomb's law alone, {name}"), |b| {
            b.iter(|| {
                let mut sum = 0.0;
                for path in black_box(&paths) {
                    let mut memory = CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], 12>>::new(
                        CurveTolerance::PARTICLES,
                    );
                    for &[zeta, x, y, _] in path {
                        sum += memory.advance(zeta, [x, y]).map_or(0.0, |force| force[0]);
                    }
                }
                sum
            });
        });
    }
    group.finish();
}

fn pairs(c: &mut Criterion) {
    let mut group = timed(c, "pair");
    let mut next = 0_u32;
    group.bench_function("a new pair of materials", |b| {
        b.iter(|| {
            next += 1;
            law(0.1 + 1e-7 * f64::from(next)).map(|law| law.load().f_z)
        });
    });
    group.finish();
}

/// A ball of alumina on glass at an angle from the normal.
fn collision(degrees: f64) -> Result<Collision, Box<dyn std::error::Error>> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let ball = Body::sphere(2.5e-3, Material::from_young(380e9, 0.23)?, 2.6e-4)?
        .moving(Motion::new([sine, 0.0, -cosine], [0.0; 3])?);
    let plate = Body::plane(Material::from_young(70e9, 0.22)?);
    Ok(Collision::new(ball, plate, Friction::new(0.092)?)?)
}

fn impacts(c: &mut Criterion) {
    let angles = [5.0, 20.0, 40.0, 80.0];
    let Ok(collisions) = angles.map(collision).into_iter().collect::<Result<Vec<_>, _>>() else {
        return;
    };
    let mut group = timed(c, "impact of alumina on glass, mean of four angles");
    group.throughput(Throughput::Elements(angles.len() as u64));
    group.bench_function("rings", |b| {
        b.iter(|| {
            collisions.iter().map(|at| RingImpact::new(at).solve().is_ok()).filter(|ok| *ok).count()
        });
    });
    group.bench_function("analytic, coupling neglected", |b| {
        b.iter(|| collisions.iter().map(|at| at.solve().is_ok()).filter(|ok| *ok).count());
    });
    group.finish();
}

criterion_group!(benches, steps, pairs, impacts);
criterion_main!(benches);
