//! Bodies that lose energy and are no spheres: limits in which another solution is known, and what a history ends in.

use carom_geometry::nalgebra::Vector3;
use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::coupled::TurningLaw;
use carom_impact::{
    Body, Collision, HistoryPoint, ImpactFriction, Motion, NormalRestitution, Rebound,
};
use carom_laws::friction::Friction;
use carom_laws::static_friction::StaticFriction;

fn friction(f: f64) -> Friction {
    Friction::new(f).unwrap()
}

/// An ellipsoid on a plane, turned about this axis.
fn egg(axis: [f64; 2], slip: [f64; 2], friction: impl Into<ImpactFriction>) -> Collision {
    let shape = Surface::ellipsoid([0.01, 0.02, 0.015]).unwrap();
    let steel = Material::from_young(1e9, 0.3).unwrap();
    let inertia = shape.solid(0.01).unwrap();
    let attitude = Attitude::about([axis[0], axis[1], 0.0], 1.2).unwrap();
    let motion = Motion::new([slip[0], slip[1], -0.8], [0.0; 3]).unwrap();
    let body = Body::new(shape, steel, inertia).turned(attitude).moving(motion);
    Collision::new(body, Body::plane(steel), friction).unwrap()
}

fn losing(e: f64, collision: Collision) -> Collision {
    collision.with_normal_restitution(NormalRestitution::new(e).unwrap())
}

fn rebound(collision: &Collision) -> Rebound {
    collision.solve().unwrap().rebound().unwrap().clone()
}

/// Without friction the contact point leaves with e times its speed, wherever the centre is.
#[test]
fn bodies_hit_off_centre_without_friction_lose_what_they_are_told() {
    for e in [0.5, 0.9] {
        let smooth = rebound(&losing(e, egg([0.7, 0.3], [0.3, 0.1], friction(0.0))));
        let before = smooth.contact_velocity_before.z;
        assert!((smooth.contact_velocity_after.z + e * before).abs() < 1e-12);
        let energy = smooth.energy;
        let left = energy.before - energy.after - energy.lost;
        assert!(energy.lost > 0.0 && left.abs() < 1e-12 * energy.before, "{energy:?}");
        let nearly = rebound(&losing(e, egg([0.7, 0.3], [0.3, 0.1], friction(1e-9))));
        let off = (nearly.contact_velocity_after - smooth.contact_velocity_after).norm();
        assert!(off < nearly.error_estimate + 1e-6, "{e}: {off}");
    }
}

/// The last velocity of a history is that of the rebound, and its forces give the impulse.
#[test]
fn histories_of_lossy_bodies_end_in_their_rebound() {
    for axis in [[0.7, 0.0], [0.7, 0.3]] {
        for slip in [[0.0, 0.3], [0.6, -0.4]] {
            let collision = losing(0.5, egg(axis, slip, friction(0.3)));
            let (rebound, history) = (rebound(&collision), collision.history(2001).unwrap());
            let last = history.last().unwrap();
            assert!((last.time - rebound.duration).abs() < 1e-9 * rebound.duration);
            let after = collision.frame().to_space(&last.velocity);
            let speed = rebound.contact_velocity_before.norm();
            assert!((after - rebound.contact_velocity_after).norm() < 1e-12 * speed);
            let pushed: Vector3<f64> = history
                .windows(2)
                .map(|at| 0.5 * (at[1].time - at[0].time) * (at[0].force + at[1].force))
                .sum();
            let off = collision.frame().to_space(&pushed) - rebound.impulse;
            assert!(off.norm() < 2e-3 * rebound.impulse.norm(), "{axis:?} {slip:?}: {off}");
            let moved: Vector3<f64> = history
                .windows(2)
                .map(|at| 0.5 * (at[1].time - at[0].time) * (at[0].velocity + at[1].velocity))
                .sum();
            let off = (moved - last.shift).norm() / rebound.maximal_approach;
            let most = |of: fn(&HistoryPoint) -> f64| history.iter().map(of).fold(0.0, f64::max);
            let deep = most(|at| at.shift.z) / rebound.maximal_approach - 1.0;
            let strong = most(|at| at.force.z) / rebound.maximal_force - 1.0;
            assert!(off.max(deep.abs()) < 1e-5 && strong.abs() < 1e-3, "{off} {deep} {strong}");
        }
    }
}

