//! What an impact on the grid says of itself: its error and its compressions.

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, Rebound};
use carom_laws::friction::Friction;
use carom_numerical::NumericalImpact;

fn collision() -> Collision {
    let material = |shear, poisson| Material::from_shear(shear, poisson).unwrap();
    let ball = Body::sphere(0.01, material(40e9, 0.2), 0.03).unwrap();
    // Far from 1 m/s: an error is a part of the velocity.
    let ball = ball.moving(Motion::new([0.8, 0.3, -16.0], [0.0; 3]).unwrap());
    let plane = Body::plane(material(160e9, 0.3));
    Collision::new(ball, plane, Friction::new(0.1).unwrap()).unwrap()
}

fn rebound(cells: usize, steps: usize) -> Rebound {
    let collision = collision();
    let outcome = NumericalImpact::new(&collision).with(cells, steps).unwrap().solve().unwrap();
    outcome.rebound().unwrap().clone()
}

#[test]
fn the_estimate_is_a_part_of_the_velocity_and_covers_the_change_to_finer_runs() {
    let (coarse, fine) = (rebound(16, 48), rebound(40, 192));
    let change = (fine.contact_velocity_after - coarse.contact_velocity_after).norm();
    let change = change / fine.contact_velocity_before.norm();
    assert!(change > 1e-5, "{change}");
    let estimate = coarse.error_estimate;
    assert!(change < estimate + fine.error_estimate, "{change} {estimate}");
    // Over the velocity of 16 m/s, not over 1 m/s.
    assert!(
        estimate < 3e-3 && fine.error_estimate < estimate,
        "{estimate} {}",
        fine.error_estimate
    );
    // An impact of spheres presses them together once.
    assert_eq!([fine.compressions, coarse.compressions], [1, 1]);
}

/// The tolerance of a collision is a part of the velocity of approach, that of the grid one of f times it.
#[test]
fn the_tolerance_of_a_collision_is_refined_to_over_its_friction() {
    let asked = collision().within(3e-3).unwrap();
    let [asked, given, finer] = [
        NumericalImpact::new(&asked),
        NumericalImpact::new(&collision()).within(3e-2).unwrap(),
        NumericalImpact::new(&collision()).within(3e-3).unwrap(),
    ]
    .map(|impact| impact.solve().unwrap().rebound().unwrap().error_estimate);
    assert!(asked == given && finer < 0.5 * given, "{asked} {given} {finer}");
}

/// A ball that slides throughout has the same changes of velocity at any slip: the estimate, a part of the
/// velocity before, falls as that grows.
#[test]
fn the_estimate_of_an_impact_that_slides_is_a_part_of_its_slip() {
    let errors = [2.0, 4.0, 40.0].map(|slip| {
        let material = |shear, poisson| Material::from_shear(shear, poisson).unwrap();
        let ball = Body::sphere(0.01, material(40e9, 0.2), 0.03).unwrap();
        let ball = ball.moving(Motion::new([slip, 0.0, -1.0], [0.0; 3]).unwrap());
        let plane = Body::plane(material(160e9, 0.3));
        let collision = Collision::new(ball, plane, Friction::new(0.1).unwrap()).unwrap();
        let outcome = NumericalImpact::new(&collision).with(12, 48).unwrap().solve().unwrap();
        let rebound = outcome.rebound().unwrap().clone();
        let before = rebound.contact_velocity_before;
        let change = (rebound.contact_velocity_after - before).norm();
        [rebound.error_estimate * before.norm(), change]
    });
    for [error, change] in errors {
        // The first cells stick for a moment: 6e-5 of the change, 2 % of its estimate.
        assert!((change / errors[0][1] - 1.0).abs() < 1e-4, "{errors:?}");
        assert!((error / errors[0][0] - 1.0).abs() < 0.03, "{errors:?}");
    }
}

/// Where f times coupling is great a step on 64 cells may take a minute: the default refinement ends at 32.
#[test]
fn great_friction_between_unlike_bodies_ends_with_its_estimate() {
    let material = |young, poisson| Material::from_young(young, poisson).unwrap();
    let ball = Body::sphere(0.01, material(10e9, 0.0), 0.01).unwrap();
    let ball = ball.moving(Motion::new([1.0, 0.0, -1.0], [0.0; 3]).unwrap());
    let plane = Body::plane(material(300e9, 0.3));
    let collision = Collision::new(ball, plane, Friction::new(3.0).unwrap()).unwrap();
    let by = |error: f64| {
        let impact = NumericalImpact::new(&collision).within(error).unwrap();
        impact.solve().unwrap().rebound().unwrap().clone()
    };
    let (fine, coarse) = (by(1e-4), by(0.1));
    let apart = (fine.contact_velocity_after - coarse.contact_velocity_after).norm();
    let [told, less] = [&coarse, &fine].map(|it| it.error_estimate * 2.0_f64.sqrt());
    assert!(apart < told + less && less < 0.02 && less < told, "{apart} {told} {less}");
}
