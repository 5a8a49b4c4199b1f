//! A given tolerance acts in every law, and what a result leaves out is in its error estimate.

use carom_halfspace::Material;
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionSolver as _, Motion, Rebound, RingImpact,
    TorsionMode, Warning,
};
use carom_laws::friction::Friction;

/// A ball of one material on a plane of another one; the tangential velocity is `lambda` times f, the normal one 1.
fn on_plane([nu, other, stiffer]: [f64; 3], friction: f64, lambda: f64, spin: f64) -> Collision {
    let motion = Motion::new([lambda * friction, 0.0, -1.0], [0.0, 0.0, spin]).unwrap();
    let ball = Body::sphere(1.0, Material::from_shear(2e6, nu).unwrap(), 1.0).unwrap();
    let plane = Body::plane(Material::from_shear(stiffer * 2e6, other).unwrap());
    Collision::new(ball.moving(motion), plane, Friction::new(friction).unwrap()).unwrap()
}

fn rebound(outcome: carom_impact::Outcome) -> Rebound {
    outcome.rebound().unwrap().clone()
}

fn velocity_between(one: &Rebound, other: &Rebound) -> f64 {
    (one.contact_velocity_after - other.contact_velocity_after).norm()
        / one.contact_velocity_before.norm()
}

fn is_told(rebound: &Rebound, asked: f64) -> bool {
    rebound.warnings.iter().any(|warning| {
        matches!(warning, Warning::NotSettled { tolerance, error_estimate }
            if *tolerance == asked && *error_estimate == rebound.error_estimate)
    })
}

/// Unlike spheres by rings: a smaller tolerance gives another answer unless the estimate already met it; answers
/// agree within their estimates, and one that is not met is told.
#[test]
fn rings_refine_to_the_tolerance_of_the_collision() {
    let mut answers = 0;
    for (materials, friction, lambda) in [
        ([0.0, 0.5, 3.0], 0.3, 0.7),
        ([0.1, 0.4, 30.0], 0.15, 2.0),
        ([0.45, 0.2, 0.1], 0.5, 0.3),
        ([0.0, 0.45, 1.0], 0.05, 4.0),
    ] {
        let collision = on_plane(materials, friction, lambda, 0.0);
        let finest = rebound(RingImpact::new(&collision).within(1e-9).unwrap().solve().unwrap());
        let mut last: Option<Rebound> = None;
        for tolerance in [1e-1, 1e-2, 1e-3, 1e-4] {
            let asked = collision.clone().within(tolerance).unwrap();
            let found = rebound(AnalyticOrRings.solve(&asked).unwrap());
            assert_eq!(found.method.name(), "rings");
            let missed = found.error_estimate > tolerance;
            assert_eq!(is_told(&found, tolerance), missed, "{tolerance} {}", found.error_estimate);
            let error = velocity_between(&found, &finest);
            assert!(error <= found.error_estimate + finest.error_estimate, "{error}");
            if let Some(last) = last.filter(|last| last.error_estimate > tolerance) {
                answers += usize::from(velocity_between(&found, &last) > 0.0);
            }
            last = Some(found);
        }
    }
    assert!(answers >= 4, "{answers} refinements");
}

/// The ball spins ever faster about the normal. What R_x changes by that is known from the law that counts the
/// spin; a result without it has an estimate that covers the change, and none is exact.
#[test]
fn a_spin_that_is_left_out_counts_in_the_estimate() {
    for spin in [0.1, 1.0, 5.0, 16.0, 100.0] {
        let collision = on_plane([0.3, 0.3, 1.0], 0.25, 1.4, spin);
        let counted = rebound(RingImpact::new(&collision).solve().unwrap());
        let without = collision.with_torsion_mode(TorsionMode::LeftOut);
        for left in [
            rebound(without.solve().unwrap()),
            rebound(AnalyticOrRings.solve(&without).unwrap()),
            rebound(RingImpact::new(&without).solve().unwrap()),
        ] {
            let error = velocity_between(&left, &counted);
            assert!(
                error < left.error_estimate + counted.error_estimate && left.error_estimate > 0.0,
                "spin {spin}: {error}, estimate {}",
                left.error_estimate
            );
            assert_eq!(left.motions[0].spin.z, spin);
        }
    }
    let exact = rebound(on_plane([0.3, 0.3, 1.0], 0.25, 1.4, 0.0).solve().unwrap());
    assert_eq!(exact.error_estimate, 0.0);
}

/// Coupling that an analytic law neglects is part of its estimate.
#[test]
fn coupling_that_is_left_out_counts_in_the_estimate() {
    for (friction, lambda) in [(0.05, 0.5), (0.1, 2.0), (0.4, 1.0)] {
        let collision = on_plane([0.0, 0.5, 3.0], friction, lambda, 0.0);
        let counted = rebound(RingImpact::new(&collision).solve().unwrap());
        let left = rebound(collision.solve().unwrap());
        let error = velocity_between(&left, &counted);
        assert!(error < left.error_estimate + counted.error_estimate, "{error}");
    }
}
