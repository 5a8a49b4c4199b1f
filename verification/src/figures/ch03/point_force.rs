//! Fig. 3.2: displacements of the surface under a normal point force.

use crate::{Absolute, Figure, FigureResult, Panel, Relative, Series, linspace};
use carom_halfspace::{Displacement, Force, Material, Point, PointLoad};
use carom_special::RangeError;
use std::f64::consts::PI;

const POISSON: f64 = 0.3;

/// The displacements at the points of the x-axis under F_z = 0.08 pi G.
fn surface(poisson: f64, at: &[f64]) -> Result<Vec<Displacement>, RangeError> {
    let body = Material::from_shear(1.0, poisson)?;
    let load = PointLoad::new(body, Force { z: 0.08 * PI, ..Force::default() })?;
    at.iter().map(|&x| load.displacement(Point::on_surface(x, 0.0))).collect()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("F_z", "0.08 π G");
    figure.assumed("ν", "0.3");
    figure.assumed("x", "0.02 to 1, in any unit of length");
    let right = linspace(0.02, 1.0, 197);
    let left: Vec<f64> = right.iter().rev().map(|x| -x).collect();
    let mut panel = Panel::new("x", "displacement");
    for (labels, at) in [(["u", "w"], &left), (["", ""], &right)] {
        let found = surface(POISSON, at)?;
        let points = |pick: fn(&Displacement) -> f64| {
            at.iter().copied().zip(found.iter().map(pick)).collect::<Vec<(f64, f64)>>()
        };
        panel.add(Series::line(labels[0], points(|d| d.u)).coloured(0));
        panel.add(Series::dashed(labels[1], points(|d| d.w)).coloured(1));
    }
    let found = surface(POISSON, &right)?;
    let shrink = 1.0 - 2.0 * POISSON;
    let closed = right
        .iter()
        .zip(&found)
        .flat_map(|(x, d)| [(d.u, -0.02 * shrink / x), (d.w, 0.04 * (1.0 - POISSON) / x)]);
    figure
        .all_close("hyperbolas u(x), w(x) of (3.6)", closed, Relative(1e-14))
        .source("closed form (3.6)");
    let mirrored = surface(POISSON, &right.iter().map(|x| -x).collect::<Vec<_>>())?;
    let parity = found.iter().zip(&mirrored).flat_map(|(d, m)| [(m.u, -d.u), (m.w, d.w)]);
    figure
        .all_close("u is odd, w even in x", parity, Absolute(0.0))
        .source("symmetry about the force");
    let incompressible = surface(0.5, &right)?;
    let largest = incompressible.iter().fold(0.0f64, |m, d| m.max(d.u.abs()));
    figure
        .at_most("the surface does not spread for ν = 1/2", largest, 0.0)
        .source("factor 1 - 2ν of (3.6)");
    figure.panel(panel);
    Ok(figure)
}
