//! Corrections of chapters 5 to 7 and 14.

use crate::Failure;
use carom_classic::history::ellipse::EllipseHistory;
use carom_classic::rigid_slip::spin_about;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::adhesion::AdhesiveTorsion;
use carom_laws::torsion::ellipse::EllipseTorsion;
use carom_laws::torsion::lubkin::Lubkin;
use carom_special::AxisRatio;
use carom_special::elliptic::complete;
use carom_special::quadrature::GaussLegendre;
use std::f64::consts::{PI, TAU};

use super::Correction;

pub(super) fn corrections() -> Result<Vec<Correction>, Failure> {
    Ok(vec![
        angle()?,
        surface()?,
        twist_without_slip()?,
        torque()?,
        slope_back()?,
        second_shift()?,
        varying_load()?,
        torque_back()?,
        sliding_spin()?,
    ])
}

/// The direction of the contact ellipse, by the forms of both bodies.
fn angle() -> Result<Correction, Failure> {
    let omega = 0.6_f64;
    let one = PrincipalRadii::new(1.0, 2.5)?;
    let two = PrincipalRadii::new(3.0, 0.8)?;
    let value = RelativeCurvature::new(one, two, omega)?.angle();
    let [d1, d2] = [1.0 - 1.0 / 2.5, 1.0 / 3.0 - 1.0 / 0.8];
    // The mixed coefficient of both forms vanishes in the right axes: half an arc tangent of it.
    let form = |x: f64, y: f64| {
        let (sin, cos) = libm::sincos(omega);
        let (p, q) = (x * cos + y * sin, y * cos - x * sin);
        0.5 * (x * x + y * y / 2.5 + p * p / 3.0 + q * q / 0.8)
    };
    let mixed = 0.5 * (form(1.0, 1.0) - form(1.0, -1.0));
    let expected = 0.5 * libm::atan2(mixed, form(1.0, 0.0) - form(0.0, 1.0));
    let (sin, cos) = libm::sincos(2.0 * omega);
    Ok(Correction {
        equation: "5.3",
        printed: r"$(\cos2\omega-\frac{d_1}{d_2})\tan2\alpha=\sin2\omega$",
        corrected: r"$(\cos2\omega+\frac{d_1}{d_2})\tan2\alpha=\sin2\omega$, $d_i=\frac1{R_i}-\frac1{R_i'}$",
        check: "angle of the axes of contact of two skew bodies",
        value,
        expected,
        as_printed: Some(0.5 * libm::atan2(d2 * sin, d2 * cos - d1)),
        tolerance: 1e-13,
        source: "the quadratic form of the gap",
    })
}

/// The surface between a rigid and an elastic body is that of the rigid one.
fn surface() -> Result<Correction, Failure> {
    let soft = Material::from_shear(1.0, 0.3)?;
    let ball = RelativeCurvature::from_coefficients(0.5, 0.4)?;
    let pressed = Hertz::new(ball, MaterialPair::new(Material::RIGID, soft)?)?;
    Ok(Correction {
        equation: "5.17",
        printed: r"$(\vartheta_1+\vartheta_2)z=\vartheta_2z_1-\vartheta_1z_2+\vartheta_2\zeta$",
        corrected: r"$(\vartheta_1+\vartheta_2)z=\vartheta_2z_1-\vartheta_1z_2+\vartheta_1\zeta$",
        check: "height of the surface where body 1 is rigid",
        value: pressed.contact_surface(0.01, 0.004, 0.001),
        expected: 0.004,
        as_printed: Some(0.004 + 0.01),
        tolerance: 1e-14,
        source: "a rigid body keeps its shape",
    })
}

/// The moment of the traction is that of the stiffness.
fn twist_without_slip() -> Result<Correction, Failure> {
    let soft = Material::from_shear(1.0, 0.3)?;
    let pair = MaterialPair::new(soft, soft)?;
    let (a, b) = (0.5, 1.0);
    let law = AdhesiveTorsion::new(ContactEllipse::new(a, b)?, pair);
    let rule = GaussLegendre::new(24)?;
    let moment = |sign: f64| {
        let mut sum = 0.0;
        for depth in rule.on(0.0, 1.0) {
            // r² = 1 - s²: the root of the traction goes with it.
            let r = (1.0 - depth.position * depth.position).sqrt();
            for turn in rule.on(0.0, TAU) {
                let (sin, cos) = libm::sincos(turn.position);
                let (x, y) = (a * r * cos, b * r * sin);
                let [t_x, t_y] = law.traction(1.0, x, y);
                let weight = a * b * depth.position * depth.weight * turn.weight;
                sum += weight * (y * t_x - sign * x * t_y);
            }
        }
        sum
    };
    Ok(Correction {
        equation: "5.32",
        printed: r"$\sigma_{zx}=T'y/s$, $\sigma_{zy}=T''x/s$",
        corrected: r"$\sigma_{zx}=T'y/s$, $\sigma_{zy}=-T''x/s$",
        check: "moment of the traction of an ellipse 1 : 2, ν = 0.3",
        value: moment(1.0),
        expected: law.stiffness(),
        as_printed: Some(moment(-1.0)),
        tolerance: 1e-12,
        source: "the compliance (5.35)",
    })
}

