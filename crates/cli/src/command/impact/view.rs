//! The outcome of a collision as records for JSON and rows of cells.

use crate::case::{ImpactCase, Input};
use crate::columns::{self, Fields, add_fields};
use crate::command::theory::Excess;
use carom_impact::coupled::VectorLaw;
use carom_impact::{
    Body, Collision, HistoryPoint, LogEntry, Motion, Outcome, Rebound, Torsion, Warning,
};
use carom_table::{Cell, Column, Quantity as _, Value, row};
use serde::ser::{Serialize, SerializeMap, SerializeSeq, Serializer};

/// An impact and what came of it. SI units.
#[derive(Debug, Clone)]
pub(super) struct Record {
    /// The number of a sweep, or the angle of incidence if the case gives it.
    pub(super) parameter: Option<Parameter>,
    case: ImpactCase,
    outcome: Outcome,
    pub(super) excess: Excess,
    pub(super) history: Option<Vec<HistoryPoint>>,
}

/// A number by which impacts differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parameter {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) value: f64,
}

impl Parameter {
    /// The number of a sweep: the angle of incidence has a name of its own.
    pub(super) fn of(input: &Input, value: f64) -> Self {
        let name = if input.field == "approach.angle" { "angle" } else { input.field };
        Self { name, unit: input.unit, value }
    }
}

/// How the impact was followed.
const METHOD: &[Column<Record>] = &[
    Column::new("method", "", "how it was solved", |record| {
        let method = |rebound: &Rebound| match record.case.contact.is_numerical {
            true => "numerical",
            false => rebound.method.name(),
        };
        record.of_rebound(method)
    }),
    Column::new("law", "", "for turning directions", |record| {
        match (record.case.contact.is_numerical, record.case.contact.law) {
            (true, _) => "numerical",
            (false, VectorLaw::Coulomb) => "coulomb",
            (false, VectorLaw::FixedDirection) => "fixed-direction",
        }
        .into()
    }),
    Column::new("compressions", "", "how often the approach grew", |record| {
        record.of_rebound(|rebound| u64::from(rebound.compressions))
    }),
    Column::new("error_estimate", "", "of the velocity, over that before", |record| {
        record.of_rebound(|rebound| rebound.error_estimate)
    }),
];
const OUTCOME: Column<Record> =
    Column::new("outcome", "", "rebound, or no_impact", |record| match record.outcome {
        Outcome::Rebound(_) => "rebound".into(),
        Outcome::NoImpact { .. } => "no_impact".into(),
    });
const WARNINGS: Column<Record> =
    Column::new("warnings", "", "what limits the validity", |record| {
        record.warnings().join("; ").into()
    });

impl Record {
    /// What came of an impact.
    pub(super) fn new(parameter: Option<Parameter>, case: ImpactCase, outcome: Outcome) -> Self {
        let excess = outcome.rebound().map(Excess::of_impact).unwrap_or_default();
        let angle = || case.angle.map(|value| Parameter { name: "angle", unit: "deg", value });
        let parameter = parameter.or_else(angle);
        Self { parameter, case, outcome, excess, history: None }
    }

    pub(super) fn rebound(&self) -> Option<&Rebound> {
        self.outcome.rebound()
    }

    pub(super) const fn collision(&self) -> &Collision {
        &self.case.collision
    }

    /// R_x, if there is one.
    pub(super) fn restitution(&self) -> Option<f64> {
        self.rebound()?.tangential_restitution
    }

    /// The motions before and after, of body 1 and body 2.
    pub(super) fn motions(&self) -> [[Motion; 2]; 2] {
        [self.case.collision.bodies().each_ref().map(Body::motion), self.outcome.motions()]
    }

    pub(super) fn limits(&self) -> &[Warning] {
        self.rebound().map_or(&[], |rebound| &rebound.warnings)
    }

    fn warnings(&self) -> Vec<String> {
        self.limits().iter().map(ToString::to_string).collect()
    }

    fn of_rebound<T: Into<Value>>(&self, value: impl Fn(&Rebound) -> T) -> Value {
        self.rebound().map_or(Value::Undefined, |rebound| value(rebound).into())
    }

