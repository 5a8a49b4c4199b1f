//! Cost of an impact: exact, from the table, and a map of it.

use std::hint::black_box;
use std::time::Duration;

use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::restitution::{RestitutionTable, restitution_map};
use criterion::{Criterion, criterion_group, criterion_main};

/// Spheres of Poisson's ratio 0.3 from grazing stick to sliding throughout.
const LAMBDAS: [f64; 8] = [0.2, 0.8, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5];

fn spheres() -> Vec<Groups> {
    let kappa = 1.7 / 1.4;
    LAMBDAS.iter().map(|&lambda| Groups::of_spheres(kappa, lambda).expect("in range")).collect()
}

fn exact(c: &mut Criterion) {
    let mut group = c.benchmark_group("oblique");
    group.measurement_time(Duration::from_secs(3));
    let figure = Groups::of_spheres(1.5, 3.0).expect("in range");
    group.bench_function("one impact (spheres, 1e-10)", |b| {
        b.iter(|| ObliqueImpact::new(black_box(figure)));
    });
    let cases = spheres();
    group.bench_function("eight impacts of spheres (nu = 0.3, 1e-10)", |b| {
        b.iter(|| {
            cases.iter().map(|&case| ObliqueImpact::new(black_box(case))).collect::<Vec<_>>()
        });
    });
    group.finish();
}

fn table(c: &mut Criterion) {
    let table = RestitutionTable::shared();
    let cases = spheres();
    let mut group = c.benchmark_group("restitution");
    group.bench_function("table, one R_x (mean of eight)", |b| {
        let mut next = 0;
        b.iter(|| {
            next = (next + 1) % cases.len();
            table.restitution(black_box(cases[next]))
        });
    });
    group.sample_size(10);
    let axis = |low: f64, high: f64| -> Vec<f64> {
        (0..200).map(|i| low + (high - low) * f64::from(i) / 199.0).collect()
    };
    let (chi, psi) = (axis(0.5, 6.5), axis(0.0, 8.0));
    group.bench_function("map of 200 x 200 at 1e-10", |b| {
        b.iter(|| restitution_map(&chi, &psi, |_| ()));
    });
    group.finish();
}

criterion_group!(benches, exact, table);
criterion_main!(benches);
