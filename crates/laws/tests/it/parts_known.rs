//! Quantities of the laws besides the force, each compared with an independent calculation.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_halfspace::{Material, MaterialPair, Point, Traction};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::{EllipsoidalLoad, circular_stress};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Dissipative as _, Shift};
use carom_laws::memory::VectorMemory;
use carom_laws::shift::CattaneoMindlin;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::law::TorsionLaw;
use carom_laws::torsion::lubkin::Lubkin;

/// Presses, slips, reverses.
fn memory() -> VectorMemory {
    let mut memory = VectorMemory::new();
    for (zeta, shift) in
        [(0.6, [0.1, 0.05]), (1.0, [0.2, -0.1]), (1.0, [0.6, 0.1]), (0.9, [0.3, 0.2])]
    {
        memory.advance(zeta, shift).unwrap();
    }
    memory
}

#[test]
fn the_force_below_a_depth_is_that_of_the_contact_at_that_depth() {
    let memory = memory();
    for depth in [0.05, 0.3, 0.45, 0.62, 0.75, 0.88] {
        let below = memory.force_below(depth);
        let sum = memory.superpose(|z| z.min(depth).powf(1.5));
        assert_relative_eq!(below[0], sum[0], max_relative = 1e-12, epsilon = 1e-14);
        assert_relative_eq!(below[1], sum[1], max_relative = 1e-12, epsilon = 1e-14);
    }
    assert_eq!(memory.force_below(2.0), memory.force());
}

#[test]
fn a_memory_moved_as_a_whole_goes_on_as_before() {
    let (mut here, mut there) = (memory(), memory());
    let by = [0.7, -0.4];
    there.translate(by);
    for (zeta, shift) in [(0.85, [0.35, 0.1]), (0.95, [-0.2, 0.1]), (0.5, [0.1, 0.3])] {
        let force = here.advance(zeta, shift).unwrap();
        let moved = there.advance(zeta, [shift[0] + by[0], shift[1] + by[1]]).unwrap();
        assert_abs_diff_eq!(force[0], moved[0], epsilon = 1e-14);
        assert_abs_diff_eq!(force[1], moved[1], epsilon = 1e-14);
    }
}

#[test]
fn the_tangent_of_adhesion_is_the_slope_of_the_force_by_its_end() {
    let (zeta, shift, h) = (1.3, [0.4, 0.35], 1e-6);
    let end = |zeta: f64, shift: [f64; 2]| {
        let mut memory = memory();
        memory.advance(zeta, shift).unwrap();
        memory
    };
    let tangent = end(zeta, shift).tangent();
    let slope = |by: [f64; 3]| {
        let at = |sign: f64| {
            let by = by.map(|by| sign * h * by);
            end(zeta + by[2], [shift[0] + by[0], shift[1] + by[1]]).force()
        };
        let (ahead, behind) = (at(1.0), at(-1.0));
        [0, 1].map(|i| (ahead[i] - behind[i]) / (2.0 * h))
    };
    let (by_x, by_zeta) = (slope([1.0, 0.0, 0.0]), slope([0.0, 0.0, 1.0]));
    for i in 0..2 {
        assert_abs_diff_eq!(tangent.by_shift[i][0], by_x[i], epsilon = 1e-8);
        assert_abs_diff_eq!(tangent.by_approach[i], by_zeta[i], epsilon = 1e-8);
    }
}

#[test]
fn the_tangent_of_sliding_is_the_rate_at_which_it_goes_on() {
    let mut memory = memory();
    memory.advance(1.1, [4.0, 1.0]).unwrap();
    let (tangent, before) = (memory.tangent(), memory.force());
    let h = 1e-7;
    // Ahead and across, while the load grows or falls more slowly than that.
    for [x, y, zeta] in [[1.0, 0.5, 0.0], [1.0, -0.3, 0.4], [0.8, 0.6, -0.7]] {
        let mut next = memory.clone();
        let force = next.advance(1.1 + h * zeta, [4.0 + h * x, 1.0 + h * y]).unwrap();
        for i in 0..2 {
            let [by_x, by_y] = tangent.by_shift[i];
            let rate = by_x * x + by_y * y + tangent.by_approach[i] * zeta;
            assert_abs_diff_eq!((force[i] - before[i]) / h, rate, epsilon = 1e-6);
        }
    }
}

