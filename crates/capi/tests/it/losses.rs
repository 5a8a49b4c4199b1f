//! What the bodies' material takes of an impact: across the border as inside.

use std::mem::zeroed;
use std::ptr::null;

use carom_capi::*;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NormalRestitution, Outcome, Rebound};
use carom_laws::friction::Friction;

const RUBBER: CaromMaterial = CaromMaterial { young_modulus: 20e6, poisson: 0.5 };
const VELOCITY: [f64; 3] = [1.5, -0.4, -2.0];
const SPIN: [f64; 3] = [3.0, 40.0, -5.0];
const UP: [f64; 3] = [0.0, 0.0, 1.0];

fn bodies() -> [CaromBody; 2] {
    // SAFETY: zeros are a solid sphere at rest.
    let [mut ball, mut floor]: [CaromBody; 2] = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass, ball.material) =
        (CAROM_SHAPE_SPHERE, 0.02, 0.03, RUBBER);
    (ball.velocity, ball.spin) = (VELOCITY, SPIN);
    (floor.shape, floor.material) = (CAROM_SHAPE_PLANE, RUBBER);
    [ball, floor]
}

fn collide(loss: u32, e: f64) -> (CaromStatus, CaromRebound, CaromError) {
    let [ball, floor] = bodies();
    // SAFETY: plain numbers.
    let mut error: CaromError = unsafe { zeroed() };
    let mut rebound = CaromRebound { duration: 7.0, ..CaromRebound::default() };
    let (up, place, told) = (UP.as_ptr(), &raw mut rebound, &raw mut error);
    // SAFETY: all pointers are references.
    let status = unsafe { carom_collide_losing(&ball, &floor, 0.3, loss, e, up, place, told) };
    (status, rebound, error)
}

fn inside(restitution: NormalRestitution) -> Rebound {
    let rubber = Material::from_young(20e6, 0.5).unwrap();
    let ball = Body::sphere(0.02, rubber, 0.03).unwrap();
    let ball = ball.moving(Motion::new(VELOCITY, SPIN).unwrap());
    let friction = Friction::new(0.3).unwrap();
    let collision = Collision::along(ball, Body::plane(rubber), UP, friction).unwrap();
    match collision.with_normal_restitution(restitution).solve().unwrap() {
        Outcome::Rebound(rebound) => *rebound,
        Outcome::NoImpact { .. } => unreachable!("they meet"),
    }
}

#[test]
fn losses_are_those_of_the_library_to_the_bit() {
    let cases = [
        (CAROM_LOSS_NONE, f64::NAN, NormalRestitution::ELASTIC),
        (CAROM_LOSS_GIVEN, 1.0, NormalRestitution::ELASTIC),
        (CAROM_LOSS_GIVEN, 0.6, NormalRestitution::new(0.6).unwrap()),
        (CAROM_LOSS_GIVEN, 0.0, NormalRestitution::new(0.0).unwrap()),
        (CAROM_LOSS_BY_WAVES, f64::NAN, NormalRestitution::by_waves()),
    ];
    for (loss, e, restitution) in cases {
        let (status, told, _) = collide(loss, e);
        let known = inside(restitution);
        assert_eq!(status, CaromStatus::Ok);
        let velocities = [told.body_1_velocity, told.body_2_velocity];
        let spins = [told.body_1_spin, told.body_2_spin];
        for (body, motion) in known.motions.iter().enumerate() {
            assert_eq!(velocities[body], <[f64; 3]>::from(motion.velocity), "{loss} {e}");
            assert_eq!(spins[body], <[f64; 3]>::from(motion.spin), "{loss} {e}");
        }
        assert_eq!(told.impulse, <[f64; 3]>::from(known.impulse));
        assert_eq!(Some(told.R_x), known.r_x);
        let budget =
            [told.energy_before, told.energy_after, told.energy_dissipated, told.energy_lost];
        let energy = known.energy;
        assert_eq!(budget, [energy.before, energy.after, energy.dissipated, energy.lost]);
    }
}

#[test]
fn what_is_lost_is_what_is_missing() {
    for e in [1.0, 0.9, 0.5, 0.0] {
        let (_, told, _) = collide(CAROM_LOSS_GIVEN, e);
        let lost = 0.5 * 0.03 * (1.0 - e * e) * 4.0;
        assert!((told.body_1_velocity[2] - 2.0 * e).abs() < 1e-14, "{e}");
        let missing = told.energy_before - told.energy_after - told.energy_dissipated;
        assert!((missing - told.energy_lost).abs() < 1e-12 * told.energy_before, "{e}");
        // Beyond that of the normal motion there is only what the tangential pulse loses alike.
        assert!(told.energy_lost >= lost - 1e-15 && (e < 1.0 || told.energy_lost == 0.0), "{e}");
    }
    // Waves take what the warning of an elastic impact speaks of.
    let (_, elastic, _) = collide(CAROM_LOSS_NONE, 1.0);
    let (_, told, _) = collide(CAROM_LOSS_BY_WAVES, 1.0);
    assert_ne!(elastic.warnings & CAROM_WARNING_WAVE_LOSS, 0);
    assert_eq!(told.warnings & CAROM_WARNING_WAVE_LOSS, 0);
    assert!(told.energy_lost > 0.01 * 0.5 * 0.03 * 4.0 && told.body_1_velocity[2] < 1.995);
}

#[test]
fn an_elastic_call_is_the_plain_one() {
    let [ball, floor] = bodies();
    let mut plain = CaromRebound::default();
    let (up, place) = (UP.as_ptr(), &raw mut plain);
    // SAFETY: all pointers are null or references.
    let status = unsafe { carom_collide(&ball, &floor, 0.3, up, place, std::ptr::null_mut()) };
    assert_eq!((status, plain), (CaromStatus::Ok, collide(CAROM_LOSS_NONE, 0.0).1));
    assert_eq!(plain.energy_lost, 0.0);
}

#[test]
fn wrong_losses_are_named_and_nothing_is_written() {
    let field = |error: &CaromError| {
        let bytes = error.field.iter().take_while(|byte| **byte != 0);
        bytes.map(|byte| char::from(*byte as u8)).collect::<String>()
    };
    for e in [-1e-300, 1.0 + f64::EPSILON, f64::NAN, f64::INFINITY] {
        let (status, rebound, error) = collide(CAROM_LOSS_GIVEN, e);
        assert_eq!(
            (status, field(&error).as_str()),
            (CaromStatus::OutOfRange, "normal_restitution")
        );
        assert_eq!(error.value.to_bits(), e.to_bits());
        assert_eq!(rebound.duration, 7.0);
    }
    let (status, _, error) = collide(3, 0.5);
    assert_eq!((status, field(&error).as_str()), (CaromStatus::OutOfRange, "loss"));
    let [ball, _] = bodies();
    // SAFETY: all pointers are null or references.
    let status = unsafe {
        let (nothing, error) = (std::ptr::null_mut(), std::ptr::null_mut());
        carom_collide_losing(&ball, null(), 0.3, 1, 0.5, null(), nothing, error)
    };
    assert_eq!(status, CaromStatus::NullPointer);
}
