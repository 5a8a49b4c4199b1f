//! Figs. 14.33 to 14.37: flat punches, pressed and shifted, or of another material than the half-space.

use super::super::mesh::{APPROACH, Mesh, SHEAR_MODULUS, Shape, Step, steps};
use crate::{Absolute, Failure, Figure, FigureResult, Panel, Relative, Series};
use carom_halfspace::operator::{DisplacementField, TractionField};
use carom_laws::law::Shift;
use carom_plot::Field;
use carom_solver::CellState;
use std::f64::consts::PI;

const INDEPENDENT: &str = "an independent half-space program";

/// Pressed in one step, then shifted along x in five.
fn shifted(xi: f64) -> Vec<Shift> {
    let rest = Shift { zeta: APPROACH, ..Shift::default() };
    let mut path = vec![rest];
    path.extend(steps(rest, Shift { xi, ..rest }, 5));
    path
}

/// The region of a punch.
type Outline = fn(f64, f64) -> bool;

fn square(_: f64, _: f64) -> bool {
    true
}

/// Base 2, height 2.
fn triangle(x: f64, y: f64) -> bool {
    x.abs() < 0.5 * (1.0 - y)
}

fn punch(semi_axes: [f64; 2], elements: [usize; 2], inside: Outline) -> Mesh {
    Mesh { poisson: [0.5; 2], shape: Shape::Punch(inside), ..Mesh::of(semi_axes, elements) }
}

fn slip_opposes(figure: &mut Figure, step: &Step) {
    figure
        .all_close("slip opposes the stress", step.cosines_to_slip(), Absolute(1e-5))
        .source("Coulomb's law");
}

pub(super) fn square_and_triangle() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ζ, ν", "0.1, 0.5; ξ = 0.145 (rectangle), 0.14 (triangle)");
    figure.assumed("outlines", "square [-1, 1]², triangle of base 2 and height 2; f = 1");
    figure.assumed("elements", "40 × 40; 5 steps of shift");
    let cases =
        [("square", square as Outline, 0.145, 0.40), ("triangle", triangle as Outline, 0.14, 0.52)];
    for (name, outline, xi, stick) in cases {
        let run = punch([1.0; 2], [40; 2], outline).follow(&shifted(xi))?;
        let last = &run[5];
        figure.panel(last.stick_map(format!("{name}, ξ = {xi}"))?);
        figure
            .close(format!("part of the {name} that sticks"), last.stick(), stick, Absolute(0.025))
            .source(INDEPENDENT);
        if name == "square" {
            let cells = last.state.cells.values();
            let grid = last.state.cells.grid();
            let same = |i: usize, j: usize, k: usize, l: usize| {
                f64::from(u8::from(cells[grid.index(i, j)] != cells[grid.index(k, l)]))
            };
            let pairs = (0..40).flat_map(|j| (0..40).map(move |i| (i, j)));
            let odd: f64 = pairs.map(|(i, j)| same(i, j, 39 - i, j) + same(i, j, i, 39 - j)).sum();
            figure
                .at_most("the square's map has both symmetries: cells that break them", odd, 0.0)
                .source("symmetry");
            let at = |i: usize, j: usize| cells[grid.index(i, j)];
            let ahead = at(0, 20) == CellState::Slip && at(39, 20) == CellState::Slip;
            let beside = at(20, 0) == CellState::Stick && at(20, 39) == CellState::Stick;
            figure
                .holds(
                    "the borders ahead and behind slip, those beside stick",
                    ahead && beside,
                    last.stick(),
                )
                .source("section 14.5");
        }
        slip_opposes(&mut figure, last);
    }
    Ok(figure)
}

/// Four letters on a raster of 23 by 7, the first row on top.
const LETTERS: [&str; 7] = [
    ".####.#.....#####.####.",
    "#.....#.......#...#...#",
    "#.....#.......#...#...#",
    ".###..#.......#...####.",
    "....#.#.......#...#....",
    "....#.#.......#...#....",
    "####..#####.#####.#....",
];
const RASTER: [f64; 2] = [23.0, 7.0];

fn letters(x: f64, y: f64) -> bool {
    let column = ((x / RASTER[0] + 0.5) * RASTER[0]).floor() as usize;
    let row = ((0.5 - y / RASTER[1]) * RASTER[1]).floor() as usize;
    LETTERS.get(row).and_then(|line| line.as_bytes().get(column)).is_some_and(|c| *c == b'#')
}

