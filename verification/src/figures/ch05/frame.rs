//! Fig. 5.1: the principal axes of two surfaces and of their gap.

use crate::{Arrow, Axis, Claim, Figure, FigureResult, Panel, Point, Series, Tolerance};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};

/// The gap between both surfaces in the axes of body 1, straight from (5.1).
fn gap(radii: [[f64; 2]; 2], omega: f64, x: f64, y: f64) -> f64 {
    let (s, c) = omega.sin_cos();
    let (u, v) = (c * x + s * y, c * y - s * x);
    let half = |r: [f64; 2], x: f64, y: f64| x * x / (2.0 * r[0]) + y * y / (2.0 * r[1]);
    half(radii[0], x, y) + half(radii[1], u, v)
}

fn arrow(angle: f64, length: f64) -> Arrow {
    let (s, c) = angle.sin_cos();
    let point = |t: f64| Point::from((t * c, t * s));
    Arrow { tail: point(0.0), head: point(length) }
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    let (radii, omega) = ([[1.0, 2.0], [3.0, 4.0]], 0.6);
    figure.assumed("R₁, R₁', R₂, R₂', ω", "1, 2, 3, 4, 0.6 rad");
    let body = |r: [f64; 2]| PrincipalRadii::new(r[0], r[1]);
    let relative = RelativeCurvature::new(body(radii[0])?, body(radii[1])?, omega)?;
    let mut panel = Panel::new(Axis::linear("x"), Axis::linear("y")).equal_aspect();
    for (label, angle) in [("body 1", 0.0), ("body 2", omega), ("gap", relative.angle())] {
        let quarter = std::f64::consts::FRAC_PI_2;
        panel.add(Series::arrows(label, [arrow(angle, 1.0), arrow(angle + quarter, 0.7)]));
    }
    figure.panel(panel);
    let (s, c) = relative.angle().sin_cos();
    let mut pairs = Vec::new();
    for i in 0..24 {
        let (v, u) = (f64::from(i) * 0.262).sin_cos();
        // A point (u, v) of the gap's axes in those of body 1.
        let (x, y) = (c * u - s * v, s * u + c * v);
        pairs.push((relative.gap(u, v), gap(radii, omega, x, y)));
    }
    figure.claim(
        Claim::all_close(
            "z₁ + z₂ = A x² + B y² in the turned axes",
            pairs,
            Tolerance::Relative(1e-14),
        )
        .source("(5.1) on 24 directions"),
    );
    figure.claim(
        Claim::close("α", relative.angle(), 0.072_729_045_7, Tolerance::Absolute(1e-9))
            .source("eigenvector of the quadratic form"),
    );
    figure.deviation(
        "(cos 2ω − …) tan 2α = sin 2ω",
        "(cos 2ω + (1/R₁ − 1/R₁')/(1/R₂ − 1/R₂')) tan 2α = sin 2ω",
        "sign of one term in (5.3b)",
    );
    Ok(figure)
}
