//! Rows of results in every output format, from their columns.

use crate::error::CliError;
use crate::format::Chosen;
use crate::output::{Format, csv};
use crate::page::Page;
use crate::round_off::{clear_round_off, without_round_off};
use carom_cases::{Error, ErrorKind};
use carom_table::{
    Cell, Column, Quantity, Value, cells, described, heads, labels, row, short, texts as texts_of,
    yes_or_no,
};
use rayon::prelude::*;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A record as a map from column names to values; absent values are omitted.
#[derive(Debug)]
pub struct Record<'a, R> {
    columns: &'a [Column<R>],
    record: &'a R,
}

impl<'a, R> Record<'a, R> {
    /// These columns of a record.
    #[must_use]
    pub const fn new(columns: &'a [Column<R>], record: &'a R) -> Self {
        Self { columns, record }
    }
}

impl<R> Serialize for Record<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Fields(&row(self.columns, Some(self.record))).serialize(serializer)
    }
}

/// Records as a list of maps from column names to values.
#[derive(Debug)]
pub struct Records<'a, R>(pub &'a [Column<R>], pub &'a [R]);

impl<R> Serialize for Records<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.1.iter().map(|record| Record::new(self.0, record)))
    }
}

/// The cells of a row as a map; absent values are omitted.
#[derive(Debug)]
pub struct Fields<'a>(pub &'a [Cell]);

impl Serialize for Fields<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        add_fields(&mut map, self.0)?;
        map.end()
    }
}

/// Adds the cells of a row to a map; absent values are omitted.
///
/// # Errors
/// The errors of the map.
pub fn add_fields<M: SerializeMap>(map: &mut M, row: &[Cell]) -> Result<(), M::Error> {
    for cell in row {
        let name = cell.name();
        match cell.value() {
            // JSON has no infinity; it is written as a word.
            Value::Number(value) if value.is_infinite() => {
                map.serialize_entry(name, if *value > 0.0 { "inf" } else { "-inf" })?;
            }
            Value::Number(value) => map.serialize_entry(name, value)?,
            Value::Count(count) => map.serialize_entry(name, count)?,
            Value::Flag(flag) => map.serialize_entry(name, yes_or_no(*flag))?,
            Value::Text(text) => map.serialize_entry(name, text)?,
            Value::Words(words) => map.serialize_entry(name, words)?,
            Value::Texts(texts) => map.serialize_entry(name, texts)?,
            Value::Vector(parts) => map.serialize_entry(name, parts)?,
            Value::Undefined => map.serialize_entry(name, &None::<f64>)?,
            Value::Absent => {}
        }
    }
    Ok(())
}

/// The records as rows: comma-separated values with all digits, or a table to read; empty in the
/// other formats.
///
/// # Errors
/// If they cannot be written in this format.
pub fn rows<R>(format: Format, columns: &[Column<R>], records: &[R]) -> Result<String, CliError> {
    match format {
        Format::Csv => {
            let text = |record: &R| cells(columns, record, |value| value.to_string());
            csv(&heads(columns), &records.iter().map(text).collect::<Vec<_>>())
        }
        Format::Table(page) => {
            let text = |record: &R| to_read(row(columns, Some(record)));
            Ok(page.records(&labels(columns), &records.iter().map(text).collect::<Vec<_>>()))
        }
        Format::Chosen(chosen) => {
            let cells: Vec<Vec<Cell>> =
                records.iter().map(|record| row(columns, Some(record))).collect();
            chosen_rows(chosen, &heads(columns), &labels(columns), &cells)
        }
        Format::Json | Format::None => Ok(String::new()),
    }
}

/// The chosen ones of these columns.
fn chosen_rows(
    chosen: Chosen,
    heads: &[String],
    labels: &[String],
    cells: &[Vec<Cell>],
) -> Result<String, CliError> {
    let places = chosen.places(heads)?;
    let pick = |texts: &[String]| -> Vec<String> {
        places.iter().map(|place| texts[*place].clone()).collect()
    };
    match chosen.page {
        Some(page) => {
            let rows: Vec<_> = cells.iter().map(|row| pick(&to_read(row.clone()))).collect();
            Ok(page.records(&pick(labels), &rows))
        }
        None => {
            let text = |row: &Vec<Cell>| pick(&texts_of(row, |value| value.to_string()));
            csv(&pick(heads), &cells.iter().map(text).collect::<Vec<_>>())
        }
    }
}

/// Rows of cells with the heads of the first row, as [`rows`].
///
/// # Errors
/// If they cannot be written in this format.
pub fn cell_rows(format: Format, cells: &[Vec<Cell>]) -> Result<String, CliError> {
    let first = cells.first().map_or(&[][..], Vec::as_slice);
    match format {
        Format::Csv => {
            let text = |row: &Vec<Cell>| texts_of(row, |value| value.to_string());
            csv(&heads(first), &cells.iter().map(text).collect::<Vec<_>>())
        }
        Format::Table(page) => {
            let text = |row: &Vec<Cell>| to_read(row.clone());
            Ok(page.records(&labels(first), &cells.iter().map(text).collect::<Vec<_>>()))
        }
        Format::Chosen(chosen) => chosen_rows(chosen, &heads(first), &labels(first), cells),
        Format::Json | Format::None => Ok(String::new()),
    }
}

