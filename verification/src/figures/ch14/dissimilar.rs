//! Figs. 14.15, 14.16: dissimilar bodies pressed together and released.

use super::super::mesh::{APPROACH, Mesh, Step, Touching, steps};
use super::angle_axis;
use crate::{Absolute, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;

const INDEPENDENT: &str = "an independent half-space program";

fn mesh() -> Mesh {
    Mesh { poisson: [0.0, 0.5], friction: 0.1, ..Mesh::of([4.0, 1.0], [64, 16]) }
}

fn inputs(figure: &mut Figure) {
    figure.stated("ν₁, ν₂, f, a/b, Δζ", "0, 0.5, 0.1, 4, 0.01; 10 steps");
    figure.assumed("a, b", "4 and 1; then 9 steps of unloading");
    figure.assumed("elements", "64 × 16 (40 × 10 in the thesis)");
}

/// Ten steps of loading, nine of unloading.
fn history() -> Vec<Shift> {
    let at = |zeta| Shift { zeta, ..Shift::default() };
    let mut path: Vec<Shift> = steps(at(0.0), at(APPROACH), 10).collect();
    path.extend(steps(at(APPROACH), at(0.1 * APPROACH), 9));
    path
}

/// (14.1) with normalised coordinates: the angle of `(x/a, k y/b)`, in degrees.
pub(super) fn law_angle(cell: &Touching, [a, b]: [f64; 2], k: f64) -> f64 {
    (k * cell.y / b).atan2(cell.x / a).to_degrees()
}

/// Root mean square of the difference of two directions along one line, in degrees.
pub(super) fn misfit(step: &Step, axes: [f64; 2], k: f64) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for cell in step.touching().filter(|cell| cell.x.hypot(cell.y) > 0.0) {
        let turn = cell.angle() - law_angle(&cell, axes, k);
        let turn = turn - 180.0 * (turn / 180.0).round();
        sum += turn * turn;
        count += 1.0;
    }
    f64::sqrt(sum / count)
}

fn best(step: &Step, axes: [f64; 2]) -> f64 {
    let grid = crate::linspace(1.0, 3.0, 401);
    grid.into_iter()
        .min_by(|a, b| misfit(step, axes, *a).total_cmp(&misfit(step, axes, *b)))
        .unwrap_or_default()
}

pub(super) fn angle() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let mesh = mesh();
    let run = mesh.follow(&history()[..10])?;
    let last = &run[9];
    let quarter = |cell: &Touching| cell.x > 0.0 && cell.y > 0.0;
    // The traction on body 1 points inwards or outwards: only its line is compared.
    let points = last.touching().filter(quarter).map(|cell| {
        let angle = cell.angle();
        (law_angle(&cell, mesh.semi_axes, 1.0), angle - 180.0 * (angle / 180.0).floor())
    });
    let mut panel = Panel::new("angle of (x/a, y/b) in degrees", angle_axis());
    panel.add(Series::markers("numerical, step 10", Marker::Dot, points.collect::<Vec<_>>()));
    let line = (0..=90).map(|degrees| {
        let angle = f64::from(degrees).to_radians();
        (f64::from(degrees), (2.0 * angle.sin()).atan2(angle.cos()).to_degrees())
    });
    panel.add(Series::line("(14.1), k = 2", line));
    figure.panel(panel);
    figure
        .close("the best k of (14.1)", best(last, mesh.semi_axes), 1.92, Absolute(0.06))
        .source(INDEPENDENT);
    figure
        .at_most(
            "root mean square of what k = 2 misses, in degrees",
            misfit(last, mesh.semi_axes, 2.0),
            3.2,
        )
        .source(INDEPENDENT);
    figure
        .at_least(
            "with y/x in place of (y/b)/(x/a) it misses, in degrees",
            misfit(last, [1.0, 1.0], 2.0),
            15.0,
        )
        .source("(14.1) as printed");
    figure.deviation(
        "σ_zy/σ_zx = 2 y/x",
        "σ_zy/σ_zx = k (y/b)/(x/a), k = 1.92",
        "the coordinates of (14.1) must be those over the semi-axes",
    );
    Ok(figure)
}

pub(super) fn size() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let mesh = mesh();
    let run = mesh.follow(&history())?;
    let hertz = mesh.hertz()?;
    let peak = hertz.at_approach(APPROACH)?.pressure(0.0, 0.0);
    let [a, b] = mesh.semi_axes;
    let mut panel = Panel::new("√(x²/a² + y²/b²)", "|t|/(f p₀)");
    for (colour, number) in [4, 10, 11, 13].into_iter().enumerate() {
        let points = run[number - 1]
            .touching()
            .map(|cell| ((cell.x / a).hypot(cell.y / b), cell.size() / (0.1 * peak)));
        panel.add(Series::markers(format!("step {number}"), Marker::Dot, points).coloured(colour));
    }
    figure.panel(panel);
    figure.panel(run[12].stick_map("stick and slip in step 13")?);
    let loading = run[..10].iter().map(Step::stick).fold(0.0, f64::max);
    figure.at_most("while loading all slips but the middle", loading, 0.03).source(INDEPENDENT);
    let released = run[10..13].iter().map(|step| (step.stick(), 0.44));
    figure
        .all_close("from the first unloading step a ring sticks", released, Absolute(0.03))
        .source(INDEPENDENT);
    let ring = |step: &Step| {
        let cells: Vec<f64> = step
            .touching()
            .filter(|cell| cell.sticks)
            .map(|cell| (cell.x / a).hypot(cell.y / b))
            .collect();
        cells.iter().sum::<f64>() / cells.len() as f64
    };
    let radii: Vec<f64> = [11, 13, 15, 17].map(|n| ring(&run[n - 1])).to_vec();
    figure.decreasing("the ring moves inwards", radii).source("Turner; section 14.2");
    let force = run[9].load.f_z / hertz.force(APPROACH);
    figure.close("F_z over Hertz's", force, 1.0075, Absolute(0.001)).source(INDEPENDENT);
    let middle = run[9].touching().map(|cell| cell.pressure).fold(0.0, f64::max) / peak;
    figure
        .close("greatest pressure over Hertz's", middle, 1.07, Absolute(0.015))
        .source(INDEPENDENT);
    Ok(figure)
}
