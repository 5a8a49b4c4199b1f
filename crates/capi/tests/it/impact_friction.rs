//! Static friction and friction by the slip speed in impacts.

use std::mem::zeroed;
use std::ptr::{null, null_mut};

use carom_capi::*;

use crate::particles::{Told, collided};

const GLASS: CaromMaterial = CaromMaterial { young_modulus: 70e9, poisson: 0.2, yield_stress: 0.0 };
const F_S: f64 = 0.5;
const F_K: f64 = 0.3;
const BY_SPEED: [f64; 3] = [0.1, 0.4, 2.0];

fn coefficient(speed: f64) -> f64 {
    let [a, b, c] = BY_SPEED;
    a + b * (-c * speed).exp()
}

fn bodies(slip: f64) -> [CaromBody; 2] {
    // SAFETY: zeros are a solid sphere at rest.
    let [mut ball, mut floor]: [CaromBody; 2] = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass) = (CAROM_SHAPE_SPHERE, 0.01, 0.02);
    (ball.material, floor.material, floor.shape) = (GLASS, GLASS, CAROM_SHAPE_PLANE);
    (ball.velocity, ball.centre) = ([slip, 0.0, -1.0], [0.0, 0.0, 0.01]);
    [ball, floor]
}

fn collide(friction: f64, more: CaromCollideOptions, slip: f64) -> Result<CaromRebound, Told> {
    let [ball, floor] = bodies(slip);
    collided([&ball, &floor], friction, Some(&[0.0, 0.0, 1.0]), Some(more))
}

#[test]
fn impacts_have_both() {
    let none = CaromCollideOptions::default();
    let [a, b, c] = BY_SPEED;
    let by_speed = CaromCollideOptions { slip_friction_b: b, slip_friction_c: c, ..none };
    for slip in [0.2, 3.0] {
        let got = collide(a, by_speed, slip).unwrap();
        let want = collide(coefficient(slip), none, slip).unwrap();
        assert!((got.R_x - want.R_x).abs() < 1e-12 && got.has_R_x == 1, "{} {}", got.R_x, want.R_x);
    }
    let grips = CaromCollideOptions { static_friction: F_S, ..none };
    let [with, without, more] = [(F_K, grips), (F_K, none), (F_S, none)]
        .map(|(friction, options)| collide(friction, options, 1.2).unwrap());
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
        let told = collide(friction, options, 1.2).unwrap_err();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, name));
    }
    // A smaller struct, of a caller of before, leaves them out.
    let old = std::mem::offset_of!(CaromCollideOptions, static_friction);
    let options = CaromCollideOptions { size: old, static_friction: -7.0, ..none };
    let [ball, floor] = bodies(1.2);
    let mut told = CaromRebound::default();
    // SAFETY: all pointers are references or null.
    let status =
        unsafe { carom_collide(&ball, &floor, F_K, null(), &options, &mut told, null_mut()) };
    assert_eq!((status, told.R_x), (CaromStatus::Ok, without.R_x));
}
