//! Cost of a flange, and of the steps of Newton's method for a bellows.

use std::hint::black_box;

use carom_shells::Wall;
use carom_shells::bellows::{Axial, Bellows, BellowsLoad, Meridian};
use carom_shells::flange::{Flange, Ring, RingForce, RingStiffness, StiffnessKind, Tube, TubeEdge};
use carom_shells::fourier::Sector;
use criterion::{Criterion, criterion_group, criterion_main};

fn bellows(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("bellows");
    let meridians = [
        ("sine", Meridian::sine(10.0, 1.0, 3.0).expect("in range")),
        ("u-shaped", Meridian::u_shaped(10.0, 0.5, 1.0).expect("in range")),
    ];
    for (name, meridian) in meridians {
        let wall = Wall::new(1.0, 0.3, 0.1).expect("in range");
        let bellows = Bellows::new(meridian, wall, 64).expect("in range");
        let load = BellowsLoad::new(0.0, Axial::Dilatation(0.2)).expect("in range");
        let state = bellows.solve(load).expect("converges");
        // One step finds the linear solution, one more the tangent at the end.
        let steps = state.convergence().iterations + 2;
        group.bench_function(format!("{name}, 64 harmonics, {steps} steps"), |bench| {
            bench.iter(|| bellows.solve(black_box(load)));
        });
    }
    group.finish();
}

fn flange(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("flange");
    group.sample_size(10);
    let section = RingStiffness::rectangle(1.0, 0.3, 0.08, 0.1).expect("in range");
    let ring = Ring::new(1.0, section).expect("in range");
    let hole = Sector::new(0.0, 0.1, 0.5).expect("in range");
    let bored = ring.clone().with_sectors(StiffnessKind::InPlane, &[hole]).expect("in range");
    let tube = Tube::koiter_sanders(1.0, Wall::new(1.0, 0.3, 0.02).expect("in range"));
    let tube = tube.expect("in range");
    let pinch = RingForce::pinch(1.0).expect("finite");
    for (name, ring) in [("uniform", ring), ("with a hole", bored)] {
        let flange = Flange::on_tube(ring, tube, TubeEdge::at_centroid()).expect("in range");
        group.bench_function(format!("{name}, 64 harmonics"), |bench| {
            bench.iter(|| flange.solve(black_box(&pinch), 64));
        });
    }
    group.finish();
}

criterion_group!(benches, bellows, flange);
criterion_main!(benches);
