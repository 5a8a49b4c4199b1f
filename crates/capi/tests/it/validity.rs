//! Limits of the theory: a/R and zeta/R against a^2 = R zeta of spheres, and the warnings of impacts.

use std::collections::BTreeSet;
use std::ffi::CStr;
use std::mem::zeroed;
use std::ptr::null;

use carom_capi::*;

const GLASS: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
const BOTH: u32 = CAROM_WARNING_LARGE_CONTACT | CAROM_WARNING_LARGE_APPROACH;

fn spheres(radius_1: f64, radius_2: f64) -> CaromPair {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let (mut pair, mut error) = (zeroed(), zeroed());
        let law = CAROM_LAW_COULOMB;
        let to = &raw mut pair;
        let status = carom_pair_of_spheres(
            &GLASS,
            &GLASS,
            radius_1,
            radius_2,
            0.2,
            law,
            0.0,
            to,
            &raw mut error,
        );
        assert_eq!(status, CaromStatus::Ok);
        pair
    }
}

fn validity(
    pair: &CaromPair,
    zeta: f64,
    radius: f64,
) -> Result<CaromValidity, (CaromStatus, String)> {
    let mut validity = CaromValidity::default();
    // SAFETY: plain numbers; all pointers are references.
    let (status, error) = unsafe {
        let mut error: CaromError = zeroed();
        (carom_pair_validity(pair, zeta, radius, &raw mut validity, &raw mut error), error)
    };
    let field = error.field.iter().take_while(|byte| **byte != 0);
    let field = field.map(|byte| char::from(*byte as u8)).collect();
    if status == CaromStatus::Ok { Ok(validity) } else { Err((status, field)) }
}

#[test]
fn spheres_have_the_circle_of_hertz() {
    let pair = spheres(1e-3, 3e-3);
    // a^2 = R zeta with 1/R = 1/R_1 + 1/R_2.
    let at = |zeta: f64| validity(&pair, zeta, 1e-3).unwrap();
    let told = at(1e-6);
    let expected = (0.75e-3 * 1e-6_f64).sqrt() / 1e-3;
    assert!((told.semi_axis_over_radius / expected - 1.0).abs() < 1e-12, "{told:?}");
    assert!((told.approach_over_radius / 1e-3 - 1.0).abs() < 1e-12, "{told:?}");
    assert_eq!(told.warnings, 0);
    // a = 0.1 mm.
    let limit = 1e-4 * 1e-4 / 0.75e-3;
    assert_eq!(at(0.999 * limit).warnings, 0);
    assert_eq!(at(1.001 * limit).warnings, CAROM_WARNING_LARGE_CONTACT);
    assert_eq!(at(0.999e-4).warnings, CAROM_WARNING_LARGE_CONTACT);
    assert_eq!(at(1.001e-4).warnings, BOTH);
    assert_eq!(at(0.0), CaromValidity::default());
    let other = validity(&spheres(3e-3, f64::INFINITY), 1e-6, 3e-3).unwrap();
    assert!((other.semi_axis_over_radius - (1e-6_f64 / 3e-3).sqrt()).abs() < 1e-12);
}

#[test]
fn an_ellipse_counts_by_its_larger_semi_axis() {
    let made = |a: f64, b: f64| {
        // SAFETY: plain numbers; all pointers are references or null.
        unsafe {
            let (mut pair, mut error) = (zeroed(), zeroed());
            let (law, to) = (CAROM_LAW_COULOMB, &raw mut pair);
            let status =
                carom_pair_of_curvatures(&GLASS, &GLASS, a, b, 0.2, law, 0.0, to, &raw mut error);
            assert_eq!(status, CaromStatus::Ok);
            pair
        }
    };
    let (flat, turned, round) = (made(500.0, 50.0), made(50.0, 500.0), made(500.0, 500.0));
    let ratio = |pair| validity(pair, 1e-7, 1e-3).unwrap().semi_axis_over_radius;
    assert!((ratio(&flat) / ratio(&turned) - 1.0).abs() < 1e-12);
    assert!(ratio(&flat) > 1.5 * ratio(&round));
}

#[test]
fn wrong_input_is_named() {
    let pair = spheres(1e-3, 3e-3);
    let named = |field: &str| (CaromStatus::OutOfRange, field.to_owned());
    for bad in [-1e-9, f64::NAN, f64::INFINITY] {
        assert_eq!(validity(&pair, bad, 1e-3), Err(named("zeta")));
        assert_eq!(validity(&pair, 1e-6, bad), Err(named("radius")));
    }
    assert_eq!(validity(&pair, 1e-6, 0.0), Err(named("radius")));
    let unknown = CaromPair { a_squared: 0.0, b_squared: 0.0, ..pair };
    assert_eq!(validity(&unknown, 1e-6, 1e-3), Err(named("a_squared")));
    let other = CaromPair { version: 0, ..pair };
    assert_eq!(validity(&other, 1e-6, 1e-3), Err((CaromStatus::BadState, "pair".to_owned())));
}

