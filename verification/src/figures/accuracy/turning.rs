//! Coulomb's law where the shift turns: the three laws on a circle and on other paths.

use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::{Nodes as _, VectorMemory};
use carom_laws::sliders::SliderLaw;
use carom_special::quadrature::{self, adaptive};

use super::{turning_grid, turning_impacts as impacts};
use crate::{Axis, Cell, Failure, Figure, FigureResult, Panel, Series, Table};

/// The radius of the circle, the approach being 1, and the steps of a turn.
const RADIUS: f64 = 0.5;
const TURN: usize = 240;
const TURNS: usize = 12;
const SLIDERS: usize = 1500;
const TOLERANCES: [f64; 5] = [3e-2, 1e-2, 1e-3, 1e-4, 1e-5];

type Path = Vec<(f64, [f64; 2])>;

/// The force over its limit, outwards and along the circle.
fn about(force: [f64; 2], x: [f64; 2]) -> [f64; 2] {
    let size = libm::hypot(x[0], x[1]);
    let outwards = (force[0] * x[0] + force[1] * x[1]) / size;
    let along = (force[1] * x[0] - force[0] * x[1]) / size;
    [outwards, along]
}

/// A path from the centre outwards and then around the circle.
fn circle() -> Path {
    let mut path = vec![(1.0, [0.0; 2])];
    path.extend((0..=TURN * TURNS).map(|step| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * step as f64 / TURN as f64);
        (1.0, [RADIUS * cos, RADIUS * sin])
    }));
    path
}

/// The steady force. An annulus with friction limit r below the radius R follows on the circle of radius
/// sqrt(R^2 - r^2), to which its elastic shift is tangent; an annulus with a larger limit stays at the
/// centre.
fn steady() -> Result<[f64; 2], Failure> {
    let edge = libm::sqrt(1.0 - RADIUS);
    let tolerance = quadrature::Tolerance::relative(1e-11)?;
    let limit = |t: f64| 1.0 - t * t;
    let outwards = adaptive(edge, 1.0, tolerance, |t| 1.5 * limit(t) * limit(t) / RADIUS)?.value;
    let along = |t: f64| {
        let part = (limit(t) / RADIUS).min(1.0);
        1.5 * limit(t) * libm::sqrt((1.0 - part) * (1.0 + part))
    };
    Ok([outwards + 1.5 * RADIUS * edge, adaptive(edge, 1.0, tolerance, along)?.value])
}

/// The path of a collision of two bodies whose shift turns irregularly.
fn collision() -> Path {
    (1..80)
        .map(|i| {
            let t = std::f64::consts::PI * f64::from(i) / 80.0;
            let x = 0.9 * libm::sin(1.3 * t + 0.4) + 0.3 * libm::cos(3.1 * t);
            let y = 0.8 * libm::cos(1.7 * t) + 0.2 * libm::sin(2.7 * t);
            (libm::sin(t), [x, y])
        })
        .collect()
}

/// A square with sharp corners.
fn corners() -> Path {
    let corner = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.4], [0.0, 0.4]];
    (0..=96)
        .map(|i| {
            let (leg, way) = (i / 6, (i % 6) as f64 / 6.0);
            let (from, to) = (corner[leg % 4], corner[(leg + 1) % 4]);
            (1.0, [0, 1].map(|k| from[k] + way * (to[k] - from[k])))
        })
        .collect()
}

