//! Figs. 6.1, 6.2, 6.4, 6.6, 6.7, 6.9, 6.11, 6.12: stress distributions of one direction.

use super::path::{cattaneo, led, stress, stress_panel};
use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace};

fn begin(path: &str) -> Figure {
    let mut figure = Figure::new();
    figure.assumed("path (ζ, ξ/(f κ))", path);
    figure.assumed("units", "the contact radius is 1 at ζ = 1");
    figure
}

fn circle(radius: f64) -> Vec<(f64, f64)> {
    linspace(0.0, std::f64::consts::TAU, 181)
        .into_iter()
        .map(|t| (radius * t.cos(), radius * t.sin()))
        .collect()
}

pub(super) fn draw_circles() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.5)");
    let memory = led(&[(1.0, 0.0), (1.0, 0.5)])?;
    let inner = memory.stick_radius();
    let mut panel = Panel::new(Axis::linear("x/a"), Axis::linear("y/a")).equal_aspect();
    panel.add(Series::area("A_k, stick", circle(inner)));
    panel.add(Series::line("A_i, contact", circle(1.0)));
    figure.panel(panel);
    let ring = linspace(inner, 1.0, 50);
    let pairs =
        ring.into_iter().map(|rho| (stress(&memory, rho), (1.0 - rho * rho).max(0.0).sqrt()));
    figure.claim(
        Claim::all_close("σ = f p in the ring S_i", pairs, Tolerance::Absolute(2e-8))
            .source("Coulomb's law"),
    );
    let below = linspace(0.0, inner - 1e-3, 50)
        .into_iter()
        .map(|rho| (1.0 - rho * rho).sqrt() - stress(&memory, rho))
        .fold(f64::INFINITY, f64::min);
    figure.claim(Claim::at_least("σ < f p in the circle A_k", below, 1e-3).source("stick"));
    Ok(figure)
}

pub(super) fn draw_first() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.5): ζ*/ζ = 0.5");
    let memory = led(&[(1.0, 0.0), (1.0, 0.5)])?;
    stress_panel(&mut figure, "first shift", &memory, &[(1.0, 1.0, 0.5)]);
    let edge = 0.5_f64.sqrt();
    let inside = (stress(&memory, edge) - stress(&memory, edge - 1e-9)) / 1e-9;
    figure.claim(
        Claim::at_least("break with a vertical inner slope at a₁*", inside, 1e3).source("(6.10)"),
    );
    Ok(figure)
}

pub(super) fn draw_unloading() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.6), (1, 0.2)");
    let memory = led(&[(1.0, 0.0), (1.0, 0.6), (1.0, 0.2)])?;
    // (6.20): zeta* = zeta - |xi_1 - xi|/(2 f kappa)
    stress_panel(&mut figure, "unloading", &memory, &[(1.0, 1.0, 0.4), (-2.0, 1.0, 0.8)]);
    figure.claim(
        Claim::close(
            "a*² = 1 − |ξ₁ − ξ|/(2 f κ ζ)",
            memory.stick_depth(),
            0.8,
            Tolerance::Absolute(1e-15),
        )
        .source("(6.20)"),
    );
    figure.deviation(
        "|F_x − F_x1| = −(4πμ/3)(a³ − a*³)",
        "F_x − F_x1 = −(4πμ/3)(a³ − a*³)",
        "(6.18)",
    );
    Ok(figure)
}

pub(super) fn draw_within_cone() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.5), (1.2, 0.5), (1.2, 0.6)");
    let before = led(&[(1.0, 0.0), (1.0, 0.5)])?;
    let after = led(&[(1.0, 0.0), (1.0, 0.5), (1.2, 0.5), (1.2, 0.6)])?;
    stress_panel(&mut figure, "total", &after, &[(1.0, 1.0, 0.5), (1.0, 1.2, 1.1)]);
    let added = linspace(0.0, 1.2_f64.sqrt(), 201)
        .into_iter()
        .map(|rho| (stress(&after, rho) - stress(&before, rho), cattaneo(1.2, 1.1, rho)));
    figure.claim(
        Claim::all_close("the additional stress is σ_CM(a, a*)", added, Tolerance::Absolute(2e-8))
            .source("(6.24) to (6.26)"),
    );
    figure.claim(
        Claim::at_least("the slip ring lies outside the old contact", after.stick_depth(), 1.0)
            .source("a* > a₁ for dξ < f κ dζ"),
    );
    Ok(figure)
}

