//! R_x as lines over one number, or as a map over both.

use super::{Plane, Row};
use crate::command::plot::drawn;
use crate::error::CliError;
use crate::output::short;
use carom_plot::{Axis, Field, Marker, Panel, Series};

/// R_x against the second number, a line for each first one; against the first if there is one
/// second only.
pub(super) fn lines(rows: &[Row], plane: &Plane<'_>) -> Result<String, CliError> {
    let [first, second] = plane.values;
    let [symbol, other] = plane.symbols;
    let (label, lines): (_, Vec<Series>) = if second.len() == 1 && first.len() > 1 {
        let points = rows.iter().map(|row| (row.numbers[0], row.restitution));
        (symbol, vec![line(format!("{other} = {}", short(second[0])), points.collect())])
    } else {
        let lines = rows.chunks(second.len().max(1)).map(|rows| {
            let finite = rows.iter().filter(|row| row.numbers[1].is_finite());
            let points = finite.map(|row| (row.numbers[1], row.restitution));
            line(format!("{symbol} = {}", short(rows[0].numbers[0])), points.collect())
        });
        (other, lines.collect())
    };
    let mut panel = Panel::new(Axis::linear(label.to_string()), Axis::linear("R_x"));
    lines.into_iter().for_each(|line| panel.add(line));
    drawn(plane.title, &[panel])
}

fn line(label: String, points: Vec<(f64, f64)>) -> Series {
    if points.len() > 1 {
        Series::line(label, points)
    } else {
        Series::markers(label, Marker::Dot, points)
    }
}

/// Whether the values span a map.
pub(super) fn check(values: [&[f64]; 2]) -> Result<(), CliError> {
    let spans = |values: &[f64]| {
        values.len() > 1
            && values.iter().all(|value| value.is_finite())
            && values.windows(2).all(|pair| pair[0] < pair[1])
    };
    match values.into_iter().all(spans) {
        true => Ok(()),
        false => Err(CliError::Options(
            "--map takes two or more finite, increasing values of both numbers, as 1:1.5:101",
        )),
    }
}

/// R_x as colours over the second number, to the right, and the first one, upwards.
pub(super) fn map(rows: &[Row], plane: &Plane<'_>) -> Result<String, CliError> {
    let [first, second] = plane.values;
    let values = rows.iter().map(|row| row.restitution).collect();
    let field = Field::new("R_x", second.to_vec(), first.to_vec(), values)?;
    let [symbol, other] = plane.symbols.map(|symbol| Axis::linear(symbol.to_string()));
    drawn(plane.title, &[Panel::new(other, symbol).over(field)])
}
