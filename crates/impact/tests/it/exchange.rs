//! What an impact tells besides its motion: the same, whichever body is named first, and for nearly round contacts.

use carom_geometry::{Attitude, Inertia, Surface};
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, Rebound};
use carom_laws::friction::Friction;

fn ball(radius: f64, young_modulus: f64, mass: f64, velocity: f64) -> Body {
    let material = Material::from_young(young_modulus, 0.3).unwrap();
    let motion = Motion::new([0.0, 0.0, velocity], [0.0, 0.0, velocity]).unwrap();
    Body::sphere(radius, material, mass).unwrap().moving(motion)
}

/// The same impact with either body first.
fn both_ways([above, below]: [Body; 2]) -> [Collision; 2] {
    let friction = Friction::new(0.2).unwrap();
    let along = |one, two, up| Collision::along(one, two, [0.0, 0.0, up], friction).unwrap();
    [along(above.clone(), below.clone(), 1.0), along(below, above, -1.0)]
}

fn solved(collision: &Collision) -> Rebound {
    collision.solve().unwrap().rebound().unwrap().clone()
}

/// A soft and a hard ball: either may be the one that radiates most.
#[test]
fn waves_count_in_both_bodies() {
    let bodies = [ball(0.01, 5e9, 0.005, -30.0), ball(0.02, 7e10, 0.09, 0.0)];
    let [one, other] = both_ways(bodies).map(|collision| solved(&collision).validity);
    assert!(one.wave_share > 0.01, "{one:?}");
    assert!((other.wave_share / one.wave_share - 1.0).abs() < 1e-12, "{one:?} {other:?}");
}

/// A ball whose mass is not spread evenly, turned so that the normal is no principal axis.
#[test]
fn a_coupled_spin_is_that_of_the_body_named() {
    let uneven = Inertia::new(0.09, [1e-5, 1.5e-5, 2e-5]).unwrap();
    let turned = Attitude::about([1.0, 0.5, 0.0], 0.6).unwrap();
    let uneven = ball(0.02, 7e10, 0.09, 0.0).with_inertia(uneven).turned(turned);
    let told = both_ways([ball(0.01, 5e9, 0.005, -1.0), uneven])
        .map(|collision| collision.with_torsion().solve().unwrap_err().to_string());
    assert!(told[0].contains("spin of body 2") && told[1].contains("spin of body 1"), "{told:?}");
}

/// Without tangential velocity R_x has a limit if all tangents are alike: for a sphere, not for what is nearly one.
#[test]
fn only_a_round_contact_has_a_limit_of_restitution() {
    let r_x = |stretch: f64| {
        let steel = Material::from_young(208e9, 0.3).unwrap();
        let surface = Surface::ellipsoid([0.01, 0.01 * stretch, 0.01]).unwrap();
        let inertia = surface.solid(0.03).unwrap();
        let motion = Motion::new([0.0, 0.0, -1.0], [0.0; 3]).unwrap();
        let body = Body::new(surface, steel, inertia).at([0.0, 0.0, 0.01]).unwrap();
        let friction = Friction::new(0.2).unwrap();
        solved(&Collision::new(body.moving(motion), Body::plane(steel), friction).unwrap()).r_x
    };
    // (9.46), of chi = 7/2 (1 - nu)/(1 - nu/2).
    assert!(r_x(1.0).is_some());
    assert_eq!([r_x(1.0 + 1e-6), r_x(1.0 - 1e-4)], [None; 2]);
}
