//! A path as records for JSON and rows for tables.

use crate::case::SceneCase;
use crate::command::theory::Excess;
use crate::error::CliError;
use carom_impact::scene::{Bounce, Ending, Path, PathPoint};
use serde::Serialize;

/// The path of the ball. SI units.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Report {
    pub(super) bounces: Vec<BounceRecord>,
    pub(super) ending: String,
    pub(super) end: PointRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) path: Option<Vec<PointRecord>>,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct BounceRecord {
    pub(super) time: f64,
    pub(super) wall: String,
    pub(super) position: [f64; 3],
    pub(super) velocity_before: [f64; 3],
    pub(super) spin_before: [f64; 3],
    pub(super) velocity: [f64; 3],
    pub(super) spin: [f64; 3],
    #[serde(rename = "R_x")]
    pub(super) restitution: Option<f64>,
    pub(super) duration: f64,
    pub(super) maximal_force: f64,
    pub(super) energy_before: f64,
    pub(super) energy_after: f64,
    pub(super) energy_dissipated: f64,
    pub(super) regimes: Vec<&'static str>,
    pub(super) warnings: Vec<String>,
    /// What lies outside the theory, if anything.
    pub(super) outside_theory: Vec<String>,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct PointRecord {
    pub(super) time: f64,
    pub(super) position: [f64; 3],
    pub(super) velocity: [f64; 3],
    pub(super) spin: [f64; 3],
}

/// The records of a path, with `points` instants of every flight if asked for.
pub(super) fn report(
    case: &SceneCase,
    path: &Path,
    points: Option<usize>,
) -> Result<Report, CliError> {
    let sampled = points.map(|count| path.points(count)).transpose()?;
    Ok(Report {
        bounces: path.bounces().iter().map(|bounce| record(case, bounce)).collect(),
        ending: ending(case, path.ending()),
        end: point(&path.last()),
        path: sampled.map(|points| points.iter().map(point).collect()),
    })
}

fn ending(case: &SceneCase, ending: Ending) -> String {
    match ending {
        Ending::Time => "the time is over".to_owned(),
        Ending::Bounces => "the last bounce is done".to_owned(),
        Ending::Rest { wall } => format!("it stays on {}", case.names[wall]),
        Ending::Edge { wall } => format!("it meets an edge of {}", case.names[wall]),
    }
}

fn record(case: &SceneCase, bounce: &Bounce) -> BounceRecord {
    let rebound = &bounce.rebound;
    BounceRecord {
        time: bounce.time,
        wall: case.names[bounce.wall].clone(),
        position: bounce.position.into(),
        velocity_before: bounce.before.velocity.into(),
        spin_before: bounce.before.spin.into(),
        velocity: bounce.after.velocity.into(),
        spin: bounce.after.spin.into(),
        restitution: rebound.tangential_restitution,
        duration: rebound.duration,
        maximal_force: rebound.maximal_force,
        energy_before: rebound.energy.before,
        energy_after: rebound.energy.after,
        energy_dissipated: rebound.energy.dissipated,
        regimes: rebound.log.iter().map(|entry| entry.regime.name()).collect(),
        warnings: rebound.warnings.iter().map(ToString::to_string).collect(),
        outside_theory: Excess::of_impact(rebound).reasons(),
    }
}

fn point(point: &PathPoint) -> PointRecord {
    PointRecord {
        time: point.time,
        position: point.position.into(),
        velocity: point.motion.velocity.into(),
        spin: point.motion.spin.into(),
    }
}

/// Heads of the bounces; velocity and spin are those afterwards.
pub(super) const HEADS: [&str; 14] = [
    "time",
    "wall",
    "x",
    "y",
    "z",
    "R_x",
    "velocity_x",
    "velocity_y",
    "velocity_z",
    "spin_x",
    "spin_y",
    "spin_z",
    "energy_dissipated",
    "regimes",
];

pub(super) fn rows(report: &Report, number: impl Fn(&f64) -> String) -> Vec<Vec<String>> {
    let row = |bounce: &BounceRecord| {
        let mut cells = vec![number(&bounce.time), bounce.wall.clone()];
        cells.extend(bounce.position.iter().map(&number));
        cells.push(bounce.restitution.as_ref().map_or_else(String::new, &number));
        cells.extend(bounce.velocity.iter().chain(&bounce.spin).map(&number));
        cells.push(number(&bounce.energy_dissipated));
        cells.push(bounce.regimes.join(" "));
        cells
    };
    report.bounces.iter().map(row).collect()
}

/// Heads of the points.
pub(super) const POINT_HEADS: [&str; 10] =
    ["time", "x", "y", "z", "velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z"];

pub(super) fn point_rows(
    points: &[PointRecord],
    number: impl Fn(&f64) -> String,
) -> Vec<Vec<String>> {
    let row = |point: &PointRecord| {
        let vectors = [point.position, point.velocity, point.spin];
        std::iter::once(&point.time).chain(vectors.as_flattened()).map(&number).collect()
    };
    points.iter().map(row).collect()
}