/// The torque is the moment of the traction (5.37).
fn torque() -> Result<Correction, Failure> {
    let stick = 0.6;
    let law = Lubkin::at_stick_radius(stick)?;
    let rule = GaussLegendre::new(60)?;
    let mut moment = 0.0;
    // Both sides of the kink, where the traction goes as a root.
    for node in rule.on(0.0, 1.0) {
        let t = node.position;
        for (rho, slope) in [
            (stick * (1.0 - t * t), 2.0 * stick * t),
            (stick + (1.0 - stick) * t * t * (3.0 - 2.0 * t), (1.0 - stick) * 6.0 * t * (1.0 - t)),
        ] {
            moment += node.weight * slope * TAU * rho * rho * law.traction(rho);
        }
    }
    let ratio = AxisRatio::new(stick)?;
    let square = stick * stick;
    let (d, e) = (complete::d(ratio), complete::e(ratio));
    let modulus = 1.0 - square; // k²
    let bracket = d * (1.0 + 2.0 * modulus) + 6.0 * e;
    let too_much = (square - stick * modulus) / (4.0 * PI) * bracket;
    Ok(Correction {
        equation: "5.41",
        printed: r"$\frac{M_z}{fF_za}=\frac{k'^2}{4\pi}[D(1+2k^2)+6E]+\ldots$",
        corrected: r"$\frac{M_z}{fF_za}=\frac{k'k^2}{4\pi}[D(1+2k^2)+6E]+\ldots$",
        check: "torque of a round contact, stick radius 0.6",
        value: law.torque(),
        expected: moment.abs(),
        as_printed: Some(law.torque() + too_much),
        tolerance: 1e-7,
        source: "quadrature of the traction (5.37)",
    })
}

/// The slope at a reversal is that of the first shift.
fn slope_back() -> Result<Correction, Failure> {
    let stiffness = ContactStiffness::new(0.8, 0.8, 1.0)?;
    let mut law = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::new(0.3)?);
    let shift = |xi: f64| Shift { zeta: 1.0, xi, ..Shift::default() };
    law.advance(shift(0.0))?;
    let there = law.advance(shift(0.2))?.f_x;
    let step = 1e-6;
    let back = law.advance(shift(0.2 - step))?.f_x;
    Ok(Correction {
        equation: "6.21",
        printed: r"$\frac{dF_x}{d\xi}=-\frac{8Ga^*}{2-\nu}$",
        corrected: r"$\frac{dF_x}{d\xi}=+\frac{8Ga^*}{2-\nu}$",
        check: "slope of the force where the shift turns back",
        value: (there - back) / step,
        expected: 0.8,
        as_printed: Some(-0.8),
        tolerance: 1e-5,
        source: "slope of the first shift (5.30)",
    })
}

/// In the outer ring the tractions of both shifts have the size of the limit.
fn second_shift() -> Result<Correction, Failure> {
    let mut history = EllipseHistory::new(1.0);
    let (first, turn) = ([0.5, 0.0], [-0.2, 0.3]);
    history.advance(1.0, first).ok_or("the first shift slides")?;
    history.advance(1.0, [first[0] + turn[0], turn[1]]).ok_or("the second shift slides")?;
    let depth = 1.0 - history.star();
    let added = turn.map(|part: f64| part / depth);
    let product = first[0] * turn[0];
    let square = turn[0] * turn[0] + turn[1] * turn[1];
    let printed = -first[0] * square / product;
    Ok(Correction {
        equation: "7.20",
        printed: r"$\zeta_2^*=\zeta_2+\frac{|e_1||\Delta e_2|^2}{e_1\cdot\Delta e_2}$",
        corrected: r"$\zeta_2^*=\zeta_2+\frac{|e_1||\Delta e_2|^2}{2\,e_1\cdot\Delta e_2}$",
        check: "|p₁ + p₂| in the outer ring after a second shift",
        value: libm::hypot(1.0 + added[0], added[1]),
        expected: 1.0,
        as_printed: Some(libm::hypot(1.0 + turn[0] / printed, turn[1] / printed)),
        tolerance: 1e-13,
        source: "Coulomb's law in the slip ring (7.16)",
    })
}

