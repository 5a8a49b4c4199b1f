//! The data of a figure as comma-separated values.

use crate::figure::{Cell, Figure, Table};

/// All series of a figure, one point per row: panel, series, x, y.
///
/// # Errors
/// If the writer fails.
pub fn series_csv(figure: &Figure) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["panel", "series", "x", "y"])?;
    for (i, panel) in figure.panels.iter().enumerate() {
        let panel_name =
            if panel.title.is_empty() { (i + 1).to_string() } else { panel.title.clone() };
        for series in &panel.series {
            for point in &series.points {
                let (x, y) = (point.x.to_string(), point.y.to_string());
                writer.write_record([&panel_name, &series.label, &x, &y])?;
            }
        }
    }
    finish(writer)
}

/// A table with column heads.
///
/// # Errors
/// If a row is not as long as the heads.
pub fn table_csv(table: &Table) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&table.columns)?;
    for row in &table.rows {
        writer.write_record(row.iter().map(|cell| match cell {
            Cell::Number(value) => value.to_string(),
            Cell::Text(text) | Cell::Remark(text) => text.clone(),
        }))?;
    }
    finish(writer)
}

fn finish(writer: csv::Writer<Vec<u8>>) -> Result<String, csv::Error> {
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_plot::{Panel, Series};

    #[test]
    fn one_point_a_row() {
        let mut figure = Figure::new();
        let mut panel = Panel::new("x", "y");
        panel.add(Series::line("a, b", [(0.1, 1e-9), (2.0, 3.0)]));
        figure.panel(panel);
        let csv = series_csv(&figure).unwrap();
        assert_eq!(csv, "panel,series,x,y\n1,\"a, b\",0.1,0.000000001\n1,\"a, b\",2,3\n");
    }

    #[test]
    fn rows_are_as_long_as_the_heads() {
        let mut table = Table::new("", ["k", "e"]);
        table.row([0.0, 7.5]);
        assert_eq!(table_csv(&table).unwrap(), "k,e\n0,7.5\n");
        table.row([0.0]);
        assert!(table_csv(&table).is_err());
    }
}
