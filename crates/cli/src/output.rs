//! Results on standard output and in the plot file; messages on standard error.
//!
//! A command works out everything first and hands it over as an [`Answer`]; nothing is written
//! before it has succeeded.

use crate::case::CaseError;
use crate::error::CliError;
use comfy_table::{CellAlignment, Table, presets::UTF8_FULL_CONDENSED};
use serde::Serialize;
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// Format of the results.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// A table to read.
    #[default]
    Table,
    /// JSON with full precision.
    Json,
    /// Comma-separated values with full precision.
    Csv,
}

/// Everything a command has to say.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Answer {
    /// For standard output.
    pub text: String,
    /// For standard error.
    pub warnings: Vec<String>,
    /// For a file.
    pub plot: Option<PlotFile>,
}

/// A plot and where it goes.
#[derive(Debug, Clone, PartialEq)]
pub struct PlotFile {
    /// The file.
    pub path: PathBuf,
    /// The SVG.
    pub svg: String,
}

impl Answer {
    /// Writes the plot, the warnings and the results.
    ///
    /// # Errors
    /// If the plot file or standard output cannot be written.
    pub fn write(&self) -> Result<(), CliError> {
        if let Some(PlotFile { path, svg }) = &self.plot {
            std::fs::write(path, svg).map_err(|source| CliError::io("write", path, source))?;
        }
        for warning in &self.warnings {
            eprintln!("warning: {warning}");
        }
        let mut stdout = std::io::stdout().lock();
        match stdout.write_all(self.text.as_bytes()).and_then(|()| stdout.flush()) {
            // A reader that has seen enough is no failure.
            Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
            result => {
                result.map_err(|source| CliError::io("write", Path::new("standard output"), source))
            }
        }
    }
}

/// Reads and parses the case file at `path`.
///
/// # Errors
/// If it cannot be read, or says something that cannot be.
pub fn read_case<T>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, CaseError>,
) -> Result<T, CliError> {
    let source =
        std::fs::read_to_string(path).map_err(|error| CliError::io("read", path, error))?;
    parse(&source).map_err(|source| CliError::Case { path: path.to_owned(), source })
}

/// Refuses results that are no finite numbers: the cells of `rows` under their heads.
///
/// # Errors
/// [`CliError::Overflow`] that names the first.
pub fn check_finite(path: &Path, heads: &[&str], rows: &[Vec<String>]) -> Result<(), CliError> {
    for (i, row) in rows.iter().enumerate() {
        for (cell, head) in row.iter().zip(heads) {
            if let Some(value) = cell.parse().ok().filter(|value: &f64| !value.is_finite()) {
                let quantity = match rows.len() {
                    1 => (*head).to_owned(),
                    _ => format!("{head} in row {}", i + 1),
                };
                return Err(CliError::Overflow { path: path.to_owned(), quantity, value });
            }
        }
    }
    Ok(())
}

/// `results` as JSON.
///
/// # Errors
/// If they cannot be put so.
pub fn json<T: Serialize>(results: &T) -> Result<String, CliError> {
    let mut text =
        serde_json::to_string_pretty(results).map_err(|error| CliError::Format(error.into()))?;
    text.push('\n');
    Ok(text)
}

/// `rows` under their heads as comma-separated values.
///
/// # Errors
/// If a row is not as long as the heads.
pub fn csv(heads: &[&str], rows: &[Vec<String>]) -> Result<String, CliError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(heads).map_err(|error| CliError::Format(error.into()))?;
    for row in rows {
        writer.write_record(row).map_err(|error| CliError::Format(error.into()))?;
    }
    let bytes = writer.into_inner().map_err(|error| CliError::Format(error.into_error().into()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// `rows` under their heads as a table to read, numbers to the right.
#[must_use]
pub fn table(heads: &[&str], rows: &[Vec<String>]) -> String {
    let mut table = Table::new();
    table.load_style(UTF8_FULL_CONDENSED);
    table.set_header(heads);
    table.add_rows(rows);
    for index in 0..heads.len() {
        let is_numeric = rows.iter().all(|row| {
            row.get(index).is_some_and(|cell| cell == "-" || cell.parse::<f64>().is_ok())
        });
        if let (true, Some(column)) = (is_numeric, table.column_mut(index)) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    format!("{table}\n")
}

/// A number with six significant digits, to read.
#[must_use]
pub fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        size if !size.is_finite() || (1e-4..1e6).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_to_read_are_short() {
        for (value, text) in [
            (1.0 / 3.0, "0.333333"),
            (-12345678.0, "-1.23457e7"),
            (1e-5, "1e-5"),
            (-0.0, "0"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn what_is_no_number_is_named() {
        let rows = [vec!["1".to_owned(), "inf".to_owned()], vec!["NaN".to_owned(), "a".to_owned()]];
        let check = |rows| check_finite(Path::new("case.toml"), &["x", "y"], rows);
        assert!(check(&rows[..1]).unwrap_err().to_string().starts_with("case.toml: y = inf, no"));
        let swapped = [rows[1].clone(), rows[1].clone()];
        assert!(check(&swapped).unwrap_err().to_string().contains("x in row 1 = NaN"));
        assert!(check(&[vec!["-".to_owned(), "1e300".to_owned()]]).is_ok());
    }

    #[test]
    fn rows_in_every_format() {
        let rows = [vec!["1".to_owned(), "a, b".to_owned()]];
        assert_eq!(csv(&["x", "name"], &rows).unwrap(), "x,name\n1,\"a, b\"\n");
        assert!(csv(&["x"], &rows).is_err());
        insta::assert_snapshot!(table(&["value", "name"], &rows), @r"
        ┌───────┬──────┐
        │ value ┆ name │
        ╞═══════╪══════╡
        │     1 ┆ a, b │
        └───────┴──────┘
        ");
    }
}
