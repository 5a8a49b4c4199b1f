//! The outcome of a collision as records for JSON and columns for CSV.

use crate::case::{ImpactCase, Input};
use crate::columns;
use crate::command::theory::Excess;
use carom_impact::coupled::VectorLaw;
use carom_impact::oblique::{Event, Regime};
use carom_impact::{Body, Collision, HistoryPoint, Motion, Outcome, Rebound, Warning};
use carom_table::{Column, Value};
use serde::ser::{Serialize, SerializeMap, SerializeSeq, Serializer};

/// An impact and what came of it. SI units.
#[derive(Debug, Clone, serde::Serialize)]
pub(super) struct Record {
    /// The number of a sweep, or the angle of incidence if the case gives it.
    #[serde(flatten)]
    pub(super) parameter: Option<Parameter>,
    pub(super) outcome: Kind,
    pub(super) contact: ContactRecord,
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
    pub(super) history: Option<Course>,
}

/// A number by which impacts differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parameter {
    pub(super) name: &'static str,
    pub(super) value: f64,
}

impl Serialize for Parameter {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(1))?;
        map.serialize_entry(self.name, &self.value)?;
        map.end()
    }
}

/// Instants in order.
#[derive(Debug, Clone)]
pub(super) struct Course(pub(super) Vec<HistoryPoint>);

impl Serialize for Course {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(self.0.len()))?;
        for point in &self.0 {
            list.serialize_element(&columns::Record::new(HistoryPoint::COLUMNS, point))?;
        }
        list.end()
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Kind {
    Rebound,
    NoImpact,
}

/// Where the bodies touch and how the impact was solved.
#[derive(Debug, Clone, serde::Serialize)]
pub(super) struct ContactRecord {
    pub(super) point: [f64; 3],
    pub(super) x_axis: [f64; 3],
    pub(super) y_axis: [f64; 3],
    pub(super) z_axis: [f64; 3],
    pub(super) curvature_a: f64,
    pub(super) curvature_b: f64,
    pub(super) axis_ratio: f64,
    pub(super) centre_1: [f64; 3],
    pub(super) centre_2: [f64; 3],
    /// None without an impact.
    pub(super) passage: Option<&'static str>,
    pub(super) law: &'static str,
    pub(super) compressions: Option<u32>,
    pub(super) error_estimate: Option<f64>,
}

#[derive(Debug, Clone, Copy, serde::Serialize)]
pub(super) struct Motions {
    pub(super) body_1: MotionRecord,
    pub(super) body_2: MotionRecord,
}

#[derive(Debug, Clone, Copy, serde::Serialize)]
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
#[derive(Debug, Clone, serde::Serialize)]
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
#[derive(Debug, Clone, Copy, serde::Serialize)]
pub(super) struct TorsionRecord {
    pub(super) spin_ratio: f64,
    pub(super) torque_impulse: f64,
    pub(super) energy_dissipated: f64,
    pub(super) error_estimate: f64,
}

#[derive(Debug, Clone, Copy, serde::Serialize)]
pub(super) struct EventRecord {
    pub(super) time: f64,
    pub(super) event: &'static str,
    pub(super) regime: &'static str,
}

/// What came of an impact.
pub(super) fn record(parameter: Option<Parameter>, case: &ImpactCase, outcome: &Outcome) -> Record {
    let rebound = outcome.rebound();
    let limits = rebound.map_or_else(Vec::new, |rebound| rebound.warnings.clone());
    let excess = rebound.map(Excess::of_impact).unwrap_or_default();
    let angle = || case.angle.map(|value| Parameter { name: "angle", value });
    Record {
        parameter: parameter.or_else(angle),
        outcome: if rebound.is_some() { Kind::Rebound } else { Kind::NoImpact },
        contact: contact(case, rebound),
        before: motions(case.collision.bodies().each_ref().map(Body::motion)),
        after: motions(outcome.motions()),
        rebound: rebound.map(rebound_record),
        warnings: limits.iter().map(ToString::to_string).collect(),
        outside_theory: excess.reasons(),
        limits,
        excess,
        history: None,
    }
}

/// The name of a swept number: the angle of incidence has one of its own.
pub(super) fn name(input: &Input) -> &'static str {
    if input.field == "approach.angle" { "angle" } else { input.field }
}

