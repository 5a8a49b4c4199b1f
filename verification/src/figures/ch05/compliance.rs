//! Fig. 5.5: the torsional compliance of an ellipse under complete adhesion.

use std::f64::consts::TAU;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::accounted::Accounted;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Energies as _, Shift};
use carom_laws::torsion::adhesion::AdhesiveTorsion;
use carom_laws::torsion::law::TorsionLaw;
use carom_special::RangeError;
use carom_special::quadrature::GaussLegendre;

use crate::reference::rows;
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Panel, Relative, Series, linspace};

const POISSON: [f64; 4] = [0.0, 0.25, 0.3, 0.5];

/// The torsion of a pair whose combined shear modulus (4.7) is 1.
fn torsion(a: f64, b: f64, nu: f64) -> Result<AdhesiveTorsion, RangeError> {
    let body = Material::from_shear(2.0, nu)?;
    Ok(AdhesiveTorsion::new(ContactEllipse::new(a, b)?, MaterialPair::new(body, body)?))
}

/// `16 G b^3 beta/(3 M_z)`.
fn compliance(a: f64, b: f64, nu: f64) -> Result<f64, RangeError> {
    Ok(16.0 / 3.0 * (b * b * b) / torsion(a, b, nu)?.stiffness())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ν", "0, 0.25, 0.3, 0.5");
    figure.assumed("a/b", "0.02 to 1, the abscissa");
    figure.assumed("ordinate", "16 G b³ β/(3 M_z), which is 1 for a circle");
    let ratios = linspace(0.02, 1.0, 197);
    let mut panel = Panel::new(
        Axis::linear("a/b").between(0.0, 1.0),
        Axis::linear("16 G b³ β / (3 M_z)").between(0.0, 12.0),
    )
    .titled("Complete adhesion (5.35)");
    let mut curves = Vec::new();
    for nu in POISSON {
        let curve: Vec<f64> =
            ratios.iter().map(|&ratio| compliance(ratio, 1.0, nu)).collect::<Result<_, _>>()?;
        panel.add(Series::line(
            format!("ν = {nu}"),
            ratios.iter().copied().zip(curve.iter().copied()),
        ));
        curves.push(curve);
    }
    figure.panel(panel);

    let table = rows::<4>(include_str!("../../../data/laws/torsion_compliance.csv"))?;
    let pairs: Result<Vec<(f64, f64)>, RangeError> =
        table.iter().map(|&[a, b, nu, value]| Ok((compliance(a, b, nu)?, value))).collect();
    figure
        .all_close("33 values, a/b from 1e-4 to 1e4", pairs?, Relative(1e-13))
        .source("(5.35) in 25 digits by an independent program");
    let mindlin: Result<Vec<(f64, f64)>, RangeError> =
        POISSON.iter().map(|&nu| Ok((compliance(1.0, 1.0, nu)?, 1.0))).collect();
    figure
        .all_close("1 at a/b = 1 for every ν", mindlin?, Absolute(1e-14))
        .source("M_z = (16/3) G a³ β, Mindlin");
    let fall = (0..ratios.len() - 1)
        .flat_map(|i| curves.windows(2).map(move |pair| pair[0][i] - pair[1][i]))
        .fold(f64::INFINITY, f64::min);
    figure
        .holds("it falls with ν where a < b", fall > 0.0, fall)
        .source("(5.35) by an independent program");
    for (nu, curve) in POISSON.into_iter().zip(&curves) {
        figure
            .decreasing(format!("ν = {nu}: it falls with a/b"), curve.iter().copied())
            .source("(5.35) by an independent program");
    }
    symmetry_claims(&mut figure)?;
    moment_claim(&mut figure)?;
    law_claim(&mut figure)?;
    figure.deviation(
        "σ_zy = +T″x/s with u = βy, v = -βx in (5.32)",
        "σ_zy = -T″x/s",
        "misprint: with the printed sign the displacement is no rotation and the moment is too small",
    );
    Ok(figure)
}

