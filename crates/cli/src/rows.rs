//! Rows of results on their way out, block by block, so that none need be held but those of a table to
//! read.

use crate::error::CliError;
use crate::output::{Format, Results, csv_rows, short, table};
use carom_table::{Cell, Column, heads, labels, texts};
use rayon::prelude::*;
use serde::Serialize;

/// Rows of a table to read, at most: its columns are as wide as their widest row.
pub const MOST_TO_READ: usize = 10_000;
/// Rows in flight: made at once, in parallel, then written in their order.
pub const BLOCK: usize = 1024;

/// Ok if so many rows can be written in this format.
///
/// # Errors
/// [`CliError::Options`] for more rows than one can read in a table.
pub const fn check_count(format: Format, count: usize) -> Result<(), CliError> {
    match format {
        Format::Table if count > MOST_TO_READ => Err(CliError::Options(TOO_MANY_TO_READ)),
        _ => Ok(()),
    }
}

const TOO_MANY_TO_READ: &str =
    "more than 10000 rows make no table to read; choose --format csv, json or none";

/// Writes rows of cells in a format.
#[derive(Debug)]
pub struct Rows {
    format: Format,
    list: JsonList,
    /// Heads of the columns that a table to read shows; all without.
    chosen: Option<Vec<&'static str>>,
    /// What stands in a row, as heads of comma-separated values or labels of a table.
    head: Vec<String>,
    /// Of the columns of a table.
    places: Vec<usize>,
    is_begun: bool,
    held: Vec<Vec<String>>,
}

impl Rows {
    /// In this format: of JSON a list.
    #[must_use]
    pub fn new(format: Format) -> Self {
        Self {
            format,
            list: JsonList::new(0),
            chosen: None,
            head: Vec::new(),
            places: Vec::new(),
            is_begun: false,
            held: Vec::new(),
        }
    }

    /// A list that stands in JSON at this depth.
    #[must_use]
    pub fn at_depth(self, depth: usize) -> Self {
        Self { list: JsonList::new(depth), ..self }
    }

    /// With these heads only in a table to read.
    #[must_use]
    pub fn showing(self, chosen: Vec<&'static str>) -> Self {
        Self { chosen: Some(chosen), ..self }
    }

    /// Of records with these columns, which stand over them even if there is none.
    #[must_use]
    pub fn of<R>(self, columns: &[Column<R>]) -> Self {
        let head = if self.format == Format::Table { labels(columns) } else { heads(columns) };
        Self { head, ..self }
    }

    /// Writes some rows: their cells, or `json`, which puts a row as it stands in JSON at a depth.
    ///
    /// # Errors
    /// If they are too many for a table, cannot be put so, or cannot be written.
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
            Format::Table => {
                check_count(self.format, self.held.len() + rows.len())?;
                let (all, places) = (self.chosen.is_none(), &self.places);
                let pick = |texts: Vec<String>| match all {
                    true => texts,
                    false => places.iter().map(|place| texts[*place].clone()).collect(),
                };
                self.held.par_extend(rows.par_iter().map(|row| pick(texts(&cells(row), short))));
                Ok(())
            }
            Format::Csv => {
                let text = |row: &R| texts(&cells(row), |value| value.to_string());
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
            Format::Table => {
                let is_chosen =
                    |head: &str| self.chosen.as_ref().is_none_or(|chosen| chosen.contains(&head));
                let heads = heads(first);
                let places = (0..heads.len()).filter(|place| is_chosen(&heads[*place]));
                self.places = places.collect();
                let labels = labels(first);
                self.head = self.places.iter().map(|place| labels[*place].clone()).collect();
                Ok(())
            }
            Format::Json | Format::None => Ok(()),
        }
    }

    /// What ends the rows: of a table all of it.
    ///
    /// # Errors
    /// If no row can be put so.
    pub fn finish(self) -> Result<String, CliError> {
        match self.format {
            Format::None => Ok(String::new()),
            Format::Table => Ok(table(&self.head, &self.held)),
            Format::Csv if self.is_begun => Ok(String::new()),
            Format::Csv => csv_rows(Some(self.head.as_slice()), &[]),
            Format::Json => Ok(self.list.end()),
        }
    }
}

/// Rows that a thread puts into a format at once.
const PART: usize = 64;

/// What is made of the rows, in their order.
fn parts<R: Sync, T: Send>(
    rows: &[R],
    make: impl Fn(&[R]) -> Result<T, CliError> + Sync,
) -> Result<Vec<T>, CliError> {
    rows.par_chunks(PART).map(&make).collect()
}

/// A list of JSON, written item by item.
#[derive(Debug, Clone, Copy)]
struct JsonList {
    depth: usize,
    is_begun: bool,
}

impl JsonList {
    /// That stands at this depth.
    const fn new(depth: usize) -> Self {
        Self { depth, is_begun: false }
    }

    /// An item that is indented already, with what stands before it.
    fn item(&mut self, item: &str) -> String {
        let before = if self.is_begun { ",\n" } else { "[\n" };
        self.is_begun = true;
        format!("{before}{}{item}", "  ".repeat(self.depth + 1))
    }

    /// What ends it.
    fn end(&self) -> String {
        let line = if self.depth == 0 { "\n" } else { "" };
        match self.is_begun {
            true => format!("\n{}]{line}", "  ".repeat(self.depth)),
            false => format!("[]{line}"),
        }
    }
}

/// `value` as JSON that stands at this depth.
///
/// # Errors
/// If it cannot be put so.
pub fn indented(value: &impl Serialize, depth: usize) -> Result<String, CliError> {
    let text =
        serde_json::to_string_pretty(value).map_err(|error| CliError::Format(error.into()))?;
    Ok(text.replace('\n', &format!("\n{}", "  ".repeat(depth))))
}
