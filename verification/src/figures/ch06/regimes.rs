//! Figs. 6.13 and 6.14: which regime a step leads to.

use super::path::led;
use crate::{Axis, Claim, Figure, FigureResult, Marker, Panel, Series, linspace};
use carom_laws::memory::ScalarMemory;

/// What a step does, by the number of slip rings it leaves.
fn level(memory: &ScalarMemory) -> f64 {
    use carom_laws::memory::Regime;
    match memory.regime() {
        Regime::Adhesion => 0.0,
        _ => memory.decrease() as f64,
    }
}

/// Draws the level against the shift, and claims that it is `expected` at every point that is not
/// on a border.
fn bar(
    figure: &mut Figure,
    title: &str,
    before: &[(f64, f64)],
    zeta: f64,
    range: [f64; 2],
    expected: impl Fn(f64) -> Option<f64>,
) -> Result<(), carom_special::RangeError> {
    let state = led(before)?;
    let mut points = Vec::new();
    let (mut wrong, mut tested) = (0_u32, 0_u32);
    for x in linspace(range[0], range[1], 401) {
        let mut memory = state.clone();
        memory.advance(zeta, x)?;
        points.push((x, level(&memory)));
        if let Some(want) = expected(x) {
            tested += 1;
            wrong += u32::from(want != level(&memory));
        }
    }
    let mut panel = Panel::new(
        Axis::linear("ξ/(f κ)"),
        Axis::linear("slip rings, 0: adhesion").between(-0.5, 4.5),
    )
    .titled(title);
    panel.add(Series::markers("regime", Marker::Circle, points));
    figure.panel(panel);
    figure.claim(
        Claim::holds(
            format!("{title}: the regime at {tested} shifts"),
            wrong == 0 && tested > 350,
            f64::from(wrong),
        )
        .source("conditions (6.43) to (6.51)"),
    );
    Ok(())
}

fn near(x: f64, borders: &[f64]) -> bool {
    borders.iter().any(|border| (x - border).abs() < 1e-9)
}

pub(super) fn draw_second() -> FigureResult {
    let mut figure = Figure::new();
    let (x_1, dz) = (0.5, 0.1);
    figure.assumed("ξ₁/(f κ), dζ", "0.5 at ζ = 1; ± 0.1");
    let before = [(1.0, 0.0), (1.0, x_1)];
    // Left of -xi_1 - dz the opposite first decrease; P_1 up to xi_1 - dz; then adhesion.
    let up = |x: f64| {
        let borders = [-x_1 - dz, x_1 - dz, x_1 + dz, 1.1, -1.1];
        if near(x, &borders) || x.abs() > 1.1 {
            None
        } else if x < borders[0] {
            Some(1.0)
        } else if x < borders[1] {
            Some(2.0)
        } else if x < borders[2] {
            Some(0.0)
        } else {
            Some(1.0)
        }
    };
    bar(&mut figure, "a) dζ > 0", &before, 1.0 + dz, [-1.05, 1.05], up)?;
    let down = |x: f64| {
        let borders = [-x_1 + dz, x_1 - dz];
        if near(x, &borders) || x.abs() > 0.9 {
            None
        } else {
            Some(if x > borders[0] && x < borders[1] { 2.0 } else { 1.0 })
        }
    };
    bar(&mut figure, "b) dζ < 0", &before, 1.0 - dz, [-0.85, 0.85], down)?;
    Ok(figure)
}

pub(super) fn draw_nth() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("path (ζ, ξ/(f κ))", "(1, 0), (1, 0.8), (1.05, 0.3); then dζ₃ = ± 0.04");
    let before = [(1.0, 0.0), (1.0, 0.8), (1.05, 0.3)];
    // After a second decrease: adhesion within dz_3, third decrease up to
    // |dxi_2| + dz_2 + dz_3, then the first one again (N - 2).
    let case = |dz: f64| {
        move |x: f64| {
            let step = x - 0.3;
            let wipe = 0.5 + 0.05 + dz;
            if near(step, &[dz.abs(), -dz.abs(), wipe]) {
                None
            } else if step.abs() < dz {
                Some(0.0)
            } else if step < dz.abs() {
                Some(2.0)
            } else if step < wipe {
                Some(3.0)
            } else {
                Some(1.0)
            }
        }
    };
    bar(&mut figure, "a) dζ > 0", &before, 1.09, [-0.2, 1.05], case(0.04))?;
    bar(&mut figure, "b) dζ < 0", &before, 1.01, [-0.1, 0.98], case(-0.04))?;
    Ok(figure)
}