pub(super) fn four_letters() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ξ, ζ, ν", "0.15, 0.1, 0.5");
    figure.assumed("letters", "S, L, I, P of our own on a raster of 1 mm; f = 1");
    figure.assumed("elements", "3 × 3 a square of the raster; 5 steps of shift");
    let half = RASTER.map(|n| 0.5 * n);
    let mesh = punch(half, RASTER.map(|n| 3 * n as usize), letters);
    let run = mesh.follow(&shifted(0.15))?;
    figure.panel(run[3].stick_map("ξ = 0.09")?);
    figure.panel(run[5].stick_map("ξ = 0.15")?);
    let squares = LETTERS.iter().flat_map(|line| line.bytes()).filter(|c| *c == b'#').count();
    let touching = run[5].touching().count() as f64;
    figure
        .close("elements that touch", touching, 9.0 * squares as f64, Absolute(0.0))
        .source("a flat punch touches all over");
    let sticks: Vec<f64> = run.iter().map(Step::stick).collect();
    figure
        .at_least("what sticks falls with the shift", sticks[3] - sticks[5], 0.02)
        .source("Cattaneo: slip spreads from the borders");
    let mixed = sticks[5] > 0.0 && sticks[5] < 1.0;
    figure.holds("both stick and slip", mixed, sticks[5]).source("fig. 14.34");
    slip_opposes(&mut figure, &run[5]);
    Ok(figure)
}

fn flat_ellipse(x: f64, y: f64) -> bool {
    x * x + (y / 0.3).powi(2) < 1.0
}

/// Five steps of pressing, three of releasing.
fn pressed() -> Result<(Mesh, Vec<Step>), Failure> {
    let mesh = Mesh {
        poisson: [0.0, 0.5],
        friction: 0.1,
        shape: Shape::Punch(flat_ellipse),
        ..Mesh::of([1.0, 0.3], [80, 32])
    };
    let at = |zeta| Shift { zeta, ..Shift::default() };
    let mut path: Vec<Shift> = steps(at(0.0), at(APPROACH), 5).collect();
    path.extend(steps(at(APPROACH), at(0.2 * APPROACH), 4));
    let run = mesh.follow(&path)?;
    Ok((mesh, run))
}

fn inputs(figure: &mut Figure) {
    figure.stated("ν₁, ν₂, a, b, f, Δζ", "0, 0.5, 1, 0.3, 0.1, ±0.02");
    figure.assumed("outline", "the ellipse; 80 × 32 elements (1000 in the thesis)");
}

/// Hertz's mean stress of an ellipse of these semi-axes under the approach 0.1, in N/mm^2.
const MEAN_STRESS: f64 = 9245.96;

pub(super) fn maps() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let (_, run) = pressed()?;
    for number in [1, 6, 7, 8] {
        figure.panel(run[number - 1].stick_map(format!("step {number}"))?);
    }
    let first = run[0].state.cells.values();
    let changed: f64 = run[1..5]
        .iter()
        .flat_map(|step| step.state.cells.values().iter().zip(first))
        .map(|(now, then)| f64::from(u8::from(now != then)))
        .sum();
    figure
        .at_most("while the load grows the map stays: cells that change", changed, 0.0)
        .source("proportional loading; section 14.6");
    let pairs = [(6, 0.48), (7, 0.41), (8, 0.16), (9, 0.005)];
    figure
        .all_close(
            "parts that stick in steps 6 to 9",
            pairs.map(|(n, part)| (run[n - 1].stick(), part)),
            Absolute(0.035),
        )
        .source(INDEPENDENT);
    let rim = |step: &Step| {
        let cells = step.touching().filter(|cell| cell.sticks);
        let radii: Vec<f64> = cells.map(|cell| cell.x.hypot(cell.y / 0.3)).collect();
        radii.iter().sum::<f64>() / radii.len() as f64
    };
    figure
        .decreasing("where it sticks moves inwards", [6, 7, 8].map(|n| rim(&run[n - 1])))
        .source("section 14.6");
    Ok(figure)
}

