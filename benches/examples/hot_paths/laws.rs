//! Steps of contact laws, and of the contact of two grains through the C interface.

use std::ptr::{null, null_mut};

use carom_capi::{
    CAROM_LAW_FIXED_DIRECTION, CaromGrain, CaromGrainLoad, CaromLawOptions, CaromMaterial,
    CaromStatus, carom_law_make, carom_touch_size, carom_touch_step,
};
use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, Shift};
use carom_laws::memory::Memory;
use carom_laws::rings::{RingConstants, RingLaw, Tolerance as RingTolerance};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::history::TwistHistory;

use crate::{HotPath, Work};

pub(crate) const PATHS: &[HotPath] = &[
    ("shift_law_step", shift_law),
    ("fixed_direction_step", fixed_direction),
    ("coulomb_step", coulomb),
    ("ring_step", rings),
    ("twist_step", twist),
    ("grain_touch", grain_touch),
];

const PATHS_TAKEN: usize = 5;
const STEPS: usize = 200;

/// A path that turns: approach and normalised shift.
fn path(number: usize) -> Vec<(f64, [f64; 2])> {
    let phase = number as f64;
    (0..STEPS)
        .map(|step| {
            let t = 0.08 * step as f64;
            let x = 0.55 * (0.7 * t + 2.0 * phase).sin() + 0.2 * (1.9 * t + phase).cos();
            let y = 0.45 * (0.6 * t + 3.0 * phase).cos() + 0.2 * (1.7 * t + phase).sin();
            (1.0 + 0.3 * (t + phase).sin(), [x, y])
        })
        .collect()
}

fn paths() -> Vec<Vec<(f64, [f64; 2])>> {
    (0..PATHS_TAKEN).map(path).collect()
}

fn shift_law() -> Work {
    let (paths, stiffness) = (paths(), ContactStiffness { c_x: 0.8, c_y: 0.8, c_z: 1.0 });
    let fresh: ShiftLaw<f64> = ShiftLaw::new(stiffness, Friction::new(0.3).expect("positive"));
    Box::new(move || {
        let mut sum = 0.0;
        for path in &paths {
            let mut law = fresh.clone();
            for &(zeta, [x, _]) in path {
                let shift = Shift { zeta, xi: 0.375 * x, ..Shift::default() };
                sum += law.advance(shift).expect("finite").f_x;
            }
        }
        sum
    })
}

fn fixed_direction() -> Work {
    let paths = paths();
    Box::new(move || {
        let mut sum = 0.0;
        for path in &paths {
            let mut memory = Memory::<[f64; 2]>::new();
            for &(zeta, x) in path {
                sum += memory.advance(zeta, x).expect("finite")[0];
            }
        }
        sum
    })
}

fn coulomb() -> Work {
    let paths = paths();
    Box::new(move || {
        let mut sum = 0.0;
        for path in &paths {
            let mut memory = CoulombMemory::<[f64; 2]>::new(Tolerance::PARTICLES);
            for &(zeta, x) in path {
                sum += memory.advance(zeta, x).expect("finite")[0];
            }
        }
        sum
    })
}

fn rings() -> Work {
    let (paths, friction) = (paths(), 0.1);
    let constants = RingConstants { c_z: 4.0, radius: 1.0, kappa: 1.2, gamma: 0.2 };
    let limit = Friction::new(friction).expect("positive");
    let fresh = RingLaw::from_constants(constants, limit, RingTolerance::PARTICLES);
    let fresh: RingLaw = fresh.expect("in range");
    Box::new(move || {
        let mut law = fresh.clone();
        let mut sum = 0.0;
        for &(zeta, [x, y]) in &paths[0] {
            let shift = Shift { zeta, xi: friction * x, eta: friction * y, omega: 0.05 * x * y };
            sum += law.advance(shift).expect("finite").f_x;
        }
        sum
    })
}

fn twist() -> Work {
    let paths = paths();
    Box::new(move || {
        let mut sum = 0.0;
        for path in &paths {
            let mut history = TwistHistory::new();
            for &(radius, [x, _]) in path {
                sum += history.advance(radius, x).expect("finite");
            }
        }
        sum
    })
}

/// A grain above another: pressed, shifted in circles, spinning.
fn above(step: usize, pair: usize) -> CaromGrain {
    let (t, phase) = (0.02 * step as f64, 0.7 * pair as f64);
    let (x, y) = (1.7 * t + 2.0 * phase, 1.3 * t + 3.0 * phase);
    CaromGrain {
        place: [0.0, 0.0, 2e-3 - 1e-7 * (1.2 + 0.3 * (t + phase).sin())],
        velocity: [4e-4 * x.cos(), -4e-4 * y.sin(), -6e-4 * (t + phase).cos()],
        spin: [0.3, 0.1, 0.2],
        radius: 1e-3,
        mass: 1.0,
    }
}

fn grain_touch() -> Work {
    let glass = CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
    let law = CAROM_LAW_FIXED_DIRECTION;
    let size = size_of::<CaromLawOptions>();
    let options = CaromLawOptions { size, law, ..CaromLawOptions::default() };
    let mut made = null_mut();
    // SAFETY: all pointers are references or null; the law lives as long as the process.
    let (law, words) = unsafe {
        let status = carom_law_make(&glass, &glass, 0.3, &options, &raw mut made, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        (made.cast_const(), carom_touch_size(made) / 8)
    };
    let still = [0.0; 3];
    let below = CaromGrain {
        place: still,
        velocity: still,
        spin: [0.1, 0.2, 0.3],
        radius: 1e-3,
        mass: 1.0,
    };
    let ways: Vec<Vec<_>> =
        (0..PATHS_TAKEN).map(|pair| (0..STEPS).map(|step| above(step, pair)).collect()).collect();
    Box::new(move || {
        let mut sum = 0.0;
        for way in &ways {
            let mut touch = vec![0_u64; words];
            for grain in way {
                let (mut load, none) = (CaromGrainLoad::default(), null_mut());
                let (to, touch) = (&raw mut load, touch.as_mut_ptr().cast());
                // SAFETY: all pointers are references or null.
                unsafe {
                    carom_touch_step(law, touch, grain, &below, null(), 1e-6, to, none, null_mut());
                }
                sum += load.force[0];
            }
        }
        sum
    })
}
