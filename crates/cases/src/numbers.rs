//! Tables of numbers in text files, separated by commas, semicolons or tabs.

use crate::case::shortened;
use csv::{Reader, ReaderBuilder, StringRecord, Trim};

/// An error in a table of numbers.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// The text is not a table.
    #[error("{0}")]
    Csv(String),
    /// A value is not a finite number.
    #[error("line {line}: `{column}` = {found} is out of range: must be a finite number")]
    Value {
        /// Line, from 1.
        line: u64,
        /// The header of its column, or its place in the row.
        column: String,
        /// The value as written.
        found: String,
    },
}

/// Rows of numbers below a header, read one by one.
#[derive(Debug)]
pub struct NumberTable<'a> {
    /// The names of the columns.
    pub heads: Vec<String>,
    reader: Reader<&'a [u8]>,
    record: StringRecord,
    row: Vec<f64>,
}

impl<'a> NumberTable<'a> {
    /// Starts to read a table.
    ///
    /// # Errors
    /// [`TableError`] if it has no header.
    pub fn new(text: &'a str) -> Result<Self, TableError> {
        let mut reader = builder(text).from_reader(text.as_bytes());
        let heads = reader.headers().map_err(|error| TableError::Csv(error.to_string()))?;
        let heads = heads.iter().map(str::to_owned).collect();
        Ok(Self { heads, reader, record: StringRecord::new(), row: Vec::new() })
    }

    /// The next row, with one number for each column; none after the last.
    ///
    /// # Errors
    /// [`TableError`] if the row is longer or shorter than the header, or a value is not a finite number.
    pub fn next_row(&mut self) -> Result<Option<&[f64]>, TableError> {
        let is_there = self.reader.read_record(&mut self.record);
        if !is_there.map_err(|error| TableError::Csv(error.to_string()))? {
            return Ok(None);
        }
        let heads = &self.heads;
        let column = |place: usize| heads.get(place).cloned().unwrap_or_default();
        self.row.clear();
        numbers(&self.record, column, &mut self.row)?;
        Ok(Some(&self.row))
    }
}

/// Rows without a header, of any lengths.
///
/// # Errors
/// [`TableError`] if a value is not a finite number.
pub fn bare(text: &str) -> Result<Vec<Vec<f64>>, TableError> {
    let mut reader = builder(text).has_headers(false).flexible(true).from_reader(text.as_bytes());
    let row = |record: Result<StringRecord, csv::Error>| {
        let record = record.map_err(|error| TableError::Csv(error.to_string()))?;
        let mut row = Vec::with_capacity(record.len());
        numbers(&record, |place| format!("value {}", place + 1), &mut row)?;
        Ok(row)
    };
    reader.records().map(row).collect()
}

/// The separator of a table: the first comma, semicolon or tab of its first line.
#[must_use]
pub fn delimiter(text: &str) -> u8 {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    first.bytes().find(|byte| b",;\t".contains(byte)).unwrap_or(b',')
}

fn builder(text: &str) -> ReaderBuilder {
    let mut builder = ReaderBuilder::new();
    builder.trim(Trim::All).delimiter(delimiter(text));
    builder
}

/// Adds the numbers of a record to a row.
fn numbers(
    record: &StringRecord,
    column: impl Fn(usize) -> String,
    row: &mut Vec<f64>,
) -> Result<(), TableError> {
    for (place, found) in record.iter().enumerate() {
        let number = found.parse().ok().filter(|number: &f64| number.is_finite());
        row.push(number.ok_or_else(|| TableError::Value {
            line: record.position().map_or(0, csv::Position::line),
            column: shortened(&column(place)),
            found: shortened(found),
        })?);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headed(text: &str) -> Result<(Vec<String>, Vec<Vec<f64>>), TableError> {
        let (mut table, mut rows) = (NumberTable::new(text)?, Vec::new());
        while let Some(row) = table.next_row()? {
            rows.push(row.to_vec());
        }
        Ok((table.heads, rows))
    }

    #[test]
    fn commas_semicolons_and_tabs_separate() {
        for text in ["1, 2\n\n3,4e0\n", "1;2\n3;4\n", "1\t2\r\n3\t 4\n"] {
            assert_eq!(bare(text).unwrap(), [[1.0, 2.0], [3.0, 4.0]], "{text:?}");
        }
        let (heads, rows) = headed("x; y\n1; 2\n").unwrap();
        assert_eq!((heads.len(), rows), (2, vec![vec![1.0, 2.0]]));
        assert!(bare("").unwrap().is_empty());
    }

    #[test]
    fn what_is_no_number_is_named_with_its_place() {
        for text in ["1,2\n3,x\n", "1,2\n3,nan\n", "1,2\n3,inf\n", "1,2\n3,\n"] {
            let error = bare(text).unwrap_err().to_string();
            assert!(error.starts_with("line 2: `value 2` = "), "{error}");
            let error = headed(&format!("x,y\n{text}")).unwrap_err().to_string();
            assert!(error.starts_with("line 3: `y` = "), "{error}");
        }
        assert!(matches!(headed("x,y\n1\n"), Err(TableError::Csv(_))));
    }
}
