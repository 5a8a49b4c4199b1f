//! The outcome of a collision as records for JSON and rows for CSV.

use super::model::Shot;
use crate::command::theory::Excess;
use carom_impact::oblique::{Event, Regime};
use carom_impact::{CollisionError, HistoryPoint, Motion, Outcome, Rebound, Warning};
use rayon::prelude::*;
use serde::Serialize;

/// An impact and what came of it. SI units.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Record {
    /// Angle of incidence, degrees, if the case gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) angle: Option<f64>,
    pub(super) outcome: Kind,
    pub(super) before: Motions,
    pub(super) after: Motions,
    #[serde(flatten)]
    pub(super) rebound: Option<ReboundRecord>,
    pub(super) warnings: Vec<String>,
    /// What lies outside the theory, if anything.
    pub(super) outside_theory: Vec<String>,
    #[serde(skip)]
    pub(super) limits: Vec<Warning>,
    #[serde(skip)]
    pub(super) excess: Excess,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) history: Option<Vec<Instant>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Kind {
    Rebound,
    NoImpact,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Motions {
    pub(super) body_1: MotionRecord,
    pub(super) body_2: MotionRecord,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct MotionRecord {
    pub(super) velocity: [f64; 3],
    pub(super) spin: [f64; 3],
}

impl Record {
    /// R_x, if there is one.
    pub(super) fn restitution(&self) -> Option<f64> {
        self.rebound.as_ref()?.restitution
    }
}

/// What only a rebound has.
#[derive(Debug, Clone, Serialize)]
pub(super) struct ReboundRecord {
    /// None where no tangential velocity says a direction for it.
    #[serde(rename = "R_x")]
    pub(super) restitution: Option<f64>,
    pub(super) impulse: [f64; 3],
    pub(super) contact_velocity_before: [f64; 3],
    pub(super) contact_velocity_after: [f64; 3],
    pub(super) duration: f64,
    pub(super) maximal_force: f64,
    pub(super) maximal_approach: f64,
    pub(super) maximal_semi_axis_a: f64,
    pub(super) maximal_semi_axis_b: f64,
    pub(super) energy_before: f64,
    pub(super) energy_after: f64,
    pub(super) energy_dissipated: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) torsion: Option<TorsionRecord>,
    pub(super) regimes: Vec<&'static str>,
    pub(super) events: Vec<EventRecord>,
}

/// What the torsional impact did to the spin about the normal.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct TorsionRecord {
    pub(super) spin_ratio: f64,
    pub(super) torque_impulse: f64,
    pub(super) energy_dissipated: f64,
    pub(super) error_estimate: f64,
}

#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct EventRecord {
    pub(super) time: f64,
    pub(super) event: &'static str,
    pub(super) regime: &'static str,
}

/// One instant of an impact. The shift is that of body 2 against body 1.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Instant {
    pub(super) time: f64,
    pub(super) approach: f64,
    pub(super) shift: f64,
    pub(super) normal_force: f64,
    pub(super) tangential_force: f64,
    pub(super) contact_radius: f64,
    pub(super) stick_radius: f64,
    pub(super) regime: &'static str,
}

/// Computes the collisions, in their order.
pub(super) fn records(shots: &[Shot]) -> Result<Vec<Record>, CollisionError> {
    shots
        .par_iter()
        .map(|shot| Ok(record(shot.angle, &shot.before, &shot.collision.solve()?)))
        .collect()
}

/// The course of a collision at `count` instants; empty without an impact.
pub(super) fn history(shot: &Shot, count: usize) -> Result<Vec<Instant>, CollisionError> {
    Ok(shot.collision.history(count)?.iter().map(instant).collect())
}

/// What came of an impact.
pub(super) fn record(angle: Option<f64>, before: &[Motion; 2], outcome: &Outcome) -> Record {
    let rebound = outcome.rebound();
    let limits = rebound.map_or_else(Vec::new, |rebound| rebound.warnings.clone());
    let excess = rebound.map(Excess::of_impact).unwrap_or_default();
    Record {
        angle,
        outcome: if rebound.is_some() { Kind::Rebound } else { Kind::NoImpact },
        before: motions(before),
        after: motions(&outcome.motions()),
        rebound: rebound.map(rebound_record),
        warnings: limits.iter().map(ToString::to_string).collect(),
        outside_theory: excess.reasons(),
        limits,
        excess,
        history: None,
    }
}

fn motions(motions: &[Motion; 2]) -> Motions {
    let [body_1, body_2] = motions
        .map(|motion| MotionRecord { velocity: motion.velocity.into(), spin: motion.spin.into() });
    Motions { body_1, body_2 }
}

