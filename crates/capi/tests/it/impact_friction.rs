//! Static friction and friction by the slip speed in impacts.

use std::mem::{size_of, zeroed};
use std::ptr::{null, null_mut};

use carom_capi::*;

const GLASS: CaromMaterial = CaromMaterial { young_modulus: 70e9, poisson: 0.2, yield_stress: 0.0 };
const F_S: f64 = 0.5;
const F_K: f64 = 0.3;
const BY_SPEED: [f64; 3] = [0.1, 0.4, 2.0];

fn words(field: &[std::ffi::c_char]) -> String {
    field.iter().take_while(|byte| **byte != 0).map(|byte| char::from(*byte as u8)).collect()
}

fn coefficient(speed: f64) -> f64 {
    let [a, b, c] = BY_SPEED;
    a + b * (-c * speed).exp()
}

fn collide(
    friction: f64,
    more: CaromCollideOptions,
    slip: f64,
) -> (CaromStatus, CaromRebound, CaromError) {
    // SAFETY: zeros are a solid sphere at rest; plain numbers.
    let ([mut ball, mut floor], mut error): ([CaromBody; 2], CaromError) = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass) = (CAROM_SHAPE_SPHERE, 0.01, 0.02);
    (ball.material, floor.material, floor.shape) = (GLASS, GLASS, CAROM_SHAPE_PLANE);
    (ball.velocity, ball.centre) = ([slip, 0.0, -1.0], [0.0, 0.0, 0.01]);
    let mut told = CaromRebound::default();
    let options = CaromCollideOptions { size: size_of::<CaromCollideOptions>(), ..more };
    // SAFETY: all pointers are references.
    let status = unsafe {
        carom_collide(
            &ball,
            &floor,
            friction,
            [0.0, 0.0, 1.0].as_ptr(),
            &options,
            &mut told,
            &mut error,
        )
    };
    (status, told, error)
}

#[test]
fn impacts_have_both() {
    let none = CaromCollideOptions::default();
    let [a, b, c] = BY_SPEED;
    let by_speed = CaromCollideOptions { slip_friction_b: b, slip_friction_c: c, ..none };
    for slip in [0.2, 3.0] {
        let (status, got, _) = collide(a, by_speed, slip);
        let (_, want, _) = collide(coefficient(slip), none, slip);
        assert_eq!(status, CaromStatus::Ok);
        assert!((got.R_x - want.R_x).abs() < 1e-12 && got.has_R_x == 1, "{} {}", got.R_x, want.R_x);
    }
    let grips = CaromCollideOptions { static_friction: F_S, ..none };
    let [with, without, more] =
        [collide(F_K, grips, 1.2).1, collide(F_K, none, 1.2).1, collide(F_S, none, 1.2).1];
    assert!(
        with.R_x < without.R_x && with.R_x > more.R_x,
        "{} {} {}",
        with.R_x,
        without.R_x,
        more.R_x
    );
    for (friction, options, name) in [
        (F_K, CaromCollideOptions { static_friction: 0.2, ..none }, "static_friction"),
        (F_K, CaromCollideOptions { static_friction: f64::NAN, ..none }, "static_friction"),
        (a, CaromCollideOptions { static_friction: F_S, ..by_speed }, "static_friction"),
        (a, CaromCollideOptions { slip_friction_b: -0.2, ..none }, "slip_friction_b"),
        (a, CaromCollideOptions { slip_friction_c: -1.0, ..by_speed }, "slip_friction_c"),
        (-1.0, by_speed, "friction"),
        (F_K, CaromCollideOptions { law: CAROM_IMPACT_RINGS, ..grips }, "static_friction"),
        (F_K, CaromCollideOptions { torsion: CAROM_TORSION_INCLUDED, ..grips }, "static_friction"),
    ] {
        let (status, _, error) = collide(friction, options, 1.2);
        assert_eq!((status, words(&error.field).as_str()), (CaromStatus::OutOfRange, name));
    }
    // A smaller struct, of a caller of before, leaves them out.
    let old = std::mem::offset_of!(CaromCollideOptions, static_friction);
    // SAFETY: plain numbers.
    let ([mut ball, mut floor], options): ([CaromBody; 2], _) =
        unsafe { (zeroed(), CaromCollideOptions { size: old, static_friction: -7.0, ..none }) };
    (ball.shape, ball.sizes[0], ball.mass) = (CAROM_SHAPE_SPHERE, 0.01, 0.02);
    (ball.material, floor.material, floor.shape) = (GLASS, GLASS, CAROM_SHAPE_PLANE);
    (ball.velocity, ball.centre) = ([1.2, 0.0, -1.0], [0.0, 0.0, 0.01]);
    let mut told = CaromRebound::default();
    // SAFETY: all pointers are references or null.
    let status =
        unsafe { carom_collide(&ball, &floor, F_K, null(), &options, &mut told, null_mut()) };
    assert_eq!((status, told.R_x), (CaromStatus::Ok, without.R_x));
}
