//! Dissipation in the material: the C interface gives the same as the library.

use std::mem::zeroed;
use std::ptr::null;

use carom_capi::*;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, LossCause, Motion, NormalRestitution, Outcome, Rebound};
use carom_laws::friction::Friction;

use crate::particles::{collided, words};

const RUBBER: CaromMaterial =
    CaromMaterial { young_modulus: 20e6, poisson: 0.5, yield_stress: 0.0 };
const VELOCITY: [f64; 3] = [1.5, -0.4, -2.0];
const SPIN: [f64; 3] = [3.0, 40.0, -5.0];
pub(crate) const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// A ball of rubber that falls on a floor of rubber, turning.
pub(crate) fn bodies() -> [CaromBody; 2] {
    // SAFETY: zeros are a solid sphere at rest.
    let [mut ball, mut floor]: [CaromBody; 2] = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass, ball.material) =
        (CAROM_SHAPE_SPHERE, 0.02, 0.03, RUBBER);
    (ball.velocity, ball.spin) = (VELOCITY, SPIN);
    (floor.shape, floor.material) = (CAROM_SHAPE_PLANE, RUBBER);
    [ball, floor]
}

fn usual() -> CaromCollideOptions {
    CaromCollideOptions::default()
}

/// The exact impact, with a loss: its coefficient, or the relaxation time.
fn options(loss: u32, normal_restitution: f64) -> CaromCollideOptions {
    let size = size_of::<CaromCollideOptions>();
    let (law, torsion) = (CAROM_IMPACT_COULOMB, CAROM_TORSION_LEFT_OUT);
    let relaxation = if loss == CAROM_LOSS_VISCOELASTIC { normal_restitution } else { f64::NAN };
    CaromCollideOptions { size, law, loss, normal_restitution, torsion, relaxation, ..usual() }
}

fn collide(loss: u32, e: f64) -> (CaromStatus, CaromRebound, CaromError) {
    let [ball, floor] = bodies();
    // SAFETY: plain numbers.
    let mut error: CaromError = unsafe { zeroed() };
    let mut rebound = CaromRebound { duration: 7.0, ..CaromRebound::default() };
    let (up, place, told) = (UP.as_ptr(), &raw mut rebound, &raw mut error);
    // SAFETY: all pointers are references.
    let status = unsafe { carom_collide(&ball, &floor, 0.3, up, &options(loss, e), place, told) };
    (status, rebound, error)
}

fn by(cause: LossCause) -> NormalRestitution {
    NormalRestitution::by(cause, 0.6).unwrap()
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
        (CAROM_LOSS_VISCOELASTIC, 1e-4, NormalRestitution::viscoelastic(1e-4).unwrap()),
        (CAROM_LOSS_YIELD, 0.6, NormalRestitution::by_yield(0.6).unwrap()),
        (CAROM_LOSS_MAXWELL, 0.6, by(LossCause::Maxwell)),
        (CAROM_LOSS_STANDARD_SOLID, 0.6, by(LossCause::StandardSolid)),
        (CAROM_LOSS_CONSTANT_TANGENT, 0.6, by(LossCause::ConstantLossTangent)),
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
        assert_eq!(told.model_uncertainty, known.model_uncertainty);
        assert_eq!(told.model_uncertainty > 0.0, loss == CAROM_LOSS_GIVEN && e < 1.0, "{loss} {e}");
        let budget =
            [told.energy_before, told.energy_after, told.energy_dissipated, told.energy_lost];
        let energy = known.energy;
        assert_eq!(budget, [energy.before, energy.after, energy.dissipated, energy.lost]);
    }
}

