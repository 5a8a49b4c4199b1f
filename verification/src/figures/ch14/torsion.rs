//! Figs. 14.22 to 14.24: torque and stick area of ellipses that are twisted.

use super::super::mesh::{APPROACH, Mesh, Step, steps};
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;
use carom_laws::torsion::adhesion::sliding_torque_arm;
use carom_laws::torsion::ellipse::EllipseTorsion;

const INDEPENDENT: &str = "an independent half-space program";

fn twisted(degrees: f64) -> Shift {
    Shift { zeta: APPROACH, omega: degrees.to_radians(), ..Shift::default() }
}

/// Pressed in one step, twisted by `degrees` in each of ten.
fn history(degrees: f64) -> Vec<Shift> {
    let mut path = vec![twisted(0.0)];
    path.extend(steps(twisted(0.0), twisted(10.0 * degrees), 10));
    path
}

/// (7.65), (7.66) at the twists of a history, over the torque of sliding.
fn law(mesh: &Mesh, path: &[Shift]) -> Result<Vec<f64>, Failure> {
    let force = mesh.hertz()?.force(APPROACH);
    let mut law = EllipseTorsion::of_contact(mesh.ellipse()?, mesh.materials()?, force)?;
    let sliding = law.sliding_torque();
    path.iter().map(|shift| Ok(law.advance(shift.omega)? / sliding)).collect()
}

/// Torques over (3/8) f F_z b E with Hertz's F_z, which dissimilar bodies exceed a little.
fn torques(mesh: &Mesh, run: &[Step]) -> Result<Vec<f64>, Failure> {
    let sliding = sliding_torque_arm(&mesh.ellipse()?) * mesh.hertz()?.force(APPROACH);
    Ok(run.iter().map(|step| step.load.m_z / sliding).collect())
}

fn distance(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

pub(super) fn torque() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a/b", "1 and 10; 50 and 400 elements");
    figure.assumed("f, Δβ", "1; 1.6° (circle) and 0.2° (a/b = 10), 10 steps");
    figure.assumed("ν₁, ν₂", "0, 0 and 0, 0.5, equal G");
    figure.assumed("elements", "40 × 40 and 60 × 30; 12 × 5 for the coarse one");
    let mut panel = Panel::new("β M_zA′/M_zS", "M_z/M_zS");
    // The axes, twist a step, elements, and what (7.65) misses for similar and dissimilar bodies.
    let cases = [
        ("a/b = 1", [1.0, 1.0], 1.6, [40, 40], [0.028, 0.053]),
        ("a/b = 10", [10.0, 1.0], 0.2, [60, 30], [0.021, 0.064]),
    ];
    for (colour, (name, axes, degrees, elements, misses)) in cases.into_iter().enumerate() {
        let path = history(degrees);
        for ((poisson, miss), marker) in
            [[0.0, 0.0], [0.0, 0.5]].into_iter().zip(misses).zip([Marker::Circle, Marker::Cross])
        {
            let mesh = Mesh { poisson, ..Mesh::of(axes, elements) };
            let (theory, run) = (law(&mesh, &path)?, mesh.follow(&path)?);
            let found = torques(&mesh, &run)?;
            let force = mesh.hertz()?.force(APPROACH);
            let own = EllipseTorsion::of_contact(mesh.ellipse()?, mesh.materials()?, force)?;
            let unit = own.initial_stiffness() / own.sliding_torque();
            let points = |values: &[f64]| -> Vec<(f64, f64)> {
                path.iter().zip(values).map(|(shift, m)| (unit * shift.omega, *m)).collect()
            };
            let kind = if poisson[1] == 0.0 { "similar" } else { "dissimilar" };
            if poisson[1] == 0.0 {
                panel
                    .add(Series::line(format!("(7.65), {name}"), points(&theory)).coloured(colour));
            }
            panel.add(
                Series::markers(format!("{name}, {kind}"), marker, points(&found)).coloured(colour),
            );
            figure
                .close(
                    format!("what (7.65) misses at most: {name}, {kind}"),
                    distance(&theory, &found),
                    miss,
                    Absolute(0.001),
                )
                .source(INDEPENDENT);
        }
    }
    figure.panel(panel);
    let path = history(0.2);
    let coarse = Mesh::of([10.0, 1.0], [12, 5]);
    let fine = Mesh::of([10.0, 1.0], [40, 20]);
    let coarse = torques(&coarse, &coarse.follow(&path)?)?;
    let fine = torques(&fine, &fine.follow(&path)?)?;
    figure
        .at_most("about 50 elements do nearly as well as 600", distance(&coarse, &fine), 0.02)
        .source("the thesis, below fig. 14.21; an independent program: 0.016");
    Ok(figure)
}

