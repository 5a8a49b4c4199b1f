//! Fig. 14.3: tangential stress on a sphere that slips back.

use super::super::mesh::{Mesh, Step};
use super::angle_axis;
use super::sphere_loop::{history, inputs};
use crate::{Absolute, Figure, FigureResult, Marker, Panel, Series};

/// Steps shown: full sliding, and every second one on the way back.
const STEPS: [usize; 6] = [6, 8, 10, 12, 14, 16];
const ELEMENTS: usize = 30;

/// t_x/(f p_0) of Mindlin on the way back, where a* is the radius inside which nothing slipped back:
/// f p outside with the sign of the new slip, inside 2 (a*/a) sqrt(1 - (r/a*)^2) more.
fn mindlin(r: f64, stick: f64) -> f64 {
    let root = |x: f64| x.max(0.0).sqrt();
    -root(1.0 - r * r) + if stick > 0.0 { 2.0 * root(stick * stick - r * r) } else { 0.0 }
}

/// The stick radius of a step: zeta* = zeta (1 - s/2), s the way back over f zeta.
fn stick_radius(step: usize) -> f64 {
    (1.0 - 0.1 * (step as f64 - 6.0)).max(0.0).sqrt()
}

fn sizes(step: &Step, peak: f64) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> =
        step.touching().map(|cell| (cell.x.hypot(cell.y), cell.size() / peak)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure, ELEMENTS);
    let mesh = Mesh::of([1.0; 2], [ELEMENTS; 2]);
    let run = mesh.follow(&history()[..16])?;
    let peak = mesh.hertz()?.at_approach(super::super::mesh::APPROACH)?.pressure(0.0, 0.0);
    let mut angles = Panel::new("r/a", angle_axis());
    let mut sizes_panel = Panel::new("r/a", "|t|/(f p₀)");
    let radii: Vec<f64> = (0..=100).map(|i| f64::from(i) / 100.0).collect();
    for (colour, number) in STEPS.into_iter().enumerate() {
        let (step, stick) = (&run[number - 1], stick_radius(number));
        let name = format!("step {number}");
        let exact = radii.iter().map(|r| (*r, mindlin(*r, stick).abs()));
        sizes_panel.add(Series::line(name.clone(), exact).coloured(colour));
        let points = sizes(step, peak);
        sizes_panel.add(Series::markers("", Marker::Dot, points).coloured(colour));
        let points = step.touching().map(|cell| (cell.x.hypot(cell.y), cell.angle().abs()));
        angles.add(Series::markers(name, Marker::Dot, points).coloured(colour));
    }
    figure.panel(angles);
    figure.panel(sizes_panel);
    let worst_error = |number: usize| {
        let (step, stick) = (&run[number - 1], stick_radius(number));
        let cell = 2.0 / ELEMENTS as f64;
        let away = step.touching().filter(|cell_at| {
            let r = cell_at.x.hypot(cell_at.y);
            // The slope jumps at the border of the stick area and is infinite at the rim.
            r < 0.9 && (r - stick).abs() > 1.5 * cell
        });
        away.map(|at| (at.traction[0] / peak - mindlin(at.x.hypot(at.y), stick)).abs())
            .fold(0.0, f64::max)
    };
    let source = "closed form of Cattaneo and Mindlin";
    let worst = STEPS.map(worst_error).into_iter().fold(0.0, f64::max);
    figure.at_most("away from borders the stress is Mindlin's", worst, 0.02).source(source);
    let sticks = [8, 10, 12, 14].map(|n| (run[n - 1].stick(), stick_radius(n).powi(2)));
    figure.all_close("part of the contact that sticks", sticks, Absolute(0.02)).source(source);
    figure
        .at_most("nothing sticks in steps 6 and 16", run[5].stick() + run[15].stick(), 0.0)
        .source(source);
    let across = STEPS
        .iter()
        .flat_map(|n| run[n - 1].touching())
        .map(|cell| (cell.traction[1] / peak).abs())
        .fold(0.0, f64::max);
    figure
        .at_most("for ν = 0 the stress points along x", across, 1e-8)
        .source("without ν the displacements along x and y are uncoupled (4.14)");
    let limit = run[15].touching().map(|cell| (cell.size() / cell.pressure, 1.0));
    figure.all_close("in step 16 all slips at f p", limit, Absolute(1e-9)).source("Coulomb's law");
    Ok(figure)
}
