//! Reference values from independent programs, as CSV in `data/`.
//!
//! The first lines of each file begin with `#` and state the origin, the accuracy and the date of
//! the values.

use crate::Failure;

/// A CSV reader that skips the lines with `#`.
pub(crate) fn reader(csv: &str) -> csv::Reader<&[u8]> {
    csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(csv.as_bytes())
}

/// The rows of a CSV file with one line of heads, as numbers.
pub(crate) fn rows<const N: usize>(csv: &str) -> Result<Vec<[f64; N]>, Failure> {
    let mut reader = reader(csv);
    let parse = |record: csv::StringRecord| -> Result<[f64; N], Failure> {
        let mut row = [0.0; N];
        for (value, field) in row.iter_mut().zip(&record) {
            *value = field.parse()?;
        }
        Ok(row)
    };
    reader.records().map(|record| parse(record?)).collect()
}