/// So do those of the law that keeps directions, as far as it is known.
#[test]
fn histories_by_fixed_directions_end_near_their_rebound() {
    let turning = egg([0.7, 0.3], [0.6, -0.4], friction(0.3)).with_law(TurningLaw::FixedDirection);
    let collision = losing(0.5, turning);
    let (rebound, history) = (rebound(&collision), collision.history(201).unwrap());
    let after = collision.frame().to_space(&history.last().unwrap().velocity);
    let off = (after - rebound.contact_velocity_after).norm();
    assert!(off < rebound.error_estimate * rebound.contact_velocity_before.norm(), "{off}");
    assert!((history.last().unwrap().time / rebound.duration - 1.0).abs() < 1e-3);
}

/// A contact that never slides as a whole knows static friction only; one that always slides, kinetic friction.
#[test]
fn static_friction_of_lossy_bodies_is_either_friction() {
    let both = StaticFriction::new(friction(0.8), friction(0.1)).unwrap();
    for law in [TurningLaw::Coulomb, TurningLaw::FixedDirection] {
        for (slip, f) in [([0.02, 0.01], 0.8), ([-3.0, 2.0], 0.1)] {
            let [of_both, of_one] =
                [egg([0.7, 0.3], slip, both), egg([0.7, 0.3], slip, friction(f))]
                    .map(|egg| rebound(&losing(0.5, egg.with_law(law))));
            let off = (of_both.contact_velocity_after - of_one.contact_velocity_after).norm();
            assert!(off < 3e-4, "{law} {slip:?}: {off}");
        }
    }
}

/// Bodies that yield leave with e times the normal speed of elastic ones, and their energies are booked.
#[test]
fn bodies_that_yield_lose_what_they_are_told() {
    for (axis, slip) in [([0.7, 0.3], [0.3, 0.1]), ([0.7, 0.0], [0.0, -0.4])] {
        let yields = NormalRestitution::by_yield(0.6).unwrap();
        let elastic = egg(axis, slip, friction(0.3));
        let yielding = rebound(&elastic.clone().with_normal_restitution(yields));
        let [slow, fast] = [&yielding, &rebound(&elastic)].map(|one| one.contact_velocity_after.z);
        assert!((slow / fast - 0.6).abs() < 1e-9, "{slow} {fast}");
        let energy = yielding.energy;
        let balance = energy.before - energy.after - energy.dissipated - energy.lost;
        assert!(balance.abs() < 1e-12 * energy.before && energy.lost > 0.0, "{energy:?}");
    }
}

/// A relaxation time that is given is that of the impact.
#[test]
fn a_relaxation_time_is_that_of_the_impact() {
    let viscous = NormalRestitution::viscoelastic(3e-6).unwrap();
    let smooth = egg([0.7, 0.3], [0.3, 0.1], friction(0.3)).with_normal_restitution(viscous);
    let viscosity = smooth.impact().unwrap().unwrap().material_viscosity().unwrap().unwrap();
    assert!((viscosity.relaxation() / 3e-6 - 1.0).abs() < 1e-9, "{viscosity:?}");
}

/// An elastic contact bears F at (3/2 F/c_z)^(2/3).
#[test]
fn the_deepest_approach_is_that_of_the_greatest_force() {
    for e in [1.0, 0.6, 0.2] {
        let collision = losing(e, egg([0.7, 0.3], [0.0; 2], friction(0.0)));
        let (force, c_z) = (rebound(&collision).maximal_force, collision.hertz().stiffness().c_z);
        let deepest = collision.impact().unwrap().unwrap().deepest();
        let known = (1.5 * force / c_z).powf(2.0 / 3.0);
        assert!((deepest / known - 1.0).abs() < 1e-6, "{e}: {deepest} {known}");
    }
}