/// The ball of a lossy material that other doors follow too: by springs of another program .15564.
#[test]
fn r_x_with_a_loss_is_known_by_table_and_exactly() {
    for (method, close) in [(CAROM_BY_TABLE, 3e-3), (CAROM_EXACT, 2e-5)] {
        let mut r_x = 0.0;
        // SAFETY: all pointers are references.
        let status =
            unsafe { carom_restitution(1.2, 2.0, 0.5, method, &mut r_x, std::ptr::null_mut()) };
        assert_eq!(status, CaromStatus::Ok);
        assert!((r_x - 0.15564).abs() < close, "{method}: {r_x}");
        for bad in [-0.1, 1.1, f64::NAN] {
            // SAFETY: as above.
            let mut error: CaromError = unsafe { zeroed() };
            // SAFETY: as above.
            let status = unsafe { carom_restitution(1.2, 2.0, bad, method, &mut r_x, &mut error) };
            assert_eq!(status, CaromStatus::OutOfRange);
        }
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
    let [plain, told] =
        [None, Some(usual())].map(|its| collided([&ball, &floor], 0.3, Some(&UP), its).unwrap());
    assert_eq!(plain, told);
    assert_eq!(plain.energy_lost, 0.0);
}

#[test]
fn wrong_losses_are_named_and_nothing_is_written() {
    for e in [-1e-300, 1.0 + f64::EPSILON, f64::NAN, f64::INFINITY] {
        let (status, rebound, error) = collide(CAROM_LOSS_GIVEN, e);
        assert_eq!(
            (status, words(&error.field).as_str()),
            (CaromStatus::OutOfRange, "normal_restitution")
        );
        assert_eq!(error.value.to_bits(), e.to_bits());
        assert_eq!(rebound.duration, 7.0);
    }
    let (status, _, error) = collide(8, 0.5);
    assert_eq!((status, words(&error.field).as_str()), (CaromStatus::OutOfRange, "loss"));
    let [ball, _] = bodies();
    // SAFETY: all pointers are null or references.
    let status = unsafe {
        let (nothing, error) = (std::ptr::null_mut(), std::ptr::null_mut());
        carom_collide(&ball, null(), 0.4, null(), &options(1, 0.5), nothing, error)
    };
    assert_eq!(status, CaromStatus::NullPointer);
}

/// Of a caller with fewer fields the others are what is usual; more than are known are refused.
#[test]
fn options_may_be_shorter_and_not_longer() {
    let [ball, floor] = bodies();
    let mut told = CaromRebound::default();
    let by = |options: &CaromCollideOptions, told: &mut CaromRebound| {
        // SAFETY: all pointers are null or references; no more is read than there is.
        unsafe {
            carom_collide(&ball, &floor, 0.3, UP.as_ptr(), options, told, std::ptr::null_mut())
        }
    };
    let (mut whole, size) = (CaromRebound::default(), size_of::<CaromCollideOptions>());
    assert_eq!(by(&CaromCollideOptions { size, ..usual() }, &mut whole), CaromStatus::Ok);
    assert_eq!(
        by(&CaromCollideOptions { size: 8, ..options(4, f64::NAN) }, &mut told),
        CaromStatus::Ok
    );
    assert_eq!(told, whole);
    for size in [0, 7, size_of::<CaromCollideOptions>() + 1, usize::MAX] {
        let wrong = CaromCollideOptions { size, ..options(0, 1.0) };
        assert_eq!(by(&wrong, &mut told), CaromStatus::OutOfRange);
    }
}

/// Law, tolerance and torsion are those of the library.
#[test]
fn options_choose_law_tolerance_and_torsion() {
    let [mut ball, mut floor] = bodies();
    (ball.material, floor.material) = (
        CaromMaterial { young_modulus: 380e9, poisson: 0.23, yield_stress: 0.0 },
        CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 },
    );
    let by = |its| collided([&ball, &floor], 0.09, Some(&UP), Some(its));
    let solved = |its| by(its).unwrap();
    let usual = usual();
    let rings = solved(CaromCollideOptions { law: CAROM_IMPACT_RINGS, ..usual });
    assert_eq!(solved(usual), rings);
    let fine = solved(CaromCollideOptions { law: CAROM_IMPACT_RINGS, tolerance: 1e-4, ..usual });
    assert!(fine.error_estimate < rings.error_estimate && (fine.R_x - rings.R_x).abs() < 0.01);
    // Rings change the spin about the normal, the others where they are asked to.
    assert_eq!((rings.has_torsion, rings.torque_impulse < 0.0), (1, SPIN[2] > 0.0));
    let alone = solved(CaromCollideOptions { law: CAROM_IMPACT_COULOMB, ..usual });
    assert!(alone.has_torsion == 0 && (alone.R_x - rings.R_x).abs() > 1e-3);
    let twisted = CaromCollideOptions { law: CAROM_IMPACT_FIXED_DIRECTION, torsion: 1, ..usual };
    let twisted = solved(twisted);
    assert_eq!((twisted.has_torsion, twisted.R_x), (1, alone.R_x));
    // A contact that slides along resists a twist less.
    assert!(twisted.torque_impulse > rings.torque_impulse && rings.torque_impulse > 0.0);
    let left = CaromCollideOptions { law: CAROM_IMPACT_RINGS, torsion: 2, ..usual };
    let left = solved(left);
    assert_eq!((left.has_torsion, left.body_1_spin[2]), (0, SPIN[2]));
    let wrong = [
        CaromCollideOptions { law: 4, ..usual },
        CaromCollideOptions { torsion: 3, ..usual },
        CaromCollideOptions { tolerance: -1.0, ..usual },
    ];
    let is_refused = |its| by(its).is_err_and(|told| told.status == CaromStatus::OutOfRange);
    assert!(wrong.into_iter().all(is_refused));
}
