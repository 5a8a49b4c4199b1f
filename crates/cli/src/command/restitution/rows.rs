//! Rows of results on their way out: as they come, so that none need be held.

use super::tensor::{self, TensorRecord};
use super::{Plane, Tensor};
use crate::error::CliError;
use crate::output::{Format, Results, csv_rows, short, table};
use carom_impact::oblique::{ObliqueImpact, Regime};
use serde::Serialize;
use serde::ser::SerializeMap;

/// Rows of a table to read, at most: its columns are as wide as their widest row.
pub(super) const MOST_TO_READ: usize = 100_000;

/// R_x and what belongs to it.
#[derive(Debug)]
pub(super) struct Row {
    names: [&'static str; 2],
    numbers: [f64; 2],
    pub(super) restitution: f64,
    regimes: Vec<&'static str>,
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
        Ok(Self { names: plane.names, numbers, restitution, regimes, tensor })
    }

    fn cells(&self, number: impl Fn(f64) -> String) -> Vec<String> {
        let numbers = self.numbers.into_iter().chain([self.restitution]).map(&number);
        let mut cells: Vec<String> = numbers.chain([self.regimes.join(" ")]).collect();
        if let Some(tensor) = &self.tensor {
            cells.extend(tensor.cells(&number));
        }
        cells
    }
}

impl Serialize for Row {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, number) in self.names.iter().zip(self.numbers) {
            // JSON has no infinity: frictionless bodies have the word `inf`.
            if number.is_finite() {
                map.serialize_entry(name, &number)?;
            } else {
                map.serialize_entry(name, "inf")?;
            }
        }
        map.serialize_entry("R_x", &self.restitution)?;
        map.serialize_entry("regimes", &self.regimes)?;
        if let Some(tensor) = &self.tensor {
            map.serialize_entry("tensor", tensor)?;
        }
        map.end()
    }
}

/// Writes rows in a format; holds those of a table only.
pub(super) struct Printer {
    format: Format,
    heads: Vec<&'static str>,
    is_begun: bool,
    held: Vec<Vec<String>>,
}

impl Printer {
    pub(super) fn new(format: Format, plane: &Plane<'_>, tensor: Option<Tensor>) -> Self {
        let mut heads = vec![plane.names[0], plane.names[1], "R_x", "regimes"];
        if tensor.is_some() {
            heads.extend(tensor::HEADS);
        }
        Self { format, heads, is_begun: false, held: Vec::new() }
    }

    /// Writes some rows.
    pub(super) fn print(&mut self, rows: &[Row], results: &mut Results) -> Result<(), CliError> {
        let mut text = String::new();
        match self.format {
            Format::None => {}
            Format::Table => self.held.extend(rows.iter().map(|row| row.cells(short))),
            Format::Csv => {
                let cells: Vec<_> = rows.iter().map(|row| row.cells(|x| x.to_string())).collect();
                let heads = (!self.is_begun).then_some(self.heads.as_slice());
                text = csv_rows(heads, &cells)?;
            }
            Format::Json => {
                for (i, row) in rows.iter().enumerate() {
                    text.push_str(if self.is_begun || i > 0 { ",\n  " } else { "[\n  " });
                    let row = serde_json::to_string_pretty(row)
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
            Format::Table => results.put(table(&self.heads, &self.held).as_bytes()),
            Format::Json => results.put(b"\n]\n"),
            Format::Csv | Format::None => Ok(()),
        }
    }
}
