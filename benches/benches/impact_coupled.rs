//! Cost of coupled oblique impacts, from the velocities before to those after, one thread.
//!
//! Planar: an ellipsoid in a plane of symmetry on a plane, law of one direction, converged to 1e-8
//! of |v_A| (the default) and to 1e-5. Spatial: the same upright with a turning direction, the
//! law of fixed directions converged to 1e-8 and to 5e-6 (the default), Coulomb's vector law to 5e-6
//! (the default) and to 1e-4. Turning: Coulomb's law to 1e-3 .. 1e-7, by the curve of `laws::coulomb`
//! (the default where c_x = c_y) and by the line of anchors.

use std::hint::black_box;

use carom_impact::Mobility;
use carom_impact::coupled::{CoupledImpact, TurningLaw};
use carom_laws::friction::Friction;
use carom_laws::sliders::SlipLines;
use carom_laws::stiffness::ContactStiffness;
use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix3, Vector3};

fn impact(d: Matrix3<f64>, c: [f64; 3], friction: f64, velocity: [f64; 3]) -> CoupledImpact {
    let stiffness = ContactStiffness::new(c[0], c[1], c[2]).expect("positive");
    let mobility = Mobility::from_matrix(d).expect("positive definite");
    let friction = Friction::new(friction).expect("positive");
    CoupledImpact::new(mobility, stiffness, friction, velocity.into()).expect("approaching")
}

fn planar() -> CoupledImpact {
    let d = Matrix3::new(12.67, 0.0, 0.0, 0.0, 9.292, 4.39, 0.0, 4.39, 6.637);
    impact(d, [28.7e9, 28.3e9, 34.6e9], 0.2, [0.0, 0.5, 2.0])
}

fn spatial() -> CoupledImpact {
    let d = Matrix3::from_diagonal(&Vector3::new(9.461, 6.758, 3.379));
    impact(d, [39.1e9, 37.3e9, 46.3e9], 0.5, [0.6, 0.4, 2.0])
}

fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("coupled impact");
    let mut run = |name: &str, law: TurningLaw, tolerance: f64, impact: CoupledImpact| {
        let impact = impact.within(tolerance).expect("positive");
        group.bench_function(format!("{name}, {tolerance:e}"), |bencher| {
            bencher.iter(|| black_box(impact).solve(law).expect("separates"));
        });
    };
    let (coulomb, fixed) = (TurningLaw::Coulomb, TurningLaw::FixedDirection);
    run("planar", coulomb, 1e-8, planar());
    run("planar", coulomb, 1e-5, planar());
    run("spatial, fixed direction", fixed, 1e-8, spatial());
    run("spatial, fixed direction", fixed, 5e-6, spatial());
    run("spatial, Coulomb", coulomb, 5e-6, spatial());
    run("spatial, Coulomb", coulomb, 1e-4, spatial());
}

/// Two oblique impacts with a turning direction, for a contact with c_x = c_y.
fn turning() -> [(CoupledImpact, f64); 2] {
    let d = Matrix3::new(2.9, 0.3, 0.5, 0.3, 2.4, -0.4, 0.5, -0.4, 1.3);
    [(0.2, [1.1, 0.4, 1.0]), (0.6, [0.3, -0.5, 1.0])]
        .map(|(f, velocity)| (impact(d, [0.85, 0.85, 1.0], f, velocity), f))
}

/// The error of a line of anchors decreases with the cube of the resolution.
fn line(friction: f64, resolution: usize) -> SlipLines {
    let stiffness = ContactStiffness::new(0.85, 0.85, 1.0).expect("positive");
    SlipLines::new(stiffness, friction, 0.75)
        .expect("positive")
        .refined(resolution.saturating_pow(3))
}

fn turning_impacts(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("turning impact");
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let impacts = turning().map(|(impact, f)| (impact.within(tolerance).expect("positive"), f));
        group.bench_function(format!("curve, {tolerance:e}"), |bencher| {
            bencher.iter(|| {
                black_box(&impacts)
                    .each_ref()
                    .map(|(impact, _)| impact.solve(TurningLaw::Coulomb).expect("separates"))
            });
        });
        group.bench_function(format!("line, {tolerance:e}"), |bencher| {
            bencher.iter(|| {
                black_box(&impacts)
                    .each_ref()
                    .map(|(impact, f)| impact.solve_with(|n| line(*f, n)).expect("separates"))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, bench, turning_impacts);
criterion_main!(benches);
