//! Any number in any field of a body, of a pair or of a ratio: finite results, or a status that names a
//! field, never an internal error.

use std::mem::{size_of, zeroed};
use std::ptr::null;

use carom_capi::*;

use crate::particles::words;

const STRANGE: [f64; 12] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    -1.0,
    1.0,
    5e-324,
    1e-160,
    1e160,
    f64::MAX,
    f64::MIN,
];
const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// The numbers of a body, behind its two words.
fn numbers(body: &mut CaromBody) -> &mut [f64] {
    let count = size_of::<CaromBody>() / size_of::<f64>() - 1;
    // SAFETY: a `repr(C)` structure of two words of four bytes and numbers.
    unsafe { std::slice::from_raw_parts_mut((&raw mut *body).cast::<f64>().add(1), count) }
}

fn is_finite(rebound: &CaromRebound) -> bool {
    let vectors = [
        rebound.body_1_velocity,
        rebound.body_2_velocity,
        rebound.body_1_spin,
        rebound.body_2_spin,
    ];
    let others = [rebound.impulse, rebound.contact_velocity_before, rebound.contact_velocity_after];
    let energies = [
        rebound.energy_before,
        rebound.energy_after,
        rebound.energy_dissipated,
        rebound.energy_lost,
    ];
    let single = [rebound.duration, rebound.maximal_force, rebound.maximal_approach];
    let all = vectors.iter().chain(&others).flatten().chain(&energies).chain(&single);
    all.chain(&[rebound.maximal_semi_axis_a, rebound.maximal_semi_axis_b]).all(|x| x.is_finite())
}

fn told(status: CaromStatus, error: &CaromError) -> String {
    let (field, text) = (words(&error.field), words(&error.text));
    assert!(!text.is_empty(), "{status:?} without words");
    assert!(status != CaromStatus::OutOfRange || !field.is_empty(), "no field: {text}");
    format!("{status:?} {field}: {text}")
}

#[test]
fn any_number_in_a_body_is_answered() {
    for shape in 0..8 {
        // SAFETY: zeros are a solid sphere at rest; the error is plain numbers.
        let (mut body, mut plate): (CaromBody, CaromBody) = unsafe { (zeroed(), zeroed()) };
        (body.shape, body.sizes, body.mass) = (shape, [0.02, 0.015, 0.01], 0.03);
        body.material = CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
        (body.velocity, body.spin) = ([0.3, 0.1, -1.0], [1.0, 2.0, 3.0]);
        (plate.shape, plate.material) = (CAROM_SHAPE_PLANE, body.material);
        let count = numbers(&mut body).len();
        for place in 0..count {
            for strange in STRANGE {
                let mut wrong = body;
                numbers(&mut wrong)[place] = strange;
                // SAFETY: as above.
                let mut error: CaromError = unsafe { zeroed() };
                let mut rebound = CaromRebound::default();
                // SAFETY: all pointers are references.
                let status = unsafe {
                    let (up, out) = (UP.as_ptr(), &raw mut rebound);
                    carom_collide(&wrong, &plate, 0.3, up, null(), out, &raw mut error)
                };
                let here = format!("shape {shape}, number {place} = {strange:e}");
                // One moment of inertia without the others is none of a body.
                let has_one = shape != CAROM_SHAPE_PLANE && wrong.moments != [0.0; 3];
                match status {
                    CaromStatus::Ok if has_one => panic!("{here}: moments {:?}", wrong.moments),
                    CaromStatus::Ok => assert!(is_finite(&rebound), "{here}: {rebound:?}"),
                    CaromStatus::Internal => panic!("{here}: {}", told(status, &error)),
                    _ => {
                        told(status, &error);
                        assert_eq!(rebound, CaromRebound::default(), "{here}");
                    }
                }
            }
        }
    }
}

#[test]
fn any_pair_and_ratio_is_answered() {
    for one in STRANGE {
        for other in STRANGE {
            // SAFETY: plain numbers.
            let (mut error, mut pair): (CaromError, CaromPair) = unsafe { (zeroed(), zeroed()) };
            let material = CaromMaterial { young_modulus: one, poisson: 0.3, yield_stress: 0.0 };
            let mut r_x = 7.0;
            let mut calls = Vec::new();
            // SAFETY: all pointers are null or references.
            unsafe {
                let (material, pair, error) = (&raw const material, &raw mut pair, &raw mut error);
                let (law, e) = (CAROM_LAW_COULOMB, error);
                calls.push(carom_pair_of_spheres(
                    material, material, 1.0, other, 0.3, law, 0.0, pair, e,
                ));
                calls.push(carom_pair_of_spheres(
                    material, material, 1.0, 1.0, other, law, 0.0, pair, e,
                ));
                calls.push(carom_pair_of_spheres(
                    material, material, other, one, 0.3, law, other, pair, e,
                ));
                calls.push(carom_pair_of_curvatures(
                    material, material, one, other, 0.3, law, 0.0, pair, e,
                ));
                let mut made = std::ptr::null_mut();
                let options = CaromLawOptions {
                    size: size_of::<CaromLawOptions>(),
                    relaxation: other,
                    ..CaromLawOptions::default()
                };
                for friction in [0.3, other] {
                    calls
                        .push(carom_law_make(material, material, friction, &options, &mut made, e));
                    carom_law_free(made);
                    made = std::ptr::null_mut();
                }
                for method in [CAROM_EXACT, CAROM_BY_TABLE] {
                    calls.push(carom_restitution(one, other, other, method, &raw mut r_x, e));
                    calls.push(carom_restitution(1.2, other, 0.5, method, &raw mut r_x, e));
                    assert!(r_x.is_finite(), "{one:e} {other:e} {method}: {r_x}");
                }
            }
            assert!(!calls.contains(&CaromStatus::Internal), "{one:e} {other:e}: {calls:?}");
        }
    }
    // SAFETY: null pointers are told.
    let status = unsafe {
        let (nothing, error) = (std::ptr::null_mut(), std::ptr::null_mut());
        carom_collide(null(), null(), 0.3, null(), null(), nothing, error)
    };
    assert_eq!(status, CaromStatus::NullPointer);
}
