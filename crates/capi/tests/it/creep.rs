//! Creep coefficients of a rolling contact.

use std::mem::zeroed;
use std::ptr::null_mut;

use carom_capi::*;

use crate::particles::words;

const NOTHING: CaromCreep = CaromCreep { c11: 7.0, c22: 7.0, c23: 7.0, c33: 7.0 };

fn creep(axis_ratio: f64, poisson: f64) -> (CaromStatus, CaromCreep, CaromError) {
    // SAFETY: plain numbers.
    let (mut creep, mut error) = (NOTHING, unsafe { zeroed() });
    // SAFETY: all pointers are references.
    let status = unsafe { carom_creep_coefficients(axis_ratio, poisson, &mut creep, &mut error) };
    (status, creep, error)
}

/// Kalker 1990, table E.3.
#[test]
fn creep_coefficients_are_those_printed() {
    for (ratio, poisson, [c11, c22, c23, c33]) in [
        (0.2, 0.25, [3.37, 2.63, 0.603, 4.27]),
        (1.0, 0.5, [5.20, 3.98, 1.63, 1.16]),
        (2.0, 0.25, [5.10, 4.90, 2.62, 0.819]),
        (5.0, 0.0, [6.96, 6.96, 5.72, 0.828]),
    ] {
        let (status, got, _) = creep(ratio, poisson);
        assert_eq!(status, CaromStatus::Ok);
        let pairs = [(got.c11, c11), (got.c22, c22), (got.c23, c23), (got.c33, c33)];
        for (got, want) in pairs {
            assert!((got / want - 1.0).abs() < 0.01, "{ratio} {poisson}: {got} {want}");
        }
    }
    // SAFETY: null is where nothing is wanted.
    let status = unsafe { carom_creep_coefficients(1.0, 0.3, &mut { NOTHING }, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
}

/// The forces of the library, without a number changed.
#[test]
fn creep_forces_are_those_of_the_library() {
    let (axes, creepages) = ([6.8e-3, 5.1e-3], [1e-3, -2e-4, 0.1]);
    // SAFETY: plain numbers.
    let (mut found, mut error): (CaromCreepForce, CaromError) = unsafe { zeroed() };
    let mut call = |axes: *const f64, friction: f64, found: &mut CaromCreepForce| {
        let creepages = creepages.as_ptr();
        // SAFETY: all pointers are references or null.
        unsafe { carom_creep_force(axes, 82e9, 0.28, friction, 80e3, creepages, found, &mut error) }
    };
    assert_eq!(call(axes.as_ptr(), 0.3, &mut found), CaromStatus::Ok);
    let contact = carom_laws::creep::force::CreepContact::new(axes, 82e9, 0.28).unwrap();
    let wanted = contact.force(0.3, 80e3, creepages).unwrap();
    assert_eq!(
        [found.f_x, found.f_y, found.m_z, found.error],
        [wanted.f_x, wanted.f_y, wanted.m_z, wanted.error]
    );
    let before = found;
    assert_eq!(call(axes.as_ptr(), -0.3, &mut found), CaromStatus::OutOfRange);
    assert_eq!(call(std::ptr::null(), 0.3, &mut found), CaromStatus::NullPointer);
    assert_eq!(found, before);
}

#[test]
fn bad_numbers_and_pointers_are_named() {
    for (ratio, poisson, name) in [
        (0.049, 0.3, "axis_ratio"),
        (20.1, 0.3, "axis_ratio"),
        (-1.0, 0.3, "axis_ratio"),
        (f64::NAN, 0.3, "axis_ratio"),
        (1.0, -0.01, "poisson"),
        (1.0, 0.51, "poisson"),
        (1.0, f64::NAN, "poisson"),
    ] {
        let (status, told, error) = creep(ratio, poisson);
        assert_eq!((status, told), (CaromStatus::OutOfRange, NOTHING), "{ratio} {poisson}");
        assert_eq!(words(&error.field), name);
        let value = if name == "poisson" { poisson } else { ratio };
        assert!(error.value == value || error.value.is_nan() && value.is_nan());
    }
    // SAFETY: plain numbers, and pointers that are null or references.
    unsafe {
        let mut error: CaromError = zeroed();
        let status = carom_creep_coefficients(1.0, 0.3, null_mut(), &mut error);
        assert_eq!(
            (status, words(&error.field).as_str()),
            (CaromStatus::NullPointer, "coefficients")
        );
    }
}
