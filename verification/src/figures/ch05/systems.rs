//! Fig. 5.1: the local coordinate systems of the two surfaces and the common one.

use std::f64::consts::PI;

use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};

use super::super::paraboloid::Paraboloid;
use crate::reference::rows;
use crate::{Absolute, Arrow, Failure, Figure, FigureResult, Panel, Point, Relative, Series};

const OMEGA: f64 = 50.0 * PI / 180.0;

/// Curvatures of an example: radii 1 and 3 of body 1, 1.5 and 6 of body 2.
fn bodies() -> Result<[PrincipalRadii; 2], carom_special::RangeError> {
    Ok([PrincipalRadii::new(1.0, 3.0)?, PrincipalRadii::new(1.5, 6.0)?])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("radii", "R₁ = 1, R₁' = 3, R₂ = 1.5, R₂' = 6");
    figure.assumed("ω", "50°, from x_A to x_B; α from x_A to x");
    let [one, two] = bodies()?;
    let gap = RelativeCurvature::new(one, two, OMEGA)?;
    figure.derived(
        "A, B, α",
        format!("{:.4}, {:.4}, {:.3}°", gap.a(), gap.b(), gap.angle().to_degrees()),
    );
    let surfaces =
        [Paraboloid::new(one, 0.0), Paraboloid::new(two, OMEGA), Paraboloid::gap(gap, gap.angle())];
    let mut panel = Panel::new("along x_A", "along y_A")
        .titled("Lines of equal height 0.05 and the axes")
        .equal_aspect();
    let names =
        ["body 1, axes x_A, y_A", "body 2, axes x_B, y_B", "gap z = A x² + B y², axes x, y"];
    for (i, (surface, name)) in surfaces.into_iter().zip(names).enumerate() {
        panel.add(Series::line(name, surface.contour(0.05)).coloured(i));
    }
    for (i, angle) in [0.0, OMEGA, gap.angle()].into_iter().enumerate() {
        let axes = [(angle, 0.95), (angle + 0.5 * PI, 0.95)].map(|(angle, length)| Arrow {
            tail: Point::new(0.0, 0.0),
            head: Point::new(length * libm::cos(angle), length * libm::sin(angle)),
        });
        panel.add(Series::arrows("", axes).coloured(i));
    }
    figure.panel(panel);

    sum_claims(&mut figure, &surfaces);
    table_claims(&mut figure)?;
    formula_claims(&mut figure, gap)?;
    figure.deviation(
        "(cos 2ω - (1/R₁ - 1/R₁')/(1/R₂ - 1/R₂')) tan 2α = -sin 2ω in (5.3b)",
        "(cos 2ω + (1/R₁ - 1/R₁')/(1/R₂ - 1/R₂')) tan 2α = sin 2ω",
        "misprint of one sign; with it x is no principal direction",
    );
    Ok(figure)
}

/// The gap is the sum of both surfaces, without a mixed term in its own axes.
fn sum_claims(figure: &mut Figure, [one, two, gap]: &[Paraboloid; 3]) {
    let points = (0..60).map(|i| {
        let (angle, r) = (0.37 * f64::from(i), 0.02 * f64::from(i));
        (r * libm::cos(angle), r * libm::sin(angle))
    });
    let pairs = points.map(|(x, y)| (gap.height(x, y), one.height(x, y) + two.height(x, y)));
    figure
        .all_close("A x² + B y² = z₁ + z₂ at 60 points", pairs, Absolute(1e-15))
        .source("(5.1), (5.2)");
}

fn table_claims(figure: &mut Figure) -> Result<(), Failure> {
    let table = rows::<8>(include_str!("../../../data/laws/principal_curvatures.csv"))?;
    let (mut coefficients, mut directions) = (Vec::new(), Vec::new());
    for [r1, r1_across, r2, r2_across, omega, a, b, angle] in table {
        let (one, two) = (PrincipalRadii::new(r1, r1_across)?, PrincipalRadii::new(r2, r2_across)?);
        let gap = RelativeCurvature::new(one, two, omega)?;
        coefficients.extend([(gap.a(), a), (gap.b(), b)]);
        if (a - b) > 1e-6 * a {
            directions.push((libm::sin(gap.angle() - angle), 0.0));
        }
    }
    figure
        .all_close("A and B of 13 pairs", coefficients, Relative(1e-14))
        .source("eigenvalues of the sum of both forms, in 25 digits");
    figure
        .all_close("the x-axis of those with A > B", directions, Absolute(1e-9))
        .source("eigenvectors, in 25 digits");
    Ok(())
}

fn formula_claims(figure: &mut Figure, gap: RelativeCurvature) -> Result<(), Failure> {
    let [[r1, r1_across], [r2, r2_across]] = bodies()?.map(|body| body.curvatures());
    let (one, two) = (r1 - r1_across, r2 - r2_across);
    let cos = libm::cos(2.0 * OMEGA);
    let sum = r1 + r1_across + r2 + r2_across;
    let difference = one * one + two * two + 2.0 * one * two * cos;
    let (a, b) = (gap.a(), gap.b());
    figure
        .all_close(
            "2(A + B) and 4(A - B)²",
            [(2.0 * (a + b), sum), (4.0 * (a - b) * (a - b), difference)],
            Relative(1e-14),
        )
        .source("(5.3a)");
    let (sin, tan) = (libm::sin(2.0 * OMEGA), libm::tan(2.0 * gap.angle()));
    figure
        .close("(5.3b), corrected", (cos + one / two) * tan, sin, Relative(1e-14))
        .source("errata");
    let printed = ((cos - one / two) * tan + sin).abs();
    figure
        .at_least("(5.3b) as printed misses by, where sin 2ω is 0.985", printed, 0.1)
        .source("errata");
    Ok(())
}
