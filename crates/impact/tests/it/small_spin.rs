//! Torsional impacts with very small spin, compared with the slope at larger ones; the gap beside a plate.

use approx::assert_relative_eq;
use carom_halfspace::Material;
use carom_impact::scene::Wall;
use carom_impact::torsional::{TorsionalGroups, TorsionalImpact, TorsionalPhase, limits};
use carom_laws::friction::Friction;
use nalgebra::Vector3;

#[test]
fn nearly_no_spin_is_on_the_line_to_a_little() {
    let ratio = |omega: f64| {
        TorsionalImpact::new(TorsionalGroups::new(0.4, omega).unwrap()).unwrap().spin_ratio()
    };
    let loss = |omega: f64| limits::first_order_loss(omega).unwrap();
    let cases: [&dyn Fn(f64) -> f64; 2] = [&ratio, &loss];
    for of in cases {
        let (none, little) = (of(0.0), of(1e-3));
        let change = of(5e-7) - none;
        assert!(change != 0.0);
        assert_relative_eq!(change, 5e-4 * (little - none), max_relative = 0.05);
    }
}

#[test]
fn phases_of_a_twist_follow_its_stick_radius() {
    let velocities: Vec<f64> =
        (0..200).map(|i| (std::f64::consts::PI * f64::from(i) / 199.0).cos()).collect();
    let mut slipped = 0;
    for (epsilon, omega) in [(0.4, 1.0), (6.0, 0.8), (20.0, 2.0), (60.0, 0.5)] {
        let groups = TorsionalGroups::new(epsilon, omega).unwrap();
        for point in TorsionalImpact::trace(groups, &velocities).unwrap() {
            match point.phase {
                TorsionalPhase::Adhesion => {
                    assert_relative_eq!(point.stick_radius, point.radius, max_relative = 1e-9);
                }
                TorsionalPhase::PartialSlip => {
                    slipped += 1;
                    assert!(0.0 < point.stick_radius && point.stick_radius < point.radius);
                }
                TorsionalPhase::Sliding => assert_eq!(point.stick_radius, 0.0),
            }
        }
    }
    assert!(slipped > 100);
}

#[test]
fn beside_a_plate_the_gap_is_to_its_edge() {
    let steel = Material::from_young(210e9, 0.3).unwrap();
    let wall = Wall::new([0.0; 3], [0.0, 0.0, 1.0], steel, Friction::new(0.3).unwrap()).unwrap();
    let plate = wall.rectangle([1.0, 0.0, 0.0], [2.0, 1.0]).unwrap();
    let gap = |x: f64, y: f64, z: f64| plate.gap(&Vector3::new(x, y, z), 0.5);
    assert_relative_eq!(gap(1.0, -0.5, 2.0), 1.5, max_relative = 1e-15);
    assert_relative_eq!(gap(5.0, 0.0, 4.0), 4.5, max_relative = 1e-15); // 3, 4, 5
    assert_relative_eq!(gap(4.0, -4.0, -6.0), 6.5, max_relative = 1e-15); // 2, 3, 6, 7
}

/// What is lost of a fast spin or to little friction is next to nothing, and has its digits: by the closed form of
/// sliding. So has what little inertia of the normal motion leaves to adhesion.
#[test]
fn small_losses_have_their_digits() {
    let loss = |epsilon: f64, omega: f64| {
        TorsionalImpact::new(TorsionalGroups::new(epsilon, omega).unwrap()).unwrap().spin_loss()
    };
    for omega in [1e3, 1e6, 1e9, 1e12, 1e15] {
        let sliding = 0.16 * limits::SLIDING_LOSS * 0.0625 / omega;
        assert_relative_eq!(loss(0.0625, omega), sliding, max_relative = 1e-11);
        assert_relative_eq!(
            limits::first_order_loss(omega).unwrap(),
            sliding / 0.0625,
            max_relative = 1e-11
        );
    }
    for epsilon in [1e-6, 1e-12, 1e-20] {
        let stuck = epsilon * limits::SMALL_SPIN_LOSS;
        assert_relative_eq!(loss(epsilon, 0.0), stuck, max_relative = 1e-11 + epsilon);
    }
}
