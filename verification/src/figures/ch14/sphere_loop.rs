//! Figs. 14.1, 14.2: two spheres pressed together, shifted to sliding, back, and forth again.

use super::super::mesh::{APPROACH, Mesh, Step, steps};
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;
use carom_laws::memory::Memory;

/// Pressed in one step; shifted to zeta, to -zeta, to zeta and to -zeta along x.
pub(super) fn history() -> Vec<Shift> {
    let at = |part: f64| Shift { zeta: APPROACH, xi: part * APPROACH, ..Shift::default() };
    let mut path = vec![at(0.0)];
    for (from, to, count) in [(0.0, 1.0, 5), (1.0, -1.0, 10), (-1.0, 1.0, 10), (1.0, -1.0, 10)] {
        path.extend(steps(at(from), at(to), count));
    }
    path
}

/// F_x/(f F_z) of Cattaneo and Mindlin at the end of each step; for nu = 0 sliding begins at
/// xi = f zeta.
fn closed_form(history: &[Shift]) -> Result<Vec<f64>, Failure> {
    let mut memory: Memory<f64> = Memory::new();
    let forces = history.iter().map(|shift| memory.advance(1.0, shift.xi / APPROACH));
    Ok(forces.collect::<Result<_, _>>()?)
}

pub(super) fn inputs(figure: &mut Figure, elements: usize) {
    figure.stated("ν, f", "0, 1; 36 steps");
    figure.derived("steps", "1 to press, then 5, 10, 10, 10 along x: sliding at both ends");
    figure.assumed("a = b, ζ, G", "1 mm, 0.1 mm, 82 000 N/mm²");
    figure.assumed(
        "elements",
        format!("{elements} × {elements} on the square about the contact (25 in the thesis)"),
    );
}

/// Normalised forces along x.
fn forces(all: &[Step]) -> Vec<f64> {
    all.iter().map(|step| step.load.f_x / step.load.f_z).collect()
}

pub(super) fn forces_by_step() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure, 20);
    let path = history();
    let exact = closed_form(&path)?;
    let runs = [6, 20, 40].map(|n| Mesh::of([1.0; 2], [n, n]).follow(&path));
    let [coarse, middle, fine] = runs;
    let (coarse, middle, fine) = (forces(&coarse?), forces(&middle?), forces(&fine?));
    let by_step = |values: &[f64]| {
        values.iter().enumerate().map(|(i, v)| ((i + 1) as f64, *v)).collect::<Vec<_>>()
    };
    let mut panel = Panel::new("step", "F_x/(f F_z), ξ/(f ζ)");
    panel.add(Series::line("F_x, Mindlin", by_step(&exact)));
    panel.add(Series::markers("F_x, 20 × 20", Marker::Circle, by_step(&middle)).coloured(0));
    let shifts: Vec<f64> = path.iter().map(|shift| shift.xi / APPROACH).collect();
    panel.add(Series::dashed("ξ", by_step(&shifts)));
    figure.panel(panel);
    let worst =
        |values: &[f64]| values.iter().zip(&exact).map(|(v, e)| (v - e).abs()).fold(0.0, f64::max);
    let reference = "closed form of Cattaneo and Mindlin";
    for (name, values, bound) in
        [("6 × 6", &coarse, 0.022), ("20 × 20", &middle, 0.0015), ("40 × 40", &fine, 3e-4)]
    {
        figure
            .at_most(
                format!("with {name} elements the force is as close as it should be"),
                worst(values),
                bound,
            )
            .source(reference);
    }
    figure
        .at_least(
            "halving the elements twice over takes most of the error",
            worst(&coarse) / worst(&middle),
            5.0,
        )
        .source(reference);
    let ends = [5, 15, 25, 35].map(|i| (middle[i].abs(), 1.0));
    figure
        .all_close("it slides where the direction turns", ends, Absolute(1e-7))
        .source("Coulomb's law");
    Ok(figure)
}

pub(super) fn loop_of_force() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure, 20);
    let path = history();
    let run = Mesh::of([1.0; 2], [20, 20]).follow(&path)?;
    let values = forces(&run);
    // The closed form between the steps too.
    let mut memory: Memory<f64> = Memory::new();
    let mut curve = Vec::new();
    let mut last = Shift { zeta: APPROACH, ..Shift::default() };
    for shift in &path {
        for between in steps(last, *shift, 10) {
            let x = between.xi / APPROACH;
            curve.push((x, memory.advance(1.0, x)?));
        }
        last = *shift;
    }
    let mut panel = Panel::new("ξ/(f ζ)", "F_x/(f F_z)");
    panel.add(Series::line("Mindlin", curve));
    let points = path.iter().zip(&values).map(|(shift, v)| (shift.xi / APPROACH, *v));
    panel.add(Series::markers("20 × 20 elements", Marker::Circle, points));
    figure.panel(panel);
    let exact = closed_form(&path)?;
    let pairs = values.iter().copied().zip(exact);
    figure
        .all_close("the loop is Mindlin's", pairs, Absolute(1.5e-3))
        .source("closed form of Cattaneo and Mindlin");
    let closes = (values[15] - values[35]).abs();
    figure.at_most("the loop closes", closes, 1e-7).source("sliding forgets what was before");
    // (6.9): on the way back F = 1 - 2 [1 - (1 - s/2)^(3/2)], s = 1 - xi/(f zeta).
    let back = (5..=15).map(|i| {
        let s = 1.0 - path[i].xi / APPROACH;
        (values[i], 1.0 - 2.0 * (1.0 - (1.0 - 0.5 * s).powf(1.5)))
    });
    figure
        .all_close("unloading is twice as soft", back, Absolute(1.5e-3))
        .source("Masing's rule on (6.9)");
    Ok(figure)
}
