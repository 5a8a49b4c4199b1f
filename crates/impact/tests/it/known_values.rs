//! Moments, tensors, forces and losses whose value follows from a line of mechanics.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_geometry::Inertia;
use carom_halfspace::{Material, MaterialPair};
use carom_impact::oblique::Groups;
use carom_impact::restitution::{RestitutionTensor, of_groups};
use carom_impact::torsional::{SpinCollision, Spinner, TorsionalImpact};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::sliders::SlipLines;
use carom_laws::stiffness::ContactStiffness;

#[test]
fn a_shell_is_a_ball_less_the_ball_inside() {
    let (radius, half) = (0.3_f64, 1e-4);
    let solid = |radius: f64| {
        let mass = 7.0 * radius.powi(3);
        (mass, Inertia::solid_sphere(mass, radius).unwrap().moments()[0])
    };
    let (outer, inner) = (solid(radius * (1.0 + half)), solid(radius * (1.0 - half)));
    let shell = Inertia::spherical_shell(outer.0 - inner.0, radius).unwrap();
    assert_relative_eq!(shell.moments()[0], outer.1 - inner.1, max_relative = 1e-7);
}

#[test]
fn a_tangent_tensor_is_the_slope_of_the_final_velocity() {
    // psi = 2 v_x/v_z; sliding, partial slip and adhesion at first.
    for (chi, x, z) in [(1.4, 1.6, 0.9), (1.44, 0.9, 1.0), (1.44, 0.3, 1.0)] {
        let groups = |x: f64, z: f64| Groups::new(chi, 2.0 * x / z).unwrap();
        let tensor = *RestitutionTensor::tangent(groups(x, z), x / z).unwrap().matrix();
        let after = |x: f64, z: f64| {
            let groups = groups(x, z);
            of_groups(groups.chi(), groups.psi()).unwrap() * x
        };
        let h = 1e-4;
        let by_x = (after(x + h, z) - after(x - h, z)) / (2.0 * h);
        let by_z = (after(x, z + h) - after(x, z - h)) / (2.0 * h);
        assert_abs_diff_eq!(tensor[(0, 0)], by_x, epsilon = 1e-6);
        assert_abs_diff_eq!(tensor[(0, 2)], by_z, epsilon = 1e-6);
    }
}

#[test]
fn rings_that_slide_carry_the_friction_of_the_whole_load() {
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.1).unwrap();
    for zeta in [0.3, 0.93, 1.0] {
        let mut law = SlipLines::new(stiffness, 0.3, 0.05).unwrap();
        law.advance(Shift { zeta, ..Shift::default() }).unwrap();
        let load = law.advance(Shift { zeta, xi: 9.0, ..Shift::default() }).unwrap();
        assert_relative_eq!(load.f_x, 0.3 * load.f_z, max_relative = 1e-13);
    }
}

#[test]
fn the_loss_of_spin_is_what_the_bodies_lose() {
    let body = Material::from_shear(2e9, 0.3).unwrap();
    let curvature = RelativeCurvature::from_coefficients(60.0, 60.0).unwrap();
    let hertz = Hertz::new(curvature, MaterialPair::new(body, body).unwrap()).unwrap();
    let friction = Friction::new(0.2).unwrap();
    let (theta_1, theta_2) = (3e-6, 8e-6);
    let one = Spinner::new(0.1, theta_1).unwrap().spinning(90.0).unwrap();
    let two = Spinner::new(0.3, theta_2).unwrap().spinning(-20.0).unwrap();
    let collision = SpinCollision::new(&hertz, friction, [one, two], 1.5).unwrap();
    let outcome = collision.solve().unwrap();
    let energy = |[a, b]: [f64; 2]| 0.5 * theta_1 * a * a + 0.5 * theta_2 * b * b;
    let lost = energy([90.0, -20.0]) - energy(outcome.spins);
    assert!(lost > 0.0);
    assert_relative_eq!(outcome.energy_loss, lost, max_relative = 1e-9);
    // Only the relative spin is lost from: its energy is that of the reduced moment.
    let impact = TorsionalImpact::new(collision.groups().unwrap().unwrap()).unwrap();
    let relative = 0.5 * (theta_1 * theta_2 / (theta_1 + theta_2)) * 110.0 * 110.0;
    assert_relative_eq!(impact.energy_loss() * relative, lost, max_relative = 1e-9);
}
