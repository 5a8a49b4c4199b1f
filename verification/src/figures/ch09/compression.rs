//! Fig. 9.1: the exact compression of an impact and Hunter's sine.

use carom_impact::closed_form::compression_time;
use carom_impact::normal::{DURATION, compression, state_at, time};
use carom_special::hypergeometric::{HypergeometricError, UnitArgument};

use crate::reference::rows;
use crate::{Absolute, Figure, FigureResult, Panel, Series, linspace};

fn sine(t: f64) -> f64 {
    libm::sin(std::f64::consts::PI * t / DURATION)
}

/// T_N/2 as the integral of dt = d zeta/w by midpoints: with S = sin^2 q it is
/// (4/5) sin^(-1/5) q dq, and with q = (pi/2) v^(5/4) smooth at 0.
fn half_duration_by_quadrature() -> f64 {
    let n = 200_000;
    let step = 1.0 / f64::from(n);
    let half_pi = std::f64::consts::FRAC_PI_2;
    (0..n)
        .map(|i| {
            let v = (f64::from(i) + 0.5) * step;
            let q = half_pi * libm::pow(v, 1.25);
            let slope = half_pi * 1.25 * libm::pow(v, 0.25);
            0.8 * libm::pow(libm::sin(q), -0.2) * slope * step
        })
        .sum()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.derived("T_N", format!("{DURATION}"));
    let times = linspace(0.0, DURATION, 201);
    let exact: Vec<(f64, f64)> = times.iter().map(|&t| (t, state_at(t).compression)).collect();
    let approximate: Vec<(f64, f64)> = times.iter().map(|&t| (t, sine(t))).collect();
    let mut panel = Panel::new("t ζ′_A / ζ_max", "ζ / ζ_max").titled("Compression");
    panel.add(Series::line("(9.8), (9.10)", exact));
    panel.add(Series::dashed("sine (9.11)", approximate));
    figure.panel(panel);

    let quadrature = half_duration_by_quadrature();
    figure
        .close("half the duration", 0.5 * DURATION, quadrature, Absolute(1e-10))
        .source("midpoint quadrature of dt = dζ/ζ′");
    let table = rows::<2>(include_str!("../../../data/impact/time.csv"))?;
    let pairs = table.iter().map(|[s, t]| (time((1.0 - s).sqrt()), *t));
    figure
        .all_close("times of seven compressions", pairs, Absolute(1e-12))
        .source("(9.8) in 25 digits by an independent program");
    let worst = linspace(0.0, DURATION, 20_001)
        .into_iter()
        .map(|t| (state_at(t).compression - sine(t)).abs())
        .fold(0.0, f64::max);
    figure
        .close("largest error of the sine", worst, 0.021_308, Absolute(1e-6))
        .source("independent scan");
    let asymmetry = linspace(0.0, 1.0, 101)
        .into_iter()
        .map(|w| (time(w) + time(-w) - DURATION).abs() + (compression(w) - compression(-w)).abs())
        .fold(0.0, f64::max);
    figure.at_most("symmetric about T/2", asymmetry, 4e-15).source("(9.10)");
    let closed: Result<Vec<(f64, f64)>, HypergeometricError> =
        table.iter().map(|[s, t]| Ok((compression_time(UnitArgument::new(*s)?)?, *t))).collect();
    figure
        .all_close("the times once more, as 2F1", closed?, Absolute(1e-12))
        .source("(9.8) in 25 digits by an independent program");
    Ok(figure)
}
