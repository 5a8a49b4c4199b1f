//! Proposition 3: a rigid punch on a simply supported rectangular plate.

use std::f64::consts::{PI, SQRT_2};
use std::sync::Arc;

use crate::{
    Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, logspace,
};
use carom_halfspace::operator::{
    DisplacementField, Plate, PlateOperator, PlateSymbol, SurfaceOperator, Threads, TractionField,
};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Frictionless, Gap, Method as _, Outline, Shape,
};

/// Deflection of the middle of a square plate over q a^4/D under a uniform load q.
const UNIFORM: f64 = 0.004_062_352_66;
/// Deflection of the middle of a square plate over P a^2/D under a force P there.
const CENTRAL: f64 = 0.011_600_839_6;
const TIMOSHENKO: &str = "Timoshenko, Woinowsky-Krieger, Navier's series";

/// D of a plate of thickness h and E* = 1.
fn bending(thickness: f64) -> f64 {
    thickness * thickness * thickness / 12.0
}

/// A square plate, a = 1 and E* = 1, below a rigid punch.
fn square(thickness: f64, cells: usize, kind: PlateSymbol) -> Result<Arc<PlateOperator>, Failure> {
    let pair = MaterialPair::new(Material::RIGID, Material::from_young(0.91, 0.3)?)?;
    let plate = Plate::new(1.0, 1.0, thickness)?;
    let grid = plate.grid(cells, cells)?;
    Ok(Arc::new(PlateOperator::new(pair, plate, grid, kind, Threads::One)?))
}

fn below_sphere(operator: &Arc<PlateOperator>, radius: f64) -> Result<ContactProblem, Failure> {
    let height = |x: f64, y: f64| 0.5 * (x * x + y * y) / radius;
    let gap = Gap::from_function(operator.grid(), height)?;
    Ok(ContactProblem::new(gap, Arc::<PlateOperator>::clone(operator), Friction::NONE)?)
}

/// A flat square punch over a quarter of the plate.
fn below_flat(operator: &Arc<PlateOperator>) -> Result<ContactProblem, Failure> {
    let outline = Outline::Rectangle { half_x: 0.25, half_y: 0.25 };
    let gap = Gap::of_shape(operator.grid(), &Shape::Punch(outline))?;
    Ok(ContactProblem::new(gap, Arc::<PlateOperator>::clone(operator), Friction::NONE)?)
}

fn pressed(problem: &ContactProblem, normal: Driven) -> Result<ContactState, Failure> {
    let method = Frictionless::default().within(1e-11)?.at_most(20_000);
    let from = ContactState::apart(problem.grid());
    let (mut to, mut scratch) = (from.clone(), method.scratch(problem)?);
    let drive = Drive { normal, ..Drive::default() };
    method.step(problem, &from, &drive, &mut to, &mut scratch, &mut ())?;
    Ok(to)
}

/// Displacements w due to pressures.
fn deflection(operator: &PlateOperator, pressure: &[f64]) -> Result<Vec<f64>, Failure> {
    let mut w = vec![0.0; pressure.len()];
    let wanted = DisplacementField::normal(&mut w);
    operator.apply(TractionField::normal(pressure), wanted, &mut operator.workspace())?;
    Ok(w)
}

/// The values of one row of cells over x/a.
fn along_row(operator: &PlateOperator, row: usize, values: &[f64]) -> Vec<(f64, f64)> {
    let grid = operator.grid();
    (0..grid.nx()).map(|i| (grid.centred_x(i), values[grid.index(i, row)])).collect()
}

