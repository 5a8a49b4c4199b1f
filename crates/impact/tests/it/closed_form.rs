//! The closed forms of section 9.2 against reference values and the exact impact.

use carom_geometry::{Attitude, Inertia};
use carom_halfspace::{Material, MaterialPair};
use carom_impact::closed_form::{
    AdhesiveCompression, ImpactConstants, compression_time, normal_energy_loss, phi,
    restitution_in_sliding, tangential_energy_loss,
};
use carom_impact::normal::{self, NormalImpact, compression};
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::{Lever, Mobility};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;
use carom_special::hypergeometric::UnitArgument;
use carom_special::quadrature::GaussLegendre;
use nalgebra::{Matrix3, Vector3};

use crate::data::{number, rows};

#[test]
fn time_of_s() {
    for row in rows("t_of_S") {
        let s = UnitArgument::new(number(&row, "S")).unwrap();
        let error = (compression_time(s).unwrap() - number(&row, "t_N")).abs();
        assert!(error < 4e-15, "{row} {error:e}");
    }
}

#[test]
fn adhesive_velocity_and_shift() {
    for row in rows("hypergeometric") {
        let chi = number(&row, "chi");
        assert!((phi(chi) / number(&row, "phi") - 1.0).abs() < 1e-15, "{row}");
        let motion = AdhesiveCompression::new(chi).unwrap();
        let s = UnitArgument::new(number(&row, "S")).unwrap();
        let velocity = number(&row, "F((1-phi)/20,(1+phi)/20;3/5;S)");
        assert!((motion.velocity(s).unwrap() - velocity).abs() < 3e-13, "{row}");
        let shift = number(&row, "3F2(2/5,(11-phi)/20,(11+phi)/20;7/5,3/5;S)");
        let expected = s.value().powf(0.4) * shift;
        assert!((motion.shift(s).unwrap() - expected).abs() < 1e-13, "{row}");
    }
}

#[test]
fn series_about_maximal_compression() {
    for chi in [0.7, 1.0, 2.9, 3.5, 6.5] {
        let motion = AdhesiveCompression::new(chi).unwrap();
        for s in [0.5, 0.6, 0.9, 0.999, 1.0] {
            let s = UnitArgument::new(s).unwrap();
            let exact = motion.shift(s).unwrap();
            let error = |terms| (motion.shift_by_series(s, terms).unwrap() - exact).abs();
            assert!(error(25) < 1e-9, "{chi} {s:?} {:e}", error(25));
            assert!(error(45) < 2e-13, "{chi} {s:?} {:e}", error(45));
        }
    }
}

#[test]
fn a_mobility_ratio_that_is_none_is_refused() {
    for chi in [0.0, -1.0, f64::NAN] {
        let error = AdhesiveCompression::new(chi).unwrap_err().to_string();
        assert!(error.contains("chi"), "{error}");
    }
}

#[test]
fn the_exact_impact_starts_with_it() {
    let (chi, w) = (3.5, [0.9, 0.6, 0.4]);
    let trace = ObliqueImpact::trace(Groups::new(chi, 0.3).unwrap(), &w).unwrap();
    let motion = AdhesiveCompression::new(chi).unwrap();
    for (point, w) in trace.iter().zip(w) {
        let s = UnitArgument::new(compression(w).powf(2.5)).unwrap();
        assert!((point.velocity - motion.velocity(s).unwrap()).abs() < 1e-12);
        assert!((point.shift - motion.shift(s).unwrap()).abs() < 1e-12);
    }
}

/// The stiffnesses of a round contact from the displacements under point loads, by quadrature.
struct ByQuadrature {
    c_x: f64,
    c_z: f64,
}