/// The same with a load that grows.
fn varying_load() -> Result<Correction, Failure> {
    let mut history = EllipseHistory::new(1.0);
    let (first, turn, growth) = ([0.5, 0.0], [-0.2, 0.3], 0.1);
    history.advance(1.0, first).ok_or("the first shift slides")?;
    let to = 1.0 + growth;
    history.advance(to, [first[0] + turn[0], turn[1]]).ok_or("the second shift slides")?;
    // e_2 = p_1 (ζ_2 - ζ_1*) + p_2 (ζ_2 - ζ_2*), (7.45), with ζ_1* = 1/2.
    let total = [first[0] + turn[0] - (to - 0.5), turn[1]];
    let added = total.map(|part| part / (to - history.star()));
    // The printed denominator has the slip after.
    let after = [-(1.0 + added[0]), -added[1]];
    let moved = [turn[0] + growth * after[0], turn[1] + growth * after[1]];
    let square = moved[0] * moved[0] + moved[1] * moved[1];
    let printed = to - (1.0 - square / (2.0 * (moved[0] * after[0] + moved[1] * after[1])));
    let wrong = total.map(|part| part / printed);
    Ok(Correction {
        equation: "7.60",
        printed: r"$\zeta_N^*=\zeta_{N-1}-\frac{|\Delta e_N'|^2}{2\,\Delta e_N'\cdot s_N}$",
        corrected: r"$\zeta_N^*=\zeta_{N-1}-\frac{|\Delta e_N'|^2}{2\,\Delta e_N'\cdot s_{N-1}}$",
        check: "|p₁ + p₂| in the outer ring, load grown by a tenth",
        value: libm::hypot(1.0 + added[0], added[1]),
        expected: 1.0,
        as_printed: Some(libm::hypot(1.0 + wrong[0], wrong[1])),
        tolerance: 1e-13,
        source: "Coulomb's law in the slip ring (7.56)",
    })
}

/// Twisted back as far as it was twisted, the contact has the opposite torque.
fn torque_back() -> Result<Correction, Failure> {
    let mut law = EllipseTorsion::new(1.0, 2.0)?;
    let there = law.advance(0.4)?;
    let value = law.advance(-0.4)?;
    Ok(Correction {
        equation: "7.66",
        printed: r"$\frac{M_1-M}{2M_{zS}}=1-\exp[-\frac{M_{zA}'}{2M_{zS}}(\beta-\beta_1)]$",
        corrected: r"$\frac{M_1-M}{2M_{zS}}=1-\exp[-\frac{M_{zA}'}{2M_{zS}}(\beta_1-\beta)]$",
        check: "torque after a twist of 0.4 and one of -0.4",
        value,
        expected: -(1.0 - libm::exp(-0.8)),
        as_printed: Some(there - 2.0 * (1.0 - libm::exp(0.8))),
        tolerance: 1e-14,
        source: "symmetry of the loop, with (7.65)",
    })
}

/// The torque of an ellipse that spins about its middle.
fn sliding_spin() -> Result<Correction, Failure> {
    let (a, b) = (1.0, 4.0);
    let value = spin_about(&ContactEllipse::new(a, b)?, 0.0, 0.0)?.torque;
    let rule = GaussLegendre::new(48)?;
    let mut sum = 0.0;
    for rise in rule.on(0.0, 0.5 * PI) {
        // r = sin t, and the root of the pressure is cos t.
        let (r, root) = libm::sincos(rise.position);
        for turn in rule.on(0.0, 0.5 * PI) {
            let (sin, cos) = libm::sincos(turn.position);
            let arm = libm::hypot(a * r * cos, b * r * sin);
            sum += 4.0 * rise.weight * turn.weight * r * root * root * arm;
        }
    }
    let torque = 1.5 / PI * sum;
    Ok(Correction {
        equation: "14.3",
        printed: r"$m_z=\frac{M_z}{fF_z\,ab}$",
        corrected: r"$m_z=\frac{M_z}{fF_z\sqrt{ab}}$",
        check: "torque of an ellipse 1 : 4 that spins about its middle",
        value,
        expected: torque / (a * b).sqrt(),
        as_printed: Some(torque / (a * b)),
        tolerance: 1e-10,
        source: "quadrature of the arm over the pressure",
    })
}