/// Symbol, cells along a side, h, approach, and the force of an independent program, for R = a = 1.
const FORCES: [(PlateSymbol, usize, f64, f64, f64); 8] = [
    (PlateSymbol::Layer, 48, 0.3, 0.01, 7.464_171_015_174_455e-4),
    (PlateSymbol::Layer, 48, 0.3, 0.08, 1.215_181_408_820_718_3e-2),
    (PlateSymbol::Layer, 48, 0.1, 0.03, 1.992_266_529_806_909_4e-4),
    (PlateSymbol::Layer, 48, 0.1, 0.08, 6.160_846_483_421_428e-4),
    (PlateSymbol::Layer, 48, 0.03, 0.08, 1.716_900_007_220_623_6e-5),
    (PlateSymbol::Sum, 48, 0.1, 0.08, 6.319_038_656_430_111e-4),
    (PlateSymbol::Kirchhoff, 24, 0.1, 0.03, 2.173_990_385_267_349_5e-4),
    (PlateSymbol::Kirchhoff, 24, 0.1, 0.08, 6.378_265_944_398_917e-4),
];

fn forces(figure: &mut Figure) -> Result<(), Failure> {
    let mut pairs = Vec::new();
    for (kind, cells, thickness, approach, known) in FORCES {
        let problem = below_sphere(&square(thickness, cells, kind)?, 1.0)?;
        pairs.push((pressed(&problem, Driven::Shift(approach))?.load().f_z, known));
    }
    figure
        .all_close("forces of a sphere on eight plates", pairs, Relative(1e-9))
        .source("independent program, same cells");
    Ok(())
}

/// Uniform load, and a force in the middle.
fn loads(figure: &mut Figure) -> Result<(), Failure> {
    let operator = square(0.01, 25, PlateSymbol::Kirchhoff)?;
    let (grid, stiffness) = (operator.grid(), bending(0.01));
    let w = deflection(&operator, &vec![1.0; grid.cells()])?[grid.index(12, 12)];
    figure
        .close("w D/(q a⁴), uniform load, 25² cells", w * stiffness, UNIFORM, Relative(1e-9))
        .source(TIMOSHENKO);
    // Errors fall as n^-2 ln n and n^-2.
    let cells = [21, 41, 81];
    let mut under = [0.0; 3];
    for (found, n) in under.iter_mut().zip(cells) {
        let operator = square(0.01, n, PlateSymbol::Kirchhoff)?;
        let grid = operator.grid();
        *found = operator.coefficients(0, 0).rows[2][2] * stiffness / grid.cell_area();
    }
    let rows = cells.map(|n| {
        let square = (n * n) as f64;
        [1.0, (n as f64).ln() / square, 1.0 / square]
    });
    let system = nalgebra::Matrix3::from_fn(|i, j| rows[i][j]);
    let fitted = system.lu().solve(&nalgebra::Vector3::from(under)).ok_or("equal rows")?;
    figure
        .close("w D/(P a²), force in the middle, many cells", fitted[0], CENTRAL, Relative(1e-5))
        .source(TIMOSHENKO);
    Ok(())
}

/// P3.1: pressures along the middle of three plates at one approach.
fn pressures(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::linear("x / a"), Axis::linear("p / greatest p"))
        .titled("Pressure under a sphere, approach 0.08 a²/R");
    let mut middle = Vec::new();
    for thickness in [0.3, 0.1, 0.03] {
        let operator = square(thickness, 48, PlateSymbol::Layer)?;
        let state = pressed(&below_sphere(&operator, 1.0)?, Driven::Shift(0.08))?;
        let pressure = state.pressure.values();
        let most = pressure.iter().copied().fold(0.0, f64::max);
        let line: Vec<_> =
            along_row(&operator, 23, pressure).into_iter().map(|(x, p)| (x, p / most)).collect();
        middle.push(line[23].1);
        let shown = line.into_iter().filter(|(x, _)| x.abs() < 0.35);
        panel.add(Series::line(format!("h/a = {thickness}"), shown));
    }
    let edge = 0.08_f64.sqrt();
    let cap = crate::linspace(-edge, edge, 121);
    panel.add(Series::dotted(
        "Hertz, half-space",
        cap.into_iter().map(|x| (x, (1.0 - x * x / 0.08).max(0.0).sqrt())),
    ));
    figure.panel(panel);
    figure
        .decreasing("a thinner plate leaves the middle of the sphere", middle.iter().copied())
        .source("Kirchhoff's plate bears on a ring");
    figure
        .close("pressure in the middle of the thinnest", middle[2], 0.0, Absolute(0.0))
        .source("Kirchhoff's plate bears on a ring");
    Ok(())
}

