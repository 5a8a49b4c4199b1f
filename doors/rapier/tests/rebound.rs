//! Rebounds by Rapier with carom, against the exact impact.

#[path = "../examples/compare/trial.rs"]
#[allow(dead_code, reason = "the picture uses more of it")]
mod trial;

use carom_rapier::ElasticImpacts;
use rapier3d::glamx::DVec3;
use rapier3d::prelude::*;
use trial::{MASSES, POISSON, RADII, Target, Trial};

const NORMALS: [[f64; 3]; 3] = [[0.0, -1.0, 0.0], [0.48, 0.6, 0.64], [-0.6, 0.0, 0.8]];

fn carom() -> ElasticImpacts {
    ElasticImpacts::new(POISSON).unwrap()
}

/// The largest differences of velocity and spin from the exact impact.
fn largest(trials: impl Iterator<Item = Trial>, hooks: &dyn PhysicsHooks) -> [f64; 2] {
    let mut count = 0;
    let largest = trials.fold([0.0_f64; 2], |largest, trial| {
        let differs = trial.by_rapier(hooks).differs(&trial.exact());
        assert!(differs.iter().all(|part| part.is_finite()), "{trial:?}");
        count += 1;
        std::array::from_fn(|i| largest[i].max(differs[i]))
    });
    assert!(count > 250);
    largest
}

#[test]
fn a_ball_leaves_a_floor_as_in_the_exact_impact() {
    for gap in [1e-3, 0.3, 0.7, 1.5] {
        let [velocity, spin] = largest(Trial::all(Target::Floor, gap), &carom());
        assert!(velocity < 2e-6 && spin < 4e-6, "gap {gap}: {velocity:.1e}, {spin:.1e}");
    }
}

/// Rapier follows a point of the ball, which turns away from the floor. If the ball arrives at the very end of one of
/// Rapier's four parts of a step, slowly and with much spin, it leaves without the impulse of friction or with a part of it.
#[test]
fn wherever_in_a_step_it_arrives_a_ball_seldom_leaves_otherwise() {
    let gaps = (0..50).map(|i| 0.01 + 0.02 * f64::from(i));
    let mut count = 0;
    let mut others = Vec::new();
    for trial in gaps.flat_map(|gap| Trial::all(Target::Floor, gap)) {
        let differs = trial.by_rapier(&carom()).differs(&trial.exact());
        count += 1;
        if differs[0].max(differs[1]) > 1e-5 {
            others.push(trial);
        }
    }
    assert!(others.len() * 500 < count, "{} of {count}", others.len());
    assert!(others.iter().all(|trial| trial.degrees >= 80.0), "{others:?}");
}

#[test]
fn two_balls_that_touch_leave_each_other_as_in_the_exact_impact() {
    for normal in NORMALS {
        let [velocity, spin] = largest(Trial::all(Target::Ball(normal), 1e-3), &carom());
        assert!(velocity < 2e-6 && spin < 2e-4, "{normal:?}: {velocity:.1e}, {spin:.1e}");
    }
}

/// Rapier turns both balls by arms to the middle of the gap. The impulse is right all the same.
#[test]
fn a_gap_between_two_balls_changes_their_spins_alone() {
    for part in [0.1, 0.2] {
        let [velocity, spin] = largest(Trial::all(Target::Ball(NORMALS[1]), part), &carom());
        assert!(velocity < 2e-6 && spin < 0.11 * part, "{part}: {velocity:.1e}, {spin:.1e}");
    }
}

#[test]
fn rapier_alone_is_far_from_the_exact_impact() {
    let [velocity, spin] = largest(Trial::all(Target::Floor, 1e-3), &());
    assert!(velocity > 0.1 && spin > 0.3, "{velocity:.1e}, {spin:.1e}");
}

/// R_x = 0 while it sticks; in sliding Rapier's impulse of friction belongs to the approach alone, without the rebound.
#[test]
fn rapier_alone_sticks_or_slides_by_half() {
    let alone = |degrees| {
        let trial = Trial::plain(degrees, 0.3, 1.0);
        (trial.r_x(&trial.by_rapier(&())), trial.r_x(&trial.exact()))
    };
    let (steep, exact) = alone(40.0);
    assert!(steep.abs() < 2e-4 && exact > 0.3, "{steep} {exact}");
    let (flat, exact) = alone(70.0);
    assert!(((1.0 + exact) / (1.0 + flat) - 2.0).abs() < 1e-4, "{flat} {exact}");
}

#[test]
fn friction_keeps_coulombs_limit() {
    for trial in Trial::all(Target::Floor, 0.5) {
        let after = trial.by_rapier(&carom());
        let [normal, _] = trial.axes();
        let impulse = MASSES[0] * (after.velocities[0] - trial.before()[0]);
        let press = -impulse.dot(normal);
        let drag = (impulse + press * normal).length();
        assert!(drag <= trial.friction * press * (1.0 + 1e-5), "{trial:?}: {drag} {press}");
    }
}

