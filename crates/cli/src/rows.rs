//! Writes rows of results block by block. Only tables to read are held in memory.

use crate::columns::to_read;
use crate::error::CliError;
use crate::format::Chosen;
use crate::output::{Format, Results, csv_rows};
use carom_table::{Cell, Column, heads, labels, texts};
use rayon::prelude::*;
use serde::Serialize;

/// Largest number of rows of a table to read: columns are as wide as their widest row.
pub const MOST_TO_READ: usize = 10_000;
/// Rows per block: computed in parallel, then written in their order.
pub const BLOCK: usize = 1024;

/// Checks that this number of rows can be written in this format.
///
/// # Errors
/// [`CliError::Options`] for more rows than a table to read may have.
pub const fn check_count(format: Format, count: usize) -> Result<(), CliError> {
    match format {
        Format::Table(_) | Format::Chosen(Chosen { page: Some(_), .. }) if count > MOST_TO_READ => {
            Err(CliError::Options(TOO_MANY_TO_READ))
        }
        _ => Ok(()),
    }
}

const TOO_MANY_TO_READ: &str =
    "a table to read has at most 10000 rows; choose --format csv, json or none";

/// Writes rows of cells in a format.
#[derive(Debug)]
pub struct Rows {
    format: Format,
    list: JsonList,
    /// Heads of the columns shown in a table to read; `None` for all.
    chosen: Option<Vec<&'static str>>,
    /// Heads of comma-separated values, or labels of a table.
    head: Vec<String>,
    /// Indices of the columns shown in a table.
    places: Vec<usize>,
    /// How many columns a table leaves out.
    left_out: usize,
    is_begun: bool,
    table_rows: Vec<Vec<String>>,
}

impl Rows {
    /// A writer for this format; in JSON, the rows form a list.
    #[must_use]
    pub fn new(format: Format) -> Self {
        Self {
            format,
            list: JsonList::new(0),
            chosen: None,
            head: Vec::new(),
            places: Vec::new(),
            left_out: 0,
            is_begun: false,
            table_rows: Vec::new(),
        }
    }

    /// A list at this depth of indentation in JSON.
    #[must_use]
    pub fn at_depth(self, depth: usize) -> Self {
        Self { list: JsonList::new(depth), ..self }
    }

    /// Shows only these heads in a table to read.
    #[must_use]
    pub fn showing(self, chosen: Vec<&'static str>) -> Self {
        Self { chosen: Some(chosen), ..self }
    }

    /// Rows of records with these columns; the heads are written even without rows.
    #[must_use]
    pub fn of<R>(self, columns: &[Column<R>]) -> Self {
        let head = if self.format.is_table() { labels(columns) } else { heads(columns) };
        Self { head, ..self }
    }

    /// Writes some rows: their cells, or for JSON the text of `json`, which formats a row at a
    /// depth.
    ///
    /// # Errors
    /// If they are too many for a table, cannot be formatted, or cannot be written.
    pub fn put<R: Sync>(
        &mut self,
        rows: &[R],
        cells: impl Fn(&R) -> Vec<Cell> + Sync,
        json: impl Fn(&R, usize) -> Result<String, CliError> + Sync,
        results: &mut Results,
    ) -> Result<(), CliError> {
        if let (false, Some(first)) = (self.is_begun, rows.first()) {
            self.begin(&cells(first), results)?;
        }
        match self.format {
            Format::None => Ok(()),
            Format::Table(_) => {
                check_count(self.format, self.table_rows.len() + rows.len())?;
                let (all, places) = (self.chosen.is_none(), &self.places);
                let pick = |texts: Vec<String>| match all {
                    true => texts,
                    false => places.iter().map(|place| texts[*place].clone()).collect(),
                };
                self.table_rows.par_extend(rows.par_iter().map(|row| pick(to_read(cells(row)))));
                Ok(())
            }
            Format::Chosen(Chosen { page: Some(_), .. }) => {
                check_count(self.format, self.table_rows.len() + rows.len())?;
                let pick = |texts: Vec<String>| picked(&texts, &self.places);
                self.table_rows.par_extend(rows.par_iter().map(|row| pick(to_read(cells(row)))));
                Ok(())
            }
            Format::Csv | Format::Chosen(_) => {
                let all = self.format == Format::Csv;
                let text = |row: &R| {
                    let texts = texts(&cells(row), |value| value.to_string());
                    if all { texts } else { picked(&texts, &self.places) }
                };
                let made = parts(rows, |rows: &[R]| {
                    csv_rows(None::<&[&str]>, &rows.iter().map(text).collect::<Vec<_>>())
                })?;
                made.iter().try_for_each(|text| results.put(text.as_bytes()))
            }
            Format::Json => {
                let depth = self.list.depth + 1;
                let made = parts(rows, |rows: &[R]| {
                    rows.iter().map(|row| json(row, depth)).collect::<Result<Vec<_>, _>>()
                })?;
                let mut items = made.iter().flatten();
                items.try_for_each(|item| results.put(self.list.item(item).as_bytes()))
            }
        }
    }

