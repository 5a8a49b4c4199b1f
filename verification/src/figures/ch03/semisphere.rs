//! Fig. 3.4: displacements in the contact under a semispherical tangential traction.

use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};
use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, SurfaceOperator, Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::ellipsoidal_shear;
use std::f64::consts::{PI, SQRT_2};

const POISSON: f64 = 0.5;

/// u and v of (3.17), corrected, in units of pi C a/(32 G) at a point of the unit circle.
fn closed_form(poisson: f64, x: f64, y: f64) -> [f64; 2] {
    let square = x * x + y * y;
    let u = 2.0 * (2.0 - poisson) * (2.0 - square) + poisson * (x * x - y * y);
    [u, 2.0 * poisson * x * y]
}

/// The same by the field of the contact law.
fn by_law(poisson: f64, x: f64, y: f64) -> Result<[f64; 2], Failure> {
    let pair = MaterialPair::new(Material::from_shear(1.0, poisson)?, Material::RIGID)?;
    let circle = ContactEllipse::circle(1.0)?;
    let displacement = ellipsoidal_shear(&circle, 1.0, &pair, x, y)?;
    Ok(displacement.map(|u| u / (PI / 32.0)))
}

/// The same by rectangles of constant traction: points (x, y, u, v) of a square mesh.
fn by_rectangles(poisson: f64, cells: usize) -> Result<Vec<[f64; 4]>, Failure> {
    let body = Material::from_shear(1.0, poisson)?;
    let pair = MaterialPair::new(body, Material::RIGID)?;
    let width = 2.0 / (cells as f64 - 1.0);
    let grid = Grid::new(cells, cells, width, width)?;
    let operator = HalfSpaceOperator::with_blocks(pair, grid, Blocks::Tangential, Threads::One)?;
    let places: Vec<(f64, f64)> =
        (0..grid.cells()).map(|i| (grid.centred_x(i % cells), grid.centred_y(i / cells))).collect();
    let traction: Vec<f64> =
        places.iter().map(|(x, y)| (1.0 - x * x - y * y).max(0.0).sqrt()).collect();
    let [mut u, mut v] = [0; 2].map(|_| vec![0.0; grid.cells()]);
    let load = TractionField { x: Some(&traction), ..Default::default() };
    let wanted = DisplacementField::tangential(&mut u, &mut v);
    operator.apply(load, wanted, &mut operator.workspace())?;
    let unit = PI / 32.0;
    let points = places.iter().zip(u.iter().zip(&v));
    Ok(points.map(|(&(x, y), (u, v))| [x, y, u / unit, v / unit]).collect())
}

