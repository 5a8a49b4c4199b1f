//! Corrections of chapters 8 to 10.

use crate::Failure;
use carom_geometry::{Inertia, angle_matrix};
use carom_halfspace::{Material, MaterialPair};
use carom_impact::closed_form::ImpactConstants;
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::torsional::limits::{no_slip, no_slip_as_printed, sliding, sliding_as_printed};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;
use carom_special::roots::try_bisect;
use nalgebra::{Matrix3, Rotation3, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

use super::Correction;

pub(super) fn corrections() -> Result<Vec<Correction>, Failure> {
    Ok(vec![rotation(), cylinders()?, sliding_begins()?, slow_spin()?, fast_spin()])
}

/// The entry [c, x] of the product of three rotations about the axes as they turn.
fn rotation() -> Correction {
    let (alpha, beta, gamma) = (0.4, 0.3, 1.2);
    let turn = |axis: Vector3<f64>, angle: f64| -> Matrix3<f64> {
        Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(axis), angle).into_inner()
    };
    // Turned frames: the components turn the other way.
    let product =
        turn(Vector3::x(), -alpha) * turn(Vector3::y(), -beta) * turn(Vector3::z(), -gamma);
    let ((sa, ca), (sb, _)) = (libm::sincos(alpha), libm::sincos(beta));
    let (sg, cg) = libm::sincos(gamma);
    Correction {
        equation: "8.5",
        printed: r"$\Pi_{cx}=\cos\alpha\sin\beta\cos\gamma-\sin\alpha\sin\gamma$",
        corrected: r"$\Pi_{cx}=\cos\alpha\sin\beta\cos\gamma+\sin\alpha\sin\gamma$",
        check: "entry of the matrix of three rotations",
        value: angle_matrix(alpha, beta, gamma)[(2, 0)],
        expected: product[(2, 0)],
        as_printed: Some(ca * sb * cg - sa * sg),
        tolerance: 1e-14,
        source: "product of three rotations about z, y', x''",
    }
}

/// Equal crossed cylinders touch as a sphere and a plane.
fn cylinders() -> Result<Correction, Failure> {
    let (radius, soft) = (0.3, Material::from_shear(2.0, 0.3)?);
    let body = Inertia::new(1.0, [0.2, 0.3, 0.4])?;
    let constants = ImpactConstants::of_crossed_cylinders([body, body], radius, [soft, soft])?;
    let cylinder = PrincipalRadii::cylinder(radius)?;
    let gap = RelativeCurvature::new(cylinder, cylinder, FRAC_PI_2)?;
    let pressed = Hertz::new(gap, MaterialPair::new(soft, soft)?)?;
    // F_z = (2/3) c_z ζ^1.5.
    let expected = 1.5 * pressed.force(1.0);
    Ok(Correction {
        equation: "9.48",
        printed: r"$c_z=2\sqrt{2R}\,/\,\textstyle\sum\frac{1-\nu_i}{G_i}$",
        corrected: r"$c_z=4\sqrt R\,/\,\textstyle\sum\frac{1-\nu_i}{G_i}$",
        check: "normal stiffness of equal crossed cylinders",
        value: constants.c_z,
        expected,
        as_printed: Some(expected / 2.0_f64.sqrt()),
        tolerance: 1e-13,
        source: "Hertz's theory of their gap, (5.12) and (5.14)",
    })
}

/// The lambda from which on a sphere slides throughout, kappa = 1.2.
fn sliding_begins() -> Result<Correction, Failure> {
    let kappa = 1.2;
    let slides = |lambda: f64| -> Result<bool, Failure> {
        let impact = ObliqueImpact::new(Groups::of_spheres(kappa, lambda)?)?;
        Ok(impact.phases().len() == 1)
    };
    let [_, least] = try_bisect([4.0, 8.0], 40, |lambda| Ok::<_, Failure>(!slides(lambda)?))?;
    Ok(Correction {
        equation: "9.33",
        printed: r"sliding throughout for $\lambda\ge7$",
        corrected: r"sliding throughout for $\lambda\ge7-\kappa$",
        check: "least λ of a sphere that slides throughout, κ = 1.2",
        value: least,
        expected: 7.0 - kappa,
        as_printed: Some(7.0),
        tolerance: 1e-9,
        source: "the recoil of the tangential spring against the slip that is left",
    })
}

/// z'' = -(5/4) z^1.5 from z' = 1, with v'' = -ε z^1.5 v: the spin at the greatest approach, and
/// the integral of z² over the impact, by classical Runge-Kutta steps.
fn stepped(epsilon: f64) -> [f64; 2] {
    let slope = |s: [f64; 5]| {
        let z = s[0].max(0.0);
        let power = z * z.sqrt();
        [s[1], -1.25 * power, s[3], -epsilon * power * s[2], z * z]
    };
    let add = |s: [f64; 5], d: [f64; 5], h: f64| std::array::from_fn(|i| s[i] + h * d[i]);
    // Half the duration, (9.8).
    let half = 0.5 * carom_impact::normal::DURATION;
    let steps = 20_000;
    let h = half / f64::from(steps);
    let mut s = [0.0, 1.0, 1.0, 0.0, 0.0];
    for _ in 0..steps {
        let k1 = slope(s);
        let k2 = slope(add(s, k1, 0.5 * h));
        let k3 = slope(add(s, k2, 0.5 * h));
        let k4 = slope(add(s, k3, h));
        s = std::array::from_fn(|i| s[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    }
    [s[2], 2.0 * s[4]]
}

fn slow_spin() -> Result<Correction, Failure> {
    let epsilon = 0.0625;
    let [middle, _] = stepped(epsilon);
    Ok(Correction {
        equation: "10.63",
        printed: r"$\frac{\dot\beta(T)}{\dot\beta(0)}=[1-\tfrac52\delta(T-2)][1-5\delta(T-2)]$",
        corrected: r"$\frac{\dot\beta(T)}{\dot\beta(0)}=2y_1^2-1$, $y_1\approx1-\tfrac52\delta(T-2)$",
        check: "spin after over spin before, slow spin, ε = 1/16",
        value: no_slip(epsilon)?,
        expected: 2.0 * middle * middle - 1.0,
        as_printed: Some(no_slip_as_printed(epsilon)),
        tolerance: 1e-8,
        source: "the equation of the spin (10.8) stepped to the greatest approach",
    })
}

/// Sliding takes the torque 3π/16 f F a all the time: 3π/32 ε/Ω ∫z² dt of the spin.
fn fast_spin() -> Correction {
    let (epsilon, omega) = (0.0625, 5.0);
    let [_, square] = stepped(epsilon);
    Correction {
        equation: "10.64",
        printed: r"$d=\frac{f\dot\zeta_A}R\sqrt{\frac{\zeta_M}R}\,\frac{21\pi^{3/2}\Gamma(1.2)}{32\,\Gamma(1.7)}$",
        corrected: r"$d=\frac{f\dot\zeta_A}R\sqrt{\frac{\zeta_M}R}\,\frac{15\pi^{3/2}\Gamma(1.2)}{32\,\Gamma(1.7)}$",
        check: "share of the spin that sliding takes, ε = 1/16, Ω = 5",
        value: 1.0 - sliding(epsilon, omega),
        expected: 3.0 * PI / 32.0 * epsilon / omega * square,
        as_printed: Some(1.0 - sliding_as_printed(epsilon, omega)),
        tolerance: 1e-6,
        source: "the torque of sliding (10.3) over the stepped approach",
    }
}
