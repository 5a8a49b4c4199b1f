//! Fig. 15.1: the values of gamma and kappa that two materials can have together.

use crate::{Absolute, Figure, FigureResult, Panel, Series, linspace};
use carom_halfspace::{Material, MaterialPair};
use carom_special::RangeError;

/// The pair with G2/G1 = `stiffness` and these Poisson's ratios.
fn pair(stiffness: f64, nu_1: f64, nu_2: f64) -> Result<MaterialPair, RangeError> {
    MaterialPair::new(Material::from_shear(1.0, nu_1)?, Material::from_shear(stiffness, nu_2)?)
}

/// kappa and gamma at the corners 0 and 1/2 of both Poisson's ratios, in turn.
fn corners(stiffness: f64) -> Result<Vec<(f64, f64)>, RangeError> {
    let ratios = [(0.0, 0.0), (0.0, 0.5), (0.5, 0.5), (0.5, 0.0)];
    let points = ratios.map(|(nu_1, nu_2)| {
        let pair = pair(stiffness, nu_1, nu_2)?;
        Ok((pair.kappa(), pair.gamma()))
    });
    points.into_iter().collect()
}

/// How far the pair lies outside the polygon (kappa, gamma) whose edges turn to the right.
fn outside(polygon: &[(f64, f64)], pair: &MaterialPair) -> f64 {
    let ends = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let distances = ends.map(|((x0, y0), (x1, y1))| {
        let (dx, dy) = (x1 - x0, y1 - y0);
        (dx * (pair.gamma() - y0) - dy * (pair.kappa() - x0)) / libm::hypot(dx, dy)
    });
    distances.fold(f64::NEG_INFINITY, f64::max)
}

/// Left side less right side of the four inequalities (15.3), positive where they hold.
fn margins(stiffness: f64, pair: &MaterialPair) -> [f64; 4] {
    let (kappa, gamma, delta) = (pair.kappa(), pair.gamma(), stiffness);
    [
        gamma - (kappa - 1.5),
        kappa * (1.0 + 3.0 * delta) - 1.5 - 2.5 * delta - gamma * (1.0 + delta),
        1.5 - kappa - gamma,
        gamma * (1.0 + delta) - (2.5 + 1.5 * delta - kappa * (3.0 + delta)),
    ]
}

type Pairs = Vec<(f64, f64)>;

/// The inequalities (15.3): on their borders, and within.
fn inequalities(stiffness: f64) -> Result<(Pairs, Pairs), RangeError> {
    let (mut borders, mut inside) = (Vec::new(), Vec::new());
    for i in 0..=20 {
        let nu = f64::from(i) / 40.0;
        let at_limit = [(0.5, nu), (0.0, nu), (nu, 0.5), (nu, 0.0)];
        for (k, (nu_1, nu_2)) in at_limit.into_iter().enumerate() {
            let margins = margins(stiffness, &pair(stiffness, nu_1, nu_2)?);
            borders.push((margins[k], 0.0));
        }
        for j in 0..=20 {
            let (nu_1, nu_2) = (nu, f64::from(j) / 40.0);
            let found = margins(stiffness, &pair(stiffness, nu_1, nu_2)?);
            // Compliances 1/G_1 = 1 and 1/G_2 = 1/δ.
            let sum = (1.0 - nu_1) + (1.0 - nu_2) / stiffness;
            let expected = [
                (1.0 - 2.0 * nu_1) / sum,
                2.0 * (1.0 + stiffness) * nu_1 / sum,
                (1.0 - 2.0 * nu_2) / (stiffness * sum),
                2.0 * (1.0 + stiffness) * nu_2 / (stiffness * sum),
            ];
            inside.extend(found.into_iter().zip(expected));
        }
    }
    Ok((borders, inside))
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("δ = G₂/G₁", "1 and 10");
    figure.assumed("ν₁, ν₂", "0 to 1/2, so that the region has four corners");
    let mut panel = Panel::new("κ", "γ");
    let printed = [
        (1.0, [(1.0, 0.0), (7.0 / 6.0, 1.0 / 3.0), (1.5, 0.0), (7.0 / 6.0, -1.0 / 3.0)]),
        (
            10.0,
            [(1.0, 9.0 / 22.0), (43.0 / 42.0, 10.0 / 21.0), (1.5, 0.0), (17.0 / 12.0, -1.0 / 12.0)],
        ),
    ];
    for (stiffness, expected) in printed {
        let polygon = corners(stiffness)?;
        let values = polygon.iter().zip(&expected);
        let pairs = values.flat_map(|(p, e)| [(p.0, e.0), (p.1, e.1)]);
        figure
            .all_close(format!("corners of the region, δ = {stiffness}"), pairs, Absolute(1e-14))
            .source("fractions worked out from (15.1), (15.2)");
        let mut farthest = f64::NEG_INFINITY;
        for nu_1 in linspace(0.0, 0.5, 21) {
            for nu_2 in linspace(0.0, 0.5, 21) {
                farthest = farthest.max(outside(&polygon, &pair(stiffness, nu_1, nu_2)?));
            }
        }
        let statement = format!("all ν₁, ν₂ from 0 to 1/2 lie inside the corners, δ = {stiffness}");
        figure.at_most(statement, farthest, 1e-14).source("the map is projective");
        panel.add(Series::area(format!("δ = {stiffness}"), polygon));
    }
    for stiffness in [0.2, 1.0, 10.0] {
        let (borders, margins) = inequalities(stiffness)?;
        figure
            .all_close(
                format!("each of (15.3) is an equality at its limit of ν, δ = {stiffness}"),
                borders,
                Absolute(1e-13),
            )
            .source("(15.3) as printed");
        figure
            .all_close(
                format!("and holds inside by as much as ν is away from the limit, δ = {stiffness}"),
                margins,
                Absolute(1e-13),
            )
            .source(
                "(15.1), (15.2) put into (15.3): 1 - 2 ν, 2.5 ν and their like over Σ (1 - ν)/G",
            );
    }
    let largest = pair(1e9, 0.0, 0.0)?.gamma();
    figure
        .close("γ tends to 1/2 as body 2 stiffens, ν = 0", largest, 0.5, Absolute(2e-9))
        .source("closed form (δ - 1)/(2(δ + 1)) at κ = 1");
    figure.panel(panel);
    Ok(figure)
}
