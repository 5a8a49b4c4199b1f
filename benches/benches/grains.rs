//! Cost of a step of the contact of two grains through the C interface: one by one, and many in a call; with a given
//! restitution and without.

use std::hint::black_box;
use std::ptr::{null, null_mut};

use carom_capi::{
    CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION, CaromEncounter, CaromGrain, CaromGrainLoad,
    CaromLaw, CaromLawOptions, CaromMaterial, CaromStatus, carom_law_make, carom_touch_size,
    carom_touch_step, carom_touch_step_many,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const PAIRS: usize = 64;
const STEPS: usize = 256;
const DT: f64 = 1e-6;

/// It lives as long as the process.
fn law(law: u32, restitution: f64) -> *const CaromLaw {
    let glass = CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
    let size = size_of::<CaromLawOptions>();
    let options = CaromLawOptions { size, law, restitution, ..CaromLawOptions::default() };
    let mut made = null_mut();
    // SAFETY: all pointers are references or null.
    let status =
        unsafe { carom_law_make(&glass, &glass, 0.3, &options, &raw mut made, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    made
}

/// Pairs that are pressed, shift in circles, spin and roll.
fn path() -> Vec<[[CaromGrain; 2]; PAIRS]> {
    let at = |step: usize, pair: usize| {
        let (t, phase) = (0.02 * step as f64, 0.7 * pair as f64);
        let place = [0.0, 0.0, 2e-3 - 1e-7 * (1.2 + 0.3 * (t + phase).sin())];
        let (x, y) = (1.7 * t + 2.0 * phase, 1.3 * t + 3.0 * phase);
        let along = [4e-4 * x.cos(), -4e-4 * y.sin(), -6e-4 * (t + phase).cos()];
        let one =
            CaromGrain { place, velocity: along, spin: [0.3, 0.1, 0.2], radius: 1e-3, mass: 1.0 };
        let still = [0.0; 3];
        [
            one,
            CaromGrain {
                place: still,
                velocity: still,
                spin: [0.1, 0.2, 0.3],
                radius: 1e-3,
                mass: 1.0,
            },
        ]
    };
    (0..STEPS).map(|step| std::array::from_fn(|pair| at(step, pair))).collect()
}

/// Touches one after the other, and the words of each.
fn apart(law: *const CaromLaw) -> (Vec<u64>, usize) {
    // SAFETY: a law.
    let words = unsafe { carom_touch_size(law) } / 8;
    (vec![0; words * PAIRS], words)
}

fn one_by_one(law: *const CaromLaw, path: &[[[CaromGrain; 2]; PAIRS]]) -> f64 {
    let ((mut touches, words), mut sum) = (apart(law), 0.0);
    for bodies in path {
        for (touch, [one, two]) in touches.chunks_exact_mut(words).zip(bodies) {
            let (mut load, touch) = (CaromGrainLoad::default(), touch.as_mut_ptr().cast());
            // SAFETY: all pointers are references or null.
            unsafe {
                let (to, none) = (&raw mut load, null_mut());
                carom_touch_step(law, touch, one, two, null(), DT, to, none, null_mut());
            }
            sum += load.force[0];
        }
    }
    sum
}

fn many(law: *const CaromLaw, path: &[[[CaromGrain; 2]; PAIRS]]) -> f64 {
    let ((mut touches, words), mut sum) = (apart(law), 0.0);
    for bodies in path {
        let mut encounters: Vec<_> = touches
            .chunks_exact_mut(words)
            .zip(bodies)
            .map(|(touch, &[one, two])| {
                let (touch, load) = (touch.as_mut_ptr().cast(), CaromGrainLoad::default());
                CaromEncounter { law, touch, wall: null(), one, two, load }
            })
            .collect();
        // SAFETY: each has a touch of its own.
        unsafe {
            carom_touch_step_many(encounters.as_mut_ptr(), PAIRS, DT, null_mut(), null_mut());
        }
        sum += encounters.iter().map(|met| met.load.force[0]).sum::<f64>();
    }
    sum
}

fn steps(criterion: &mut Criterion) {
    let path = path();
    for (name, number, restitution) in [
        ("fixed-direction", CAROM_LAW_FIXED_DIRECTION, 1.0),
        ("fixed-direction, restitution", CAROM_LAW_FIXED_DIRECTION, 0.8),
        ("coulomb", CAROM_LAW_COULOMB, 1.0),
        ("coulomb, restitution", CAROM_LAW_COULOMB, 0.8),
    ] {
        let law = law(number, restitution);
        let [alone, together] = [one_by_one(law, &path), many(law, &path)];
        assert!((alone / together - 1.0).abs() < 1e-12);
        let mut group = criterion.benchmark_group(format!("grains, {name}"));
        group.throughput(Throughput::Elements((PAIRS * STEPS) as u64));
        group.bench_function("one by one", |b| b.iter(|| one_by_one(law, black_box(&path))));
        group.bench_function("many", |b| b.iter(|| many(law, black_box(&path))));
        group.finish();
    }
}

criterion_group!(benches, steps);
criterion_main!(benches);
