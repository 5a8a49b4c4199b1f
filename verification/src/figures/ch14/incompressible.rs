//! Figs. 14.4, 14.5: the history of fig. 14.1 with nu = 0.5, where directions couple.

use super::super::mesh::{APPROACH, Mesh, Step, Touching, steps};
use super::angle_axis;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;
use carom_laws::memory::Memory;

const ELEMENTS: usize = 40;
/// Angle of the stress at (0.475, 0.475) after some steps: an independent program on this mesh.
/// The third is known to a degree only.
const ANGLES: [(usize, f64, f64); 5] =
    [(6, -5.1, 0.06), (8, -8.8, 0.06), (10, -71.0, 0.5), (12, -172.8, 0.06), (16, 175.0, 0.06)];
const INDEPENDENT: &str = "an independent half-space program";

/// Full sliding begins at xi = kappa f zeta, kappa = 3/2.
const SLIDING: f64 = 1.5 * APPROACH;

fn history() -> Vec<Shift> {
    let at = |part: f64| Shift { zeta: APPROACH, xi: part * SLIDING, ..Shift::default() };
    let mut path = vec![at(0.0)];
    for (from, to, count) in [(0.0, 1.0, 5), (1.0, -1.0, 10), (-1.0, 1.0, 10), (1.0, -1.0, 10)] {
        path.extend(steps(at(from), at(to), count));
    }
    path
}

fn mesh(elements: usize) -> Mesh {
    Mesh { poisson: [0.5; 2], ..Mesh::of([1.0; 2], [elements; 2]) }
}

fn inputs(figure: &mut Figure) {
    figure.stated("ν, a = b, ζ, Δξ, f", "0.5, 1, 0.1, 0.03, 1");
    figure.assumed("elements", format!("{ELEMENTS} × {ELEMENTS} (10 × 7 in the thesis)"));
}

pub(super) fn loop_of_force() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let path = history();
    let run = mesh(ELEMENTS).follow(&path)?;
    let mut memory: Memory<f64> = Memory::new();
    let (mut curve, mut exact) = (Vec::new(), Vec::new());
    let mut last = path[0];
    for shift in &path {
        for between in steps(last, *shift, 10) {
            curve.push((between.xi, memory.advance(1.0, between.xi / SLIDING)?));
        }
        exact.push(memory.force());
        last = *shift;
    }
    let points: Vec<(f64, f64)> =
        path.iter().zip(&run).map(|(s, step)| (s.xi, step.load.f_x / step.load.f_z)).collect();
    let mut panel = Panel::new("ξ in mm", "F_x/(f F_z)");
    panel.add(Series::line("Mindlin", curve));
    panel.add(Series::markers("numerical", Marker::Circle, points.iter().copied()));
    figure.panel(panel);
    let source = "closed form of Cattaneo and Mindlin, which takes the stress to point along x";
    let pairs = points.iter().map(|point| point.1).zip(exact);
    figure.all_close("the loop is nearly Mindlin's", pairs, Absolute(0.0055)).source(source);
    let across = run.iter().map(|step| (step.load.f_y / step.load.f_z).abs()).fold(0.0, f64::max);
    figure.at_most("no force along y", across, 1e-8).source("symmetry");
    Ok(figure)
}

fn at(step: &Step, x: f64, y: f64) -> Result<Touching, Failure> {
    let near = step.touching().find(|cell| (cell.x - x).hypot(cell.y - y) < 1e-9);
    near.ok_or_else(|| "no element at this place".into())
}

pub(super) fn stress() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let mesh = mesh(ELEMENTS);
    let run = mesh.follow(&history()[..16])?;
    let peak = mesh.hertz()?.at_approach(APPROACH)?.pressure(0.0, 0.0);
    let mut angles = Panel::new("r/a", angle_axis());
    let mut sizes = Panel::new("r/a", "|t|/(f p₀)");
    let sector = |cell: &Touching| cell.x > 0.0 && cell.y > 0.0;
    for (colour, number) in [6, 8, 10, 12, 14, 16].into_iter().enumerate() {
        let of = |value: &dyn Fn(&Touching) -> f64| -> Vec<(f64, f64)> {
            let cells = run[number - 1].touching().filter(sector);
            cells.map(|cell| (cell.x.hypot(cell.y), value(&cell))).collect()
        };
        let name = format!("step {number}");
        angles
            .add(Series::markers(name.clone(), Marker::Dot, of(&Touching::angle)).coloured(colour));
        sizes.add(
            Series::markers(name, Marker::Dot, of(&|cell| cell.size() / peak)).coloured(colour),
        );
    }
    figure.panel(angles);
    figure.panel(sizes);
    for (number, angle, tolerance) in ANGLES {
        let measured = at(&run[number - 1], 0.475, 0.475)?.angle();
        let statement = format!("step {number}: angle at (0.475, 0.475), which turns by 180°");
        figure.close(statement, measured, angle, Absolute(tolerance)).source(INDEPENDENT);
    }
    // On the axes symmetry keeps it along x: cells beside them turn little.
    let beside = run[9].touching().filter(|cell| cell.y.abs() < 0.03 && cell.size() > 0.05 * peak);
    let turned = beside.map(|cell| cell.traction[1].abs() / cell.size()).fold(0.0, f64::max);
    figure.at_most("beside the x-axis it hardly turns", turned, 0.15).source("symmetry");
    let circle: Vec<f64> = run[9]
        .touching()
        .filter(|cell| (cell.x.hypot(cell.y) - 0.67).abs() < 0.03)
        .map(|cell| cell.angle().abs())
        .collect();
    let spread = circle.iter().copied().fold(0.0, f64::max)
        - circle.iter().copied().fold(f64::INFINITY, f64::min);
    figure
        .at_least("in step 10 the angle is not constant on circles", spread, 30.0)
        .source("the thesis, below fig. 14.3");
    Ok(figure)
}