/// The largest difference from the closed form inside the circle.
fn error(cells: usize) -> Result<f64, Failure> {
    let points = by_rectangles(POISSON, cells)?;
    let inside = points.iter().filter(|[x, y, ..]| x * x + y * y < 0.999);
    Ok(inside.fold(0.0, |worst: f64, &[x, y, u, v]| {
        let [eu, ev] = closed_form(POISSON, x, y);
        worst.max((u - eu).abs()).max((v - ev).abs())
    }))
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ν", "0.5");
    figure.stated("ρ", "0 to a");
    figure.assumed("unit of displacement", "π C a/(32 G)");
    let radii = linspace(0.0, 1.0, 51);
    let mesh = by_rectangles(POISSON, 81)?;
    let mut u_panel = Panel::new("ρ/a", "u").titled("u");
    let mut v_panel = Panel::new("ρ/a", "v").titled("v");
    for (name, along) in
        [("θ = 0", [1.0, 0.0]), ("θ = 45°", [1.0 / SQRT_2; 2]), ("θ = 90°", [0.0, 1.0])]
    {
        let line = |component: usize| {
            let value = |r: f64| by_law(POISSON, r * along[0], r * along[1]);
            let points = radii.iter().map(|&r| Ok((r, value(r)?[component])));
            points.collect::<Result<Vec<(f64, f64)>, Failure>>()
        };
        u_panel.add(Series::line(name, line(0)?));
        v_panel.add(Series::line(name, line(1)?));
    }
    let on_axis: Vec<_> = mesh.iter().filter(|[x, y, ..]| *x >= 0.0 && y.abs() < 1e-9).collect();
    let markers = on_axis.iter().step_by(4).map(|[x, _, u, _]| (*x, *u));
    u_panel.add(Series::markers("rectangles, θ = 0", Marker::Circle, markers.collect::<Vec<_>>()));
    let diagonal = mesh.iter().filter(|[x, y, ..]| *x >= 0.0 && (x - y).abs() < 1e-9);
    let markers = diagonal
        .map(|[x, y, _, v]| (libm::hypot(*x, *y), *v))
        .filter(|(r, _)| *r <= 1.0)
        .step_by(3);
    v_panel.add(Series::markers(
        "rectangles, θ = 45°",
        Marker::Circle,
        markers.collect::<Vec<_>>(),
    ));
    figure.panel(u_panel);
    figure.panel(v_panel);

    law_claims(&mut figure)?;
    reference_claim(&mut figure)?;
    let transverse = by_rectangles(0.0, 41)?.iter().fold(0.0f64, |m, p| m.max(p[3].abs()));
    figure
        .at_most("no transverse displacement for ν = 0", transverse, 1e-13)
        .source("text below (4.5)");
    let errors = [error(21)?, error(41)?, error(81)?];
    figure.decreasing("rectangles converge to (3.17)", errors).source("independent program path");
    figure
        .at_most("81 by 81 rectangles differ from u(0) by 0.2 % at most", errors[2] / 6.0, 2e-3)
        .source("(3.17) corrected; the mesh's own error at the rim");
    figure.deviation(
        "(3.17) with 1/16",
        "1/32 with the combined G of (4.7), or G of one body for its displacement",
        "quadrature gives half of the printed displacement; (5.29) and (7.10) agree with 1/32",
    );
    Ok(figure)
}

/// The field of the law, which is drawn, compared with values and the closed form.
fn law_claims(figure: &mut Figure) -> Result<(), Failure> {
    let corners = [(0.0, 0.0, 6.0), (1.0, 0.0, 3.5), (0.0, 1.0, 2.5)];
    let corners: Result<Vec<(f64, f64)>, Failure> =
        corners.iter().map(|&(x, y, u)| Ok((by_law(POISSON, x, y)?[0], u))).collect();
    figure
        .all_close("u is 6 at the centre, 3.5 and 2.5 at the rim", corners?, Absolute(1e-14))
        .source("(3.17) corrected, worked out by hand");
    let mut field = Vec::new();
    for nu in [0.0, 0.2, POISSON] {
        for x in linspace(-0.9, 0.9, 7) {
            for y in linspace(-0.4, 0.4, 5) {
                field.extend(by_law(nu, x, y)?.into_iter().zip(closed_form(nu, x, y)));
            }
        }
    }
    figure
        .all_close("u and v of the law at 105 points", field, Absolute(1e-14))
        .source("(3.17) corrected");
    let mut largest = (0.0, 0.0);
    for t in linspace(0.0, PI / 2.0, 181) {
        let v = by_law(POISSON, libm::cos(t), libm::sin(t))?[1];
        if v > largest.1 {
            largest = (t, v);
        }
    }
    figure
        .all_close(
            "v is largest at 45°, 1/12 of u(0)",
            [(largest.0, PI / 4.0), (largest.1, 0.5)],
            Absolute(1e-14),
        )
        .source("caption and text; (3.17) corrected");
    Ok(())
}

/// Compares the law with values of 70 digits for circles.
fn reference_claim(figure: &mut Figure) -> Result<(), Failure> {
    let text = include_str!("../../../data/halfspace/ellipsoid_traction.csv");
    let rows = rows::<8>(text)?;
    let circles = rows.iter().filter(|row| row[2] == 1.0 && row[3] == 1.0);
    let mut pairs = Vec::new();
    for row in circles {
        let unit = PI / (32.0 * row[4]);
        let [u, v] = by_law(row[5], row[0], row[1])?;
        pairs.extend([(u * unit, row[6]), (v * unit, row[7])]);
    }
    figure
        .all_close("the field of the law", pairs, Absolute(1e-15))
        .source("quadrature with 70 digits, ν = 0 and 0.5");
    Ok(())
}