/// A world with gravity and a floor.
fn room() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let floor = ColliderBuilder::cuboid(50.0, 1.0, 50.0).friction(0.4).restitution(0.9);
    world.insert(RigidBodyBuilder::fixed().translation(-Vector::Y), floor);
    world
}

fn hooked(collider: ColliderBuilder) -> ColliderBuilder {
    collider.friction(0.4).restitution(0.9).active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS)
}

/// The motion of a body after some steps.
fn moved(body: RigidBodyBuilder, collider: ColliderBuilder, hooks: &dyn PhysicsHooks) -> RigidBody {
    let mut world = room();
    let (handle, _) = world.insert(body, collider);
    for _ in 0..240 {
        world.step_with_events(hooks, &());
    }
    world.bodies[handle].clone()
}

#[test]
fn a_box_stays_rapiers() {
    let thrown = || {
        RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, 2.0, 0.0))
            .linvel(Vector::new(3.0, 0.0, 1.0))
            .angvel(AngVector::new(1.0, 2.0, 3.0))
    };
    let shape = || hooked(ColliderBuilder::cuboid(0.3, 0.2, 0.1));
    let (with, without) = (moved(thrown(), shape(), &carom()), moved(thrown(), shape(), &()));
    assert_eq!(with.position(), without.position());
    assert_eq!(with.linvel(), without.linvel());
}

#[test]
fn a_ball_that_may_not_turn_stays_rapiers() {
    let thrown = || {
        RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, 2.0, 0.0))
            .linvel(Vector::new(3.0, 0.0, 1.0))
            .lock_rotations()
    };
    let shape = || hooked(ColliderBuilder::ball(0.2));
    let (with, without) = (moved(thrown(), shape(), &carom()), moved(thrown(), shape(), &()));
    assert_eq!(with.linvel(), without.linvel());
}

#[test]
fn a_rolling_ball_rolls_on() {
    let rolling = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, 0.2, 0.0))
        .linvel(Vector::new(1.0, 0.0, 0.0))
        .angvel(AngVector::new(0.0, 0.0, -5.0));
    let after = moved(rolling, hooked(ColliderBuilder::ball(0.2)), &carom());
    assert!((after.linvel().x - 1.0).abs() < 1e-3, "{}", after.linvel());
    assert!((after.angvel().z + 5.0).abs() < 5e-3, "{}", after.angvel());
}

#[test]
fn no_bounce_of_a_ball_with_spin_gains_energy() {
    let mut world = room();
    let thrown = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, 2.0, 0.0))
        .linvel(Vector::new(2.0, 0.0, -1.0))
        .angvel(AngVector::new(10.0, 5.0, 20.0));
    let (ball, _) = world.insert(thrown, hooked(ColliderBuilder::ball(0.2)));
    let (mut before, mut falls, mut bounces) = (0.0, true, 0);
    for _ in 0..600 {
        world.step_with_events(&carom(), &());
        let body = &world.bodies[ball];
        let (rises, energy) = (body.linvel().y > 0.0, body.kinetic_energy());
        if falls && rises {
            assert!(energy <= before, "{energy} after {before}");
            bounces += 1;
        }
        (falls, before) = (!rises, energy);
    }
    assert!(bounces >= 5, "{bounces}");
}

#[test]
fn a_moving_floor_is_a_floor_in_another_frame() {
    let speed = 1.5;
    let throw = |belt: f32| {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::ZERO;
        let floor = RigidBodyBuilder::kinematic_velocity_based()
            .translation(-Vector::Y)
            .linvel(Vector::new(belt, 0.0, 0.0));
        world.insert(floor, hooked(ColliderBuilder::cuboid(50.0, 1.0, 50.0)));
        let thrown = RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, 0.21, 0.0))
            .linvel(Vector::new(1.0 + belt, -3.0, 0.5));
        let (ball, _) = world.insert(thrown, hooked(ColliderBuilder::ball(0.2)));
        for _ in 0..10 {
            world.step_with_events(&carom(), &());
        }
        let body = &world.bodies[ball];
        (body.linvel() - Vector::new(belt, 0.0, 0.0), body.angvel())
    };
    let (rest, moving) = (throw(0.0), throw(speed));
    assert!(rest.0.y > 2.0);
    assert!((rest.0 - moving.0).length() < 1e-4, "{} {}", rest.0, moving.0);
    assert!((rest.1 - moving.1).length() < 1e-3, "{} {}", rest.1, moving.1);
}

#[test]
fn spin_about_the_normal_stays() {
    let trial = Trial { spin: [0.0, 0.0, 0.7], ..Trial::plain(30.0, 0.3, 0.8) };
    let after = trial.by_rapier(&carom());
    let [normal, _] = trial.axes();
    let drill = |spin: DVec3| RADII[0] * spin.dot(normal);
    assert!((drill(after.spins[0]) - drill(trial.before()[1])).abs() < 1e-4);
}

#[test]
fn poissons_ratio_is_checked() {
    for wrong in [-1.0, 0.51, f64::NAN] {
        assert_eq!(ElasticImpacts::new(wrong).unwrap_err().field, "poisson");
    }
}