pub(super) fn draw_beyond_cone() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.5), (1.2, 0.5), (1.2, 0.9)");
    let after = led(&[(1.0, 0.0), (1.0, 0.5), (1.2, 0.5), (1.2, 0.9)])?;
    let parts = [(1.0, 1.0, 0.5), (1.0, 1.2, 1.0), (1.0, 0.5, 0.3)];
    stress_panel(&mut figure, "σ + σ' + σ''", &after, &parts);
    let pairs = linspace(0.0, 1.09, 101)
        .into_iter()
        .map(|rho| (stress(&after, rho), cattaneo(1.2, 0.3, rho)));
    figure.claim(
        Claim::all_close("the sum is the virgin stress", pairs, Tolerance::Absolute(2e-8))
            .source("sum law (6.9)"),
    );
    Ok(figure)
}

pub(super) fn draw_receding() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.5), (0.8, 0.5)");
    let memory = led(&[(1.0, 0.0), (1.0, 0.5), (0.8, 0.5)])?;
    let parts = [(1.0, 1.0, 0.5), (-1.0, 1.0, 0.8), (1.0, 0.5, 0.3)];
    stress_panel(&mut figure, "decreasing ζ", &memory, &parts);
    let direct = led(&[(0.8, 0.0), (0.8, 0.5)])?;
    figure.claim(
        Claim::close(
            "as if loaded at the smaller ζ",
            memory.force(),
            direct.force(),
            Tolerance::Absolute(1e-15),
        )
        .source("(6.37)"),
    );
    Ok(figure)
}

/// (6.40): zeta_2* = zeta_2 + [(xi_2 - xi_1)/(f kappa) - zeta_2 + zeta_1]/2.
fn second_star(zeta_1: f64, x_1: f64, zeta_2: f64, x_2: f64) -> f64 {
    zeta_2 + 0.5 * (x_2 - x_1 - zeta_2 + zeta_1)
}

fn reversal(
    figure: &mut Figure,
    title: &str,
    path: &[(f64, f64)],
) -> Result<(), carom_special::RangeError> {
    let memory = led(path)?;
    let (zeta_1, x_1) = path[1];
    let (zeta_2, x_2) = path[path.len() - 1];
    let (first, second) = (zeta_1 - x_1, second_star(zeta_1, x_1, zeta_2, x_2));
    // (6.38c): the first traction up to zeta_2*, the opposite one outside.
    stress_panel(figure, title, &memory, &[(1.0, second, first), (-1.0, zeta_2, second)]);
    let points: Vec<f64> = memory.instantaneous_adhesions().collect();
    figure.claim(
        Claim::holds(format!("{title}: P₁ is remembered"), points.len() == 1, points.len() as f64)
            .source("section 6.5"),
    );
    figure.claim(
        Claim::close(
            format!("{title}: ζ₂*"),
            memory.stick_depth(),
            second,
            Tolerance::Absolute(1e-15),
        )
        .source("(6.40)"),
    );
    Ok(())
}

pub(super) fn draw_reversal() -> FigureResult {
    let mut figure = begin("(1, 0), (1, 0.5), then (1.1, 0.3) or (0.9, 0.3)");
    reversal(&mut figure, "a) dζ > 0", &[(1.0, 0.0), (1.0, 0.5), (1.1, 0.3)])?;
    reversal(&mut figure, "b) dζ < 0", &[(1.0, 0.0), (1.0, 0.5), (0.9, 0.3)])?;
    Ok(figure)
}

pub(super) fn draw_continued() -> FigureResult {
    let mut figure = begin("as fig. 6.11, then (1.15, 0.1) or (0.85, 0.1)");
    let up = [(1.0, 0.0), (1.0, 0.5), (1.1, 0.3), (1.15, 0.1)];
    reversal(&mut figure, "a) dζ > 0", &up)?;
    let down = [(1.0, 0.0), (1.0, 0.5), (0.9, 0.3), (0.85, 0.1)];
    reversal(&mut figure, "b) dζ < 0", &down)?;
    Ok(figure)
}
