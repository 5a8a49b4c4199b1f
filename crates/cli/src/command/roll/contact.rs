//! The picture of a rolling contact: where it sticks and slips, its tractions and its leading edge.

use crate::command::solve::plot::{around_contact, arrows, axes};
use crate::error::CliError;
use carom_plot::{Axis, Field, Panel, Point, Series};
use carom_solver::{CellState, ContactState, Contour};

/// A side whose normal has this part or less in the direction of rolling runs along it.
const ALONG: f64 = 1e-9;

/// The cells that stick and slip, the tractions as arrows, and the leading edge as a line.
pub(super) fn contact(
    state: &ContactState,
    middle: [f64; 2],
    direction: f64,
) -> Result<Panel, CliError> {
    let panel = axes(&format!("tractions on body 1, {}", rolls(direction)));
    let mut panel = panel.over(kinds(state, middle)?);
    for (i, edge) in leading_edges(&state.contact_outlines(), direction).into_iter().enumerate() {
        let label = if i == 0 { "leading edge" } else { "" };
        let points = edge.into_iter().map(|[x, y]| Point::new(middle[0] + x, middle[1] + y));
        panel.add(Series::line(label, points.collect::<Vec<_>>()).coloured(3));
    }
    if let Some(arrows) = arrows(state, middle) {
        panel.add(Series::arrows("", arrows).coloured(2));
    }
    Ok(panel)
}

/// The tractions along a single line of cells, between the limits of friction.
pub(super) fn line(state: &ContactState, middle: [f64; 2], friction: f64, direction: f64) -> Panel {
    let grid = state.pressure.grid();
    let (pressure, x, y) = (&state.pressure, &state.traction_x, &state.traction_y);
    let is_column = grid.nx() == 1;
    let [columns, rows] = around_contact(state);
    let places: Vec<(usize, f64)> = match is_column {
        true => rows.map(|j| (j, middle[1] + grid.centred_y(j))).collect(),
        false => columns.map(|i| (i, middle[0] + grid.centred_x(i))).collect(),
    };
    let axis = Axis::linear(if is_column { "y / m" } else { "x / m" });
    let title = format!("tractions on body 1, {}", rolls(direction));
    let mut panel = Panel::new(axis, Axis::linear("traction / Pa")).titled(title);
    let curve = |of: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
        places.iter().map(|(cell, at)| (*at, of(*cell))).collect()
    };
    for (colour, (name, field)) in [("t_x", x), ("t_y", y)].into_iter().enumerate() {
        if field.values().iter().any(|traction| *traction != 0.0) {
            let points = curve(&|cell| field.values()[cell]);
            panel.add(Series::line(name, points).coloured(colour));
        }
    }
    for (label, sign) in [("±f p", friction), ("", -friction)] {
        let points = curve(&|cell| sign * pressure.values()[cell]);
        panel.add(Series::dashed(label, points).coloured(2));
    }
    panel
}

/// The direction of rolling in words.
fn rolls(direction: f64) -> String {
    let degrees = direction.to_degrees().rem_euclid(360.0);
    let near = |angle: f64| (degrees - angle).abs() < 1e-9;
    match () {
        () if near(0.0) || near(360.0) => "rolls to the right".to_owned(),
        () if near(90.0) => "rolls upwards".to_owned(),
        () if near(180.0) => "rolls to the left".to_owned(),
        () if near(270.0) => "rolls downwards".to_owned(),
        () => format!("rolls at {degrees:.4}°"),
    }
}

/// The map of cells that stick and slip.
fn kinds(state: &ContactState, middle: [f64; 2]) -> Result<Field, CliError> {
    let grid = state.cells.grid();
    let [columns, rows] = around_contact(state);
    let x = columns.clone().map(|i| middle[0] + grid.centred_x(i)).collect();
    let y = rows.clone().map(|j| middle[1] + grid.centred_y(j)).collect();
    let kind = |(i, j): (usize, usize)| match state.cells.values()[j * grid.nx() + i] {
        CellState::Stick => Some(0),
        CellState::Slip => Some(1),
        _ => None,
    };
    let cells = rows.flat_map(|j| columns.clone().map(move |i| (i, j)));
    Ok(Field::of_kinds(["stick", "slip"], x, y, cells.map(kind).collect())?)
}

/// The parts of outlines where particles enter the contact: the outward normal points in the
/// direction of rolling.
fn leading_edges(outlines: &[Contour], direction: f64) -> Vec<Vec<[f64; 2]>> {
    let (sin, cos) = libm::sincos(direction);
    let mut edges = Vec::new();
    for outline in outlines {
        let points = &outline.points;
        let count = points.len();
        let at = |i: usize| points[i % count];
        let cross = |i: usize| at(i)[0] * at(i + 1)[1] - at(i)[1] * at(i + 1)[0];
        let turn = (0..count).map(cross).sum::<f64>().signum();
        // The outward normal of a side that runs along (dx, dy) to the left is (dy, -dx).
        let leads = |i: usize| {
            let [dx, dy] = [at(i + 1)[0] - at(i)[0], at(i + 1)[1] - at(i)[1]];
            turn * (dy * cos - dx * sin) > ALONG * libm::hypot(dx, dy)
        };
        // Begin where the edge does not lead, so that no part is split.
        let Some(start) = (0..count).find(|i| !leads(*i)) else { continue };
        let mut edge: Vec<[f64; 2]> = Vec::new();
        for i in start..start + count {
            if leads(i) {
                if edge.is_empty() {
                    edge.push(at(i));
                }
                edge.push(at(i + 1));
            } else if !edge.is_empty() {
                edges.push(std::mem::take(&mut edge));
            }
        }
        if !edge.is_empty() {
            edges.push(edge);
        }
    }
    edges
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square from (-1, -1) to (1, 1), in either sense.
    fn square(reversed: bool) -> Contour {
        let mut points = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        if reversed {
            points.reverse();
        }
        Contour { points }
    }

    #[test]
    fn the_leading_edge_lies_ahead() {
        for reversed in [false, true] {
            for (degrees, axis, side) in
                [(0.0_f64, 0, 1.0), (90.0, 1, 1.0), (180.0, 0, -1.0), (-90.0, 1, -1.0)]
            {
                let edges = leading_edges(&[square(reversed)], degrees.to_radians());
                assert_eq!(edges.len(), 1, "{degrees}");
                assert_eq!(edges[0].len(), 2);
                assert!(edges[0].iter().all(|point| point[axis] == side), "{degrees}: {edges:?}");
            }
            let corner = leading_edges(&[square(reversed)], 0.7);
            assert_eq!((corner.len(), corner[0].len()), (1, 3));
        }
    }

    #[test]
    fn the_direction_is_said_in_words() {
        assert_eq!(rolls(0.0), "rolls to the right");
        assert_eq!(rolls(std::f64::consts::FRAC_PI_2), "rolls upwards");
        assert_eq!(rolls(std::f64::consts::PI), "rolls to the left");
        assert_eq!(rolls(-std::f64::consts::FRAC_PI_2), "rolls downwards");
        assert_eq!(rolls(0.5), "rolls at 28.6479°");
    }
}
