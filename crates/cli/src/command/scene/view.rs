//! A path as records for JSON and rows of cells.

use crate::case::SceneCase;
use crate::columns::{self, add_fields};
use crate::command::theory::Excess;
use crate::error::CliError;
use carom_impact::Rebound;
use carom_impact::scene::{Bounce, Ending, Path, PathPoint};
use carom_table::{Cell, row};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// The path of the ball. SI units.
pub(super) struct Report<'a> {
    case: &'a SceneCase,
    path: &'a Path,
    /// Instants of every flight, if asked for.
    pub(super) points: Option<Vec<PathPoint>>,
}

/// What a table to read shows of a bounce.
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

/// A row for a bounce; without one, what stands in it.
pub(super) fn cells(bounce: Option<(&SceneCase, &Bounce)>) -> Vec<Cell> {
    let mut cells = row(Bounce::COLUMNS, bounce.map(|(_, bounce)| bounce));
    let wall = bounce.map(|(case, bounce)| case.names[bounce.wall].clone());
    cells.insert(1, Cell::new("wall", "", "that it meets", wall));
    cells.extend(row(Rebound::COLUMNS, bounce.map(|(_, bounce)| &bounce.rebound)));
    cells
}

impl<'a> Report<'a> {
    /// Of a path, with `points` instants of every flight if asked for.
    pub(super) fn new(
        case: &'a SceneCase,
        path: &'a Path,
        points: Option<usize>,
    ) -> Result<Self, CliError> {
        let points = points.map(|count| path.points(count)).transpose()?;
        Ok(Self { case, path, points })
    }

    /// A row for each bounce.
    pub(super) fn rows(&self) -> Vec<Vec<Cell>> {
        let bounces = self.path.bounces().iter();
        bounces.map(|bounce| cells(Some((self.case, bounce)))).collect()
    }

    /// Why it ends.
    pub(super) fn ending(&self) -> String {
        let name = |wall: usize| &self.case.names[wall];
        match self.path.ending() {
            Ending::Time => "the time is over".to_owned(),
            Ending::Bounces => "the last bounce is done".to_owned(),
            Ending::Rest { wall } => format!("it stays on {}", name(wall)),
            Ending::Edge { wall } => format!("it meets an edge of {}", name(wall)),
        }
    }

    /// Where it ends.
    pub(super) fn end(&self) -> PathPoint {
        self.path.last()
    }
}

impl Serialize for Report<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let bounces: Vec<_> = self
            .path
            .bounces()
            .iter()
            .map(|bounce| BounceRecord { case: self.case, bounce })
            .collect();
        let end = self.end();
        let point = |point| columns::Record::new(PathPoint::COLUMNS, point);
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("bounces", &bounces)?;
        map.serialize_entry("ending", &self.ending())?;
        map.serialize_entry("end", &point(&end))?;
        if let Some(points) = &self.points {
            map.serialize_entry("path", &points.iter().map(point).collect::<Vec<_>>())?;
        }
        map.end()
    }
}

struct BounceRecord<'a> {
    case: &'a SceneCase,
    bounce: &'a Bounce,
}

impl Serialize for BounceRecord<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rebound = &self.bounce.rebound;
        let warnings: Vec<String> = rebound.warnings.iter().map(ToString::to_string).collect();
        let mut map = serializer.serialize_map(None)?;
        add_fields(&mut map, &cells(Some((self.case, self.bounce))))?;
        map.serialize_entry("warnings", &warnings)?;
        map.serialize_entry("outside_theory", &Excess::of_impact(rebound).reasons())?;
        map.end()
    }
}