fn rebound_record(rebound: &Rebound) -> ReboundRecord {
    ReboundRecord {
        restitution: rebound.tangential_restitution,
        impulse: rebound.impulse.into(),
        contact_velocity_before: rebound.velocity_before.into(),
        contact_velocity_after: rebound.velocity_after.into(),
        duration: rebound.duration,
        maximal_force: rebound.maximal_force,
        maximal_approach: rebound.maximal_approach,
        maximal_semi_axis_a: rebound.maximal_contact.semi_axis_a(),
        maximal_semi_axis_b: rebound.maximal_contact.semi_axis_b(),
        energy_before: rebound.energy.before,
        energy_after: rebound.energy.after,
        energy_dissipated: rebound.energy.dissipated,
        torsion: rebound.torsion.map(|torsion| TorsionRecord {
            spin_ratio: torsion.spin_ratio,
            torque_impulse: torsion.torque_impulse,
            energy_dissipated: torsion.dissipated,
            error_estimate: torsion.error_estimate,
        }),
        regimes: rebound.log.iter().map(|entry| entry.regime.name()).collect(),
        events: rebound
            .log
            .iter()
            .map(|entry| EventRecord {
                time: entry.time,
                event: event_name(entry.event),
                regime: Regime::name(entry.regime),
            })
            .collect(),
    }
}

const fn event_name(event: Event) -> &'static str {
    match event {
        Event::Touch => "touch",
        Event::SlipStart => "slip starts",
        Event::SlipStop => "slip stops",
        Event::RingClosed => "slip ring closed",
        Event::StickEnd => "stick area gone",
        Event::SlideStop => "sliding stops",
    }
}

fn instant(point: &HistoryPoint) -> Instant {
    Instant {
        time: point.time,
        approach: point.approach,
        shift: point.shift,
        normal_force: point.normal_force,
        tangential_force: point.tangential_force,
        contact_radius: point.contact_radius,
        stick_radius: point.stick_radius,
        regime: point.regime.name(),
    }
}

/// Heads of the CSV of outcomes.
pub(super) const HEADS: [&str; 34] = [
    "angle",
    "outcome",
    "R_x",
    "body_1_velocity_x",
    "body_1_velocity_y",
    "body_1_velocity_z",
    "body_1_spin_x",
    "body_1_spin_y",
    "body_1_spin_z",
    "body_2_velocity_x",
    "body_2_velocity_y",
    "body_2_velocity_z",
    "body_2_spin_x",
    "body_2_spin_y",
    "body_2_spin_z",
    "impulse_x",
    "impulse_y",
    "impulse_z",
    "contact_velocity_before_x",
    "contact_velocity_before_y",
    "contact_velocity_before_z",
    "contact_velocity_after_x",
    "contact_velocity_after_y",
    "contact_velocity_after_z",
    "duration",
    "maximal_force",
    "maximal_approach",
    "maximal_semi_axis_a",
    "maximal_semi_axis_b",
    "energy_before",
    "energy_after",
    "energy_dissipated",
    "regimes",
    "warnings",
];

/// A row of the CSV of outcomes: motions are those after the impact.
pub(super) fn cells(record: &Record) -> Vec<String> {
    let mut cells = vec![
        record.angle.map_or_else(String::new, |angle| angle.to_string()),
        match record.outcome {
            Kind::Rebound => "rebound".to_owned(),
            Kind::NoImpact => "no_impact".to_owned(),
        },
        record.restitution().map_or_else(String::new, |restitution| restitution.to_string()),
    ];
    let Motions { body_1, body_2 } = &record.after;
    let motions = [body_1.velocity, body_1.spin, body_2.velocity, body_2.spin];
    cells.extend(motions.as_flattened().iter().map(f64::to_string));
    match &record.rebound {
        None => cells.resize(HEADS.len() - 1, String::new()),
        Some(rebound) => {
            let vectors =
                [rebound.impulse, rebound.contact_velocity_before, rebound.contact_velocity_after];
            cells.extend(vectors.as_flattened().iter().map(f64::to_string));
            let numbers = [
                rebound.duration,
                rebound.maximal_force,
                rebound.maximal_approach,
                rebound.maximal_semi_axis_a,
                rebound.maximal_semi_axis_b,
                rebound.energy_before,
                rebound.energy_after,
                rebound.energy_dissipated,
            ];
            cells.extend(numbers.iter().map(f64::to_string));
            cells.push(rebound.regimes.join(" "));
        }
    }
    cells.push(record.warnings.join("; "));
    cells
}

/// Heads of the CSV of a history.
pub(super) const HISTORY_HEADS: [&str; 8] = [
    "time",
    "approach",
    "shift",
    "normal_force",
    "tangential_force",
    "contact_radius",
    "stick_radius",
    "regime",
];

/// A row of a history.
pub(super) fn history_cells(instant: &Instant, number: fn(f64) -> String) -> Vec<String> {
    let numbers = [
        instant.time,
        instant.approach,
        instant.shift,
        instant.normal_force,
        instant.tangential_force,
        instant.contact_radius,
        instant.stick_radius,
    ];
    numbers.into_iter().map(number).chain([instant.regime.to_owned()]).collect()
}
