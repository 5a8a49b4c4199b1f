//! A path as records for JSON and rows of cells.

use super::End;
use crate::columns::{self, add_fields};
use crate::command::theory::Excess;
use crate::error::CliError;
use crate::rows::indented;
use carom_cases::case::SceneCase;
use carom_impact::Rebound;
use carom_impact::scene::{Bounce, Ending, PathPoint};
use carom_table::{Cell, Quantity as _, row};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Columns of a bounce in a table.
pub(super) const READABLE: [&str; 14] = [
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

/// The cells of a bounce; without one, only the names and meanings of the columns.
pub(super) fn cells(bounce: Option<(&SceneCase, &Bounce)>) -> Vec<Cell> {
    let mut cells = row(Bounce::COLUMNS, bounce.map(|(_, bounce)| bounce));
    let wall = bounce.map(|(case, bounce)| case.names[bounce.wall].clone());
    cells.insert(1, Cell::new("wall", "", "name of the wall", wall));
    let rebound = row(Rebound::COLUMNS, bounce.map(|(_, bounce)| &bounce.rebound));
    // The motions of the ball, body 1, are listed already; the walls do not move.
    let is_new = |cell: &Cell| cell.name() != "outcome" && !cell.name().starts_with("body_");
    cells.extend(rebound.into_iter().filter(is_new));
    cells
}

/// Why a path ends, in words.
pub(super) fn ending(case: &SceneCase, ending: Ending) -> String {
    let name = |wall: usize| &case.names[wall];
    match ending {
        Ending::Time => "the time is over".to_owned(),
        Ending::Bounces => "the last bounce is done".to_owned(),
        Ending::Rest { wall } => format!("it stays on {}", name(wall)),
        Ending::Edge { wall } => format!("it meets an edge of {}", name(wall)),
    }
}

/// The part of the JSON after the bounces.
pub(super) fn end(case: &SceneCase, end: &End) -> Result<String, CliError> {
    let ending = indented(&ending(case, end.ending), 1)?;
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
        map.serialize_entry("outside_theory", &Excess::of_impact(rebound).reasons())?;
        map.end()
    }
}
