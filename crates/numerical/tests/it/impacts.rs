//! Impacts on a grid and the estimates of their errors: against the exact impact, against rings, against finer grids.

use carom_geometry::{Inertia, Surface};
use carom_halfspace::Material;
use carom_impact::coupled::{Trajectory, TurningLaw};
use carom_impact::normal::NormalImpact;
use carom_impact::{
    Body, Collision, Motion, NormalRestitution, Outcome, Rebound, RingImpact, TorsionMode,
};
use carom_laws::friction::Friction;
use carom_numerical::NumericalImpact;
use carom_solver::NumericalLaw;
use nalgebra::Vector3;

/// Shear modulus and Poisson's ratio.
type Elastic = [f64; 2];

const SOFT: Elastic = [40e9, 0.2];
const HARD: Elastic = [160e9, 0.3];

fn material([shear, poisson]: Elastic) -> Material {
    Material::from_shear(shear, poisson).unwrap()
}

fn ball(bodies: [Elastic; 2], friction: f64, lambda: f64) -> Collision {
    let ball = Body::sphere(0.01, material(bodies[0]), 0.03).unwrap();
    let slip = if friction.is_finite() { lambda * friction } else { lambda };
    let motion = Motion::new([slip, 0.0, -1.0], [0.0; 3]).unwrap();
    let plane = Body::plane(material(bodies[1]));
    Collision::new(ball.moving(motion), plane, Friction::new(friction).unwrap()).unwrap()
}

/// Two ellipsoids that meet off their axes: all couplings of the mobility count.
fn eggs(friction: f64, [along, across]: [f64; 2]) -> Collision {
    let egg = |axes, elastic, motion| {
        let shape = Surface::ellipsoid(axes).unwrap();
        let inertia = shape.solid(0.1).unwrap();
        Body::new(shape, material(elastic), inertia).moving(motion)
    };
    let motion = Motion::new([along, across, -1.0], [5.0, -9.0, 3.0]).unwrap();
    let one = egg([0.03, 0.02, 0.015], SOFT, motion);
    let two = egg([0.02, 0.03, 0.03], HARD, Motion::default());
    Collision::along(one, two, [-0.15, -0.1, 0.98], Friction::new(friction).unwrap()).unwrap()
}

fn rebound(outcome: Outcome) -> Rebound {
    outcome.rebound().unwrap().clone()
}

/// How far the velocity of the contact point is off, over the velocity before, as the estimate.
fn off(one: &Rebound, other: &Rebound) -> f64 {
    let before = one.contact_velocity_before.norm();
    (one.contact_velocity_after - other.contact_velocity_after).norm() / before
}

#[test]
fn alike_spheres_rebound_exactly_within_the_estimate() {
    for (friction, lambda) in [(0.05, 0.2), (0.1, 1.5), (0.3, 4.0), (0.5, 9.0)] {
        let collision = ball([SOFT, SOFT], friction, lambda);
        let exact = rebound(collision.solve().unwrap());
        let grid = rebound(NumericalImpact::new(&collision).solve().unwrap());
        let (off, estimate) = (off(&grid, &exact), grid.error_estimate);
        assert!(off <= estimate && estimate < 0.011, "{friction} {lambda}: {off} {estimate}");
        assert!((grid.maximal_approach / exact.maximal_approach - 1.0).abs() < 2e-3);
        // Few cells at the edge of the contact: its area is uneven.
        assert!((grid.maximal_force / exact.maximal_force - 1.0).abs() < 3e-3);
    }
}

#[test]
fn unlike_spheres_rebound_as_by_rings_within_both_estimates() {
    for (friction, lambda) in [(0.05, 0.4), (0.1, 0.5), (0.2, 2.0), (0.3, 3.0)] {
        let collision = ball([SOFT, HARD], friction, lambda);
        let rings = RingImpact::new(&collision).within(1e-3).unwrap();
        let rings = rebound(rings.solve().unwrap());
        let grid = rebound(NumericalImpact::new(&collision).solve().unwrap());
        let (off, estimate) = (off(&grid, &rings), grid.error_estimate);
        let allowed = estimate + rings.error_estimate;
        assert!(off <= allowed && estimate < 0.011, "{friction} {lambda}: {off} {allowed}");
    }
}

/// The velocity of the contact point after the impact of two eggs, in space, by 48 cells in 256 steps. 32 cells in 256 or
/// 128 steps give the same to 1e-4.
struct Egg {
    friction: f64,
    slip: [f64; 2],
    after: [f64; 3],
}

const EGGS: [Egg; 3] = [
    Egg { friction: 0.1, slip: [0.05, 0.02], after: [0.174_206, 0.121_976, -0.903_555] },
    Egg { friction: 0.3, slip: [-0.3, 0.4], after: [0.008_087, 0.308_359, -0.896_228] },
    Egg { friction: 0.2, slip: [0.9, -0.2], after: [0.325_754, 0.056_343, -0.996_126] },
];