impl ByQuadrature {
    /// For the gap r^2/(2 R): a contact of radius 1 under the pressure p0 sqrt(1 - r^2).
    fn new(radius: f64, materials: [Material; 2]) -> Self {
        let rule = GaussLegendre::new(60).unwrap();
        let turn = 2.0 * std::f64::consts::PI;
        let normal: f64 = materials.iter().map(|m| (1.0 - m.poisson()) / m.shear_modulus()).sum();
        // A force p dA sinks the surface at the distance s by (1 - nu)/(2 pi G s) p dA; dA = s ds dt.
        let sinks = |x: f64| {
            let along = |t: f64| {
                let (sin, cos) = t.sin_cos();
                let chord = (1.0 - x * x * sin * sin).sqrt();
                // s = chord sin q - x cos t, so that the pressure is chord cos q.
                let start = (x * cos / chord).asin();
                let half = 0.5 * std::f64::consts::PI;
                rule.integrate(start, half, |q| (chord * q.cos()).powi(2))
            };
            normal / turn * rule.integrate(0.0, turn, along)
        };
        // u(0) - u(1/2) closes the gap.
        let pressure = 0.125 / radius / (sinks(0.0) - sinks(0.5));
        let approach = pressure * sinks(0.0);
        let force = pressure * turn / 3.0;
        let c_z = 1.5 * force / approach.powf(1.5);
        // The traction (1 - r^2)^(-1/2) moves the surface alike; at the centre by
        // sum (1 - nu + nu cos^2 t)/(2 pi G) int dr dt/sqrt(1 - r^2), under the force 2 pi.
        let shift: f64 = materials
            .iter()
            .map(|m| {
                let by_angle = rule.integrate(0.0, turn, |t| {
                    (1.0 - m.poisson() + m.poisson() * t.cos().powi(2)) / m.shear_modulus()
                });
                by_angle / turn * 0.25 * turn
            })
            .sum();
        Self { c_x: turn / shift / approach.sqrt(), c_z }
    }
}

fn two_materials() -> [Material; 2] {
    [Material::from_shear(2.0, 0.45).unwrap(), Material::from_shear(3.0, 0.1).unwrap()]
}

#[test]
fn constants_of_spheres() {
    let (masses, radii, materials) = ([0.3, 0.5], [0.7, 1.1], two_materials());
    let constants = ImpactConstants::of_spheres(masses, radii, materials).unwrap();
    let quadrature = ByQuadrature::new(1.0 / (1.0 / 0.7 + 1.0 / 1.1), materials);
    assert!((constants.c_z / quadrature.c_z - 1.0).abs() < 1e-12, "{:e}", quadrature.c_z);
    assert!((constants.c_x / quadrature.c_x - 1.0).abs() < 1e-12, "{:e}", quadrature.c_x);
    let lever = |i: usize, arm: f64| {
        let ball = Inertia::solid_sphere(masses[i], radii[i]).unwrap();
        Lever::new(ball, &Attitude::ALIGNED, arm * Vector3::z()).unwrap()
    };
    let mobility =
        Mobility::new(&[lever(0, -radii[0]), lever(1, radii[1])], &Matrix3::identity()).unwrap();
    let diagonal = Vector3::new(constants.d_xx, constants.d_yy, constants.d_zz);
    assert!((mobility.matrix() - Matrix3::from_diagonal(&diagonal)).amax() < 1e-14);
    assert!(ImpactConstants::of_spheres([0.0, 1.0], radii, materials).is_err());
    assert!(ImpactConstants::of_spheres([f64::INFINITY; 2], radii, materials).is_err());
    assert!(ImpactConstants::of_spheres(masses, [f64::INFINITY; 2], materials).is_err());
    assert!(ImpactConstants::of_spheres(masses, radii, [Material::RIGID; 2]).is_err());
}