pub(super) fn displacement_and_stress() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let (mesh, run) = pressed()?;
    let (step, grid) = (&run[4], mesh.grid()?);
    let problem = mesh.problem()?;
    let operator = problem.operator();
    let mut w = vec![0.0; grid.cells()];
    let state = &step.state;
    let load = TractionField::full(
        state.traction_x.values(),
        state.traction_y.values(),
        state.pressure.values(),
    );
    operator.apply(load, DisplacementField::normal(&mut w), &mut operator.workspace())?;
    let x: Vec<f64> = (0..grid.nx()).map(|i| grid.centred_x(i)).collect();
    let y: Vec<f64> = (0..grid.ny()).map(|i| grid.centred_y(i)).collect();
    let map = |title: &str, label: &str, values: Vec<f64>| -> Result<Panel, Failure> {
        let field = Field::new(label, x.clone(), y.clone(), values)?;
        let panel = Panel::new("x", "y").titled(title);
        Ok(panel.equal_aspect().over(field))
    };
    figure.panel(map("normal displacement", "w/ζ", w.iter().map(|w| w / APPROACH).collect())?);
    let stress = state.pressure.values().iter().map(|p| p / MEAN_STRESS).collect();
    figure.panel(map("normal stress", "−σ_zz/σ_M", stress)?);
    let mut arrows = Panel::new("x", "y").titled("tangential stress").equal_aspect();
    arrows.add(step.arrows("t", 0.08, |cell| cell.traction));
    figure.panel(arrows);
    // Hertz: F_z/(pi a b) by quadrature of the elliptic integral, apart from the library.
    let hertz = {
        let count = 20_000;
        let k: f64 = (0..count)
            .map(|i| {
                let phi = 0.5 * PI * (f64::from(i) + 0.5) / f64::from(count);
                (phi.cos().powi(2) + 0.09 * phi.sin().powi(2)).sqrt().recip()
            })
            .sum::<f64>()
            * 0.5
            * PI
            / f64::from(count);
        // F_z = (4 pi/3) b zeta G/((1 - nu) K), b the larger semi-axis;
        // (1 - nu)/G of the pair: 1/G_1 + 1/(2 G_2).
        let compliance = 1.5 / SHEAR_MODULUS;
        4.0 / 3.0 * APPROACH / (0.3 * compliance * k)
    };
    figure
        .close("Hertz's mean stress", hertz, MEAN_STRESS, Relative(1e-6))
        .source("the thesis prints 9246; closed form");
    let touching: Vec<f64> = w
        .iter()
        .zip(state.pressure.values())
        .filter(|(_, p)| **p > 0.0)
        .map(|(w, _)| w / APPROACH)
        .collect();
    figure
        .all_close("below the punch w = ζ", touching.into_iter().map(|w| (w, 1.0)), Absolute(1e-8))
        .source("a flat punch");
    let middle = grid.index(grid.nx() / 2, grid.ny() / 2);
    figure
        .close(
            "pressure in the middle over σ_M",
            state.pressure.values()[middle] / MEAN_STRESS,
            0.835,
            Absolute(0.01),
        )
        .source(INDEPENDENT);
    figure
        .close("F_z over Hertz's", step.load.f_z / (MEAN_STRESS * 0.3 * PI), 1.51, Absolute(0.01))
        .source(INDEPENDENT);
    Ok(figure)
}

pub(super) fn slip() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let (_, run) = pressed()?;
    let step = &run[4];
    let mut panel = Panel::new("x", "y").titled("slip in step 5").equal_aspect();
    panel.add(step.arrows("slip of body 1", 0.08, |cell| cell.slip));
    let mut outline: Vec<(f64, f64)> = (0..=120)
        .map(|i| {
            let angle = std::f64::consts::TAU * f64::from(i) / 120.0;
            (angle.cos(), 0.3 * angle.sin())
        })
        .collect();
    outline.push(outline[0]);
    panel.add(Series::line("punch", outline));
    figure.panel(panel);
    slip_opposes(&mut figure, step);
    let most = |step: &Step| step.touching().map(|cell| cell.slip_size()).fold(0.0, f64::max);
    figure
        .close("each step of loading slips alike", most(step) / most(&run[0]), 1.0, Absolute(1e-5))
        .source("proportional loading");
    Ok(figure)
}
