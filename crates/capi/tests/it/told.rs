//! What an impact tells across the border: the torque's impulse by the change of the spin, and whose body is wrong.

use std::mem::zeroed;
use std::ptr::null;

use carom_capi::*;

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const RUBBER: CaromMaterial =
    CaromMaterial { young_modulus: 20e6, poisson: 0.5, yield_stress: 0.0 };

fn bodies() -> [CaromBody; 2] {
    // SAFETY: zeros are a solid sphere at rest.
    let [mut ball, mut other]: [CaromBody; 2] = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass, ball.material) =
        (CAROM_SHAPE_SPHERE, 0.02, 0.03, RUBBER);
    (ball.velocity, ball.spin) = ([0.5, -0.1, -2.0], [3.0, 40.0, -90.0]);
    (other.shape, other.sizes[0], other.mass, other.material) =
        (CAROM_SHAPE_SPHERE, 0.03, 0.05, RUBBER);
    [ball, other]
}

fn collide([one, two]: &[CaromBody; 2], torsion: u32) -> (CaromStatus, CaromRebound, CaromError) {
    // SAFETY: plain numbers.
    let mut error: CaromError = unsafe { zeroed() };
    error.index = -7;
    let (mut told, size) = (CaromRebound::default(), size_of::<CaromCollideOptions>());
    let options = CaromCollideOptions {
        size,
        law: CAROM_IMPACT_COULOMB,
        torsion,
        ..CaromCollideOptions::default()
    };
    // SAFETY: all pointers are references.
    let status =
        unsafe { carom_collide(one, two, 0.5, UP.as_ptr(), &options, &mut told, &mut error) };
    (status, told, error)
}

#[test]
fn the_impulse_of_the_torque_is_what_the_spin_took() {
    let bodies = bodies();
    let (status, told, _) = collide(&bodies, CAROM_TORSION_INCLUDED);
    assert_eq!((status, told.has_torsion), (CaromStatus::Ok, 1));
    let moment = |body: &CaromBody| 0.4 * body.mass * body.sizes[0] * body.sizes[0];
    let one = moment(&bodies[0]) * (told.body_1_spin[2] - bodies[0].spin[2]);
    let two = moment(&bodies[1]) * (told.body_2_spin[2] - bodies[1].spin[2]);
    assert!((told.torque_impulse / one - 1.0).abs() < 1e-9, "{} {one}", told.torque_impulse);
    assert!((told.torque_impulse / two + 1.0).abs() < 1e-9, "{} {two}", told.torque_impulse);
    let ratio = (told.body_1_spin[2] - told.body_2_spin[2]) / bodies[0].spin[2];
    assert!((told.spin_ratio / ratio - 1.0).abs() < 1e-12);
    // Left out, it is told, and nothing else is.
    let (_, left, _) = collide(&bodies, CAROM_TORSION_LEFT_OUT);
    assert_eq!(left.warnings & CAROM_WARNING_SPIN_LEFT_ALONE, CAROM_WARNING_SPIN_LEFT_ALONE);
    assert_eq!(left.warnings & CAROM_WARNING_NOT_SETTLED, 0);
}

#[test]
fn an_error_names_the_body_that_is_wrong() {
    for wrong in [0, 1] {
        let mut bodies = bodies();
        bodies[wrong].material.poisson = 0.7;
        let (status, _, error) = collide(&bodies, CAROM_TORSION_AUTO);
        assert_eq!((status, error.index), (CaromStatus::OutOfRange, wrong as i64));
    }
    // Where neither is wrong by itself, neither is named.
    let ball = bodies()[0];
    let mut told = CaromRebound::default();
    // SAFETY: plain numbers.
    let mut error: CaromError = unsafe { zeroed() };
    error.index = -7;
    // SAFETY: all pointers are null or references.
    let status =
        unsafe { carom_collide(&ball, &ball, -0.5, UP.as_ptr(), null(), &mut told, &mut error) };
    assert_eq!((status, error.index), (CaromStatus::OutOfRange, -1));
}
