//! Fig. 5.3: the dimensionless parameters of the Hertz contact.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::hertz::{Hertz, HertzParameters};
use carom_laws::stiffness::ContactStiffness;
use carom_special::{AxisRatio, RangeError};

use crate::reference::rows;
use crate::{
    Absolute, Axis, Claim, Failure, Figure, FigureResult, Panel, Relative, Series, linspace,
};

const NAMES: [&str; 4] = ["α", "β", "γ", "δ"];

fn values(ratio: f64) -> Result<[f64; 4], RangeError> {
    let HertzParameters { alpha, beta, gamma, delta } = HertzParameters::of(AxisRatio::new(ratio)?);
    Ok([alpha, beta, gamma, delta])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("a/b", "0.001 to 1, the abscissa");
    let ratios = linspace(0.001, 1.0, 400);
    let curves: Vec<[f64; 4]> = ratios.iter().map(|&r| values(r)).collect::<Result<_, _>>()?;
    let mut panel = Panel::new(
        Axis::linear("a/b").between(0.0, 1.0),
        Axis::linear("α, β, γ, δ").between(0.0, 1.0),
    )
    .titled("Parameters (5.12), (5.25a)");
    for (i, name) in NAMES.into_iter().enumerate() {
        let points = ratios.iter().zip(&curves).map(|(&r, curve)| (r, curve[i]));
        panel.add(Series::line(name, points));
    }
    figure.panel(panel);

    let table = rows::<5>(include_str!("../../../data/laws/hertz_parameters.csv"))?;
    for (i, name) in NAMES.into_iter().enumerate() {
        let pairs: Result<Vec<(f64, f64)>, RangeError> =
            table.iter().map(|row| Ok((values(row[0])?[i], row[i + 1]))).collect();
        figure
            .all_close(format!("{name} at 22 ratios"), pairs?, Relative(4e-15))
            .source("(5.12) in 25 digits by an independent program");
    }
    figure
        .all_close(
            "a/b = 1: 3/4, 1, 1/2, 1/2",
            values(1.0)?.into_iter().zip([0.75, 1.0, 0.5, 0.5]),
            Absolute(1e-15),
        )
        .source("closed form");
    for (i, name) in NAMES.into_iter().enumerate() {
        let column = curves.iter().map(|curve| curve[i]);
        let claim = if i < 2 {
            Claim::increasing(format!("{name} rises with a/b"), column)
        } else {
            Claim::decreasing(format!("{name} falls with a/b"), column)
        };
        figure.claim(claim.source("limits 0, 0, 1, 1 for a slender ellipse, (5.12), (5.25a)"));
    }
    limit_claims(&mut figure)?;
    definition_claims(&mut figure)?;
    stiffness_claims(&mut figure, &ratios)?;
    figure.deviation("β = a²(A + B)/ξ in (5.14)", "β = a²(A + B)/ζ", "misread symbol");
    figure.deviation(
        "c_x = c_y for similar materials (text below (5.25))",
        "for ν = 0 and for a = b",
        "similar materials are the precondition of (5.25), not a third case",
    );
    Ok(figure)
}

/// K = ln(4 b/a) and E = 1 for slender ellipses.
fn limit_claims(figure: &mut Figure) -> Result<(), Failure> {
    let ratio = 1e-6;
    let k = libm::log(4.0 / ratio);
    let expected = [0.477_464_829_275_686 * ratio, 1.0 / k, 1.0, 1.0 - 1.0 / k];
    figure
        .all_close(
            "a/b = 1e-6: β = 1/ln(4b/a) and δ = 1 - β approach 0 and 1 only as a logarithm",
            values(ratio)?.into_iter().zip(expected),
            Relative(1e-9),
        )
        .source("K = ln(4b/a), E = 1, α = (3/2π) a/b");
    Ok(())
}

/// The use of the parameters: (5.14) holds for a contact computed from its curvatures.
fn definition_claims(figure: &mut Figure) -> Result<(), Failure> {
    let body = Material::from_shear(80_000.0, 0.3)?;
    let materials = MaterialPair::new(body, body)?;
    let mut pairs = Vec::new();
    for share in linspace(0.5, 0.99, 12) {
        let hertz =
            Hertz::new(RelativeCurvature::from_coefficients(share, 1.0 - share)?, materials)?;
        let state = hertz.at_approach(1e-3)?;
        let a = state.ellipse.semi_axis_a();
        let [alpha, beta, gamma, _] = values(hertz.axis_ratio().get())?;
        let compliance = 2.0 * (1.0 - 0.3) / (2.0 * 80_000.0); // φ_1 + φ_2
        pairs.push((alpha, a * a * a / (state.force * compliance)));
        pairs.push((beta, a * a / state.approach));
        pairs.push((gamma, share));
    }
    figure
        .all_close("(5.14) for contacts of A + B = 1", pairs, Relative(1e-13))
        .source("force, approach and semi-axis of the Hertz contact");
    Ok(())
}

fn stiffness_claims(figure: &mut Figure, ratios: &[f64]) -> Result<(), Failure> {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for nu in linspace(0.0, 0.5, 6) {
        for &ratio in ratios {
            let c = ContactStiffness::from_axis_ratio(1.0, AxisRatio::new(ratio)?, nu)?;
            least = least.min(c.c_x).min(c.c_y);
            most = most.max(c.c_x).max(c.c_y);
        }
    }
    figure.at_least("c_x/c_z and c_y/c_z for ν from 0 to 0.5", least, 0.5).source("(15.8)");
    figure.at_most("and at most", most, 1.0).source("(15.8)");
    Ok(())
}
