//! Cost of a step of the contact of two grains through the C interface: one by one, and many in a call; with a given
//! restitution and without.

use std::hint::black_box;
use std::mem::{MaybeUninit, zeroed};
use std::ptr::null_mut;

use carom_capi::{
    CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION, CAROM_TOUCH_WORDS, CaromEncounter, CaromGrain,
    CaromGrainLoad, CaromGrains, CaromMaterial, CaromStatus, CaromTouch, carom_grains_of,
    carom_grains_restitution, carom_touch_grains, carom_touch_many,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const PAIRS: usize = 64;
const STEPS: usize = 256;
const DT: f64 = 1e-6;

fn grains(law: u32, restitution: f64) -> CaromGrains {
    let glass = CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut grains = zeroed();
        let to = &raw mut grains;
        let status = carom_grains_of(&glass, &glass, 0.3, law, 0.0, 0.0, to, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        let status = carom_grains_restitution(to, restitution, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        grains
    }
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

fn apart() -> Vec<CaromTouch> {
    vec![CaromTouch { mark: 0, words: [MaybeUninit::new(0); CAROM_TOUCH_WORDS] }; PAIRS]
}

fn one_by_one(grains: &CaromGrains, path: &[[[CaromGrain; 2]; PAIRS]]) -> f64 {
    let (mut touches, mut sum) = (apart(), 0.0);
    for bodies in path {
        for (touch, [one, two]) in touches.iter_mut().zip(bodies) {
            let (mut load, none) = (CaromGrainLoad::default(), null_mut());
            // SAFETY: all pointers are references or null.
            unsafe {
                let to = &raw mut load;
                carom_touch_grains(grains, touch, one, two, DT, to, none, null_mut());
            }
            sum += load.force[0];
        }
    }
    sum
}

fn many(grains: &CaromGrains, path: &[[[CaromGrain; 2]; PAIRS]]) -> f64 {
    let (mut touches, mut sum) = (apart(), 0.0);
    for bodies in path {
        let mut encounters: Vec<_> = touches
            .iter_mut()
            .zip(bodies)
            .map(|(touch, &[one, two])| {
                let load = CaromGrainLoad::default();
                CaromEncounter { grains, touch, one, two, load }
            })
            .collect();
        // SAFETY: each has a touch of its own.
        unsafe {
            carom_touch_many(encounters.as_mut_ptr(), PAIRS, DT, null_mut(), null_mut());
        }
        sum += encounters.iter().map(|met| met.load.force[0]).sum::<f64>();
    }
    sum
}

fn steps(criterion: &mut Criterion) {
    let path = path();
    for (name, law, restitution) in [
        ("fixed-direction", CAROM_LAW_FIXED_DIRECTION, 1.0),
        ("fixed-direction, restitution", CAROM_LAW_FIXED_DIRECTION, 0.8),
        ("coulomb", CAROM_LAW_COULOMB, 1.0),
        ("coulomb, restitution", CAROM_LAW_COULOMB, 0.8),
    ] {
        let grains = grains(law, restitution);
        let [alone, together] = [one_by_one(&grains, &path), many(&grains, &path)];
        assert!((alone / together - 1.0).abs() < 1e-12);
        let mut group = criterion.benchmark_group(format!("grains, {name}"));
        group.throughput(Throughput::Elements((PAIRS * STEPS) as u64));
        group.bench_function("one by one", |b| b.iter(|| one_by_one(&grains, black_box(&path))));
        group.bench_function("many", |b| b.iter(|| many(&grains, black_box(&path))));
        group.finish();
    }
}

criterion_group!(benches, steps);
criterion_main!(benches);