#[test]
fn the_stick_depth_of_a_law_is_a_part_of_its_approach() {
    let stiffness = ContactStiffness::new(0.8, 0.7, 1.3).unwrap();
    let friction = Friction::new(0.4).unwrap();
    let mut law = ShiftLaw::<[f64; 2]>::new(stiffness, friction);
    let (zeta, xi, eta) = (0.03, 0.008, -0.004);
    law.advance(Shift { zeta, ..Shift::default() }).unwrap();
    law.advance(Shift { zeta, xi, eta, ..Shift::default() }).unwrap();
    let known = CattaneoMindlin::new(stiffness, friction).at_shift(zeta, xi, eta).unwrap();
    assert!(!known.is_sliding());
    assert_relative_eq!(law.stick_depth(), known.stick_depth(), max_relative = 1e-12);
}

#[test]
fn the_greatest_shear_is_that_of_the_stresses_found_without_symmetry() {
    let body = Material::from_shear(2.0, 0.2).unwrap();
    let circle = ContactEllipse::circle(1.5).unwrap();
    let load = EllipsoidalLoad::new(circle, body).unwrap();
    let peak = Traction { normal: 1.0, ..Traction::default() };
    for (rho, depth) in [(0.0, 0.6), (1.4, 0.01), (2.0, 0.3), (3.0, 0.02), (1.0, 2.0)] {
        let stress = circular_stress(1.5, 1.0, &body, rho, depth).unwrap();
        let whole = load.stress(peak, Point { x: rho, y: 0.0, z: depth }).unwrap();
        assert_relative_eq!(stress.greatest_shear(), whole.maximum_shear(), max_relative = 1e-10);
    }
}

#[test]
fn a_twisted_contact_tells_its_stick_radius_and_normal_energy() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let curvature = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
    let hertz = Hertz::new(curvature, MaterialPair::new(body, body).unwrap()).unwrap();
    let mut law = TorsionLaw::new(&hertz, Friction::new(0.3).unwrap()).unwrap();
    let zeta = 0.04;
    law.advance(Shift { zeta, ..Shift::default() }).unwrap();
    assert_relative_eq!(law.stored_energy(), hertz.normal_energy(zeta), max_relative = 1e-13);
    let load = law.advance(Shift { zeta, omega: 0.1, ..Shift::default() }).unwrap();
    // Lubkin's solution of this torque, in units of f F_z a.
    let radius = hertz.ellipse(zeta).unwrap().semi_axis_a();
    let lubkin = Lubkin::at_torque(load.m_z / (0.3 * load.f_z * radius)).unwrap();
    assert!(lubkin.stick_radius() < 0.9);
    assert_relative_eq!(law.stick_radius(), lubkin.stick_radius(), max_relative = 1e-9);
}

#[test]
fn no_twist_is_carried_beyond_the_contact() {
    let mut history = TwistHistory::new();
    history.advance(1.0, 0.0).unwrap();
    history.advance(1.0, 0.6).unwrap();
    assert!(history.density(0.9) > 0.0);
    assert_eq!(history.density(1.0), 0.0);
    assert_eq!(history.density(1.5), 0.0);
}

#[test]
fn radii_are_what_a_surface_was_made_of() {
    let radii = PrincipalRadii::new(4.0, -0.5).unwrap();
    assert_eq!(radii.radii(), [4.0, -0.5]);
    assert_eq!(PrincipalRadii::cylinder(8.0).unwrap().radii(), [8.0, f64::INFINITY]);
}
