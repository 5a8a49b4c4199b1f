//! The picture of a rolling contact.

use super::contact::{contact, line};
use crate::command::between::curve_through;
use crate::command::plot::{VANISHES, Value, add_curve, without};
use crate::command::solve::plot::pressures;
use crate::error::CliError;
use crate::output::Picture;
use carom_cases::case::RollCase;
use carom_cases::roll::{Rolled, Row};
use carom_plot::{Axis, Marker, Panel, Series};
use carom_rolling::RollingDrive;
use carom_solver::Driven;

/// Marks where rows make no curve.
const MARKS: [Marker; 2] = [Marker::Circle, Marker::Square];

/// A torque below this part of the friction limit times the width of the contact is round-off.
const ROUND_OFF: f64 = 1e-9;

/// What varies between rows.
enum Varying {
    /// One quantity: its name and its value.
    One(&'static str, Value<Row>),
    /// Several, so that rows are told apart by their number alone.
    Several,
}

/// What varies between the rows of a case: the given motion, by its creepage where a force is given.
fn varying(case: &RollCase) -> Varying {
    if case.distance.is_some() {
        return Varying::One("distance / m", |row| row.distance.unwrap_or(0.0));
    }
    let drives = case.drives.as_slice();
    let motions = |drive: &RollingDrive| [drive.along, drive.across, drive.spin, drive.normal];
    let by_load = drives.iter().any(|drive| matches!(drive.normal, Driven::Load(_)));
    let axes: [(&str, Value<Row>); 4] = [
        ("creepage", |row| row.creepage.along),
        ("creepage across", |row| row.creepage.across),
        ("spin / (rad/m)", |row| row.creepage.spin),
        match by_load {
            true => ("F_z / N", |row| row.load.f_z),
            false => ("ζ / m", |row| row.approach),
        },
    ];
    let changes =
        |i: &usize| drives.windows(2).any(|pair| motions(&pair[0])[*i] != motions(&pair[1])[*i]);
    let mut found = (0..axes.len()).filter(changes);
    match (found.next(), found.next()) {
        (Some(_), Some(_)) => Varying::Several,
        (one, _) => {
            let (name, of) = axes[one.unwrap_or(0)];
            Varying::One(name, of)
        }
    }
}

/// A quantity of a row that is drawn.
struct Drawn {
    title: &'static str,
    axis: &'static str,
    of: Value<Row>,
}

/// The torque, or the spin of a body that turns freely.
fn twist(rows: &[Row]) -> Drawn {
    let is_torque =
        |row: &Row| row.load.m_z.abs() > ROUND_OFF * row.limit * libm::sqrt(row.contact_area);
    match rows.iter().any(is_torque) || rows.iter().all(|row| row.creepage.spin == 0.0) {
        true => Drawn { title: "torque on body 1", axis: "M_z / N m", of: |row| row.load.m_z },
        false => Drawn {
            title: "spin without a torque",
            axis: "spin / (rad/m)",
            of: |row| row.creepage.spin,
        },
    }
}

pub(super) fn draw(case: &RollCase, rolled: &Rolled) -> Result<Picture, CliError> {
    let (rows, state, middle) = (rolled.rows.as_slice(), &rolled.state, rolled.window.middle());
    let (mut panels, mut rest) = (Vec::new(), Vec::new());
    if rows.len() > 1 {
        let mut sorted: Vec<(f64, Row)> = (1..).map(f64::from).zip(rows.iter().copied()).collect();
        let (label, is_curve) = match varying(case) {
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
            true => add_curve(panel, name, curve_through(&points), points),
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
        let axes: [(&str, Value<Row>); 2] =
            [("F_x", |row| row.load.f_x), ("F_y", |row| row.load.f_y)];
        let is_there =
            |force: Value<Row>| rows.iter().any(|row| force(row).abs() > VANISHES * row.limit);
        let absent = axes.iter().filter(|(_, force)| !is_there(*force)).map(|(name, _)| *name);
        let mut forces = panel(&without("forces on body 1", absent), "force/(f F_z)");
        for (i, (name, force)) in axes.into_iter().enumerate() {
            if !is_there(force) {
                continue;
            }
            let colour = forces.series.iter().filter(|series| !series.label.is_empty()).count();
            let line = points(&|row| force(row) / row.limit);
            add(&mut forces, name, line);
            if is_curve && sorted.iter().all(|(_, row)| row.springs.is_some()) {
                let springs = points(&|row| {
                    row.springs.map_or(0.0, |both| [both.f_x, both.f_y][i]) / row.limit
                });
                let springs = curve_through(&springs);
                forces.add(Series::dashed(format!("{name}, FASTSIM"), springs).coloured(colour));
            }
            if is_curve && sorted.iter().all(|(_, row)| row.table.is_some()) {
                let table = points(&|row| {
                    row.table.map_or(0.0, |both| [both.f_x, both.f_y][i]) / row.limit
                });
                let table = curve_through(&table);
                forces.add(Series::dotted(format!("{name}, table"), table).coloured(colour));
            }
        }
        panels.push(forces);
        let twist = twist(rows);
        let mut torque = panel(twist.title, twist.axis);
        let line = points(&twist.of);
        add(&mut torque, "", line);
        let turns = |drive: &RollingDrive| drive.spin != Driven::Shift(0.0);
        if case.drives.iter().any(turns) {
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
    panels.push(pressures(state, middle)?);
    let grid = state.cells.grid();
    let direction = case.method.direction();
    panels.push(match grid.nx() > 1 && grid.ny() > 1 {
        true => contact(state, middle, direction)?,
        false => line(state, middle, case.friction.motion, direction),
    });
    Ok(Picture::new("Rolling contact", panels).with(rest))
}
