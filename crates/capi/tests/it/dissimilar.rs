//! R_x of dissimilar spheres.

use std::mem::zeroed;
use std::ptr::null_mut;

use carom_capi::*;
use carom_impact::restitution::{DissimilarGroups, DissimilarTable};
use carom_laws::friction::Friction;

use crate::particles::words;

/// kappa, gamma, f, lambda, D_xx/D_zz.
fn of_dissimilar(numbers: [f64; 5]) -> (CaromStatus, [f64; 2], u32, CaromError) {
    let [kappa, gamma, f, lambda, ratio] = numbers;
    // SAFETY: plain numbers.
    let mut error: CaromError = unsafe { zeroed() };
    let (mut r_x, mut estimate, mut method) = (7.0, 7.0, 7);
    // SAFETY: all pointers are references.
    let status = unsafe {
        let (e, m) = (&raw mut estimate, &raw mut method);
        carom_restitution_dissimilar(kappa, gamma, f, lambda, ratio, &mut r_x, e, m, &mut error)
    };
    (status, [r_x, estimate], method, error)
}

#[test]
fn restitution_of_dissimilar_spheres_is_that_of_the_library() {
    for (numbers, by) in [
        ([1.1, -0.3, 0.1, 2.0, 3.5], CAROM_BY_TABLE),
        ([1.02, 0.47, 0.9, 0.0, 2.5], CAROM_BY_TABLE),
        ([1.1, 0.3, 0.1, 9.0, 3.5], CAROM_BY_RINGS),
        ([1.0, 0.5, f64::INFINITY, 0.0, 3.5], CAROM_BY_RINGS),
        ([1.2, 0.0, 0.1, 2.0, 3.5], CAROM_EXACT),
        ([1.1, 0.3, 0.0, 2.0, 3.5], CAROM_EXACT),
        ([1.1, 0.3, 0.2, f64::INFINITY, 3.5], CAROM_EXACT),
    ] {
        let [kappa, gamma, f, lambda, ratio] = numbers;
        let friction = Friction::new(f).unwrap();
        let groups = DissimilarGroups::new(kappa, gamma, friction, lambda, ratio).unwrap();
        let found = DissimilarTable::shared().restitution(&groups).unwrap();
        let (status, told, method, _) = of_dissimilar(numbers);
        assert_eq!((status, method), (CaromStatus::Ok, by), "{numbers:?}");
        assert_eq!(told, [found.r_x, found.error_estimate]);
        let mut r_x = 0.0;
        // SAFETY: null is what is not wanted.
        unsafe {
            let to = &raw mut r_x;
            let (no, nothing) = (null_mut(), null_mut());
            carom_restitution_dissimilar(
                kappa,
                gamma,
                f,
                lambda,
                ratio,
                to,
                no,
                nothing,
                null_mut(),
            );
        }
        assert_eq!(r_x, found.r_x);
    }
    let (mut alike, (_, [r_x, _], ..)) = (0.0, of_dissimilar([1.2, 0.0, 0.1, 2.0, 3.5]));
    // SAFETY: all pointers are references.
    unsafe { carom_restitution(1.2, 2.0, 1.0, CAROM_EXACT, &mut alike, null_mut()) };
    assert_eq!(alike, r_x);
}

#[test]
fn bad_numbers_of_dissimilar_spheres_are_named() {
    for (numbers, name) in [
        ([1.6, 0.0, 0.1, 2.0, 3.5], "kappa"),
        ([1.1, 0.41, 0.1, 2.0, 3.5], "gamma"),
        ([1.1, f64::NAN, 0.1, 2.0, 3.5], "gamma"),
        ([1.1, 0.3, -0.1, 2.0, 3.5], "friction"),
        ([1.1, 0.3, f64::INFINITY, 2.0, 3.5], "lambda"),
        ([1.1, 0.3, 0.1, -2.0, 3.5], "lambda"),
        ([1.1, 0.3, 0.1, 2.0, 0.0], "mobility_ratio"),
    ] {
        let (status, told, method, error) = of_dissimilar(numbers);
        assert_eq!((status, told, method), (CaromStatus::OutOfRange, [7.0; 2], 7), "{numbers:?}");
        assert_eq!(words(&error.field), name);
    }
}