fn contact(case: &ImpactCase, rebound: Option<&Rebound>) -> ContactRecord {
    let collision: &Collision = &case.collision;
    let (frame, curvature) = (collision.frame(), collision.hertz().curvature());
    let centre = |i: usize| collision.bodies()[i].placed().centre().into();
    ContactRecord {
        point: collision.point().into(),
        x_axis: frame.x().into(),
        y_axis: frame.y().into(),
        z_axis: frame.z().into(),
        curvature_a: curvature.a(),
        curvature_b: curvature.b(),
        axis_ratio: collision.hertz().axis_ratio().get(),
        centre_1: centre(0),
        centre_2: centre(1),
        passage: rebound.map(|rebound| match case.contact.is_numerical {
            true => "numerical",
            false => rebound.passage.name(),
        }),
        law: match (case.contact.is_numerical, case.contact.law) {
            (true, _) => "numerical",
            (false, VectorLaw::Coulomb) => "coulomb",
            (false, VectorLaw::FixedDirection) => "fixed-direction",
        },
        compressions: rebound.map(|rebound| rebound.compressions),
        error_estimate: rebound.map(|rebound| rebound.error_estimate),
    }
}

fn motions(motions: [Motion; 2]) -> Motions {
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

/// The columns of outcomes; the first is the swept number `parameter`.
pub(super) fn columns(parameter: &'static str) -> Vec<Column<Record>> {
    let first = Column::new(parameter, "", "that the case gives or sweeps over", |r: &Record| {
        r.parameter.map(|parameter| parameter.value).into()
    });
    [&[first], COLUMNS].concat()
}

fn of<T: Into<Value>>(record: &Record, value: impl Fn(&ReboundRecord) -> T) -> Value {
    record.rebound.as_ref().map(value).map_or(Value::Absent, Into::into)
}

/// Motions are those after the impact.
pub(super) const COLUMNS: &[Column<Record>] = &[
    Column::new("outcome", "", "rebound, or no_impact", |r| match r.outcome {
        Kind::Rebound => "rebound".into(),
        Kind::NoImpact => "no_impact".into(),
    }),
    Column::new("R_x", "", "tangential restitution", |r| r.restitution().into()),
    Column::vector("body_1_velocity", "m/s", "of the centre afterwards", |r| {
        r.after.body_1.velocity.into()
    }),
    Column::vector("body_1_spin", "rad/s", "afterwards", |r| r.after.body_1.spin.into()),
    Column::vector("body_2_velocity", "m/s", "of the centre afterwards", |r| {
        r.after.body_2.velocity.into()
    }),
    Column::vector("body_2_spin", "rad/s", "afterwards", |r| r.after.body_2.spin.into()),
    Column::vector("impulse", "N s", "on body 1", |r| of(r, |b| b.impulse)),
    Column::vector("contact_velocity_before", "m/s", "of body 2 against body 1", |r| {
        of(r, |b| b.contact_velocity_before)
    }),
    Column::vector("contact_velocity_after", "m/s", "of body 2 against body 1", |r| {
        of(r, |b| b.contact_velocity_after)
    }),
    Column::new("duration", "s", "from touch to separation", |r| of(r, |b| b.duration)),
    Column::new("maximal_force", "N", "normal", |r| of(r, |b| b.maximal_force)),
    Column::new("maximal_approach", "m", "of distant points", |r| of(r, |b| b.maximal_approach)),
    Column::new("maximal_semi_axis_a", "m", "of the contact along x", |r| {
        of(r, |b| b.maximal_semi_axis_a)
    }),
    Column::new("maximal_semi_axis_b", "m", "of the contact along y", |r| {
        of(r, |b| b.maximal_semi_axis_b)
    }),
    Column::new("energy_before", "J", "kinetic", |r| of(r, |b| b.energy_before)),
    Column::new("energy_after", "J", "kinetic", |r| of(r, |b| b.energy_after)),
    Column::new("energy_dissipated", "J", "by friction", |r| of(r, |b| b.energy_dissipated)),
    Column::new("regimes", "", "in order; sign: traction on body 1 along the first slip", |r| {
        of(r, |b| b.regimes.clone())
    }),
    Column::new("warnings", "", "what limits the validity", |r| r.warnings.join("; ").into()),
    Column::new("passage", "", "how it was solved", |r| r.contact.passage.into()),
    Column::new("law", "", "for turning directions", |r| r.contact.law.into()),
    Column::new("compressions", "", "how often the approach grew", |r| {
        r.contact.compressions.map(u64::from).into()
    }),
    Column::new("error_estimate", "", "of the velocity, over that before", |r| {
        r.contact.error_estimate.into()
    }),
    Column::vector("point", "m", "of contact", |r| r.contact.point.into()),
    Column::vector("normal", "", "common normal, into body 1", |r| r.contact.z_axis.into()),
];