#[test]
fn a_contact_yields_at_1_6_times_its_yield_stress() {
    let soft = CaromMaterial { yield_stress: 1e9, ..GLASS };
    // SAFETY: plain numbers; all pointers are references or null.
    let pair: CaromPair = unsafe {
        let (mut pair, mut error) = (zeroed(), zeroed());
        let (law, to) = (CAROM_LAW_COULOMB, &raw mut pair);
        let status =
            carom_pair_of_spheres(&GLASS, &soft, 1e-3, 3e-3, 0.2, law, 0.0, to, &raw mut error);
        assert_eq!(status, CaromStatus::Ok);
        pair
    };
    // p = (2/pi) E* sqrt(zeta/R), E* = E/(2 (1 - nu^2)).
    let modulus = 70e9 / (2.0 * (1.0 - 0.22 * 0.22));
    let pressure = |zeta: f64| 2.0 / std::f64::consts::PI * modulus * (zeta / 0.75e-3).sqrt();
    let at = |zeta: f64| validity(&pair, zeta, 1e-3).unwrap();
    let zeta = 1e-6;
    assert!((at(zeta).pressure_over_yield / (pressure(zeta) / 1.6e9) - 1.0).abs() < 1e-12);
    let limit = zeta * (1.6e9 / pressure(zeta)).powi(2);
    assert_eq!(at(0.999 * limit).warnings, 0);
    assert_eq!(at(1.001 * limit).warnings, CAROM_WARNING_YIELDS);
    let [bad, unknown] =
        [0.0, f64::INFINITY].map(|yield_stress| CaromPair { yield_stress, ..pair });
    assert_eq!(
        validity(&bad, zeta, 1e-3),
        Err((CaromStatus::OutOfRange, "yield_stress".to_owned()))
    );
    assert_eq!(validity(&unknown, zeta, 1e-3).unwrap().pressure_over_yield, 0.0);
}

/// A rubber ball that falls on a rigid floor.
fn fall(velocity: f64) -> CaromRebound {
    let rubber = CaromMaterial { young_modulus: 1e6, poisson: 0.5, yield_stress: 0.0 };
    // SAFETY: zeros are a solid sphere at rest; all pointers are references or null.
    unsafe {
        let [mut ball, mut floor]: [CaromBody; 2] = zeroed();
        (ball.shape, ball.sizes[0], ball.mass, ball.material) =
            (CAROM_SHAPE_SPHERE, 0.02, 0.03, rubber);
        ball.velocity[2] = -velocity;
        (floor.shape, floor.material.young_modulus) = (CAROM_SHAPE_PLANE, f64::INFINITY);
        let (mut rebound, mut error, up) = (CaromRebound::default(), zeroed(), [0.0, 0.0, 1.0]);
        let to = &raw mut rebound;
        let status = carom_collide(&ball, &floor, 0.3, up.as_ptr(), null(), to, &raw mut error);
        assert_eq!(status, CaromStatus::Ok);
        rebound
    }
}

#[test]
fn an_impact_warns_where_its_contact_does() {
    let mut met = BTreeSet::new();
    for velocity in [0.001, 0.1, 1.0, 3.0, 10.0] {
        let rebound = fall(velocity);
        let deep = validity(&spheres(0.02, f64::INFINITY), rebound.maximal_approach, 0.02).unwrap();
        assert_eq!(rebound.warnings & BOTH, deep.warnings, "{velocity} m/s");
        assert!(
            (rebound.maximal_semi_axis_b / 0.02 / deep.semi_axis_over_radius - 1.0).abs() < 1e-9
        );
        met.insert(deep.warnings);
    }
    assert_eq!(met, BTreeSet::from([0, CAROM_WARNING_LARGE_CONTACT, BOTH]));
}

#[test]
fn each_warning_has_its_words() {
    // SAFETY: static texts that end with a zero.
    let text = |bits| unsafe { CStr::from_ptr(carom_warning_text(bits)) }.to_str().unwrap();
    let texts: BTreeSet<_> = (0..10).map(|i| text(1 << i)).collect();
    let none = text(0);
    assert_eq!(texts.len(), 10);
    assert!(!texts.contains(none));
    assert_eq!([text(3), text(1024), text(u32::MAX)], [none; 3]);
}
