//! What an impact tells across the border: the torque's impulse by the change of the spin, and whose body is wrong.

use carom_capi::*;

use crate::losses::{self, UP};
use crate::particles::{Told, collided};

fn bodies() -> [CaromBody; 2] {
    let [mut ball, mut other] = losses::bodies();
    (ball.velocity, ball.spin) = ([0.5, -0.1, -2.0], [3.0, 40.0, -90.0]);
    (other.shape, other.sizes[0], other.mass) = (CAROM_SHAPE_SPHERE, 0.03, 0.05);
    [ball, other]
}

fn collide([one, two]: &[CaromBody; 2], torsion: u32) -> Result<CaromRebound, Told> {
    let law = CAROM_IMPACT_COULOMB;
    let options = CaromCollideOptions { law, torsion, ..CaromCollideOptions::default() };
    collided([one, two], 0.5, Some(&UP), Some(options))
}

#[test]
fn the_impulse_of_the_torque_is_what_the_spin_took() {
    let bodies = bodies();
    let told = collide(&bodies, CAROM_TORSION_INCLUDED).unwrap();
    assert_eq!(told.has_torsion, 1);
    let moment = |body: &CaromBody| 0.4 * body.mass * body.sizes[0] * body.sizes[0];
    let one = moment(&bodies[0]) * (told.body_1_spin[2] - bodies[0].spin[2]);
    let two = moment(&bodies[1]) * (told.body_2_spin[2] - bodies[1].spin[2]);
    assert!((told.torque_impulse / one - 1.0).abs() < 1e-9, "{} {one}", told.torque_impulse);
    assert!((told.torque_impulse / two + 1.0).abs() < 1e-9, "{} {two}", told.torque_impulse);
    let ratio = (told.body_1_spin[2] - told.body_2_spin[2]) / bodies[0].spin[2];
    assert!((told.spin_ratio / ratio - 1.0).abs() < 1e-12);
    // Left out, it is told, and nothing else is.
    let left = collide(&bodies, CAROM_TORSION_LEFT_OUT).unwrap();
    assert_eq!(left.warnings & CAROM_WARNING_SPIN_LEFT_ALONE, CAROM_WARNING_SPIN_LEFT_ALONE);
    assert_eq!(left.warnings & CAROM_WARNING_NOT_SETTLED, 0);
}

#[test]
fn an_error_names_the_body_that_is_wrong() {
    for wrong in [0, 1] {
        let mut bodies = bodies();
        bodies[wrong].material.poisson = 0.7;
        let told = collide(&bodies, CAROM_TORSION_AUTO).unwrap_err();
        assert_eq!((told.status, told.index), (CaromStatus::OutOfRange, wrong as i64));
    }
    // Where neither is wrong by itself, neither is named.
    let ball = bodies()[0];
    let told = collided([&ball, &ball], -0.5, Some(&UP), None).unwrap_err();
    assert_eq!((told.status, told.index), (CaromStatus::OutOfRange, -1));
}
