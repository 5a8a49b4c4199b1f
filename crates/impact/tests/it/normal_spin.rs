//! The spin about the common normal: unchanged, or changed by the torsional impact.

use approx::assert_relative_eq;
use carom_geometry::{Attitude, Inertia, Surface};
use carom_halfspace::Material;
use carom_impact::torsional::{SpinCollision, Spinner};
use carom_impact::{Body, Collision, CollisionError, Motion, NormalSpinError, Rebound};
use carom_laws::friction::Friction;
use carom_laws::validity::Limit;
use nalgebra::{Matrix3, Vector3};

fn rubber() -> Material {
    Material::from_shear(1e6, 0.5).unwrap()
}

fn friction() -> Friction {
    Friction::new(0.4).unwrap()
}

fn ball(radius: f64, mass: f64, velocity: [f64; 3], spin: [f64; 3]) -> Body {
    let motion = Motion::new(velocity, spin).unwrap();
    Body::sphere(radius, rubber(), mass).unwrap().moving(motion)
}

fn solved(collision: &Collision) -> Rebound {
    collision.solve().unwrap().rebound().unwrap().clone()
}

const FIRST: ([f64; 3], [f64; 3]) = ([0.7, 0.2, -2.0], [5.0, 30.0, 80.0]);
const SECOND: ([f64; 3], [f64; 3]) = ([-0.1, 0.3, 0.4], [-20.0, 3.0, -15.0]);

#[test]
fn spin_and_slip_are_those_of_the_two_impacts_by_themselves() {
    let bodies = [ball(0.02, 0.03, FIRST.0, FIRST.1), ball(0.03, 0.1, SECOND.0, SECOND.1)];
    let without = Collision::new(bodies[0].clone(), bodies[1].clone(), friction()).unwrap();
    let without = without.keeping_axes();
    let with = without.clone().with_torsion();
    let (alone, both) = (solved(&without), solved(&with));
    let spinners = [
        Spinner::solid_sphere(0.03, 0.02).unwrap().spinning(80.0).unwrap(),
        Spinner::solid_sphere(0.1, 0.03).unwrap().spinning(-15.0).unwrap(),
    ];
    let spin = SpinCollision::new(with.hertz(), friction(), spinners, 2.4).unwrap();
    let spin = spin.solve().unwrap();
    for i in 0..2 {
        let change = both.motions[i].spin - alone.motions[i].spin;
        assert_eq!(both.motions[i].velocity, alone.motions[i].velocity);
        assert!(change.x == 0.0 && change.y == 0.0);
        assert_relative_eq!(both.motions[i].spin.z, spin.spins[i], max_relative = 1e-12);
    }
    let torsion = both.torsion.unwrap();
    assert!(torsion.spin_ratio > 0.5 && torsion.spin_ratio < 0.99, "{torsion:?}");
    assert_relative_eq!(torsion.dissipated, spin.energy_loss, max_relative = 1e-12);
    assert_eq!(alone.torsion, None);
    assert_eq!(alone.motions[0].spin.z, 80.0);
}

#[test]
fn energy_and_angular_momentum_balance() {
    let bodies = [ball(0.02, 0.03, FIRST.0, FIRST.1), ball(0.03, 0.1, SECOND.0, SECOND.1)];
    let normal = Vector3::new(0.3, -0.5, 1.2).normalize();
    let [one, two] = bodies.clone();
    let collision = Collision::along(one, two, normal.into(), friction()).unwrap();
    let rebound = solved(&collision.with_torsion().keeping_axes());
    assert!(rebound.torsion.unwrap().dissipated > 0.0);
    let energy = rebound.energy;
    let balance = energy.before - energy.after - energy.dissipated;
    assert!(balance.abs() < 1e-13 * energy.before, "{balance:e}");
    // About the contact point.
    let (masses, radii) = ([0.03, 0.1], [0.02, 0.03]);
    let arms = [-radii[0] * normal, radii[1] * normal];
    let turning = |motions: &[Motion; 2]| -> Vector3<f64> {
        (0..2)
            .map(|i| {
                let theta = 0.4 * masses[i] * radii[i] * radii[i];
                theta * motions[i].spin - masses[i] * arms[i].cross(&motions[i].velocity)
            })
            .sum()
    };
    let before = turning(&bodies.map(|body| body.motion()));
    assert!((turning(&rebound.motions) - before).norm() < 1e-14 * before.norm());
}

