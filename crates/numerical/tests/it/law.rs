//! The choice of the contact law of a collision.

use carom_geometry::Surface;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NeededLaw, Outcome};
use carom_laws::friction::Friction;
use carom_laws::validity::Limit;
use carom_numerical::CollisionLaw;

/// A ball on a plane, by the shear moduli of both, with nu = 0.2 and 0.4.
fn ball(moduli: [f64; 2], poisson: [f64; 2], friction: f64, slip: f64) -> Collision {
    let material = |i: usize| Material::from_shear(moduli[i], poisson[i]).unwrap();
    let ball = Body::sphere(0.01, material(0), 0.03).unwrap();
    let ball = ball.moving(Motion::new([slip, 0.0, -1.0], [0.0; 3]).unwrap());
    Collision::new(ball, Body::plane(material(1)), Friction::new(friction).unwrap()).unwrap()
}

fn r_x(outcome: &Outcome) -> f64 {
    outcome.rebound().unwrap().r_x.unwrap()
}

fn warns(outcome: &Outcome) -> bool {
    let warnings = &outcome.rebound().unwrap().warnings;
    warnings.iter().any(|warning| warning.ratio(Limit::Coupling).is_some())
}

#[test]
fn like_bodies_have_the_same_bits_as_by_the_analytic_law() {
    for (friction, slip) in [(0.0, 0.3), (0.1, 0.0), (0.1, 0.05), (0.3, 2.0), (f64::INFINITY, 1.0)]
    {
        let collision = ball([80e9, 80e9], [0.3, 0.3], friction, slip);
        assert_eq!(collision.coupling_bound(), 0.0);
        assert_eq!(CollisionLaw::Auto.solve(&collision).unwrap(), collision.solve().unwrap());
    }
}

#[test]
fn the_law_changes_where_the_bound_meets_the_tolerance_and_the_result_by_less() {
    // The contrast of the materials is refined until the choice changes.
    let at = |contrast: f64| ball([80e9, 80e9 * (1.0 + contrast)], [0.3, 0.3], 0.2, 0.1);
    let needed = |contrast: f64| at(contrast).needed_law(Collision::NEGLIGIBLE_COUPLING);
    let (mut low, mut high) = (0.0, 3.0);
    assert_eq!([needed(low), needed(high)], [NeededLaw::Analytic, NeededLaw::Rings]);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if needed(middle) == NeededLaw::Analytic { low = middle } else { high = middle }
    }
    let [below, above] =
        [low, high].map(|contrast| CollisionLaw::Auto.solve(&at(contrast)).unwrap());
    assert!(!warns(&below) && !warns(&above));
    let names = [&below, &above].map(|outcome| outcome.rebound().unwrap().method.name());
    assert_eq!(names, ["uncoupled", "rings"]);
    assert!((r_x(&below) - r_x(&above)).abs() < Collision::NEGLIGIBLE_COUPLING);
    // What is neglected stands in the estimate.
    let estimate = below.rebound().unwrap().error_estimate;
    let slip = 0.1 / 1.0_f64.hypot(0.1);
    assert!((estimate / (Collision::NEGLIGIBLE_COUPLING * slip) - 1.0).abs() < 1e-6, "{estimate}");
}

#[test]
fn rings_and_grid_agree_where_the_analytic_law_is_far_off() {
    let collision = ball([40e9, 160e9], [0.2, 0.3], 0.1, 0.05);
    let [auto, rings, grid, analytic] = ["auto", "rings", "numerical", "coulomb"]
        .map(|word| word.parse::<CollisionLaw>().unwrap().solve(&collision).unwrap());
    assert_eq!(auto, rings);
    assert!((r_x(&rings) - r_x(&grid)).abs() < 0.01, "{} {}", r_x(&rings), r_x(&grid));
    assert!((r_x(&rings) - r_x(&analytic)).abs() > 0.05, "{} {}", r_x(&rings), r_x(&analytic));
    assert!(warns(&analytic) && !warns(&rings) && !warns(&grid));
    let bound = collision.coupling_bound();
    assert!((r_x(&grid) - r_x(&analytic)).abs() < bound, "{bound}");
}

#[test]
fn without_friction_coupling_is_nothing() {
    let collision = ball([40e9, 160e9], [0.2, 0.3], 0.0, 0.05);
    assert_eq!(collision.needed_law(0.0), NeededLaw::Analytic);
    assert_eq!(r_x(&CollisionLaw::Auto.solve(&collision).unwrap()), -1.0);
}

#[test]
fn where_friction_hardly_lets_anything_slip_the_analytic_law_is_used_and_warns() {
    for friction in [30.0, f64::INFINITY] {
        let collision = ball([40e9, 160e9], [0.2, 0.3], friction, 1.5);
        let outcome = CollisionLaw::Auto.solve(&collision).unwrap();
        assert_eq!(collision.needed_law(Collision::NEGLIGIBLE_COUPLING), NeededLaw::Analytic);
        assert!(warns(&outcome) && outcome.rebound().unwrap().error_estimate > 0.0);
        assert_eq!(r_x(&outcome), r_x(&collision.solve().unwrap()));
    }
}

/// An ellipsoid of one material on a plane of another.
fn egg(friction: f64) -> Collision {
    let material = |shear, poisson| Material::from_shear(shear, poisson).unwrap();
    let egg = Surface::ellipsoid([0.012, 0.01, 0.009]).unwrap();
    let inertia = egg.solid(0.03).unwrap();
    let egg = Body::new(egg, material(40e9, 0.2), inertia)
        .at([0.0, 0.0, 0.009])
        .unwrap()
        .moving(Motion::new([0.05, 0.02, -1.0], [0.0; 3]).unwrap());
    let plane = Body::plane(material(160e9, 0.3));
    Collision::touching(egg, plane, Friction::new(friction).unwrap()).unwrap()
}

#[test]
fn other_shapes_go_to_the_grid_but_for_infinite_friction() {
    let collision = egg(0.1);
    assert_eq!(collision.needed_law(Collision::NEGLIGIBLE_COUPLING), NeededLaw::Grid);
    let outcome = CollisionLaw::Auto.solve(&collision).unwrap();
    assert_eq!(outcome.rebound().unwrap().method.name(), "numerical");
    assert!(!warns(&outcome));
    let stuck = CollisionLaw::Auto.solve(&egg(f64::INFINITY)).unwrap();
    assert!(warns(&stuck));
    assert!(CollisionLaw::Rings.solve(&egg(0.1)).is_err());
}

#[test]
fn histories_by_rings_begin_at_touch_and_end_at_the_rebound() {
    let collision = ball([40e9, 160e9], [0.2, 0.3], 0.1, 0.05);
    let outcome = CollisionLaw::Auto.solve(&collision).unwrap();
    let rebound = outcome.rebound().unwrap();
    let history = CollisionLaw::Auto.history(&collision, 41).unwrap();
    assert_eq!(history.len(), 41);
    assert_eq!((history[0].time, history[0].velocity), (0.0, collision.velocity()));
    let last = history[40];
    assert!((last.time / rebound.duration - 1.0).abs() < 1e-12);
    let after = rebound.contact_velocity_after;
    let end = collision.frame().to_space(&last.velocity);
    assert!((end - after).norm() < 5e-3 * 0.1, "{end} {after}");
    let peak = history.iter().map(|point| point.force.z).fold(0.0, f64::max);
    assert!((peak / rebound.maximal_force - 1.0).abs() < 0.01);
    assert!(CollisionLaw::Auto.history(&collision, 1).is_err());
}
