//! Rebounds by Rapier with carom, against the exact impact.

#[path = "../examples/compare/trial.rs"]
#[allow(dead_code, reason = "the picture uses more of it")]
mod trial;

use carom_rapier::ElasticImpacts;
use rapier3d::glamx::DVec3;
use rapier3d::prelude::*;
use trial::{After, MASSES, POISSON, RADII, Target, Trial};

const NORMALS: [[f64; 3]; 3] = [[0.0, -1.0, 0.0], [0.48, 0.6, 0.64], [-0.6, 0.0, 0.8]];
/// The greatest difference where the material takes something: R_x is from a table that is within 3e-3, and changes the
/// velocities by less.
const TABLE: f64 = 1e-3;
/// And the mean one.
const MEAN: f64 = 1e-4;

fn carom() -> ElasticImpacts {
    ElasticImpacts::new(POISSON).unwrap()
}

/// Differences from the exact impact over the speed of the ball: of velocity and of spin.
#[derive(Debug)]
struct Misses {
    largest: [f64; 2],
    mean: [f64; 2],
}

impl Misses {
    fn of(differences: &[[f64; 2]]) -> Self {
        let of = |part: usize| differences.iter().map(move |d| d[part]);
        Self {
            largest: [0, 1].map(|part| of(part).fold(0.0, f64::max)),
            mean: [0, 1].map(|part| of(part).sum::<f64>() / differences.len() as f64),
        }
    }

    fn are_below(&self, [velocity, spin]: [f64; 2]) -> bool {
        self.largest[0] < velocity && self.largest[1] < spin
    }

    /// Whether they are those of the table with a loss.
    fn are_of_the_table(&self) -> bool {
        self.are_below([TABLE; 2]) && self.mean.iter().all(|part| *part < MEAN)
    }
}

/// Those of throws whose material takes nothing, and of throws whose material does.
fn misses(target: Target, gaps: &[f64], hooks: &dyn PhysicsHooks) -> [Misses; 2] {
    let differs = |(trial, exact): (Trial, After)| {
        let differs = trial.by_rapier(hooks).differs(&exact);
        assert!(differs.iter().all(|part| part.is_finite()), "{trial:?}");
        (trial.is_elastic(), differs)
    };
    let all: Vec<_> = Trial::solved(target, gaps).map(differs).collect();
    assert!(all.len() > 250);
    [true, false].map(|kind| {
        let of_kind = all.iter().filter(|(is_elastic, _)| *is_elastic == kind);
        Misses::of(&of_kind.map(|(_, differs)| *differs).collect::<Vec<_>>())
    })
}

#[test]
fn a_ball_leaves_a_floor_as_in_the_exact_impact() {
    let [elastic, lossy] = misses(Target::Floor, &[1e-3, 0.3, 0.7, 1.5], &carom());
    assert!(elastic.are_below([2e-6, 4e-6]), "{elastic:?}");
    assert!(lossy.are_of_the_table(), "{lossy:?}");
}

/// Rapier follows a point of the ball, which turns away from the floor. If the ball arrives at the very end of one of
/// Rapier's four parts of a step, slowly and with much spin, it leaves without the impulse of friction or with a part of it.
#[test]
fn wherever_in_a_step_it_arrives_a_ball_seldom_leaves_otherwise() {
    let gaps: Vec<_> = (0..50).map(|i| 0.01 + 0.02 * f64::from(i)).collect();
    let mut count = 0;
    let mut others = Vec::new();
    for (trial, exact) in Trial::solved(Target::Floor, &gaps) {
        let differs = trial.by_rapier(&carom()).differs(&exact);
        count += 1;
        if differs[0].max(differs[1]) > if trial.is_elastic() { 1e-5 } else { TABLE } {
            others.push(trial);
        }
    }
    assert!(others.len() * 500 < count, "{} of {count}", others.len());
    assert!(others.iter().all(|trial| trial.degrees >= 80.0), "{others:?}");
}

#[test]
fn two_balls_that_touch_leave_each_other_as_in_the_exact_impact() {
    for normal in NORMALS {
        let [elastic, lossy] = misses(Target::Ball(normal), &[1e-3], &carom());
        assert!(elastic.are_below([2e-6, 2e-4]), "{normal:?}: {elastic:?}");
        assert!(lossy.are_of_the_table(), "{normal:?}: {lossy:?}");
    }
}

/// Rapier turns both balls by arms to the middle of the gap. The impulse is right all the same.
#[test]
fn a_gap_between_two_balls_changes_their_spins_alone() {
    for part in [0.1, 0.2] {
        let [elastic, lossy] = misses(Target::Ball(NORMALS[1]), &[part], &carom());
        assert!(elastic.are_below([2e-6, 0.11 * part]), "{part}: {elastic:?}");
        let is_right = lossy.are_below([TABLE, 0.11 * part + TABLE]) && lossy.mean[0] < MEAN;
        assert!(is_right, "{part}: {lossy:?}");
    }
}

#[test]
fn rapier_alone_is_far_from_the_exact_impact() {
    let both = misses(Target::Floor, &[1e-3], &());
    let [velocity, spin] = [0, 1].map(|part| both[0].largest[part].max(both[1].largest[part]));
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