fn placed(body: &Body, z: f64) -> Body {
    body.clone().at([0.0, 0.0, z]).unwrap()
}

#[test]
fn an_encounter_of_spheres_is_their_collision() {
    let bodies = [ball(0.02, 0.03, FIRST.0, FIRST.1), ball(0.03, 0.1, SECOND.0, SECOND.1)];
    let collision = solved(
        &Collision::new(bodies[0].clone(), bodies[1].clone(), friction()).unwrap().with_torsion(),
    );
    let encounter =
        Collision::touching(placed(&bodies[0], 0.02), placed(&bodies[1], -0.03), friction())
            .unwrap();
    let with = encounter.clone().with_torsion().solve().unwrap();
    let with = with.rebound().unwrap();
    for i in 0..2 {
        let (own, other) = (with.motions[i], collision.motions[i]);
        assert!((own.spin - other.spin).norm() < 1e-10 * other.spin.norm());
        assert!((own.velocity - other.velocity).norm() < 1e-11);
    }
    let energy = with.energy;
    assert!((energy.before - energy.after - energy.dissipated).abs() < 1e-12 * energy.before);
    let waves = |rebound: &Rebound| {
        let shares = rebound.warnings.iter().filter_map(|warning| warning.ratio(Limit::Waves));
        shares.collect::<Vec<_>>()
    };
    assert_relative_eq!(waves(with)[0], waves(&collision)[0], max_relative = 1e-12);
    // Left out, it is said, with a share that is close to the true one.
    let without = encounter.solve().unwrap();
    let mut told = without.rebound().unwrap().warnings.iter();
    let share = told.find_map(|warning| warning.ratio(Limit::Spin));
    let taken = 1.0 - with.torsion.unwrap().spin_ratio;
    assert!(share.unwrap() > taken && share.unwrap() < 2.0 * taken, "{share:?} {taken}");
    assert!(!with.warnings.iter().any(|w| w.ratio(Limit::Spin).is_some()));
}

// A top: an ellipsoid on the end of axis c, turned about it.
fn top(attitude: Attitude, centre: [f64; 3], inertia: Inertia) -> Body {
    let egg = Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap();
    Body::new(egg, rubber(), inertia)
        .turned(attitude)
        .at(centre)
        .unwrap()
        .moving(Motion::new([0.1, 0.2, -2.0], [10.0, 0.0, 90.0]).unwrap())
}

fn egg_inertia() -> Inertia {
    Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap().solid(0.038).unwrap()
}

#[test]
fn an_ellipsoid_on_its_axis_spins_by_itself() {
    let turned = Attitude::about([0.0, 0.0, 1.0], 0.4).unwrap();
    let floor = Body::plane(Material::RIGID);
    let body = top(turned, [0.0, 0.0, 0.015], egg_inertia());
    let encounter = Collision::touching(body.clone(), floor, friction()).unwrap().with_torsion();
    let rebound = encounter.solve().unwrap().rebound().unwrap().clone();
    let torsion = rebound.torsion.unwrap();
    let change = rebound.motions[0].spin.z - 90.0;
    assert_relative_eq!(change, 90.0 * (torsion.spin_ratio - 1.0), max_relative = 1e-10);
    let theta = egg_inertia().moments()[2];
    assert_relative_eq!(torsion.torque_impulse, theta * change, max_relative = 1e-10);
    let energy = rebound.energy;
    assert!((energy.before - energy.after - energy.dissipated).abs() < 1e-12 * energy.before);
}