fn symmetry_claims(figure: &mut Figure) -> Result<(), Failure> {
    let (mut swapped, mut equal) = (Vec::new(), Vec::new());
    for ratio in [0.05, 0.2, 0.5, 0.8] {
        for nu in POISSON {
            let one = torsion(ratio, 1.0, nu)?.stiffness();
            swapped.push((torsion(1.0, ratio, nu)?.stiffness(), one));
        }
        let [along_x, along_y] = torsion(ratio, 1.0, 0.5)?.coefficients();
        equal.push((along_x, along_y));
    }
    figure
        .all_close("a and b may be exchanged", swapped, Relative(1e-13))
        .source("symmetry; computed with the parameter k² < 0");
    figure.all_close("T′ = T″ for ν = 0.5", equal, Relative(1e-13)).source("errata of (5.34)");
    Ok(())
}

/// The law of a contact that cannot slip: each disc added by compression twists from then on.
fn law_claim(figure: &mut Figure) -> Result<(), Failure> {
    let body = Material::from_shear(2.0, 0.3)?;
    let pair = MaterialPair::new(body, body)?;
    let gap = RelativeCurvature::from_coefficients(1.0, 0.4)?;
    let hertz = Hertz::new(gap, pair)?;
    let mut law = Accounted::new(TorsionLaw::new(&hertz, Friction::new(f64::INFINITY)?)?);
    let stiffness = |zeta: f64| -> Result<f64, Failure> {
        let ellipse = hertz.ellipse(zeta)?;
        let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
        // From the ordinate of the figure.
        Ok(16.0 / 3.0 * b * b * b / compliance(a / b, 1.0, 0.3)?)
    };
    let (first, second) = (stiffness(0.01)?, stiffness(0.02)?);
    let mut pairs = Vec::new();
    let mut at = |zeta: f64, omega: f64| law.advance(Shift { zeta, omega, ..Shift::default() });
    at(0.01, 0.0)?;
    pairs.push((at(0.01, 1e-3)?.m_z / (1e-3 * first), 1.0));
    at(0.02, 1e-3)?;
    let load = at(0.02, 3e-3)?;
    pairs.push((load.m_z / (1e-3 * first + 2e-3 * second), 1.0));
    // Discs of the first compression carry 3e-3, those added later 2e-3.
    let energy = 0.5 * (9e-6 * first + 4e-6 * (second - first));
    pairs.push((law.law().twist_energy() / energy, 1.0));
    pairs.push((law.dissipated() / energy, 0.0));
    figure
        .all_close(
            "torque and energy of a twist, a compression and a twist without slip, over (5.35)",
            pairs,
            Absolute(1e-12),
        )
        .source("M_z = K₁ β₁ + K₂ (β - β₁) and half of Σ K β² with K of the figure");
    Ok(())
}

/// The moment of the traction (5.32), with its sign corrected, is that of (5.35).
fn moment_claim(figure: &mut Figure) -> Result<(), Failure> {
    let rule = GaussLegendre::new(12)?;
    let mut pairs = Vec::new();
    let mut wrong = f64::INFINITY;
    for (a, b, nu) in [(1.0, 1.0, 0.3), (0.5, 1.0, 0.0), (0.3, 1.2, 0.4), (2.0, 0.7, 0.5)] {
        let torsion = torsion(a, b, nu)?;
        let [mut along_x, mut along_y] = [0.0; 2];
        for step in 0..32 {
            let (sin, cos) = libm::sincos(TAU * f64::from(step) / 32.0);
            // On rays r dr/s = -ds with s² = 1 - r².
            along_x += rule.integrate(0.0, 1.0, |s| {
                let r = (1.0 - s * s).sqrt();
                let (x, y) = (a * r * cos, b * r * sin);
                y * s * torsion.traction(1.0, x, y)[0]
            });
            along_y += rule.integrate(0.0, 1.0, |s| {
                let r = (1.0 - s * s).sqrt();
                let (x, y) = (a * r * cos, b * r * sin);
                x * s * torsion.traction(1.0, x, y)[1]
            });
        }
        let area = a * b * TAU / 32.0;
        pairs.push((area * (along_x - along_y), torsion.stiffness()));
        wrong = wrong.min(1.0 - area * (along_x + along_y) / torsion.stiffness());
    }
    figure
        .all_close("∫(y σ_zx - x σ_zy)dS is M_z", pairs, Relative(1e-12))
        .source("quadrature of (5.32) against (5.35)");
    figure
        .at_least("with the printed sign of σ_zy the moment lacks", wrong, 0.1)
        .source("quadrature");
    Ok(())
}
