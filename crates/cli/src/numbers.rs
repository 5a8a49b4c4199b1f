//! Tables of numbers in files of comma-separated values; semicolons and tabs separate too.

use csv::{ReaderBuilder, StringRecord, Trim};

/// What is wrong with a table of numbers.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// It is no table.
    #[error("{0}")]
    Csv(String),
    /// A value that is no finite number.
    #[error("line {line}: `{column}` = {found} is out of range: must be a finite number")]
    Value {
        /// Line, from 1.
        line: u64,
        /// The head of its column, or its place in the row.
        column: String,
        /// What stands there.
        found: String,
    },
}

/// Rows of numbers under heads.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberTable {
    /// The heads.
    pub heads: Vec<String>,
    /// The rows, each as long as the heads.
    pub rows: Vec<Vec<f64>>,
}

/// A table under heads.
///
/// # Errors
/// [`TableError`] if a row is longer or shorter than the heads, or a value is no finite number.
pub fn headed(text: &str) -> Result<NumberTable, TableError> {
    let mut reader = builder(text).from_reader(text.as_bytes());
    let heads = reader.headers().map_err(|error| TableError::Csv(error.to_string()))?;
    let heads: Vec<String> = heads.iter().map(str::to_owned).collect();
    let rows = numbers(reader.records(), |place| heads.get(place).cloned().unwrap_or_default())?;
    Ok(NumberTable { heads, rows })
}

/// Rows without heads, as long as they come.
///
/// # Errors
/// [`TableError`] if a value is no finite number.
pub fn bare(text: &str) -> Result<Vec<Vec<f64>>, TableError> {
    let mut reader = builder(text).has_headers(false).flexible(true).from_reader(text.as_bytes());
    numbers(reader.records(), |place| format!("value {}", place + 1))
}

/// What separates the values of a table: the first comma, semicolon or tab of its first line.
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

fn numbers(
    records: impl Iterator<Item = Result<StringRecord, csv::Error>>,
    column: impl Fn(usize) -> String,
) -> Result<Vec<Vec<f64>>, TableError> {
    let row = |record: Result<StringRecord, csv::Error>| {
        let record = record.map_err(|error| TableError::Csv(error.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |(place, found): (usize, &str)| {
            let number = found.parse().ok().filter(|number: &f64| number.is_finite());
            number.ok_or_else(|| TableError::Value {
                line,
                column: column(place),
                found: found.to_owned(),
            })
        };
        record.iter().enumerate().map(number).collect()
    };
    records.map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_semicolons_and_tabs_separate() {
        for text in ["1, 2\n\n3,4e0\n", "1;2\n3;4\n", "1\t2\r\n3\t 4\n"] {
            assert_eq!(bare(text).unwrap(), [[1.0, 2.0], [3.0, 4.0]], "{text:?}");
        }
        let table = headed("x; y\n1; 2\n").unwrap();
        assert_eq!((table.heads.len(), table.rows), (2, vec![vec![1.0, 2.0]]));
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
