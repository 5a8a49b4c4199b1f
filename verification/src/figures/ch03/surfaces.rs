//! Fig. 3.1: the surfaces of the two bodies near the contact point.

use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};

use super::super::paraboloid::Paraboloid;
use crate::{Absolute, Figure, FigureResult, Marker, Panel, Relative, Series, linspace};

const OMEGA: f64 = 0.6;

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("radii", "R₁ = 1, R₁' = 2, R₂ = 3, R₂' = 4");
    figure.assumed("ω", "0.6 rad between the principal directions of R₁ and R₂");
    let (one, two) = (PrincipalRadii::new(1.0, 2.0)?, PrincipalRadii::new(3.0, 4.0)?);
    let gap = RelativeCurvature::new(one, two, OMEGA)?;
    // In the common axes, x along the larger relative curvature.
    let upper = Paraboloid::new(one, -gap.angle());
    let lower = Paraboloid::new(two, OMEGA - gap.angle());
    let xs = linspace(-0.8, 0.8, 161);
    let mut section = Panel::new("x", "z (into body 1)").titled("Section y = 0");
    section.add(Series::line("body 1, z₁", xs.iter().map(|&x| (x, upper.height(x, 0.0)))));
    section.add(Series::line("body 2, -z₂", xs.iter().map(|&x| (x, -lower.height(x, 0.0)))));
    let points = [(0.6, upper.height(0.6, 0.0)), (0.6, -lower.height(0.6, 0.0))];
    section.add(Series::dashed("z = z₁ + z₂", points));
    section.add(Series::markers("P₁", Marker::Circle, [points[0]]));
    section.add(Series::markers("P₂", Marker::Square, [points[1]]));
    section.add(Series::markers("O", Marker::Dot, [(0.0, 0.0)]));
    figure.panel(section);
    let mut map = Panel::new("x", "y").titled("Lines of equal distance").equal_aspect();
    let distance = Paraboloid::gap(gap, 0.0);
    for height in [0.02, 0.05, 0.1, 0.2] {
        map.add(Series::line(format!("z = {height}"), distance.contour(height)));
    }
    figure.panel(map);

    let grid: Vec<(f64, f64)> = linspace(-0.5, 0.5, 9)
        .into_iter()
        .flat_map(|x| linspace(-0.5, 0.5, 9).into_iter().map(move |y| (x, y)))
        .collect();
    let both = |x: f64, y: f64| upper.height(x, y) + lower.height(x, y);
    let pairs = grid.iter().map(|&(x, y)| (both(x, y), gap.a() * x * x + gap.b() * y * y));
    figure.all_close("z₁ + z₂ = A x² + B y² at 81 points", pairs, Absolute(1e-15)).source("(3.5)");
    let mixed = (both(0.5, 0.5) - both(0.5, -0.5)).abs();
    figure.at_most("no mixed term C x y", mixed, 1e-15).source("(3.4), (3.5)");
    figure.decreasing("A > B > 0", [gap.a(), gap.b(), 0.0]).source("(3.5)");
    figure
        .close("A of this pair", gap.a(), 0.654_797_163_336_101_1, Relative(1e-14))
        .source("eigenvalue in 25 digits by an independent program");
    figure
        .close("B of this pair", gap.b(), 0.386_869_503_330_565_6, Relative(1e-14))
        .source("eigenvalue in 25 digits by an independent program");
    Ok(figure)
}