/// Parts that stick after steps 1 to 11 with 60 x 30 elements, by an independent program.
const STICK: [f64; 11] =
    [1.0, 0.719, 0.521, 0.382, 0.276, 0.209, 0.162, 0.120, 0.092, 0.070, 0.056];

pub(super) fn contours() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a/b, Δβ", "10, 0.2°");
    figure.assumed("f, ν", "1, 0");
    figure.assumed("elements", "60 × 30 (40 × 20 in the thesis)");
    let mesh = Mesh::of([10.0, 1.0], [60, 30]);
    let run = mesh.follow(&history(0.2))?;
    let mut panel = Panel::new("x", "y");
    for (i, step) in run.iter().enumerate().take(8) {
        panel.add(Series::line(format!("β = {:.1}°", 0.2 * i as f64), step.stick_outline()));
    }
    figure.panel(panel);
    let pairs = run.iter().map(Step::stick).zip(STICK);
    figure.all_close("parts that stick", pairs, Absolute(1.5e-3)).source(INDEPENDENT);
    let offset = run[1..8].iter().map(|step| {
        let [x, y] = step.stick_centre();
        x.abs() / 10.0 + y.abs()
    });
    figure
        .at_most("the stick area stays in the middle", offset.fold(0.0, f64::max), 1e-9)
        .source("symmetry");
    Ok(figure)
}

pub(super) fn varying() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a/b, ν", "1/10, 0");
    figure.assumed("amplitude", "1° in 5 + 10 + 10 steps; a = 1, b = 10, f = 1");
    figure.assumed("elements", "20 × 40");
    let mesh = Mesh::of([1.0, 10.0], [20, 40]);
    let mut path = vec![twisted(0.0)];
    for (from, to, count) in [(0.0, 1.0, 5), (1.0, -1.0, 10), (-1.0, 1.0, 10)] {
        path.extend(steps(twisted(from), twisted(to), count));
    }
    let run = mesh.follow(&path)?;
    let (found, theory) = (torques(&mesh, &run)?, law(&mesh, &path)?);
    let points = |values: &[f64]| -> Vec<(f64, f64)> {
        path.iter().zip(values).map(|(shift, m)| (shift.omega.to_degrees(), *m)).collect()
    };
    let mut panel = Panel::new("β in degrees", "M_z/M_zS");
    panel.add(Series::dashed("(7.66)", points(&theory)));
    panel.add(Series::markers("numerical", Marker::Circle, points(&found)).coloured(0));
    figure.panel(panel);
    figure
        .close("what (7.66) misses at most", distance(&theory, &found), 0.022, Absolute(0.003))
        .source(INDEPENDENT);
    figure.at_most("the loop closes", (found[5] - found[25]).abs(), 1e-3).source(INDEPENDENT);
    let opposite = (1..=10).map(|i| (found[15 + i] - found[15], found[5] - found[5 + i]));
    figure
        .all_close("the way there is the way back, reversed", opposite, Absolute(2e-3))
        .source("Masing's rule");
    Ok(figure)
}
