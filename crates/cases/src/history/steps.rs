//! The steps of a history from a CSV file.

use crate::Error;
use crate::case::shortened;
use crate::input::CaseFile;
use crate::numbers::{NumberTable, TableError};
use carom_laws::law::Shift;
use std::path::Path;

const COLUMNS: [&str; 4] = ["zeta", "xi", "eta", "omega"];
/// Number of columns that a file must have; the others are optional.
const OPTIONAL: usize = 3;

/// An error in a CSV file of steps.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StepsError {
    /// The file is not a table of numbers.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A column is missing.
    #[error(
        "column `{0}` is missing: the columns must be zeta, xi, eta and optionally omega, in any order"
    )]
    Missing(&'static str),
    /// An unknown column.
    #[error(
        "unknown column `{0}`: the columns must be zeta, xi, eta and optionally omega, in any order, in m and rad, without units \
         behind their names"
    )]
    Unknown(String),
    /// The table has no rows.
    #[error("there is no step: at least one row must follow the header")]
    Empty,
}

/// Reads the steps from the file that a case names.
///
/// # Errors
/// If it cannot be read, is not a text of at most 64 MiB, lacks a column or has an unknown one, or a value is
/// not a finite number.
pub fn read(case: &CaseFile, name: &Path) -> Result<Vec<Shift>, Error> {
    parse(&case.table(name)?).map_err(|source| Error::from(source).of_file(&case.beside(name)))
}

fn parse(text: &str) -> Result<Vec<Shift>, StepsError> {
    let mut table = NumberTable::new(text)?;
    let heads = &table.heads;
    if let Some(unknown) = heads.iter().find(|head| !COLUMNS.contains(&head.as_str())) {
        return Err(StepsError::Unknown(shortened(unknown)));
    }
    let places = COLUMNS.map(|column| heads.iter().position(|head| head == column));
    let lacking = COLUMNS[..OPTIONAL].iter().zip(places).find(|(_, place)| place.is_none());
    if let Some((column, _)) = lacking {
        return Err(StepsError::Missing(column));
    }
    let mut shifts = Vec::new();
    while let Some(row) = table.next_row()? {
        let [zeta, xi, eta, omega] = places.map(|place| place.map_or(0.0, |place| row[place]));
        shifts.push(Shift { zeta, xi, eta, omega });
    }
    if shifts.is_empty() { Err(StepsError::Empty) } else { Ok(shifts) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_in_any_order() {
        let shifts = parse("xi, zeta, eta\n1e-6, 2e-6, 0\n-1,2,3\n").unwrap();
        assert_eq!(shifts[0], Shift { zeta: 2e-6, xi: 1e-6, ..Shift::default() });
        assert_eq!(shifts[1].xi, -1.0);
        let twisted = parse("omega,zeta,xi,eta\n0.5,1,0,0\n").unwrap();
        assert_eq!(twisted, [Shift { zeta: 1.0, omega: 0.5, ..Shift::default() }]);
    }

    #[test]
    fn bad_files_are_explained() {
        let long = format!("unknown column `{}...`", "x".repeat(200));
        for (text, message) in [
            ("zeta,xi\n1,2\n", "column `eta` is missing"),
            ("zeta,xi,eta,theta\n", "unknown column `theta`"),
            ("zeta,xi,eta\n", "there is no step"),
            (&format!("zeta,xi,eta,{}\n", "x".repeat(1000)), &long),
            ("zeta,xi,eta\n1,nan,0\n", "line 2: `xi` = nan is out of range"),
            ("zeta,xi,eta\n1,2,3\n1,2,x\n", "line 3: `eta` = x is out of range"),
            ("zeta,xi,eta\n1,2\n", "CSV error"),
            ("zeta,xi,eta,omega\n1,2,3,inf\n", "line 2: `omega` = inf is out of range"),
            ("zeta,xi,omega\n1,2,3\n", "column `eta` is missing"),
        ] {
            let error = parse(text).unwrap_err().to_string();
            assert!(error.starts_with(message), "{error}");
        }
    }
}
