//! The outcome of a collision as records for JSON and rows of cells.

use crate::columns::{self, Fields, Records, add_fields};
use carom_cases::case::{ImpactCase, Input};
use carom_cases::impact;
use carom_impact::{
    Body, Collision, HistoryPoint, LogEntry, Motion, Outcome, Rebound, Torsion, Warning,
};
use carom_laws::validity::Validity;
use carom_table::{Cell, Column, Quantity as _, Value, row};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// An impact and its outcome. SI units.
#[derive(Debug, Clone)]
pub(super) struct Record {
    /// The swept number, or the angle of incidence if the case gives it.
    pub(super) parameter: Option<Parameter>,
    case: ImpactCase,
    outcome: Outcome,
    pub(super) validity: Validity,
    pub(super) history: Option<Vec<HistoryPoint>>,
}

/// The number in which impacts of a sweep differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parameter {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) value: f64,
}

impl Parameter {
    /// The swept number; the angle of incidence has a short name.
    pub(super) fn of(input: &Input, value: f64) -> Self {
        Self { name: impact::name(input), unit: input.unit, value }
    }
}

const LAW: Column<Record> =
    Column::text("law", "", "law of friction", |record| record.case.contact.law.name().into());

impl Record {
    /// The record of an impact.
    pub(super) fn new(parameter: Option<Parameter>, case: ImpactCase, outcome: Outcome) -> Self {
        let validity = outcome.rebound().map(|rebound| rebound.validity).unwrap_or_default();
        let angle = || case.angle.map(|value| Parameter { name: "angle", unit: "deg", value });
        let parameter = parameter.or_else(angle);
        Self { parameter, case, outcome, validity, history: None }
    }

    pub(super) fn rebound(&self) -> Option<&Rebound> {
        self.outcome.rebound()
    }

    pub(super) const fn collision(&self) -> &Collision {
        &self.case.collision
    }

    /// The motions before and after, of body 1 and body 2.
    pub(super) fn motions(&self) -> [[Motion; 2]; 2] {
        [self.case.collision.bodies().each_ref().map(Body::motion), self.outcome.motions()]
    }

    pub(super) fn limits(&self) -> &[Warning] {
        self.rebound().map_or(&[], |rebound| &rebound.warnings)
    }

    /// Contact point, contact axes and law.
    pub(super) fn contact(&self) -> Vec<Cell> {
        let mut cells = row(Collision::COLUMNS, Some(&self.case.collision));
        cells.push(LAW.cell(Some(self)));
        cells
    }

    /// The outcome with torsion, without motions and warnings.
    pub(super) fn quantities(&self) -> Vec<Cell> {
        // What has a value without an impact too are the motions and the word for the outcome itself.
        let is_of_impact = |(cell, without): &(Cell, Cell)| {
            *without.value() == Value::Absent && !matches!(cell.value(), Value::Texts(_))
        };
        let outcome = row(Outcome::COLUMNS, Some(&self.outcome)).into_iter();
        let outcome = outcome.zip(without_impact(&self.outcome.motions())).filter(is_of_impact);
        let torsion = self.rebound().and_then(|rebound| rebound.torsion);
        let torsion = row(Torsion::COLUMNS, torsion.as_ref());
        let named = |cell: Cell| {
            let name = format!("torsion.{}", cell.name());
            cell.named(name)
        };
        let torsion = torsion.into_iter().map(named);
        outcome.map(|(cell, _)| cell).chain(torsion).collect()
    }

    /// The regimes in order.
    pub(super) fn events(&self) -> &[LogEntry] {
        self.rebound().map_or(&[], |rebound| &rebound.log)
    }
}

/// The swept number, or the angle of incidence.
fn parameter(record: Option<&Record>) -> Cell {
    let parameter = record.and_then(|record| record.parameter);
    let (name, unit) =
        parameter.map_or(("angle", "deg"), |parameter| (parameter.name, parameter.unit));
    let value = parameter.map(|parameter| parameter.value);
    Cell::new(name, unit, "given or swept number", value)
}

/// The cells of a row of CSV; without a record, only the names and meanings of the columns.
pub(super) fn cells(record: Option<&Record>) -> Vec<Cell> {
    let mut cells = vec![parameter(record)];
    cells.extend(row(Outcome::COLUMNS, record.map(|record| &record.outcome)));
    cells.push(LAW.cell(record));
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
        add_fields(&mut map, &[parameter(Some(self))])?;
        map.serialize_entry("contact", &Fields(&self.contact()))?;
        map.serialize_entry("before", &Fields(&motions(&self.motions()[0])))?;
        add_fields(&mut map, &row(Outcome::COLUMNS, Some(&self.outcome)))?;
        if let Some(rebound) = self.rebound() {
            if let Some(torsion) = &rebound.torsion {
                let torsion = columns::Record::new(Torsion::COLUMNS, torsion);
                map.serialize_entry("torsion", &torsion)?;
            }
            map.serialize_entry("events", &Records(LogEntry::COLUMNS, &rebound.log))?;
        }
        map.serialize_entry("outside_theory", &self.validity.reasons())?;
        if let Some(points) = &self.history {
            map.serialize_entry("history", &Records(HistoryPoint::COLUMNS, points))?;
        }
        map.end()
    }
}

/// Motions of body 1 and body 2, named as those of an outcome.
fn motions(motions: &[Motion; 2]) -> Vec<Cell> {
    let is_motion = |cell: &Cell| matches!(cell.value(), Value::Vector(_));
    without_impact(motions).into_iter().filter(is_motion).collect()
}

/// The cells of an outcome without an impact.
fn without_impact(motions: &[Motion; 2]) -> Vec<Cell> {
    row(Outcome::COLUMNS, Some(&Outcome::NoImpact { motions: *motions }))
}