/// P3.2: force against approach.
fn force_curves(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::log("approach R / a²"), Axis::log("F R / (E* a³)"))
        .titled("Force of a sphere of radius R");
    for (colour, thickness) in [0.3, 0.1].into_iter().enumerate() {
        let problem = below_sphere(&square(thickness, 48, PlateSymbol::Layer)?, 1.0)?;
        let mut points = Vec::new();
        for approach in logspace(2e-3, 0.1, 12) {
            points.push((approach, pressed(&problem, Driven::Shift(approach))?.load().f_z));
        }
        let name = format!("h/a = {thickness}");
        panel.add(Series::markers(name, Marker::Circle, points).coloured(colour));
        let force = logspace(1e-6, 0.03, 61);
        let of = |soft: f64, hard: f64| {
            let at = move |f: f64| (soft * CENTRAL * f / bending(thickness) + hard * hertz(f), f);
            force.clone().into_iter().map(at).filter(|at| (1e-3..0.2).contains(&at.0))
        };
        let names = if colour == 0 { ["series law", "bending alone"] } else { [""; 2] };
        panel.add(Series::line(names[0], of(1.0, 1.0)).coloured(colour));
        panel.add(Series::dashed(names[1], of(1.0, 0.0)).coloured(colour));
        if colour == 0 {
            panel.add(Series::dotted("Hertz, half-space", of(0.0, 1.0)).coloured(6));
        }
    }
    figure.panel(panel);
    series_law(figure)
}

/// Hertz's approach of a sphere R = 1 on a half-space E* = 1.
fn hertz(force: f64) -> f64 {
    (0.75 * force).powf(2.0 / 3.0)
}

/// Contact narrower than the plate is thick: Hertz and bending in series.
fn series_law(figure: &mut Figure) -> Result<(), Failure> {
    let mut pairs = Vec::new();
    let problem = below_sphere(&square(0.1, 144, PlateSymbol::Layer)?, 1.0)?;
    for c in [0.04, 0.05] {
        let force: f64 = 4.0 / 3.0 * c * c * c;
        let series = CENTRAL * force / bending(0.1) + hertz(force);
        pairs.push((pressed(&problem, Driven::Load(force))?.shift.zeta, series));
    }
    figure
        .all_close("approach at Hertz's c/h = 0.4 and 0.5, h/a = 0.1", pairs, Relative(0.02))
        .source("Hertz and Kirchhoff in series, for c < h");
    Ok(())
}

/// Kirchhoff's plate under a sphere: it bears on a ring.
fn ring(figure: &mut Figure) -> Result<(), Failure> {
    // D = 1; rho: the conformal radius of the square about its middle.
    let (c, radius) = (0.1_f64, 20.0);
    let rho = 4.0 * PI.sqrt() / libm::tgamma(0.25).powi(2);
    let log = (rho / c).ln();
    let force = 4.0 * PI / (radius * log);
    let approach = force * (CENTRAL - c * c * (log + 1.0) / (8.0 * PI));
    let operator = square(12.0_f64.cbrt(), 48, PlateSymbol::Kirchhoff)?;
    let state = pressed(&below_sphere(&operator, radius)?, Driven::Shift(approach))?;
    figure
        .close(
            "F R/D, sphere on Kirchhoff's plate, c = 0.1 a",
            state.load().f_z,
            force,
            Relative(5.1e-4),
        )
        .source("closed form, conformal radius");
    let grid = operator.grid();
    let places = grid.centres().zip(state.pressure.values());
    let inside = places.filter(|((x, y), p)| libm::hypot(*x, *y) < 0.07 && **p > 0.0).count();
    figure
        .close("cells in contact within 0.7 of the ring", inside as f64, 0.0, Absolute(0.0))
        .source("a plate that follows the sphere carries no load");
    Ok(())
}

