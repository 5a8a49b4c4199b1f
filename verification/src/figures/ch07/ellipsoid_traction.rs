//! Fig. 7.2: the functions of the displacement under an ellipsoidal tangential traction.

use crate::reference::rows;
use crate::{Absolute, Axis, Figure, FigureResult, Panel, Relative, Series, logspace};
use carom_halfspace::{Material, MaterialPair, Offset, Rectangle, RectangleInfluence, Traction};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::ellipsoidal_shear;
use std::f64::consts::PI;

/// Gamma, Phi, Psi, Theta of (7.11)-(7.14) for a/b = `ratio`, from the displacements (7.10) of the
/// library at the centre, half way to the ends of both axes and between.
fn functions(ratio: f64, nu: f64) -> Result<[f64; 4], carom_special::RangeError> {
    let pair = MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)?;
    let ellipse = ContactEllipse::new(ratio, 1.0)?;
    let unit = 0.5 * ratio.max(1.0);
    let at = |s: f64, t: f64| -> Result<[f64; 2], carom_special::RangeError> {
        Ok(ellipsoidal_shear(&ellipse, 1.0, &pair, s * ratio, t)?.map(|u| u / unit))
    };
    // Half way to the edge is a quarter of the fall.
    let gamma = at(0.0, 0.0)?[0];
    let (phi, psi) = (4.0 * (gamma - at(0.5, 0.0)?[0]), 4.0 * (gamma - at(0.0, 0.5)?[0]));
    Ok([gamma, phi, psi, 4.0 * at(0.5, 0.5)?[1]])
}

/// u over u_0 at the centre of the ellipse, summed over rectangles.
fn centre(ratio: f64, nu: f64, cells: usize) -> Result<f64, carom_special::RangeError> {
    let pair = MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)?;
    let (dx, dy) = (2.0 * ratio / cells as f64, 2.0 / cells as f64);
    let cell = RectangleInfluence::new(pair, Rectangle::new(dx, dy)?);
    let middle = 0.5 * (cells as f64 - 1.0);
    let mut u = 0.0;
    for iy in 0..cells {
        for ix in 0..cells {
            let offset = Offset { x: (ix as f64 - middle) * dx, y: (iy as f64 - middle) * dy };
            let (s, t) = (offset.x / ratio, offset.y);
            let x = (1.0 - s * s - t * t).max(0.0).sqrt();
            let load = Traction { x, ..Traction::default() };
            u += cell.coefficients(offset)?.displacement(load).u;
        }
    }
    Ok(u / (0.5 * ratio.max(1.0)))
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ν", "0, 0.25, 0.5");
    figure.assumed("a/b", "0.1 to 10");
    let ratios = logspace(0.1, 10.0, 101);
    let names = ["Γ", "Φ", "Ψ", "Θ"];
    for (index, name) in names.into_iter().enumerate() {
        let mut panel = Panel::new(Axis::log("a/b"), name).titled(name);
        for nu in [0.0, 0.25, 0.5] {
            let value = |&ratio: &f64| functions(ratio, nu).map(|all| (ratio, all[index]));
            let points: Vec<(f64, f64)> = ratios.iter().map(value).collect::<Result<_, _>>()?;
            panel.add(Series::line(format!("ν = {nu}"), points));
        }
        figure.panel(panel);
    }
    let text = include_str!("../../../data/halfspace/gamma_phi_psi_theta.csv");
    let mut pairs = Vec::new();
    for [ratio, nu, expected @ ..] in rows::<6>(text)? {
        pairs.extend(functions(ratio, nu)?.into_iter().zip(expected));
    }
    figure
        .all_close("Γ, Φ, Ψ, Θ for a < b, a = b and a > b", pairs, Absolute(1e-14))
        .source("40-digit arithmetic, checked by quadrature");
    let mut circle = Vec::new();
    for nu in [0.0, 0.25, 0.5] {
        let closed = [4.0 * (2.0 - nu), 4.0 - 3.0 * nu, 4.0 - nu, 2.0 * nu];
        let closed = closed.map(|value| PI / 16.0 * value);
        for ratio in [1.0 - 1e-13, 1.0, 1.0 + 1e-13] {
            circle.extend(functions(ratio, nu)?.into_iter().zip(closed));
        }
    }
    figure
        .all_close("both branches meet at the circle", circle, Absolute(1e-12))
        .source("closed forms for a = b in (7.11)-(7.14)");
    let theta = ratios.iter().map(|&ratio| functions(ratio, 0.0).map(|all| all[3]));
    let theta = theta.collect::<Result<Vec<_>, _>>()?.into_iter().fold(0.0, f64::max);
    figure.at_most("Θ = 0 for ν = 0", theta, 0.0).source("text below (4.5)");
    let mut sums = Vec::new();
    for (ratio, nu) in [(0.2, 0.3), (0.5, 0.5), (1.0, 0.3), (3.0, 0.4)] {
        sums.push((centre(ratio, nu, 101)?, functions(ratio, nu)?[0]));
    }
    figure
        .all_close("Γ is u/u₀ at the centre", sums, Relative(2e-3))
        .source("sum over 101 by 101 rectangles of constant traction");
    let mut laws = Vec::new();
    for (ratio, nu) in [(0.2, 0.3), (0.5, 0.5), (1.0, 0.3), (3.0, 0.4)] {
        let [gamma, phi, psi, theta] = functions(ratio, nu)?;
        let pair = MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)?;
        let ellipse = ContactEllipse::new(ratio, 1.0)?;
        for (s, t) in [(0.0, 0.0), (0.7, 0.2), (-0.3, 0.9)] {
            let [u, v] = ellipsoidal_shear(&ellipse, 1.0, &pair, s * ratio, t)?;
            let scale = 0.5 * ratio.max(1.0);
            laws.push((u, scale * (gamma - phi * s * s - psi * t * t)));
            laws.push((v, scale * theta * s * t));
        }
    }
    figure
        .all_close("u and v all over the ellipse", laws, Absolute(1e-14))
        .source("(7.10) with the drawn functions");
    figure.deviation("\"Fig. 7.1\" in the text", "Fig. 7.2", "number of the figure");
    Ok(figure)
}
