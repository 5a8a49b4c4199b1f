//! The files of a run: SVG and CSV for each figure, and the report.

use crate::catalogue::Entry;
use crate::data::{series_csv, table_csv};
use crate::report;
use crate::run::{Drawn, Outcome};
use std::path::{Path, PathBuf};

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The system refused.
    #[error("cannot write {}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// Its reason.
        source: std::io::Error,
    },
    /// The data do not make a table.
    #[error(transparent)]
    Csv(#[from] csv::Error),
}

/// Writes SVG, CSV and the report of all outcomes into `folder`; returns the report's path.
///
/// # Errors
/// If a file cannot be written.
pub fn write(
    folder: &Path,
    catalogue: &[Entry],
    outcomes: &[Outcome],
) -> Result<PathBuf, WriteError> {
    std::fs::create_dir_all(folder)
        .map_err(|source| WriteError::Io { path: folder.to_owned(), source })?;
    for outcome in outcomes {
        if let Ok(drawn) = &outcome.result {
            write_figure(folder, &stem(outcome.entry), drawn)?;
        }
    }
    let path = folder.join("report.html");
    write_file(&path, &report::html(catalogue, outcomes))?;
    Ok(path)
}

/// `fig-5.3` or `table-13.1`.
fn stem(entry: Entry) -> String {
    if entry.id.starts_with("table-") { entry.id.to_owned() } else { format!("fig-{}", entry.id) }
}

fn write_figure(folder: &Path, stem: &str, drawn: &Drawn) -> Result<(), WriteError> {
    if let Some(svg) = &drawn.svg {
        write_file(&folder.join(format!("{stem}.svg")), svg)?;
        write_file(&folder.join(format!("{stem}.csv")), &series_csv(&drawn.figure)?)?;
    }
    for (i, table) in drawn.figure.tables.iter().enumerate() {
        let name = match (&drawn.svg, drawn.figure.tables.len()) {
            (None, 1) => format!("{stem}.csv"),
            _ => format!("{stem}-table-{}.csv", i + 1),
        };
        write_file(&folder.join(name), &table_csv(table)?)?;
    }
    Ok(())
}

fn write_file(path: &Path, text: &str) -> Result<(), WriteError> {
    std::fs::write(path, text).map_err(|source| WriteError::Io { path: path.to_owned(), source })
}
