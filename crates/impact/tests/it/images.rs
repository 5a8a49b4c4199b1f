//! Impacts under exchanged bodies and turned axes.

#[path = "../../../../testing/image.rs"]
mod image;

use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, Rebound};
use carom_laws::friction::Friction;
use image::Image;

/// A vector of space: the normal is the third axis. The bodies keep their places when they are exchanged.
fn space(image: Image, [x, y, z]: [f64; 3]) -> [f64; 3] {
    if image.turns { [-y, x, z] } else { [x, y, z] }
}

/// A ball of one material above another ball, or above an ellipsoid whose axes differ.
fn rebound(image: Image, is_round: bool, spin: f64) -> ([Motion; 2], Rebound) {
    let [soft, hard] = [(2e7, 0.2), (9e7, 0.4)].map(|(e, nu)| Material::from_young(e, nu).unwrap());
    let turn = |v| space(image, v);
    let upper = Motion::new(turn([0.3, -0.2, -1.0]), turn([9.0, 4.0, spin])).unwrap();
    let lower = Motion::new(turn([0.1, 0.1, 0.2]), turn([-3.0, 8.0, -0.5 * spin])).unwrap();
    let top = Body::sphere(0.02, soft, 0.03).unwrap();
    let bottom = if is_round {
        Body::sphere(0.03, hard, 0.2).unwrap()
    } else {
        let surface = Surface::ellipsoid([0.05, 0.03, 0.04]).unwrap();
        let inertia = surface.solid(0.2).unwrap();
        let angle = if image.turns { std::f64::consts::FRAC_PI_2 } else { 0.0 };
        let attitude = Attitude::about([0.0, 0.0, 1.0], angle).unwrap();
        Body::new(surface, hard, inertia).turned(attitude)
    };
    let height = if is_round { 0.05 } else { 0.06 };
    let top = top.at([0.0, 0.0, height]).unwrap().moving(upper);
    let bottom = bottom.at([0.0; 3]).unwrap().moving(lower);
    let [one, two] = image.bodies([top, bottom]);
    let collision = Collision::touching(one, two, Friction::new(0.25).unwrap()).unwrap();
    let outcome = collision.solve().unwrap();
    let rebound = outcome.rebound().unwrap().clone();
    (image.bodies(rebound.motions), rebound)
}

#[test]
fn impacts_have_no_favourite_body_or_axis() {
    for (is_round, spin) in [(true, 0.0), (true, 60.0), (false, 0.0)] {
        let (first, rebound_1) = rebound(Image::ALL[0], is_round, spin);
        for image in Image::ALL {
            let (other, rebound_2) = rebound(image, is_round, spin);
            for (one, two) in first.iter().zip(&other) {
                let turned = space(image, one.velocity.into());
                let off = (nalgebra::Vector3::from(turned) - two.velocity).norm();
                assert!(off < 1e-9, "{image:?} {is_round} {spin}: {one:?} {two:?}");
            }
            let [one, two] = [rebound_1.maximal_force, rebound_2.maximal_force];
            assert!((one / two - 1.0).abs() < 1e-9, "{image:?}: {one} {two}");
        }
    }
}