/// A ball that spins about the normal: what a rebound with a loss tells is what the ball has.
#[test]
fn lossy_balls_tell_of_the_spin_and_the_slip_that_they_have() {
    let rubber = Material::from_young(1e7, 0.4).unwrap();
    let (radius, mass, before) = (0.02, 0.03, 80.0);
    let motion = Motion::new([0.3, 0.4, -0.8], [0.0, 0.0, before]).unwrap();
    let ball = Body::sphere(radius, rubber, mass).unwrap().moving(motion);
    let floor = Body::plane(Material::RIGID);
    let collision = Collision::new(ball, floor, friction(0.3)).unwrap().with_torsion();
    for loss in [NormalRestitution::new(0.5).unwrap(), NormalRestitution::by_yield(0.5).unwrap()] {
        let rebound = rebound(&collision.clone().with_normal_restitution(loss));
        let (after, told) = (rebound.motions[0].spin.z, rebound.torsion.unwrap());
        assert!(after > 0.0 && after < 0.99 * before, "{after}");
        assert!((told.spin_ratio * before / after - 1.0).abs() < 1e-9, "{told:?}");
        let momentum = 0.4 * mass * radius * radius * (after - before);
        assert!((told.torque_impulse.abs() + momentum).abs() < 1e-9 * momentum.abs(), "{told:?}");
        let energy = rebound.energy;
        let balance = energy.before - energy.after - energy.dissipated - energy.lost;
        assert!(balance.abs() < 1e-12 * energy.before, "{energy:?}");
        let [one, two] = [rebound.contact_velocity_before, rebound.contact_velocity_after];
        let r_x = -one.xy().dot(&two.xy()) / one.xy().norm_squared();
        assert!((rebound.r_x.unwrap() - r_x).abs() < 1e-9, "{:?} {r_x}", rebound.r_x);
    }
}

/// Static friction that hardly exceeds kinetic friction changes little.
#[test]
fn static_friction_of_lossy_bodies_begins_at_kinetic_friction() {
    for (axis, slip, e) in [([0.7, 0.3], [0.3, 0.1], 0.1), ([0.7, 0.0], [0.0, 0.4], 0.6)] {
        let both = StaticFriction::new(friction(0.3 * (1.0 + 1e-9)), friction(0.3)).unwrap();
        let of_both = rebound(&losing(e, egg(axis, slip, both)));
        let of_one = rebound(&losing(e, egg(axis, slip, friction(0.3))));
        let off = (of_both.contact_velocity_after - of_one.contact_velocity_after).norm();
        assert!(off < 1e-6, "{e}: {off}");
    }
}

/// Bodies that lose all of the normal motion part without it, however they are hit.
#[test]
fn bodies_that_lose_all_do_not_approach_after_the_impact() {
    for (axis, slip) in
        [([0.7, 0.0], [0.0, 0.0]), ([0.7, 0.0], [0.0, -0.4]), ([0.7, 0.3], [0.3, 0.2])]
    {
        for (f, e) in [(1e-6, 0.0), (0.4, 0.0), (1.2, 1e-3)] {
            let rebound = rebound(&losing(e, egg(axis, slip, friction(f))));
            let [before, after] = [rebound.contact_velocity_before, rebound.contact_velocity_after];
            assert!(after.z * before.z < 1e-12, "{axis:?} {slip:?} {f} {e}: {after}");
            assert!(
                e > 0.0 || after.z.abs() < 1e-3 * before.norm(),
                "{axis:?} {slip:?} {f}: {after}"
            );
        }
    }
}

/// Friction without a limit is the limit of great friction, and gives off no heat.
#[test]
fn endless_friction_of_lossy_bodies_is_great_friction() {
    for (axis, slip) in [([0.7, 0.0], [0.0, 0.4]), ([0.7, 0.3], [0.3, 0.2])] {
        let [great, endless] =
            [1e9, f64::INFINITY].map(|f| rebound(&losing(0.4, egg(axis, slip, friction(f)))));
        let off = (great.contact_velocity_after - endless.contact_velocity_after).norm();
        assert!(off < 1e-3 && endless.energy.dissipated < 1e-3 * endless.energy.before, "{off}");
    }
}

/// The heat of friction of a body that hardly loses energy is that of an elastic one.
#[test]
fn heats_of_lossy_bodies_begin_at_those_of_elastic_ones() {
    for (axis, slip) in
        [([0.7, 0.0], [0.0, 0.3]), ([0.7, 0.0], [0.0, -0.4]), ([0.7, 0.3], [0.5, 0.2])]
    {
        for (law, most) in [(TurningLaw::Coulomb, 1e-3), (TurningLaw::FixedDirection, 1e-2)] {
            let elastic = egg(axis, slip, friction(0.5)).with_law(law);
            let lossy = rebound(&losing(0.9999, elastic.clone())).energy;
            let elastic = rebound(&elastic).energy;
            let off = (lossy.dissipated - elastic.dissipated).abs().max(lossy.lost);
            assert!(elastic.dissipated > 1e-3 * elastic.before);
            assert!(off < most * elastic.before, "{axis:?} {slip:?} {law}: {lossy:?} {elastic:?}");
        }
    }
}
