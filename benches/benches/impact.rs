//! Cost of an impact: exact, from the table, and a map of it; of alike spheres and of dissimilar ones.

use std::hint::black_box;
use std::time::Duration;

use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::restitution::{
    DissimilarGroups, DissimilarTable, RestitutionTable, Sensitivity, of_dissimilar, of_spheres,
    restitution_map,
};
use carom_laws::friction::Friction;
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
    let cases = drawn();
    group.bench_function("R_x of drawn spheres (mean of 1024)", |b| {
        let mut next = 0;
        b.iter(|| {
            next = (next + 1) % cases.len();
            ObliqueImpact::new(black_box(cases[next])).map(|impact| impact.restitution())
        });
    });
    group.bench_function("R_x of drawn spheres with derivatives (mean of 1024)", |b| {
        let mut next = 0;
        b.iter(|| {
            next = (next + 1) % cases.len();
            Sensitivity::of(black_box(cases[next]))
        });
    });
    group.finish();
}

/// Solid spheres of kappa and lambda that do not slide throughout.
fn drawn() -> Vec<Groups> {
    let part = |i: u32, step: f64| (f64::from(i) * step).fract();
    let spheres = |i: u32| {
        let kappa = 0.8 + 0.7 * part(i, 0.618_034);
        Groups::of_spheres(kappa, (7.0 - kappa) * part(i, 0.754_878)).expect("in range")
    };
    (1..=1024).map(spheres).collect()
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

/// Solid spheres of kappa, gamma, f and lambda all over the table, so that its entries come from all its memory.
fn dissimilar_spheres() -> Vec<(DissimilarGroups, [f64; 2])> {
    let part = |i: usize, step: f64| (i as f64 * step).fract();
    let spheres = |i: usize| {
        // Parts of the golden ratio and its like do not repeat.
        let (kappa, lambda) = (1.0 + 0.45 * part(i, 0.618_034), 7.9 * part(i, 0.754_878));
        let gamma = (1.5 - kappa) * (0.1 + 0.9 * part(i, 0.569_840));
        let friction = Friction::new((gamma / 10.0).max(0.9 * part(i, 0.819_173)));
        let friction = friction.expect("in range");
        let groups = DissimilarGroups::of_spheres(kappa, gamma, friction, lambda);
        (groups.expect("in range"), [kappa, lambda])
    };
    (1..=1024).map(spheres).collect()
}

fn dissimilar(c: &mut Criterion) {
    let table = DissimilarTable::shared();
    let spheres = dissimilar_spheres();
    assert!(spheres.iter().all(|(groups, _)| table.stored(groups).is_some()), "all in the table");
    let mut group = c.benchmark_group("restitution of dissimilar spheres");
    let mut next = 0;
    let mut turn = || {
        next = (next + 1) % spheres.len();
        black_box(spheres[next])
    };
    group.bench_function("table, one R_x (mean of 1024)", |b| {
        b.iter(|| table.restitution(&turn().0));
    });
    group.bench_function("exact, one R_x of alike spheres (mean of 1024)", |b| {
        b.iter(|| {
            let [kappa, lambda] = turn().1;
            of_spheres(kappa, lambda)
        });
    });
    group.sample_size(10);
    group.bench_function("rings, one R_x (mean of 1024)", |b| {
        b.iter(|| of_dissimilar(&turn().0, 1e-2));
    });
    group.finish();
}

criterion_group!(benches, exact, table, dissimilar);
criterion_main!(benches);
