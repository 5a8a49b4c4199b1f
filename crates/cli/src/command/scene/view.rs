//! A path as records for JSON and rows of cells.

use crate::columns::{self, add_fields};
use crate::error::CliError;
use crate::rows::indented;
use carom_cases::case::SceneCase;
use carom_cases::scene::{End, rebound_columns, wall_name};
use carom_impact::ImpactFriction;
use carom_impact::scene::{Bounce, Event, PathPoint, Wall};
use carom_table::{Cell, row};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Columns of a bounce in a table.
const READABLE: [&str; 14] = [
    "time",
    "wall",
    "position_x",
    "position_y",
    "position_z",
    "velocity_x",
    "velocity_y",
    "velocity_z",
    "spin_x",
    "spin_y",
    "spin_z",
    "R_x",
    "energy_dissipated",
    "regimes",
];

/// The columns of a table; with that of friction, if the friction of a wall depends on the slip speed.
pub(super) fn shown(case: &SceneCase) -> Vec<&'static str> {
    let by_speed = |wall: &Wall| matches!(wall.friction(), ImpactFriction::SlipSpeed(_));
    let friction: &[_] = if case.scene.walls().iter().any(by_speed) { &["friction"] } else { &[] };
    [&READABLE[..], friction].concat()
}

/// The cells of a bounce; without one, only the names and meanings of the columns.
pub(super) fn cells(bounce: Option<(&SceneCase, &Bounce)>) -> Vec<Cell> {
    let mut cells = row(Bounce::COLUMNS, bounce.map(|(_, bounce)| bounce));
    let wall = bounce.map(|(case, bounce)| case.names[bounce.wall].clone());
    cells.insert(1, Cell::new("wall", "", "name of the wall", wall));
    // The motions of the ball, body 1, are listed already; the walls do not move.
    cells.extend(row(&rebound_columns(), bounce.map(|(_, bounce)| &bounce.rebound)));
    cells
}

/// The cells of an event; without one, only the names and meanings of the columns.
pub(super) fn event_cells(event: Option<(&SceneCase, &Event)>) -> Vec<Cell> {
    let mut cells = row(Event::COLUMNS, event.map(|(_, event)| event));
    let wall = event.map(|(case, event)| wall_name(case, event));
    cells.insert(2, Cell::new("wall", "", "name of the wall", wall));
    cells
}

/// The part of the JSON after the bounces.
pub(super) fn end(case: &SceneCase, end: &End) -> Result<String, CliError> {
    let ending = indented(&end.reason(case), 1)?;
    let last = indented(&columns::Record::new(PathPoint::COLUMNS, &end.last), 1)?;
    Ok(format!(",\n  \"ending\": {ending},\n  \"end\": {last}"))
}

/// A bounce in JSON.
pub(super) struct BounceRecord<'a> {
    case: &'a SceneCase,
    bounce: &'a Bounce,
}

impl<'a> BounceRecord<'a> {
    pub(super) const fn new(case: &'a SceneCase, bounce: &'a Bounce) -> Self {
        Self { case, bounce }
    }
}

impl Serialize for BounceRecord<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rebound = &self.bounce.rebound;
        let mut map = serializer.serialize_map(None)?;
        add_fields(&mut map, &cells(Some((self.case, self.bounce))))?;
        map.serialize_entry("outside_theory", &rebound.validity.reasons())?;
        map.end()
    }
}
