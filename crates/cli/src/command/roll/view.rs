//! The columns of a rolling contact that are shown.

use carom_cases::roll::{COLUMNS, Row};
use carom_table::Column;

/// The columns that have values; a table to read omits the last ones.
pub(super) fn columns(rows: &[Row], is_to_read: bool) -> Vec<Column<Row>> {
    let has = |name: &str| match name {
        "wear_number" | "heating" => rows.iter().all(|row| row.distance.is_none()),
        "distance" | "time" => rows.iter().any(|row| row.distance.is_some()),
        "F_x_springs" | "F_y_springs" | "springs_error" => {
            rows.iter().any(|row| row.springs.is_some())
        }
        "F_x_table" | "F_y_table" | "M_z_table" | "table_error" => {
            rows.iter().any(|row| row.table.is_some())
        }
        "error" => rows.iter().any(|row| row.estimates.is_some()),
        "residual_normal" | "residual_tangential" | "iterations" | "contact_area" => !is_to_read,
        name if name.ends_with("_error") => {
            !is_to_read && rows.iter().any(|row| row.estimates.is_some())
        }
        _ => true,
    };
    COLUMNS.iter().copied().filter(|column| has(column.name())).collect()
}
