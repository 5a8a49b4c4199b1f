//! The picture of a rolling contact.

use crate::command::plot::{Value, add_curve};
use crate::command::solve::plot::{pressures, stick_and_slip};
use crate::error::CliError;
use crate::output::Picture;
use carom_cases::roll::Row;
use carom_plot::{Axis, Marker, Panel, Series};
use carom_solver::ContactState;

/// Marks where rows make no curve.
const MARKS: [Marker; 2] = [Marker::Circle, Marker::Square];

/// What varies between rows.
enum Varying {
    /// One quantity: its name and its value.
    One(&'static str, Value<Row>),
    /// Several, so that rows are told apart by their number alone.
    Several,
}

fn varying(rows: &[Row]) -> Varying {
    let all: [(&str, Value<Row>); 4] = [
        ("distance / m", |row| row.distance.unwrap_or(0.0)),
        ("creepage", |row| row.creepage.along),
        ("creepage across", |row| row.creepage.across),
        ("spin / (rad/m)", |row| row.creepage.spin),
    ];
    let changes =
        |(_, of): &&(&str, Value<Row>)| rows.windows(2).any(|pair| of(&pair[0]) != of(&pair[1]));
    let mut found = all.iter().filter(changes);
    match (found.next(), found.next()) {
        (Some(_), Some(_)) if rows.iter().all(|row| row.distance.is_none()) => Varying::Several,
        (Some((name, of)), _) => Varying::One(name, *of),
        (None, _) => Varying::One(all[1].0, all[1].1),
    }
}

pub(super) fn draw(rows: &[Row], state: &ContactState) -> Result<Picture, CliError> {
    let (mut panels, mut rest) = (Vec::new(), Vec::new());
    if rows.len() > 1 {
        let mut sorted: Vec<(f64, Row)> = (1..).map(f64::from).zip(rows.iter().copied()).collect();
        let (label, is_curve) = match varying(rows) {
            Varying::One(label, at) => {
                sorted.iter_mut().for_each(|(place, row)| *place = at(row));
                sorted.sort_by(|one, other| one.0.total_cmp(&other.0));
                (label, true)
            }
            Varying::Several => ("number of the row", false),
        };
        let points = |of: &dyn Fn(&Row) -> f64| -> Vec<(f64, f64)> {
            sorted.iter().map(|(place, row)| (*place, of(row))).collect()
        };
        let add = |panel: &mut Panel, name: &str, points: Vec<(f64, f64)>| match is_curve {
            true => add_curve(panel, name, points.clone(), points),
            false => {
                let colour = panel.series.len();
                panel.add(
                    Series::markers(name, MARKS[colour % MARKS.len()], points).coloured(colour),
                );
            }
        };
        let panel = |title: &str, axis: &str| {
            Panel::new(Axis::linear(label), Axis::linear(axis)).titled(title)
        };
        let mut forces = panel("forces on body 1", "force/(f F_z)");
        let axes: [(&str, Value<Row>); 2] =
            [("F_x", |row| row.load.f_x), ("F_y", |row| row.load.f_y)];
        for (i, (name, force)) in axes.into_iter().enumerate() {
            let line = points(&|row| force(row) / row.limit);
            add(&mut forces, name, line);
            if is_curve && sorted.iter().all(|(_, row)| row.springs.is_some()) {
                let springs = points(&|row| row.springs.map_or(0.0, |both| both[i]) / row.limit);
                forces.add(Series::dashed(format!("{name}, FASTSIM"), springs).coloured(i));
            }
        }
        panels.push(forces);
        let mut torque = panel("torque on body 1", "M_z / N m");
        let line = points(&|row| row.load.m_z);
        add(&mut torque, "", line);
        if rows.iter().any(|row| row.creepage.spin != 0.0) {
            panels.push(torque)
        } else {
            rest.push(torque)
        }
        let mut areas = panel("areas", "area / m²");
        for (name, area) in
            [("contact", points(&|row| row.contact_area)), ("stick", points(&|row| row.stick_area))]
        {
            add(&mut areas, name, area);
        }
        rest.push(areas);
    }
    panels.push(pressures(state, [0.0; 2])?);
    panels.push(stick_and_slip(state, [0.0; 2]));
    Ok(Picture::new("Rolling contact, to the right", panels).with(rest))
}
