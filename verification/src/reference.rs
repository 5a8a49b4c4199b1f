//! Reference values from independent programs, kept as CSV under `data/`.
//!
//! Each file says in its first lines, which begin with `#`, where its values come from, how exact
//! they are and when they were made.

use crate::Failure;

/// A reader of CSV that passes over the lines with `#`.
pub(crate) fn reader(csv: &str) -> csv::Reader<&[u8]> {
    csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(csv.as_bytes())
}

/// The rows of a CSV with one line of heads, as numbers.
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
