//! Cost of one torsional impact, in adhesion, partial slip and sliding.

use std::hint::black_box;

use carom_impact::torsional::{TorsionalGroups, TorsionalImpact, limits};
use criterion::{Criterion, criterion_group, criterion_main};

fn torsional(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("torsional impact");
    for omega in [0.01, 0.3, 1.0, 5.0, 100.0] {
        let groups = TorsionalGroups::new(0.0625, omega).expect("in range");
        group.bench_function(format!("Omega = {omega}"), |bench| {
            bench.iter(|| TorsionalImpact::new(black_box(groups)));
        });
    }
    group.bench_function("limit of small spin", |bench| {
        bench.iter(|| limits::no_slip(black_box(0.0625)));
    });
    group.finish();
}

criterion_group!(benches, torsional);
criterion_main!(benches);
