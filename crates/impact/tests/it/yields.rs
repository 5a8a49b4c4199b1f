//! Impacts that yield, against the velocity at which a sphere begins to.

use std::f64::consts::{FRAC_PI_2, PI};

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, Rebound, Warning};
use carom_laws::friction::Friction;
use carom_laws::validity::{Limit, Validity};

const RADIUS: f64 = 0.01;
const MASS: f64 = 7850.0 * 4.0 / 3.0 * PI * RADIUS * RADIUS * RADIUS;

fn steel() -> Material {
    Material::from_young(208e9, 0.3).unwrap()
}

fn fall([ball, floor]: [Material; 2], velocity: f64) -> Rebound {
    let ball = Body::sphere(RADIUS, ball, MASS)
        .unwrap()
        .moving(Motion::new([0.1, 0.0, -velocity], [0.0; 3]).unwrap());
    let friction = Friction::new(0.2).unwrap();
    let collision = Collision::along(ball, Body::plane(floor), [0.0, 0.0, 1.0], friction).unwrap();
    collision.solve().unwrap().rebound().unwrap().clone()
}

fn yields(rebound: &Rebound) -> Option<f64> {
    rebound.warnings.iter().find_map(|warning| warning.ratio(Limit::Yields))
}

/// The velocity at which the greatest pressure of a sphere of steel on steel is p: the energy stored at the approach
/// R (pi p/(2 E*))^2 is (8/15) E* R^3 (pi p/(2 E*))^5.
fn velocity_of(pressure: f64) -> f64 {
    let modulus = 208e9 / (2.0 * (1.0 - 0.3 * 0.3));
    let energy = 8.0 / 15.0 * modulus * RADIUS.powi(3) * (FRAC_PI_2 * pressure / modulus).powi(5);
    (2.0 * energy / MASS).sqrt()
}

#[test]
fn a_steel_ball_yields_from_its_yield_velocity_on() {
    let stress = 1e9;
    let soft = steel().yielding_at(stress).unwrap();
    let velocity = velocity_of(1.6 * stress);
    // Johnson, Contact Mechanics, 11.4: 0.14 m/s for hard steel of 1 GPa.
    assert!((velocity - 0.14).abs() < 0.005, "{velocity}");
    for materials in [[soft, steel()], [steel(), soft], [soft, soft.with_hardness(8e9).unwrap()]] {
        assert_eq!(yields(&fall(materials, 0.999_999 * velocity)), None);
        let beyond = fall(materials, 1.000_001 * velocity);
        let ratio = yields(&beyond).unwrap();
        assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
        // p grows as v^(2/5).
        let fast = fall(materials, 32.0 * velocity);
        assert!((yields(&fast).unwrap() / 4.0 - 1.0).abs() < 1e-12);
        assert_eq!(fast.validity.pressure_over_yield, fast.peak_pressure / (1.6 * stress));
    }
}

#[test]
fn a_ball_of_unknown_strength_does_not_yield() {
    let rebound = fall([steel(); 2], 5.0);
    assert_eq!((yields(&rebound), rebound.validity.pressure_over_yield), (None, 0.0));
}

#[test]
fn the_warning_says_how_far_it_is_from_yield() {
    let validity = Validity { pressure_over_yield: 1.25, ..Validity::default() };
    let told: Vec<String> = Warning::of(validity).map(|warning| warning.to_string()).collect();
    assert_eq!(
        told,
        [
            "yields: the greatest pressure exceeds 1.6 times the yield stress, from which metals flow below the \
          surface: it is 1.25 times that"
        ]
    );
}
