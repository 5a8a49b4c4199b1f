//! Elastic energies compared with the work of the force, by quadrature; power laws compared with
//! their shape.

use approx::assert_relative_eq;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::hertz::Hertz;
use carom_laws::profile::{Hertzian, NormalProfile, PowerLaw, RoundedFlat};
use carom_special::quadrature::{Tolerance, adaptive};

fn work(force: impl Fn(f64) -> f64, approach: f64) -> f64 {
    let tolerance = Tolerance::relative(1e-12).unwrap();
    adaptive(0.0, approach, tolerance, force).unwrap().value
}

#[test]
fn hertz_energy_is_the_work_of_the_force() {
    let body = Material::from_shear(3.0, 0.2).unwrap();
    let curvature = RelativeCurvature::from_coefficients(2.0, 0.3).unwrap();
    let hertz = Hertz::new(curvature, MaterialPair::new(body, body).unwrap()).unwrap();
    for approach in [1e-6, 0.01, 2.5] {
        let expected = work(|zeta| hertz.force(zeta), approach);
        assert_relative_eq!(hertz.normal_energy(approach), expected, max_relative = 1e-11);
    }
    assert_eq!(hertz.normal_energy(-1.0), 0.0);
}

#[test]
fn energy_of_a_rounded_flat_is_the_work_of_its_force() {
    for flat in [0.1, 1.0, 3.0] {
        let profile = RoundedFlat::new(flat).unwrap();
        for approach in [0.01, 0.7, 5.0] {
            let expected = work(|zeta| profile.force(zeta), approach);
            assert_relative_eq!(profile.energy(approach), expected, max_relative = 1e-10);
        }
    }
}

#[test]
fn stiffness_of_a_power_law_grows_as_the_radius_of_its_shape() {
    // The contact radius of z ~ rho^s grows as zeta^(1/s), and the stiffness with it.
    for shape in [0.5, 2.0 / 3.0, 1.0, 2.0, 4.0] {
        let profile = PowerLaw::of_shape(shape).unwrap();
        let growth = profile.stiffness(8.0 * 0.3) / profile.stiffness(0.3);
        assert_relative_eq!(growth, 8.0_f64.powf(1.0 / shape), max_relative = 1e-13);
    }
    let paraboloid = PowerLaw::of_shape(2.0).unwrap();
    assert_relative_eq!(paraboloid.force(0.3), Hertzian.force(0.3), max_relative = 1e-15);
}
