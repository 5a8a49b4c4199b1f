//! The columns of a rolling contact that are shown.

use carom_cases::roll::{COLUMNS, Row};
use carom_table::Column;

/// The columns that have values; a table to read omits the last ones.
pub(super) fn columns(rows: &[Row], is_to_read: bool) -> Vec<Column<Row>> {
    let has = |name: &str| match name {
        "distance" | "time" => rows.iter().any(|row| row.distance.is_some()),
        "F_x_springs" | "F_y_springs" => rows.iter().any(|row| row.springs.is_some()),
        "residual_normal" | "residual_tangential" | "iterations" | "contact_area" => !is_to_read,
        _ => true,
    };
    COLUMNS.iter().copied().filter(|column| has(column.name())).collect()
}
