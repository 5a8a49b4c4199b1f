//! Rows of results on their way out: as they come, so that none need be held.

use super::tensor::TensorRecord;
use super::{Plane, Tensor};
use crate::columns::Record;
use crate::error::CliError;
use crate::output::{Format, Results, csv_rows, short, table};
use carom_impact::oblique::{ObliqueImpact, Regime};
use carom_table::{Column, cells, heads, labels};
use serde::Serialize;

/// Rows of a table to read, at most: its columns are as wide as their widest row.
pub(super) const MOST_TO_READ: usize = 100_000;

/// R_x and what belongs to it.
#[derive(Debug)]
pub(super) struct Row {
    numbers: [f64; 2],
    pub(super) restitution: f64,
    regimes: Vec<&'static str>,
    tensor: Option<TensorRecord>,
}

const RESTITUTION: Column<Row> =
    Column::new("R_x", "", "tangential restitution", |row| row.restitution.into());
const REGIMES: Column<Row> =
    Column::new("regimes", "", "what the contact does, one after the other", |row| {
        row.regimes.clone().into()
    });

/// The columns of spheres.
pub(super) const OF_SPHERES: &[Column<Row>] = &[
    Column::new("kappa", "", "ratio of stiffness c_z/c_x", |row| row.numbers[0].into()),
    Column::new("lambda", "", "tangential over normal velocity, over friction", |row| {
        row.numbers[1].into()
    }),
    RESTITUTION,
    REGIMES,
];

/// The columns of any bodies.
pub(super) const OF_ANY: &[Column<Row>] = &[
    Column::new("chi", "", "D_xx c_x/(D_zz c_z)", |row| row.numbers[0].into()),
    Column::new("psi", "", "c_x/c_z times lambda", |row| row.numbers[1].into()),
    RESTITUTION,
    REGIMES,
];

macro_rules! component {
    ($name:literal, $row:literal, $column:literal) => {
        Column::new($name, "", "component of the tensor (3.3)", |row: &Row| {
            row.tensor.map(|tensor| tensor.rows[$row][$column]).into()
        })
    };
}

/// Those of a tensor.
pub(super) const OF_TENSOR: &[Column<Row>] = &[
    Column::new("tensor", "", "its name", |row| row.tensor.map(|tensor| tensor.name).into()),
    component!("R_xx", 0, 0),
    component!("R_xy", 0, 1),
    component!("R_xz", 0, 2),
    component!("R_yx", 1, 0),
    component!("R_yy", 1, 1),
    component!("R_yz", 1, 2),
    component!("R_zx", 2, 0),
    component!("R_zy", 2, 1),
    component!("R_zz", 2, 2),
];

/// A row as it stands in JSON.
#[derive(Serialize)]
struct RowRecord<'a> {
    #[serde(flatten)]
    row: Record<'a, Row>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tensor: Option<TensorRecord>,
}

impl Row {
    /// The impact of two numbers of the plane.
    pub(super) fn new(
        plane: &Plane<'_>,
        numbers: [f64; 2],
        tensor: Option<Tensor>,
        ratio: f64,
    ) -> Result<Self, CliError> {
        let groups = (plane.groups)(numbers[0], numbers[1])?;
        let impact = ObliqueImpact::new(groups)?;
        let regimes = impact.regimes().map(Regime::name).collect();
        let restitution = impact.restitution();
        let tensor = tensor.map(|tensor| tensor.record(groups, ratio)).transpose()?;
        Ok(Self { numbers, restitution, regimes, tensor })
    }
}

/// Writes rows in a format; holds those of a table only.
pub(super) struct Printer {
    format: Format,
    plane: &'static [Column<Row>],
    columns: Vec<Column<Row>>,
    is_begun: bool,
    held: Vec<Vec<String>>,
}

impl Printer {
    pub(super) fn new(format: Format, plane: &Plane<'_>, tensor: Option<Tensor>) -> Self {
        let tensor = if tensor.is_some() { OF_TENSOR } else { &[] };
        let columns = [plane.columns, tensor].concat();
        Self { format, plane: plane.columns, columns, is_begun: false, held: Vec::new() }
    }

    /// Writes some rows.
    pub(super) fn print(&mut self, rows: &[Row], results: &mut Results) -> Result<(), CliError> {
        let mut text = String::new();
        match self.format {
            Format::None => {}
            Format::Table => {
                self.held.extend(rows.iter().map(|row| cells(&self.columns, row, short)));
            }
            Format::Csv => {
                let row = |row| cells(&self.columns, row, |value| value.to_string());
                let cells: Vec<_> = rows.iter().map(row).collect();
                let heads = heads(&self.columns);
                text = csv_rows((!self.is_begun).then_some(heads.as_slice()), &cells)?;
            }
            Format::Json => {
                for (i, row) in rows.iter().enumerate() {
                    text.push_str(if self.is_begun || i > 0 { ",\n  " } else { "[\n  " });
                    let tensor = row.tensor;
                    let record = RowRecord { row: Record::new(self.plane, row), tensor };
                    let row = serde_json::to_string_pretty(&record)
                        .map_err(|error| CliError::Format(error.into()))?;
                    text.push_str(&row.replace('\n', "\n  "));
                }
            }
        }
        self.is_begun = true;
        results.put(text.as_bytes())
    }

    /// Ends the results.
    pub(super) fn finish(self, results: &mut Results) -> Result<(), CliError> {
        match self.format {
            Format::Table => results.put(table(&labels(&self.columns), &self.held).as_bytes()),
            Format::Json => results.put(b"\n]\n"),
            Format::Csv | Format::None => Ok(()),
        }
    }
}