#[test]
fn unlike_ellipsoids_rebound_as_on_finer_grids_within_the_estimate() {
    for Egg { friction, slip, after } in &EGGS {
        let collision = eggs(*friction, *slip);
        let velocity = collision.impact().unwrap().unwrap().velocity();
        let speed = velocity.z;
        let mut last = f64::INFINITY;
        for tolerance in [1e-2, 4e-3] {
            let grid = NumericalImpact::new(&collision).within(tolerance).unwrap();
            let grid = rebound(grid.solve().unwrap());
            let off = (grid.contact_velocity_after - Vector3::from(*after)).norm();
            let before = grid.contact_velocity_before.norm();
            // Beside what the spin about the normal may change, which the grid leaves out.
            let by_spin = grid.validity.spin_on_shift * velocity.xy().norm();
            let estimate = grid.error_estimate * before - by_spin;
            assert!(off <= estimate + 5e-4 * friction * speed, "{friction}: {off} {estimate}");
            assert!(estimate <= tolerance * speed * (1.0 + friction), "{friction}: {estimate}");
            assert!(off < 5e-3 * friction * speed, "{friction}: {off} {grid:?}");
            assert!(estimate <= last);
            last = estimate;
        }
    }
}

/// The tangential velocity after the impact of two eggs in so many steps, over f times that of approach.
fn followed(egg: &Egg, steps: usize, slip_ahead: bool) -> Vector3<f64> {
    let collision = eggs(egg.friction, egg.slip);
    let (hertz, velocity) = (*collision.hertz(), collision.impact().unwrap().unwrap().velocity());
    let mobility = *collision.mobility().matrix();
    let normal = NormalImpact::new(mobility.m33, hertz.stiffness().c_z, velocity.z).unwrap();
    let friction = Friction::new(egg.friction).unwrap();
    let law = NumericalLaw::new(hertz, friction, normal.maximal_approach(), 12).unwrap();
    let law = law.within(1e-6).unwrap();
    let mut law = if slip_ahead { law.with_slip_ahead() } else { law };
    let (stiffness, expected) = (hertz.stiffness(), Some(normal.duration()));
    let trajectory = Trajectory { mobility, velocity, stiffness, steps, expected };
    let end = trajectory.follow(&mut law, |_, _| ()).unwrap().unwrap();
    Vector3::new(end.velocity.x, end.velocity.y, 0.0) / (egg.friction * velocity.z)
}

#[test]
fn slip_taken_ahead_makes_few_steps_as_good_as_many() {
    for egg in &EGGS {
        let limit = followed(egg, 512, true);
        let [plain, ahead] =
            [false, true].map(|slip_ahead| (followed(egg, 64, slip_ahead) - limit).norm());
        assert!(ahead < 6e-3 && plain > 2.0 * ahead, "{}: {plain} {ahead}", egg.friction);
        // Both have the same limit.
        assert!((followed(egg, 512, false) - limit).norm() < 0.3 * plain);
    }
}

#[test]
fn friction_and_energy_bound_what_is_extrapolated() {
    for friction in [0.02, 0.3, 1.5] {
        let collision = eggs(friction, [1.0, -0.7]);
        let found = rebound(NumericalImpact::new(&collision).with(8, 16).unwrap().solve().unwrap());
        let normal = found.impulse.dot(&collision.frame().z());
        let tangential = (found.impulse - collision.frame().z() * normal).norm();
        assert!(tangential <= friction * normal.abs() * (1.0 + 1e-12));
        assert!(found.energy.after <= found.energy.before * (1.0 + 1e-12));
    }
}

#[test]
fn a_tolerance_out_of_range_is_refused() {
    let collision = ball([SOFT, HARD], 0.1, 1.0);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = NumericalImpact::new(&collision).within(tolerance).unwrap_err();
        assert_eq!(error.field, "tolerance");
    }
    assert_eq!(NumericalImpact::new(&collision).with(7, 40).unwrap_err().field, "cells");
    assert_eq!(NumericalImpact::new(&collision).with(8, 15).unwrap_err().field, "steps");
    assert!(NumericalImpact::new(&ball([SOFT, HARD], f64::INFINITY, 1.0)).solve().is_err());
    assert!(NumericalImpact::new(&collision).history(1).is_err());
}

/// Where few steps are far off more of them are taken, and the estimate falls with what they still change.
#[test]
fn an_estimate_falls_as_steps_are_refined() {
    let (collision, tolerance) = (ball([SOFT, SOFT], 1.0, 4.0), 2e-3);
    let exact = rebound(collision.solve().unwrap());
    let grid = NumericalImpact::new(&collision).within(tolerance).unwrap();
    let grid = rebound(grid.solve().unwrap());
    // The tolerance holds for the tangential velocity over f v_z and for the normal one over v_z, both 1 m/s here.
    let estimate = grid.error_estimate * grid.contact_velocity_before.norm();
    assert!(estimate <= tolerance * f64::sqrt(2.0), "{estimate}");
    assert!(off(&grid, &exact) <= grid.error_estimate, "{}", off(&grid, &exact));
}