/// A row to read: numbers with six digits; a component of a vector, a force, a shift or a torque that
/// is round-off beside the others is written as zero.
#[must_use]
pub fn to_read(mut row: Vec<Cell>) -> Vec<String> {
    clear_round_off(&mut row);
    texts_of(&row, short)
}

/// A table to read of few columns with texts, which wrap where the page is too narrow.
#[must_use]
pub fn texts<R>(page: Page, columns: &[Column<R>], records: &[R]) -> String {
    let rows: Vec<_> = records.iter().map(|record| cells(columns, record, short)).collect();
    page.texts(&labels(columns), &rows)
}

/// A table to read, with one line for each cell of a row that has a value.
#[must_use]
pub fn upright(page: Page, row: &[Cell]) -> String {
    let line = |cell: &Cell| {
        let value = match cell.value() {
            Value::Absent => return None,
            Value::Words(words) if words.is_empty() => return None,
            Value::Undefined => "-".to_owned(),
            Value::Vector(parts) => vector(*parts),
            _ => texts_of(std::slice::from_ref(cell), short).concat(),
        };
        Some([cell.name(), &value, cell.unit(), cell.meaning()].map(str::to_owned).to_vec())
    };
    page.texts(
        &["quantity", "value", "unit", "meaning"],
        &row.iter().filter_map(line).collect::<Vec<_>>(),
    )
}

/// Three components to read; one that is round-off beside the largest is written as zero.
fn vector(value: [f64; 3]) -> String {
    without_round_off(value).map(short).join("  ")
}

/// Checks that all numbers are finite.
///
/// # Errors
/// [`ErrorKind::Overflow`] that names the first that is not.
pub fn check<R: Sync>(columns: &[Column<R>], records: &[R]) -> Result<(), CliError> {
    let all = records.len();
    check_rows(records, [0, all], |record| row(columns, Some(record)))
}

/// Checks that all numbers are finite in a part of `all` rows, of which the first has this index,
/// from 0.
///
/// # Errors
/// [`ErrorKind::Overflow`] that names the first that is not.
pub fn check_rows<R: Sync>(
    rows: &[R],
    [first, all]: [usize; 2],
    cells: impl Fn(&R) -> Vec<Cell> + Sync,
) -> Result<(), CliError> {
    let wrong = rows.par_iter().enumerate().find_map_first(|(i, row)| {
        let (head, value) = infinite(&cells(row))?;
        let quantity = if all == 1 { head } else { format!("{head} in row {}", first + i + 1) };
        Some(Error::from(ErrorKind::Overflow { quantity, value }))
    });
    wrong.map_or(Ok(()), |error| Err(error.into()))
}

/// The head and the value of the first number that is not finite.
fn infinite(row: &[Cell]) -> Option<(String, f64)> {
    row.iter().find_map(|cell| {
        let numbers: &[f64] = match cell.value() {
            Value::Number(number) => std::slice::from_ref(number),
            Value::Vector(parts) => parts,
            _ => &[],
        };
        let part = numbers.iter().position(|value| !value.is_finite())?;
        Some((heads(std::slice::from_ref(cell)).swap_remove(part), numbers[part]))
    })
}

/// A paragraph of help that explains the columns.
#[must_use]
pub fn help(title: &str, columns: &[impl Quantity]) -> String {
    format!("{title}:\n{}", described(columns))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_named() {
        let row = |x: f64, y: [f64; 3]| {
            vec![Cell::new("x", "m", "", x), Cell::new("t", "", "", "inf"), of_vector(y)]
        };
        fn of_vector(value: [f64; 3]) -> Cell {
            Column::vector("v", "", "", |value: &[f64; 3]| (*value).into()).cell(Some(&value))
        }
        let check = |rows: &[Vec<Cell>]| check_rows(rows, [0, rows.len()], Clone::clone);
        let error = |rows: &[Vec<Cell>]| check(rows).unwrap_err().to_string();
        let bad = row(1.0, [0.0, f64::INFINITY, 0.0]);
        assert!(error(std::slice::from_ref(&bad)).starts_with("v_y = inf is"));
        assert!(error(&[row(1.0, [0.0; 3]), row(f64::NAN, [0.0; 3])]).contains("x in row 2 = NaN"));
        assert!(check(&[row(1e300, [0.0; 3])]).is_ok());
    }

    #[test]
    fn a_row_of_a_block_is_counted_from_the_first_of_all() {
        let row = |x: f64| vec![Cell::new("x", "m", "", x)];
        let rows = [row(1.0), row(f64::INFINITY), row(2.0)];
        let error = check_rows(&rows, [200, 500], Clone::clone).unwrap_err();
        assert!(error.to_string().contains("x in row 202 = inf"), "{error}");
    }

    #[test]
    fn an_infinity_keeps_its_sign_in_json() {
        let numbers = [("a", f64::NEG_INFINITY), ("b", f64::INFINITY), ("c", -2.5)];
        let row = numbers.map(|(name, x)| Cell::new(name, "m", "", x));
        let written = serde_json::to_value(Fields(&row)).unwrap();
        assert_eq!(written, serde_json::json!({ "a": "-inf", "b": "inf", "c": -2.5 }));
    }
}
