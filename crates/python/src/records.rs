//! Results as columns: name, unit and meaning come from the tables that stand beside the results.

use carom::impact::{EnergyBudget, HistoryPoint, Motion, Outcome, Rebound};
use carom::laws::hertz::HertzState;
use carom::table::{Column, Quantity as _, Value};
use carom_cli::cases::history_columns;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// An outcome as a record: what only a rebound has is absent if the bodies do not meet.
pub(crate) struct Parted {
    motions: [Motion; 2],
    rebound: Option<Box<Rebound>>,
}

impl From<Outcome> for Parted {
    fn from(outcome: Outcome) -> Self {
        let motions = outcome.motions();
        match outcome {
            Outcome::NoImpact { .. } => Self { motions, rebound: None },
            Outcome::Rebound(rebound) => Self { motions, rebound: Some(rebound) },
        }
    }
}

impl Parted {
    fn of<T: Into<Value>>(&self, get: impl FnOnce(&Rebound) -> T) -> Value {
        self.rebound.as_deref().map(get).into()
    }

    fn energy(&self, get: impl FnOnce(&EnergyBudget) -> f64) -> Value {
        self.of(|rebound| get(&rebound.energy))
    }

    pub(crate) const COLUMNS: &'static [Column<Self>] = &[
        Column::vector("velocity_1", "m/s", "of the centre of body 1 afterwards", |p| {
            <[f64; 3]>::from(p.motions[0].velocity).into()
        }),
        Column::vector("spin_1", "1/s", "of body 1 afterwards", |p| {
            <[f64; 3]>::from(p.motions[0].spin).into()
        }),
        Column::vector("velocity_2", "m/s", "of the centre of body 2 afterwards", |p| {
            <[f64; 3]>::from(p.motions[1].velocity).into()
        }),
        Column::vector("spin_2", "1/s", "of body 2 afterwards", |p| {
            <[f64; 3]>::from(p.motions[1].spin).into()
        }),
        Column::vector("impulse", "N s", "that body 2 gave body 1", |p| {
            p.of(|r| <[f64; 3]>::from(r.impulse))
        }),
        Column::vector("velocity_before", "m/s", "of contact point 2 against 1 before", |p| {
            p.of(|r| <[f64; 3]>::from(r.velocity_before))
        }),
        Column::vector("velocity_after", "m/s", "of contact point 2 against 1 after", |p| {
            p.of(|r| <[f64; 3]>::from(r.velocity_after))
        }),
        Column::new(
            "restitution",
            "",
            "R_x, the tangential velocity after over that before, reversed",
            |p| p.of(|r| r.tangential_restitution),
        ),
        Column::new("duration", "s", "from touch to separation", |p| p.of(|r| r.duration)),
        Column::new("maximal_force", "N", "greatest normal force", |p| p.of(|r| r.maximal_force)),
        Column::new("maximal_approach", "m", "greatest approach", |p| p.of(|r| r.maximal_approach)),
        Column::new("semi_axis_a", "m", "of the greatest contact, smaller", |p| {
            p.of(|r| r.maximal_contact.semi_axis_a())
        }),
        Column::new("semi_axis_b", "m", "of the greatest contact, larger", |p| {
            p.of(|r| r.maximal_contact.semi_axis_b())
        }),
        Column::new(
            "energy_before",
            "J",
            "kinetic energy before, bodies held fast left out",
            |p| p.energy(|e| e.before),
        ),
        Column::new("energy_after", "J", "kinetic energy after, the same", |p| {
            p.energy(|e| e.after)
        }),
        Column::new("dissipated", "J", "what friction took", |p| p.energy(|e| e.dissipated)),
        Column::new("lost", "J", "what the bodies' material took", |p| p.energy(|e| e.lost)),
        Column::new("error_estimate", "", "of the velocity after, over that before", |p| {
            p.of(|r| r.error_estimate)
        }),
        Column::new("method", "", "how the impact was followed", |p| {
            p.of(|r| format!("{:?}", r.method).to_lowercase())
        }),
        Column::new("warnings", "", "what limits the validity", |p| {
            p.of(|r| r.warnings.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
        }),
    ];
}

/// Name, unit, meaning and number of parts of each column of a result.
#[pyfunction]
pub(crate) fn columns(
    record: &str,
) -> PyResult<Vec<(&'static str, &'static str, &'static str, usize)>> {
    match record {
        "HertzState" => Ok(about(HertzState::COLUMNS)),
        "HistoryPoint" => Ok(about(HistoryPoint::COLUMNS)),
        "HistoryStep" => Ok(about(&history_columns())),
        "Rebound" => Ok(about(Parted::COLUMNS)),
        "SolverStep" => Ok(about(&carom::solver::StepSummary::columns())),
        _ => Err(PyValueError::new_err(format!("no result `{record}`"))),
    }
}

fn about<R>(columns: &[Column<R>]) -> Vec<(&'static str, &'static str, &'static str, usize)> {
    let one = |column: &Column<R>| {
        (column.name(), column.unit(), column.meaning(), column.parts().len().max(1))
    };
    columns.iter().map(one).collect()
}

/// Bytes that a record takes until its arrays are made: its own, those of its numbers and texts, and of a
/// column on its way.
pub(crate) fn bytes<R>(columns: &[Column<R>]) -> usize {
    let numbers: usize = columns.iter().map(|column| column.parts().len().max(1)).sum();
    let texts = columns.len() * size_of::<String>();
    size_of::<R>() + numbers * size_of::<f64>() + texts + size_of::<Value>()
}

/// Records as arrays, one for each column: numbers (n,), vectors (n, 3), texts as lists; what is absent
/// is not a number, or empty.
pub(crate) fn arrays<'py, R>(
    py: Python<'py>,
    columns: &[Column<R>],
    records: &[R],
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for column in columns {
        let values: Vec<Value> = records.iter().map(|record| column.value(record)).collect();
        if column.parts().len() == 3 {
            let parts = values.into_iter().flat_map(vector).collect::<Vec<f64>>();
            let array = PyArray1::from_vec(py, parts).reshape([records.len(), 3])?;
            let _: &Bound<'_, PyArray2<f64>> = &array;
            dict.set_item(column.name(), array)?;
        } else if values.iter().any(|value| matches!(value, Value::Text(_) | Value::Words(_))) {
            dict.set_item(column.name(), values.into_iter().map(text).collect::<Vec<_>>())?;
        } else {
            let numbers = values.into_iter().map(number).collect();
            dict.set_item(column.name(), PyArray1::from_vec(py, numbers))?;
        }
    }
    Ok(dict)
}

fn vector(value: Value) -> [f64; 3] {
    match value {
        Value::Vector(parts) => parts,
        _ => [f64::NAN; 3],
    }
}

fn number(value: Value) -> f64 {
    match value {
        Value::Number(number) => number,
        Value::Count(count) => count as f64,
        _ => f64::NAN,
    }
}

fn text(value: Value) -> String {
    match value {
        Value::Text(text) => text.into_owned(),
        Value::Words(words) => words.join(" "),
        _ => String::new(),
    }
}