/// A ball without lateral contraction on an almost rigid plane, f = 1: what spreading surfaces do to cells that come
/// into contact shows in no change by cells or by steps. 24 cells and 128 steps are within 8e-4 of 56 and 224.
#[test]
fn a_strongly_coupled_impact_is_within_its_estimate() {
    let collision = ball([[1e9, 0.0], [1e12, 0.3]], 1.0, 0.8);
    let [coarse, fine] = [64, 128].map(|steps| {
        let grid = NumericalImpact::new(&collision).with(24, steps).unwrap();
        rebound(grid.solve().unwrap())
    });
    let (off, estimate) = (off(&coarse, &fine), coarse.error_estimate);
    assert!(off > 4e-3 && off + 8e-4 < estimate, "{off} {estimate}");
}

/// What friction takes is what it takes in the impact whose solution is known; nothing without friction.
#[test]
fn friction_heat_of_lossy_bodies_is_that_of_the_exact_impact() {
    let lossy = |bodies, (friction, slip, e): (f64, f64, f64)| {
        let lambda = if friction > 0.0 { slip / friction } else { slip };
        let restitution = NormalRestitution::new(e).unwrap();
        let collision = ball(bodies, friction, lambda).with_normal_restitution(restitution);
        let known = rebound(collision.solve().unwrap());
        let most = friction * known.impulse.z.abs() * slip;
        let grid = rebound(NumericalImpact::new(&collision).solve().unwrap());
        (grid.energy.dissipated, known.energy.dissipated, most)
    };
    for case in [(0.0, 1.0, 0.3), (0.1, 3.0, 0.0), (0.3, 1.0, 0.3)] {
        let (heat, known, most) = lossy([SOFT, SOFT], case);
        assert!((heat - known).abs() <= 0.02 * most, "{case:?}: {heat}, {known}");
    }
    let (heat, known, most) = lossy([SOFT, HARD], (0.1, 3.0, 0.0));
    assert!((heat - known).abs() <= 0.05 * most, "{heat}, {known} without coupling");
}

/// Like bodies that lose energy have the exact velocity within their estimate, of which the law in steps takes the most.
#[test]
fn the_estimate_of_lossy_bodies_holds_the_error_of_the_step_law() {
    for (lambda, e) in [(1.0, 0.1), (0.3, 0.1), (1.0, 0.5)] {
        let restitution = NormalRestitution::new(e).unwrap();
        let collision = ball([SOFT, SOFT], 0.3, lambda).with_normal_restitution(restitution);
        let known = rebound(collision.solve().unwrap());
        let grid = NumericalImpact::new(&collision).with(16, 128).unwrap();
        let solved = rebound(grid.solve().unwrap());
        let (off, told) = (off(&solved, &known), solved.error_estimate);
        assert!(off <= told && told < 6e-3, "{lambda} {e}: {off} {told}");
    }
}

/// Both laws of turning slip are within their estimate of the grid, which the change by finer steps alone does not tell.
#[test]
fn the_laws_of_turning_slip_hold_their_distance_from_the_grid() {
    for (friction, moments, slip, poisson, e) in [
        (0.23, [7.3, 3.2, 6.4], [0.68, 0.82], 0.0, 1.0),
        (0.24, [5.5, 9.0, 7.9], [0.55, 0.60], 0.15, 1.0),
        (0.25, [11.4, 5.6, 9.3], [0.79, 0.30], 0.3, 1.0),
        (0.20, [7.3, 4.8, 11.1], [0.40, 0.73], 0.0, 0.8),
    ] {
        let bodies = material([28e9, poisson]);
        let inertia = Inertia::new(0.01, moments.map(|moment| 1e-7 * moment)).unwrap();
        let ball = Body::new(Surface::sphere(0.01).unwrap(), bodies, inertia);
        let ball = ball.moving(Motion::new([slip[0], slip[1], -1.0], [0.0; 3]).unwrap());
        let collision = Collision::new(ball, Body::plane(bodies), Friction::new(friction).unwrap());
        let collision = collision.unwrap().with_torsion_mode(TorsionMode::LeftOut);
        let collision = collision.with_normal_restitution(NormalRestitution::new(e).unwrap());
        let grid = NumericalImpact::new(&collision).with(20, 96).unwrap();
        let grid = rebound(grid.solve().unwrap());
        for law in TurningLaw::ALL {
            let found = rebound(collision.clone().with_law(law).solve().unwrap());
            let (off, told) = (off(&found, &grid), found.error_estimate);
            assert!(off < told + grid.error_estimate, "{law} {friction} {e}: {off} {told}");
            assert!(e < 1.0 || off > 1e-3, "{law} {friction}: {off}");
            assert!(told < 10.0 * off.max(1e-3), "{law} {friction} {e}: {off} {told}");
        }
    }
}
