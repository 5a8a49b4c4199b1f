//! The picture of a fit: data with their errors, fit and band, and residuals.

use crate::output::Picture;
use carom_fit::{Curve, Fit, Point, Prediction};
use carom_plot::{Axis, Marker, Panel, Series};

/// Measured values that are drawn with bars, at most; more would hide the fit.
const MOST_BARS: usize = 200;

/// A panel of fit and data for each quantity, and one of residuals.
pub(super) fn draw(fit: &Fit) -> Picture {
    let mut panels: Vec<Panel> = match &fit.curve {
        Some(curve) => curve.lines.iter().map(|line| along(fit, curve, line)).collect(),
        None => quantities(fit).into_iter().map(|name| against(fit, name)).collect(),
    };
    panels.push(residuals(fit));
    Picture::new("Fit", panels)
}

fn label(name: &str, unit: &str) -> String {
    let words = name.replace('_', " ");
    if unit.is_empty() { words } else { format!("{words} / {unit}") }
}

/// Data and fit over the input that varies.
fn along(
    fit: &Fit,
    curve: &Curve,
    (name, unit, line): &(String, &'static str, Vec<Prediction>),
) -> Panel {
    let own: Vec<&Point> = fit.points.iter().filter(|point| point.quantity == *name).collect();
    let place = |point: &Point| curve.given[point.row - 1];
    let input = curve.input.0.rsplit('.').next().unwrap_or_default();
    let mut panel =
        Panel::new(Axis::linear(label(input, curve.input.1)), Axis::linear(label(name, unit)));
    let at = || curve.along.iter().zip(line);
    let ends: Option<Vec<(f64, [f64; 2])>> =
        at().map(|(x, one)| Some((*x, one.interval?))).collect();
    if let Some(ends) = ends {
        let lower = ends.iter().map(|(x, [low, _])| (*x, *low));
        let upper = ends.iter().rev().map(|(x, [_, high])| (*x, *high));
        let outline: Vec<(f64, f64)> = lower.chain(upper).collect();
        panel.add(Series::area("95 %", outline).coloured(0));
    }
    panel.add(Series::line("fit", at().map(|(x, one)| (*x, one.value))).coloured(0));
    if own.len() <= MOST_BARS {
        for point in &own {
            let (x, high) = (place(point), point.measured + point.error);
            let bar = [(x, point.measured - point.error), (x, high)];
            panel.add(Series::line("", bar).coloured(6));
        }
    }
    let dots = own.iter().map(|point| (place(point), point.measured));
    panel.add(Series::markers("measured", Marker::Dot, dots.collect::<Vec<_>>()).coloured(1));
    panel
}

fn quantities(fit: &Fit) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for point in &fit.points {
        if !names.contains(&point.quantity.as_str()) {
            names.push(&point.quantity);
        }
    }
    names
}

/// Measured over fitted values, where several inputs vary.
fn against(fit: &Fit, name: &str) -> Panel {
    let own = || fit.points.iter().filter(|point| point.quantity == name);
    let ends = own().flat_map(|point| [point.measured, point.fitted]);
    let [low, high] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    let mut panel =
        Panel::new(Axis::linear("fitted"), Axis::linear("measured")).titled(label(name, ""));
    panel.add(Series::line("", [(low, low), (high, high)]).coloured(0));
    let dots = own().map(|point| (point.fitted, point.measured));
    panel.add(Series::markers("", Marker::Dot, dots.collect::<Vec<_>>()).coloured(1));
    panel
}

/// Residuals over standard errors, in the order of the data.
fn residuals(fit: &Fit) -> Panel {
    let mut panel =
        Panel::new(Axis::linear("row of the data"), Axis::linear("residual / standard error"));
    let last = fit.points.iter().map(|point| point.row).max().unwrap_or(1) as f64;
    for level in [-2.0, 0.0, 2.0] {
        panel.add(Series::dotted("", [(0.5, level), (last + 0.5, level)]).coloured(6));
    }
    for (k, name) in quantities(fit).into_iter().enumerate() {
        let own = fit.points.iter().filter(|point| point.quantity == name);
        let dots: Vec<(f64, f64)> = own.map(|point| (point.row as f64, point.residual())).collect();
        panel.add(Series::markers(label(name, ""), Marker::Dot, dots).coloured(1 + k));
    }
    panel.titled("residuals")
}
