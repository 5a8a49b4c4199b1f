//! The states of a history as records.

use crate::columns::Record;
use carom_cases::history::{Step, TRACTION_COLUMNS, Traction};
use carom_laws::validity::Validity;
use carom_table::Column;
use serde::Serialize;

/// A step in JSON.
#[derive(Serialize)]
pub(super) struct StepRecord<'a> {
    #[serde(flatten)]
    step: Record<'a, Step>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tractions: Vec<Record<'a, Traction>>,
    outside_theory: Vec<String>,
}

/// A step in JSON, with its limits.
pub(super) fn record<'a>(
    columns: &'a [Column<Step>],
    step: &'a Step,
    validity: Validity,
) -> StepRecord<'a> {
    let traction = |traction| Record::new(&TRACTION_COLUMNS[1..], traction);
    StepRecord {
        step: Record::new(columns, step),
        tractions: step.tractions.iter().map(traction).collect(),
        outside_theory: validity.reasons(),
    }
}
