//! The picture of a rolling contact.

use crate::command::plot::{Value, add_curve};
use crate::command::solve::plot::{pressures, stick_and_slip};
use crate::error::CliError;
use crate::output::Picture;
use carom_cases::roll::Row;
use carom_plot::{Axis, Panel, Series};
use carom_solver::ContactState;

/// The quantity that varies between rows: its name and its value.
fn abscissa(rows: &[Row]) -> (&'static str, Value<Row>) {
    let all: [(&str, Value<Row>); 4] = [
        ("distance / m", |row| row.distance.unwrap_or(0.0)),
        ("creepage", |row| row.creepage.along),
        ("creepage across", |row| row.creepage.across),
        ("spin / (rad/m)", |row| row.creepage.spin),
    ];
    let changes =
        |(_, of): &&(&str, Value<Row>)| rows.windows(2).any(|pair| of(&pair[0]) != of(&pair[1]));
    *all.iter().find(changes).unwrap_or(&all[1])
}

pub(super) fn draw(rows: &[Row], state: &ContactState) -> Result<Picture, CliError> {
    let mut panels = Vec::new();
    if rows.len() > 1 {
        let (label, at) = abscissa(rows);
        let mut sorted = rows.to_vec();
        sorted.sort_by(|one, other| at(one).total_cmp(&at(other)));
        let points = |of: &dyn Fn(&Row) -> f64| -> Vec<(f64, f64)> {
            sorted.iter().map(|row| (at(row), of(row))).collect()
        };
        let panel = |title: &str, axis: &str| {
            Panel::new(Axis::linear(label), Axis::linear(axis)).titled(title)
        };
        let mut forces = panel("forces on body 1", "force/(f F_z)");
        let axes: [(&str, Value<Row>); 2] =
            [("F_x", |row| row.load.f_x), ("F_y", |row| row.load.f_y)];
        for (i, (name, force)) in axes.into_iter().enumerate() {
            let line = points(&|row| force(row) / row.limit);
            add_curve(&mut forces, name, line.clone(), line);
            if sorted.iter().all(|row| row.springs.is_some()) {
                let springs = points(&|row| row.springs.map_or(0.0, |both| both[i]) / row.limit);
                forces.add(Series::dashed(format!("{name}, FASTSIM"), springs).coloured(i));
            }
        }
        panels.push(forces);
        let mut torque = panel("torque on body 1", "M_z / N m");
        let line = points(&|row| row.load.m_z);
        add_curve(&mut torque, "", line.clone(), line);
        panels.push(torque);
        let mut areas = panel("areas", "area / m²");
        for (name, area) in
            [("contact", points(&|row| row.contact_area)), ("stick", points(&|row| row.stick_area))]
        {
            add_curve(&mut areas, name, area.clone(), area);
        }
        panels.push(areas);
    }
    panels.push(pressures(state, [0.0; 2])?);
    panels.push(stick_and_slip(state, [0.0; 2]));
    Ok(Picture::new("Rolling contact, to the right", panels))
}