    /// Where the bodies touch and how the impact was followed.
    pub(super) fn contact(&self) -> Vec<Cell> {
        [row(Collision::COLUMNS, Some(&self.case.collision)), row(METHOD, Some(self))].concat()
    }

    /// What came of it, and what torsion did.
    pub(super) fn quantities(&self) -> Vec<Cell> {
        let torsion = self.rebound().and_then(|rebound| rebound.torsion);
        let torsion = row(Torsion::COLUMNS, torsion.as_ref());
        let named = |cell: Cell| {
            let name = format!("torsion.{}", cell.name());
            cell.named(name)
        };
        let torsion = torsion.into_iter().map(named);
        row(Rebound::COLUMNS, self.rebound()).into_iter().chain(torsion).collect()
    }

    /// What happened when.
    pub(super) fn events(&self) -> &[LogEntry] {
        self.rebound().map_or(&[], |rebound| &rebound.log)
    }
}

/// The number of a sweep, or the angle of incidence.
fn parameter(record: Option<&Record>) -> Cell {
    let parameter = record.and_then(|record| record.parameter);
    let (name, unit) =
        parameter.map_or(("angle", "deg"), |parameter| (parameter.name, parameter.unit));
    let value = parameter.map(|parameter| parameter.value);
    Cell::new(name, unit, "that the case gives or sweeps over", value)
}

/// A row of comma-separated values; without a record, what stands in one. Motions are those after the
/// impact.
pub(super) fn cells(record: Option<&Record>) -> Vec<Cell> {
    let mut cells = vec![parameter(record), OUTCOME.cell(record)];
    let rebound = row(Rebound::COLUMNS, record.and_then(Record::rebound));
    let (restitution, others) = rebound.split_at(1);
    cells.extend_from_slice(restitution);
    let after = record.map(|record| record.outcome.motions());
    for (i, body) in ["body_1", "body_2"].into_iter().enumerate() {
        let motion = row(Motion::COLUMNS, after.as_ref().map(|motions| &motions[i]));
        cells.extend(motion.into_iter().map(|cell| {
            let name = format!("{body}_{}", cell.name());
            cell.named(name)
        }));
    }
    cells.extend_from_slice(others);
    cells.push(WARNINGS.cell(record));
    cells.extend(row(METHOD, record));
    let place = row(Collision::COLUMNS, record.map(|record| &record.case.collision));
    cells.extend(place.into_iter().filter_map(|cell| match cell.name() {
        "point" => Some(cell),
        "z_axis" => Some(cell.named("normal")),
        _ => None,
    }));
    cells
}

impl Serialize for Record {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        add_fields(&mut map, &[parameter(Some(self)), OUTCOME.cell(Some(self))])?;
        map.serialize_entry("contact", &Fields(&self.contact()))?;
        for (when, motions) in ["before", "after"].into_iter().zip(self.motions()) {
            map.serialize_entry(when, &Motions(motions))?;
        }
        if let Some(rebound) = self.rebound() {
            add_fields(&mut map, &row(Rebound::COLUMNS, Some(rebound)))?;
            if let Some(torsion) = &rebound.torsion {
                let torsion = columns::Record::new(Torsion::COLUMNS, torsion);
                map.serialize_entry("torsion", &torsion)?;
            }
            map.serialize_entry("events", &List(LogEntry::COLUMNS, &rebound.log))?;
        }
        map.serialize_entry("warnings", &self.warnings())?;
        map.serialize_entry("outside_theory", &self.excess.reasons())?;
        if let Some(points) = &self.history {
            map.serialize_entry("history", &List(HistoryPoint::COLUMNS, points))?;
        }
        map.end()
    }
}

/// Motions of body 1 and body 2.
struct Motions([Motion; 2]);

impl Serialize for Motions {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(2))?;
        for (body, motion) in ["body_1", "body_2"].into_iter().zip(&self.0) {
            map.serialize_entry(body, &columns::Record::new(Motion::COLUMNS, motion))?;
        }
        map.end()
    }
}

/// Records by their columns, one after another.
struct List<'a, R>(&'a [Column<R>], &'a [R]);

impl<R> Serialize for List<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(self.1.len()))?;
        for record in self.1 {
            list.serialize_element(&columns::Record::new(self.0, record))?;
        }
        list.end()
    }
}
