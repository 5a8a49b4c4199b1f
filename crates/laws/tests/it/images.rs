//! Contact laws under exchanged bodies and turned axes.

#[path = "../../../../testing/image.rs"]
mod image;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::coulomb::Tolerance;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::rings::{self, RingLaw};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;
use image::Image;

const PATH: [[f64; 4]; 6] = [
    [0.6, 0.1, -0.05, 0.0],
    [1.0, 0.3, 0.1, 0.02],
    [0.9, 0.35, -0.4, -0.1],
    [1.1, -0.2, -0.5, 0.15],
    [0.7, -0.6, 0.3, 0.1],
    [0.4, 0.1, 0.2, -0.05],
];

/// F_x, F_y, F_z and M_z of the image after each step of the path, in the first names.
fn followed<L: ContactLaw<Error: std::fmt::Debug>>(
    image: Image,
    unit: f64,
    mut law: L,
) -> Vec<[f64; 4]> {
    let step = |[zeta, xi, eta, omega]: [f64; 4]| {
        let [xi, eta] = image.across([unit * xi, unit * eta]);
        let load = law.advance(Shift { zeta, xi, eta, omega: unit * omega }).unwrap();
        [load.f_x, load.f_y, load.f_z, load.m_z]
    };
    PATH.into_iter().map(step).collect()
}

fn agree(image: Image, first: &[[f64; 4]], other: &[[f64; 4]], tolerance: f64) {
    for (one, two) in first.iter().zip(other) {
        let [x, y] = image.across([one[0], one[1]]);
        for (a, b) in [(x, two[0]), (y, two[1]), (one[2], two[2]), (one[3], two[3])] {
            assert!((a - b).abs() <= tolerance * one[2], "{image:?}: {one:?} {two:?}");
        }
    }
}

#[test]
fn laws_of_shifts_have_no_favourite_body_or_axis() {
    let friction = Friction::new(0.4).unwrap();
    for turning in TurningLaw::ALL {
        let law = |image: Image| {
            let [c_x, c_y] = image.axes([0.7, 0.9]);
            let stiffness = ContactStiffness::new(c_x, c_y, 1.1).unwrap();
            ShiftLaw::<[f64; 2]>::chosen(turning, stiffness, friction, Tolerance::FINE)
        };
        let first = followed(Image::ALL[0], 1.0, law(Image::ALL[0]));
        for image in Image::ALL {
            agree(image, &first, &followed(image, 1.0, law(image)), 1e-12);
        }
    }
}

#[test]
fn the_law_of_rings_has_no_favourite_body_or_axis() {
    let bodies = [(1.0, 0.1), (4.0, 0.45)].map(|(g, nu)| Material::from_shear(g, nu).unwrap());
    let gap = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
    let law = |image: Image| {
        let [one, two] = image.bodies(bodies);
        let hertz = Hertz::new(gap, MaterialPair::new(one, two).unwrap()).unwrap();
        let tolerance = rings::Tolerance::new(1e-6).unwrap();
        RingLaw::<6, 8>::new(&hertz, Friction::new(0.4).unwrap(), tolerance).unwrap()
    };
    let first = followed(Image::ALL[0], 0.5, law(Image::ALL[0]));
    for image in Image::ALL {
        agree(image, &first, &followed(image, 0.5, law(image)), 1e-5);
    }
}