/// P3.3: the plate under a flat punch.
fn flat_punch(figure: &mut Figure) -> Result<(), Failure> {
    let approach = 0.01;
    let mut panel = Panel::new(Axis::linear("x / a"), Axis::linear("-w / approach"))
        .titled("Plate under a flat square punch, h/a = 0.1");
    let operator = square(0.1, 48, PlateSymbol::Layer)?;
    let state = pressed(&below_flat(&operator)?, Driven::Shift(approach))?;
    let w = deflection(&operator, state.pressure.values())?;
    for (name, row) in [("below an edge", 12), ("through the middle", 23)] {
        let line = along_row(&operator, row, &w);
        panel.add(Series::line(name, line.into_iter().map(|(x, w)| (x, -w / approach))));
    }
    panel.add(Series::dashed("punch", [(-0.25, -1.0), (0.25, -1.0)]).coloured(6));
    figure.panel(panel);

    let mut panel = Panel::new(Axis::linear("x / a"), Axis::linear("gap / approach"))
        .titled("Gap below the middle of the flat punch");
    let mut lifted = Vec::new();
    for thickness in [0.3, 0.1, 0.03] {
        let operator = square(thickness, 48, PlateSymbol::Layer)?;
        let state = pressed(&below_flat(&operator)?, Driven::Shift(approach))?;
        let w = deflection(&operator, state.pressure.values())?;
        let line: Vec<_> = along_row(&operator, 23, &w)
            .into_iter()
            .filter(|(x, _)| x.abs() < 0.25)
            .map(|(x, w)| (x, w / approach - 1.0))
            .collect();
        lifted.push(line[line.len() / 2].1);
        panel.add(Series::line(format!("h/a = {thickness}"), line));
    }
    figure.panel(panel);
    figure
        .increasing("a thinner plate leaves the middle of the punch more", lifted)
        .source("the half-space touches everywhere");
    corners(figure)
}

/// Kirchhoff's plate bears on the corners of a flat square punch.
fn corners(figure: &mut Figure) -> Result<(), Failure> {
    let approach = 1e-3;
    let operator = square(1.0, 48, PlateSymbol::Kirchhoff)?;
    let state = pressed(&below_flat(&operator)?, Driven::Shift(approach))?;
    let touching = state.pressure.values().iter().filter(|p| **p > 0.0).count();
    let is_corner =
        |&(ix, iy): &(usize, usize)| state.pressure.get(ix, iy).is_some_and(|p| *p > 0.0);
    let at_corners =
        [(12, 12), (12, 35), (35, 12), (35, 35)].iter().filter(|at| is_corner(at)).count();
    figure
        .close(
            "cells in contact, flat punch on Kirchhoff's plate",
            touching as f64,
            4.0,
            Absolute(0.0),
        )
        .source("a bowl bears on the corners");
    figure
        .close("of them in the corners", at_corners as f64, 4.0, Absolute(0.0))
        .source("a bowl bears on the corners");
    // Four forces at the centres of the corner cells, half a cell inside the punch.
    let flexibility = approach * bending(1.0) / state.load().f_z;
    figure
        .close(
            "approach D/(F a²), forces on four cells",
            flexibility,
            0.003_217_7,
            Relative(1.5e-3),
        )
        .source("Navier's series of four point forces at the centres of the corner cells");
    Ok(())
}

