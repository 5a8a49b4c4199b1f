//! Measured data: named columns of numbers.

use crate::FitError;

/// A column of measured data.
#[derive(Debug, Clone, PartialEq)]
pub struct DataColumn {
    /// Its name: a field of the case, a quantity of its outcome, or the latter with `_sd`.
    pub name: String,
    /// Its unit as written; empty if the heading gives none.
    pub unit: String,
    /// One number for each row; NaN where none was measured.
    pub values: Vec<f64>,
}

/// Measured data, with one row for each measurement.
///
/// ```
/// use carom_fit::Data;
/// let data = Data::from_csv("angle (deg),R_x\n5,0.21\n30,\n")?;
/// assert_eq!(data.rows(), 2);
/// assert_eq!((data.columns()[0].name.as_str(), data.columns()[0].unit.as_str()), ("angle", "deg"));
/// assert!(data.columns()[1].values[1].is_nan());
/// # Ok::<(), carom_fit::FitError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Data {
    columns: Vec<DataColumn>,
}

impl Data {
    /// Data of these columns. A heading may have its unit behind it, as `time / s`, `time (s)` or `time [s]`.
    ///
    /// # Errors
    /// [`FitError::Table`] if there is no row, or the columns are of different length;
    /// [`FitError::Column`] if a name stands twice.
    pub fn new(columns: Vec<(String, Vec<f64>)>) -> Result<Self, FitError> {
        let column = |(heading, values): (String, Vec<f64>)| {
            let (name, unit) = split(&heading);
            DataColumn { name, unit, values }
        };
        let columns: Vec<DataColumn> = columns.into_iter().map(column).collect();
        let rows = columns.first().map_or(0, |column| column.values.len());
        if rows == 0 {
            return Err(FitError::Table("there is no row".to_owned()));
        }
        for (i, column) in columns.iter().enumerate() {
            if column.values.len() != rows {
                let (own, first) = (column.values.len(), &columns[0].name);
                let reason = format!("it has {own} rows, `{first}` has {rows}");
                return Err(FitError::column(&column.name, reason));
            }
            if columns[..i].iter().any(|other| other.name == column.name) {
                return Err(FitError::column(&column.name, "it stands twice"));
            }
        }
        Ok(Self { columns })
    }

    /// Data from comma-separated values with one line of headings; lines that begin with `#` are comments. Semicolons or
    /// tabs may separate as well. An empty entry was not measured.
    ///
    /// # Errors
    /// As [`Data::new`]; [`FitError::Entry`] for an entry that is not a finite number.
    pub fn from_csv(text: &str) -> Result<Self, FitError> {
        let failed = |error: csv::Error| FitError::Table(ragged(&error));
        let text = text.trim_start_matches('\u{feff}');
        let first = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#'));
        let first =
            first.ok_or_else(|| FitError::Table("there is no line of headings".to_owned()))?;
        if let Some(wrong) = no_headings(first) {
            return Err(FitError::Table(wrong));
        }
        let separator = [',', ';', '\t'].into_iter().find(|sign| first.contains(*sign));
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .delimiter(separator.map_or(b',', |sign| sign as u8))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let headings = reader.headers().map_err(failed)?.clone();
        let mut columns: Vec<(String, Vec<f64>)> =
            headings.iter().map(|heading| (heading.to_owned(), Vec::new())).collect();
        for (row, record) in reader.records().enumerate() {
            let record = record.map_err(failed)?;
            for ((heading, values), entry) in columns.iter_mut().zip(&record) {
                values.push(number(entry).ok_or_else(|| FitError::Entry {
                    column: split(heading).0,
                    row: row + 1,
                    found: format!("{entry:?}"),
                    allowed: allowed(entry),
                })?);
            }
        }
        Self::new(columns)
    }

    /// The columns.
    #[must_use]
    pub fn columns(&self) -> &[DataColumn] {
        &self.columns
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }
}

/// Why a line is no line of headings, if it is none.
fn no_headings(line: &str) -> Option<String> {
    if line.contains('=') || line.starts_with('[') {
        return Some(
            "this is a case, not a table of numbers: the case comes first, then the data"
                .to_owned(),
        );
    }
    let is_number = |entry: &str| entry.trim().parse::<f64>().is_ok();
    let all = line.split([',', ';', '\t']).all(is_number);
    all.then(|| {
        format!("the first line, \"{line}\", has numbers: headings are missing, as in \"angle (deg),R_x\"")
    })
}

/// What is wrong with a row, in words.
fn ragged(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            format!(
                "line {line} has {len} entries, the headings are {expected_len}; with decimal commas the entries are \
                 separated by semicolons"
            )
        }
        _ => error.to_string(),
    }
}

fn number(entry: &str) -> Option<f64> {
    match entry {
        "" => Some(f64::NAN),
        text => text.parse().ok().filter(|number: &f64| number.is_finite()),
    }
}

fn allowed(entry: &str) -> String {
    let point = entry.replacen(',', ".", 1);
    match point.parse::<f64>() {
        Ok(_) if point != entry => format!("a number with a point: {point}"),
        _ => "a finite number, or empty where nothing was measured".to_owned(),
    }
}

/// Name and unit of a heading.
pub(crate) fn split(heading: &str) -> (String, String) {
    let heading = heading.trim();
    let behind = |open: &str, close: &str| {
        let (name, rest) = heading.split_once(open)?;
        let unit = rest.trim_end().strip_suffix(close)?;
        Some((name.trim().to_owned(), unit.trim().to_owned()))
    };
    behind(" / ", "")
        .or_else(|| behind("(", ")"))
        .or_else(|| behind("[", "]"))
        .unwrap_or_else(|| (heading.to_owned(), String::new()))
}
