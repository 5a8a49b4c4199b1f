//! R_x as lines over one number, or as a map over both.

use super::Plane;
use crate::command::plot::{MOST_MARKS, add_curve};
use crate::error::CliError;
use crate::output::Picture;
use carom_plot::{Axis, Field, Marker, Panel, Series};
use carom_special::linspace;
use carom_table::short;
use rayon::prelude::*;

/// Nodes of a map, at most: its picture takes eight bytes for each.
const MOST_NODES: usize = 16_000_000;
/// Points of a line, unless more are given.
const POINTS: usize = 301;

/// R_x against the second number, a line for each first one; against the first if there is one
/// second only. The lines are computed between the numbers given, which are marked.
pub(super) fn lines(plane: &Plane<'_>) -> Result<Picture, CliError> {
    let [first, second] = plane.values;
    let [symbol, other] = plane.symbols;
    let is_over_first = second.len() == 1 && first.len() > 1;
    let (along, lines, [symbol, other]) = if is_over_first {
        (first, second, [symbol, other])
    } else {
        (second, first, [other, symbol])
    };
    let mut panel = Panel::new(Axis::linear(symbol.to_string()), Axis::linear("R_x"));
    let given: Vec<f64> = along.iter().copied().filter(|value| value.is_finite()).collect();
    let is_marked = (2..=MOST_MARKS).contains(&given.len());
    for value in lines {
        let pair = |at: f64| if is_over_first { [at, *value] } else { [*value, at] };
        let label = format!("{other} = {}", short(*value));
        if given.len() < 2 {
            panel.add(Series::markers(label, Marker::Dot, points(plane, &given, pair)?));
            continue;
        }
        let marks = if is_marked { points(plane, &given, pair)? } else { Vec::new() };
        add_curve(&mut panel, &label, points(plane, &close_together(&given), pair)?, marks);
    }
    let marks = if is_marked { " (dots: the values given)" } else { "" };
    Ok(Picture::new(&format!("{}{marks}", plane.title), [panel]))
}

/// R_x at each of the numbers.
fn points(
    plane: &Plane<'_>,
    numbers: &[f64],
    pair: impl Fn(f64) -> [f64; 2] + Sync,
) -> Result<Vec<(f64, f64)>, CliError> {
    let point = |at: &f64| Ok((*at, plane.bodies.restitution(pair(*at))?));
    numbers.par_iter().map(point).collect()
}

/// The numbers given, and more between the least and the greatest of them.
fn close_together(given: &[f64]) -> Vec<f64> {
    let mut all = given.to_vec();
    if given.len() < POINTS {
        let (low, high) =
            given.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
                (low.min(*at), high.max(*at))
            });
        all.extend(linspace(low, high, POINTS));
    }
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Whether the values span a map.
pub(super) fn check(values: [&[f64]; 2]) -> Result<(), CliError> {
    let spans = |values: &[f64]| {
        values.len() > 1
            && values.iter().all(|value| value.is_finite())
            && values.windows(2).all(|pair| pair[0] < pair[1])
    };
    if !values.into_iter().all(spans) {
        return Err(CliError::Options(
            "--map takes two or more finite, increasing values of both numbers, as 1:1.5:101",
        ));
    }
    match values[0].len().saturating_mul(values[1].len()) {
        0..=MOST_NODES => Ok(()),
        _ => Err(CliError::Options("--map takes at most 16000000 pairs, 4000 by 4000")),
    }
}

/// R_x as colours over the second number, to the right, and the first one, upwards; `values` has a
/// row for each first number.
pub(super) fn map(values: Vec<f64>, plane: &Plane<'_>) -> Result<Picture, CliError> {
    let [first, second] = plane.values;
    let field = Field::new("R_x", second.to_vec(), first.to_vec(), values)?;
    let [symbol, other] = plane.symbols.map(|symbol| Axis::linear(symbol.to_string()));
    Ok(Picture::new(&plane.title, [Panel::new(other, symbol).over(field)]))
}