    fn begin(&mut self, first: &[Cell], results: &mut Results) -> Result<(), CliError> {
        self.is_begun = true;
        match self.format {
            Format::Csv => results.put(csv_rows(Some(heads(first).as_slice()), &[])?.as_bytes()),
            Format::Table(_) => {
                let is_chosen =
                    |head: &str| self.chosen.as_ref().is_none_or(|chosen| chosen.contains(&head));
                let heads = heads(first);
                let places = (0..heads.len()).filter(|place| is_chosen(&heads[*place]));
                self.places = places.collect();
                self.left_out = heads.len() - self.places.len();
                let labels = labels(first);
                self.head = self.places.iter().map(|place| labels[*place].clone()).collect();
                Ok(())
            }
            Format::Chosen(chosen) => {
                let (all, labels) = (heads(first), labels(first));
                self.places = chosen.places(&all)?;
                if chosen.page.is_none() {
                    let head = picked(&all, &self.places);
                    return results.put(csv_rows(Some(head.as_slice()), &[])?.as_bytes());
                }
                self.head = picked(&labels, &self.places);
                Ok(())
            }
            Format::Json | Format::None => Ok(()),
        }
    }

    /// The end of the rows; for a table, all of it.
    ///
    /// # Errors
    /// If a row cannot be formatted.
    pub fn finish(self) -> Result<String, CliError> {
        match self.format {
            Format::None => Ok(String::new()),
            Format::Table(page) => {
                let table = page.records(&self.head, &self.table_rows);
                Ok(match self.left_out {
                    0 => table,
                    count => table + &page.fold(&format!("{count} {FURTHER}\n")),
                })
            }
            Format::Chosen(Chosen { page: Some(page), .. }) => {
                Ok(page.records(&self.head, &self.table_rows))
            }
            Format::Csv | Format::Chosen(_) if self.is_begun => Ok(String::new()),
            Format::Csv | Format::Chosen(_) => csv_rows(Some(self.head.as_slice()), &[]),
            Format::Json => Ok(self.list.end()),
        }
    }
}

/// What is told of columns that a table leaves out.
const FURTHER: &str = "further columns: choose with --columns, or see all with --format csv";

/// The texts at these places.
fn picked(texts: &[String], places: &[usize]) -> Vec<String> {
    places.iter().map(|place| texts[*place].clone()).collect()
}

/// Rows formatted by one thread at a time.
const PART: usize = 64;

/// Applies a function to parts of the rows in parallel; results in order.
fn parts<R: Sync, T: Send>(
    rows: &[R],
    make: impl Fn(&[R]) -> Result<T, CliError> + Sync,
) -> Result<Vec<T>, CliError> {
    rows.par_chunks(PART).map(&make).collect()
}

/// A JSON list, written item by item.
#[derive(Debug, Clone, Copy)]
struct JsonList {
    depth: usize,
    is_begun: bool,
}

impl JsonList {
    /// A list at this depth of indentation.
    const fn new(depth: usize) -> Self {
        Self { depth, is_begun: false }
    }

    /// An indented item with its separator.
    fn item(&mut self, item: &str) -> String {
        let before = if self.is_begun { ",\n" } else { "[\n" };
        self.is_begun = true;
        format!("{before}{}{item}", "  ".repeat(self.depth + 1))
    }

    /// The end of the list.
    fn end(&self) -> String {
        let line = if self.depth == 0 { "\n" } else { "" };
        match self.is_begun {
            true => format!("\n{}]{line}", "  ".repeat(self.depth)),
            false => format!("[]{line}"),
        }
    }
}

/// `value` as JSON at this depth of indentation.
///
/// # Errors
/// If it cannot be expressed in JSON.
pub fn indented(value: &impl Serialize, depth: usize) -> Result<String, CliError> {
    let text =
        serde_json::to_string_pretty(value).map_err(|error| CliError::Format(error.into()))?;
    Ok(text.replace('\n', &format!("\n{}", "  ".repeat(depth))))
}