#[test]
fn constants_of_crossed_cylinders() {
    let (radius, materials) = (0.8, two_materials());
    // Body 1 lies along x, body 2 along y.
    let (one, two) =
        (Inertia::new(2.0, [0.64, 3.0, 3.0]).unwrap(), Inertia::new(5.0, [7.0, 1.6, 7.0]).unwrap());
    let constants = ImpactConstants::of_crossed_cylinders([one, two], radius, materials).unwrap();
    let quadrature = ByQuadrature::new(radius, materials);
    assert!((constants.c_z / quadrature.c_z - 1.0).abs() < 1e-12);
    assert!((constants.c_x / quadrature.c_x - 1.0).abs() < 1e-12);
    let cylinder = PrincipalRadii::cylinder(radius).unwrap();
    let right = std::f64::consts::FRAC_PI_2;
    let gap = RelativeCurvature::new(cylinder, cylinder, right).unwrap();
    let pair = MaterialPair::new(materials[0], materials[1]).unwrap();
    let stiffness = Hertz::new(gap, pair).unwrap().stiffness();
    assert!((constants.c_z / stiffness.c_z - 1.0).abs() < 1e-12);
    assert!((constants.c_x / stiffness.c_x - 1.0).abs() < 1e-12);
    let lever = |inertia: Inertia, arm: f64| {
        Lever::new(inertia, &Attitude::ALIGNED, arm * Vector3::z()).unwrap()
    };
    let mobility =
        Mobility::new(&[lever(one, -radius), lever(two, radius)], &Matrix3::identity()).unwrap();
    let diagonal = Vector3::new(constants.d_xx, constants.d_yy, constants.d_zz);
    assert!((mobility.matrix() - Matrix3::from_diagonal(&diagonal)).amax() < 1e-14);
    assert!(constants.d_xx != constants.d_yy);
}

#[test]
fn energy_losses_are_differences_of_kinetic_energy() {
    // (9.58) with the motion of (9.56): an impulse J at the contact point of two solid spheres.
    let (masses, radii) = ([0.3, 0.5], [0.7, 1.1]);
    let (before, ratio) = (1.7, 0.4);
    let d_xx = 3.5 * (1.0 / masses[0] + 1.0 / masses[1]);
    let impulse = (1.0 + ratio) * before / d_xx;
    let mut energy = [0.0; 2];
    // Body 2 moves with `before`; the impulse acts along +x on body 1, below its centre.
    for (i, sign) in [(0, 1.0), (1, -1.0)] {
        let (m, r) = (masses[i], radii[i]);
        let theta = 0.4 * m * r * r;
        let velocity = if i == 1 { before } else { 0.0 };
        let after = velocity + sign * impulse / m;
        let spin = r * impulse / theta;
        energy[0] += 0.5 * m * velocity * velocity;
        energy[1] += 0.5 * m * after * after + 0.5 * theta * spin * spin;
    }
    let lost = tangential_energy_loss(masses, ratio, before).unwrap();
    assert!((energy[0] - energy[1] - lost).abs() < 1e-15, "{} {lost}", energy[0] - energy[1]);
    // (9.60): a head-on impact.
    let (normal, speed) = (0.6, 2.3);
    let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
    let lost = normal_energy_loss(masses, normal, speed).unwrap();
    let expected = 0.5 * reduced * (speed * speed - (normal * speed).powi(2));
    assert!((lost - expected).abs() < 1e-15);
    assert!(normal_energy_loss([-1.0, 1.0], normal, speed).is_err());
}

#[test]
fn sliding_throughout_is_the_impulse_of_friction() {
    // (9.33): u_E = u_A - f D_xx int F_z dt with int F_z dt = 2 zeta'/D_zz.
    let (chi, psi) = (3.1, 8.0);
    let impact = ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
    assert!((impact.restitution() - restitution_in_sliding(chi, psi).unwrap()).abs() < 1e-15);
    assert_eq!(restitution_in_sliding(chi, 2.0 * chi - 1.1), None);
}

#[test]
fn duration_and_maximal_compression_by_quadrature() {
    // zeta'^2 = v^2 - (8/15) D_zz c_z zeta^(5/2) (9.2); zeta = zeta_max (1 - q^2) removes the root.
    let (mobility, stiffness, velocity) = (0.7, 40.0, 1.9);
    let impact = NormalImpact::new(mobility, stiffness, velocity).unwrap();
    let maximum = impact.maximal_approach();
    let squared =
        |zeta: f64| velocity * velocity - 8.0 / 15.0 * mobility * stiffness * zeta.powf(2.5);
    assert!(squared(maximum).abs() < 1e-14);
    let rule = GaussLegendre::new(80).unwrap();
    let half =
        rule.integrate(0.0, 1.0, |q| 2.0 * q * maximum / squared(maximum * (1.0 - q * q)).sqrt());
    assert!((2.0 * half / impact.duration() - 1.0).abs() < 1e-9);
    assert!((impact.duration() / impact.time_unit() - normal::DURATION).abs() < 1e-14);
}