#[test]
fn coupled_spins_are_refused() {
    let floor = Body::plane(Material::RIGID);
    let tilted = Attitude::about([0.3, 1.0, 0.0], 0.5).unwrap();
    let body = top(tilted, [0.0, 0.0, 0.1], egg_inertia());
    let encounter = Collision::meeting(body, floor, friction()).unwrap();
    assert!(encounter.solve().is_ok());
    let error = encounter.with_torsion().solve().unwrap_err();
    assert!(matches!(error, CollisionError::NormalSpin(NormalSpinError::NormalCoupled)), "{error}");
    // The normal passes through the centre, but is no principal axis.
    for moments in [[1e-5, 2e-5, 2.5e-5], [1e-5, 1.0001e-5, 1.0001e-5]] {
        let skewed = Inertia::new(0.038, moments).unwrap();
        let sphere = Surface::sphere(0.02).unwrap();
        let body = Body::new(sphere, rubber(), skewed)
            .turned(tilted)
            .at([0.0, 0.0, 0.02])
            .unwrap()
            .moving(Motion::new([0.0, 0.0, -1.0], [0.0, 0.0, 50.0]).unwrap());
        let floor = Body::plane(Material::RIGID);
        let encounter = Collision::touching(body, floor, friction()).unwrap();
        let error = encounter.with_torsion().solve().unwrap_err();
        let expected = NormalSpinError::SpinCoupled { body: 1 };
        assert!(matches!(error, CollisionError::NormalSpin(e) if e == expected), "{error}");
    }
}

#[test]
fn a_spin_that_turns_back_fast_is_stepped() {
    // So fast and soft that the ball is pressed flat: epsilon beyond 0.826.
    let soft = Material::from_shear(1e4, 0.0).unwrap();
    let body = |spin: f64| {
        Body::sphere(0.02, soft, 0.0369)
            .unwrap()
            .moving(Motion::new([0.0, 0.0, -1.155], [0.0, 0.0, spin]).unwrap())
    };
    let hit = |spin: f64| {
        Collision::new(body(spin), Body::plane(soft), friction()).unwrap().with_torsion().solve()
    };
    let outcome = hit(26.0).unwrap();
    let torsion = outcome.rebound().unwrap().torsion.unwrap();
    assert!(torsion.error_estimate > 1e-10 && torsion.error_estimate < 0.01, "{torsion:?}");
    assert!(torsion.spin_ratio.abs() < 1.0 && torsion.dissipated > 0.0, "{torsion:?}");
    // Without spin nothing turns back.
    let still = hit(0.0).unwrap();
    assert_eq!(still.rebound().unwrap().torsion.unwrap().spin_ratio, 1.0);
}

#[test]
fn hard_balls_keep_their_spin_without_a_word() {
    let steel = Material::from_shear(80e9, 0.3).unwrap();
    let motion = Motion::new([0.0, 0.0, -0.01], [0.0, 0.0, 10.0]).unwrap();
    let ball = Body::sphere(0.01, steel, 0.0329).unwrap().moving(motion);
    let rebound = solved(&Collision::new(ball, Body::plane(steel), friction()).unwrap());
    assert_eq!(rebound.warnings, []);
}

#[test]
fn bodies_apart_are_brought_together() {
    let floor = || Body::plane(rubber());
    let tilt = Attitude::about([1.0, 0.3, 0.0], 0.7).unwrap();
    let body = |z: f64| top(tilt, [0.4, -0.1, z], egg_inertia());
    let met = Collision::meeting(body(0.5), floor(), friction()).unwrap();
    let down = tilt.to_body(&Vector3::z());
    let height = Vector3::new(0.03 * down.x, 0.02 * down.y, 0.015 * down.z).norm();
    let centre = met.bodies()[0].placed().centre();
    assert_relative_eq!(centre.z, height, max_relative = 1e-11);
    // Straight along its velocity (0.1, 0.2, -2).
    assert_relative_eq!(centre.x, 0.4 + 0.05 * (0.5 - height), max_relative = 1e-11);
    assert_relative_eq!(centre.y, -0.1 + 0.1 * (0.5 - height), max_relative = 1e-11);
    let apart = |error: CollisionError| match error {
        CollisionError::Search(carom_geometry::SearchError::NotTouching { gap, .. }) => gap,
        other => panic!("{other}"),
    };
    let leaving = body(0.5).moving(Motion::new([0.0, 0.0, 1.0], [0.0; 3]).unwrap());
    let gap = apart(Collision::meeting(leaving, floor(), friction()).unwrap_err());
    assert_relative_eq!(gap, 0.5 - height, max_relative = 1e-12);
    assert!(apart(Collision::meeting(body(0.01), floor(), friction()).unwrap_err()) < 0.0);
}

