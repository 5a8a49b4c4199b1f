//! Results to read: each number with its estimated error.

use crate::columns::to_read;
use crate::page::Page;
use carom_cases::contact::{COLUMNS, Row};
use carom_table::{Column, Value, labels};

/// The end of the name of an error.
const ERROR: &str = "_error";
/// An error below this part of its number is that of a given one.
const NO_ERROR: f64 = 1e-9;

/// The table of the cases.
pub(super) fn table(page: Page, rows: &[Row]) -> String {
    let (errors, values): (Vec<_>, Vec<_>) =
        COLUMNS.iter().copied().partition(|column| column.name().ends_with(ERROR));
    let error_of = |column: &Column<Row>| {
        errors.iter().find(|error| error.name().strip_suffix(ERROR) == Some(column.name())).copied()
    };
    let text = |row: &Row| -> Vec<String> {
        let cells = values.iter().map(|column| column.cell(Some(row))).collect();
        let texts = to_read(cells).into_iter().zip(&values);
        let with_error = |(text, column): (String, &Column<Row>)| match (
            column.value(row),
            error_of(column).map(|error| error.value(row)),
        ) {
            (Value::Number(number), Some(Value::Number(error)))
                if error > NO_ERROR * number.abs() && number != 0.0 =>
            {
                format!("{text} ± {error:.0e}")
            }
            _ => text,
        };
        texts.map(with_error).collect()
    };
    page.records(&labels(&values), &rows.iter().map(text).collect::<Vec<_>>())
}