fn off(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

/// The forces on a path, and the mean number of stored vertices.
fn follow(path: &Path, tolerance: f64) -> Result<(Vec<[f64; 2]>, f64), Failure> {
    let mut law = CoulombMemory::<[f64; 2]>::new(Tolerance::new(tolerance)?);
    let (mut forces, mut vertices) = (Vec::with_capacity(path.len()), 0);
    for &(zeta, x) in path {
        forces.push(law.advance(zeta, x)?);
        vertices += law.stack().len();
    }
    Ok((forces, vertices as f64 / path.len() as f64))
}

fn sliders(path: &Path) -> Result<Vec<[f64; 2]>, Failure> {
    let mut law = SliderLaw::new(SLIDERS, 1.0, 1.0)?;
    Ok(path.iter().map(|&(zeta, x)| law.advance(zeta, x)).collect::<Result<_, _>>()?)
}

fn chapter_7(path: &Path) -> Result<Vec<[f64; 2]>, Failure> {
    let mut law = VectorMemory::new();
    Ok(path.iter().map(|&(zeta, x)| law.advance(zeta, x)).collect::<Result<_, _>>()?)
}

fn largest(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    a.iter().zip(b).map(|(a, b)| off(*a, *b)).fold(0.0, f64::max)
}

/// The largest ratio of the stiffness to that without slip, at constant approach.
fn jump(path: &Path, forces: &[[f64; 2]]) -> f64 {
    let steps = path.windows(2).zip(forces.windows(2));
    steps
        .filter(|(at, _)| at[0].0 == at[1].0 && off(at[0].1, at[1].1) > 0.0)
        .map(|(at, f)| off(f[0], f[1]) / (1.5 * at[1].0.sqrt() * off(at[0].1, at[1].1)))
        .fold(0.0, f64::max)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("circle", "ζ = 1, |X| = 1/2, 240 steps a turn, 12 turns");
    figure.assumed("square", "ζ = 1, sides of 0.4 in 6 steps, 4 rounds");
    figure.assumed("collision", "ζ = sin t, X a curve of sines");
    steady_claims(&mut figure)?;
    let paths = [("circle", circle()), ("square", corners()), ("collision", collision())];
    let mut panel = Panel::new(Axis::log("tolerance"), Axis::log("largest error / limit"));
    let mut table = Table::new(
        "Errors against 1500 sliders, over the limit at ζ = 1",
        ["path", "law", "largest error", "vertices", "dΦ/(no slip)"],
    );
    for (name, path) in &paths {
        let want = sliders(path)?;
        let old = chapter_7(path)?;
        let missed = largest(&old, &want);
        let old_jump = jump(path, &old);
        table.row([
            Cell::from(*name),
            "chapter 7".into(),
            missed.into(),
            "-".into(),
            old_jump.into(),
        ]);
        figure
            .at_least(format!("{name}: chapter 7 misses by"), missed, 0.02)
            .source("sliders, each dragged by itself");
        let mut errors = Vec::new();
        for tolerance in TOLERANCES {
            let (forces, vertices) = follow(path, tolerance)?;
            let (error, stiff) = (largest(&forces, &want), jump(path, &forces));
            let law = format!("Coulomb, {tolerance:e}");
            table.row([
                Cell::from(*name),
                law.into(),
                Cell::Remark(format!("{error:.1e}")),
                Cell::Remark(format!("{vertices:.1}")),
                Cell::Remark(format!("{stiff:.3}")),
            ]);
            figure
                .at_most(format!("{name}: error at {tolerance:e}"), error, tolerance.max(5e-5))
                .source("sliders, each dragged by itself");
            figure
                .at_most(format!("{name}: stiffness at {tolerance:e}"), stiff, 1.0 + tolerance)
                .source("no contact is stiffer than one that sticks");
            errors.push((tolerance, error));
        }
        panel.add(Series::line(*name, errors));
    }
    figure.panel(panel);
    figure.table(table);
    impacts::add(&mut figure)?;
    turning_grid::add(&mut figure)?;
    Ok(figure)
}

/// The circle: three laws on it, and their steady forces.
fn steady_claims(figure: &mut Figure) -> Result<(), Failure> {
    let path = circle();
    let (fine, _) = follow(&path, 1e-5)?;
    let laws = [("chapter 7", chapter_7(&path)?), ("sliders", sliders(&path)?), ("Coulomb", fine)];
    let expected = steady()?;
    let last = path.len() - 1;
    let mut panel = Panel::new("turns", "Φ/ζ^1.5 along the circle");
    for (i, (name, forces)) in laws.iter().enumerate() {
        let curve: Vec<_> = (1..=3 * TURN)
            .map(|step| ((step - 1) as f64 / TURN as f64, about(forces[step], path[step].1)[1]))
            .collect();
        panel.add(Series::line(*name, curve).coloured(i));
    }
    panel.add(Series::dashed("steady", [(0.0, expected[1]), (3.0, expected[1])]).coloured(3));
    figure.panel(panel);
    let [outwards, along] = about(laws[2].1[last], path[last].1);
    let tolerance = crate::Absolute(1e-3);
    figure
        .close("circle: force outwards", outwards, expected[0], tolerance)
        .source("closed form: steady tractrices of a circle");
    figure
        .close("circle: force along", along, expected[1], tolerance)
        .source("closed form: steady tractrices of a circle");
    Ok(())
}