#[test]
fn balls_meet_where_they_should_or_pass() {
    let sphere = |x: f64, velocity: [f64; 3]| {
        let surface = Surface::sphere(1.0).unwrap();
        let inertia = surface.solid(1.0).unwrap();
        Body::new(surface, rubber(), inertia)
            .at([x, 5.0, 0.0])
            .unwrap()
            .moving(Motion::new(velocity, [0.0; 3]).unwrap())
    };
    let target = || sphere(0.0, [0.0, 2.0, 0.0]);
    // Relative to the target it comes straight down the y axis at x = 1.2.
    let coming = |x: f64| {
        let mut body = sphere(x, [0.0, -1.0, 0.0]);
        body = body.at([x, 9.0, 0.0]).unwrap();
        Collision::meeting(body, target(), friction())
    };
    let met = coming(1.2).unwrap();
    // The centres are 2 apart: 1.2 across, 1.6 along.
    assert_relative_eq!(met.bodies()[0].placed().centre().y, 6.6, max_relative = 1e-12);
    assert!(coming(2.1).is_err());
    // Through the hole of a ring, and against its inside.
    let ring = |x: f64| {
        let surface = Surface::torus(3.0, 0.5).unwrap();
        let inertia = surface.solid(1.0).unwrap();
        let ring = Body::new(surface, rubber(), inertia);
        let body = sphere(x, [0.0, 0.0, -1.0]).at([x, 0.0, 4.0]).unwrap();
        Collision::meeting(body, ring, friction())
    };
    assert!(ring(0.0).is_err());
    let met = ring(2.0).unwrap();
    // The tube's centre is 1 away across: sqrt(1.5^2 - 1) above it.
    assert_relative_eq!(met.bodies()[0].placed().centre().z, 1.25_f64.sqrt(), max_relative = 1e-10);
    assert!(met.mobility().matrix() != &Matrix3::identity());
}

#[test]
fn next_to_no_friction_takes_the_spin_of_complete_sliding() {
    // The torque of sliding is (3 pi/16) f F a; a is that of the approach, zeta_max (1 - w^2)^(2/5).
    let (mass, radius, speed, turn) = (0.03, 0.02, 2.0, 80.0);
    let steps = 200_000;
    let w = |i: usize| (2 * i + 1) as f64 / f64::from(steps) - 1.0;
    let shape: f64 =
        (0..steps as usize).map(|i| (1.0 - w(i) * w(i)).powf(0.2)).sum::<f64>() * 2.0 / 2e5;
    let plane = Body::plane(rubber());
    for f in [1e-13, 1e-14, 1e-20, 1e-30] {
        let thrown = ball(radius, mass, [0.3, 0.0, -speed], [0.0, 0.0, turn]);
        let collision = Collision::new(thrown, plane.clone(), Friction::new(f).unwrap()).unwrap();
        let torsion = solved(&collision.with_torsion()).torsion.unwrap();
        let hertz = collision_hertz();
        let spinners = [Spinner::solid_sphere(mass, radius).unwrap(), Spinner::held_fast()];
        let contact = SpinCollision::new(&hertz, friction(), spinners, speed).unwrap();
        let impulse =
            3.0 * std::f64::consts::PI / 16.0 * f * mass * speed * contact.contact_radius() * shape;
        assert_relative_eq!(torsion.torque_impulse.abs(), impulse, max_relative = 1e-5);
        assert!((1.0 - 1e-10..=1.0).contains(&torsion.spin_ratio));
    }
}

fn collision_hertz() -> carom_laws::hertz::Hertz {
    let thrown = ball(0.02, 0.03, [0.0, 0.0, -1.0], [0.0; 3]);
    *Collision::new(thrown, Body::plane(rubber()), friction()).unwrap().hertz()
}