/// kh and F(kh) in arithmetic of many digits.
const FACTORS: [(f64, f64); 6] = [
    (0.1, 6_012.018_285_458_557),
    (0.25, 388.845_710_145_970_86),
    (0.5, 50.491_391_386_696_14),
    (1.0, 7.382_435_342_618_087),
    (2.0, 1.709_062_664_724_982),
    (5.0, 1.005_564_555_601_46),
];

/// F(kh) = C E* k/2 from the eigenvalue of the longest wave, for small cells.
fn factor(s: f64, kind: PlateSymbol) -> Result<f64, Failure> {
    let k = SQRT_2 * PI;
    let on = |cells: usize| -> Result<f64, Failure> {
        let operator = square(s / k, cells, kind)?;
        Ok(0.5 * k * operator.eigenvalue(1, 1).ok_or("no waves")?)
    };
    // Aliases along one axis are of the order n^-2, along both n^-3.
    let (coarse, medium, fine) = (on(16)?, on(32)?, on(64)?);
    let [first, second] = [(coarse, medium), (medium, fine)].map(|(a, b)| (4.0 * b - a) / 3.0);
    Ok((8.0 * second - first) / 7.0)
}

/// P3.4: the compliance of a wave.
fn compliance(figure: &mut Figure) -> Result<(), Failure> {
    let closed = |s: f64| {
        let (sinh, cosh) = (libm::sinh(s), libm::cosh(s));
        (sinh * cosh + s) / (sinh * sinh - s * s)
    };
    let all = logspace(0.2, 20.0, 81);
    let drawn = |of: &dyn Fn(f64) -> f64| all.iter().map(|&s| (s, of(s))).collect::<Vec<_>>();
    let mut panel = Panel::new(Axis::log("k h"), Axis::log("F"))
        .titled("Compliance of a wave over that of the half-space");
    panel.add(Series::line("layer", drawn(&closed)));
    let within = |points: Vec<(f64, f64)>| points.into_iter().filter(|at| at.1 > 0.3);
    panel.add(Series::dashed("bending, 6/(k h)³", within(drawn(&|s| 6.0 / (s * s * s)))));
    panel.add(Series::dashed("half-space", [(0.2, 1.0), (20.0, 1.0)]));
    panel.add(Series::dotted("sum", drawn(&|s| 1.0 + 6.0 / (s * s * s))));
    let (mut pairs, mut points) = (Vec::new(), Vec::new());
    for (s, known) in FACTORS {
        let found = factor(s, PlateSymbol::Layer)?;
        pairs.push((found, known));
        points.push((s, found));
    }
    let shown = points.into_iter().filter(|at| at.0 > 0.2);
    panel.add(Series::markers("operator", Marker::Circle, shown).coloured(0));
    figure.panel(panel);
    figure
        .all_close("F of the longest wave on the plate", pairs, Relative(1e-5))
        .source("closed form of the layer, twenty digits");
    for (s, known) in [(1.0, -0.051_803_412_4), (3.2, 0.075_781_397_8)] {
        let off = factor(s, PlateSymbol::Sum)? / factor(s, PlateSymbol::Layer)? - 1.0;
        figure
            .close(format!("sum over layer - 1 at k h = {s}"), off, known, Absolute(1e-6))
            .source("(1 + 6/s³)/F(s) - 1 in closed form, near its extremes");
    }
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("method", "Fourier solution for a constant pressure on a small rectangle");
    figure.stated("punch", "rigid, of known form");
    figure.assumed("plate", "square, a = 1, simply supported, corners held down, E* = 1, ν = 0.3");
    figure.assumed(
        "theory",
        "elastic layer unless another is named; linear, so that the approach scales with 1/R",
    );
    figure.assumed("cells", "48² on the whole plate unless stated");
    forces(&mut figure)?;
    loads(&mut figure)?;
    pressures(&mut figure)?;
    force_curves(&mut figure)?;
    ring(&mut figure)?;
    flat_punch(&mut figure)?;
    compliance(&mut figure)?;
    Ok(figure)
}
