//! The files of a run: SVG, CSV and a record for each page, and the report.

use crate::catalogue::Entry;
use crate::data::{series_csv, table_csv};
use crate::page::Page;
use crate::run::{Drawn, Outcome};
use std::path::{Path, PathBuf};

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// An input/output error.
    #[error("cannot write {}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// The error of the system.
        source: std::io::Error,
    },
    /// The data cannot be written as a table.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// The record cannot be written as JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

/// The output folder of a run. The record of a page remains until the page is computed again, so
/// that the report of a partial run contains all pages.
#[derive(Debug, Clone)]
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// The folder at `path`, created if it does not exist.
    ///
    /// # Errors
    /// If it cannot be created.
    pub fn new(path: PathBuf) -> Result<Self, WriteError> {
        let folder = Self { path };
        let records = folder.records();
        std::fs::create_dir_all(&records)
            .map_err(|source| WriteError::Io { path: records, source })?;
        Ok(folder)
    }

    fn records(&self) -> PathBuf {
        self.path.join("pages")
    }

    fn record(&self, entry: Entry) -> PathBuf {
        self.records().join(format!("{}.json", entry.stem()))
    }

    /// The file for messages of a page while it is computed.
    #[must_use]
    pub fn log(&self, entry: Entry) -> PathBuf {
        self.records().join(format!("{}.log", entry.stem()))
    }

    /// The record of a page from this run or an earlier one; `None` if there is no readable one.
    #[must_use]
    pub fn load(&self, entry: Entry) -> Option<Page> {
        let text = std::fs::read_to_string(self.record(entry)).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// Saves the record of a page.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&self, entry: Entry, page: &Page) -> Result<(), WriteError> {
        write_whole(&self.record(entry), &serde_json::to_string(page)?)
    }

    /// Deletes the record of a page.
    ///
    /// # Errors
    /// If it exists and cannot be deleted.
    pub fn forget(&self, entry: Entry) -> Result<(), WriteError> {
        let path = self.record(entry);
        match std::fs::remove_file(&path) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                Err(WriteError::Io { path, source: error })
            }
            _ => Ok(()),
        }
    }

    /// Writes SVG and CSV of an outcome.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn draw(&self, outcome: &Outcome) -> Result<(), WriteError> {
        match &outcome.result {
            Ok(drawn) => draw(&self.path, &outcome.entry.stem(), drawn),
            Err(_) => Ok(()),
        }
    }

    /// Writes the report; returns its path.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn report(&self, html: &str) -> Result<PathBuf, WriteError> {
        let path = self.path.join("report.html");
        write_whole(&path, html)?;
        Ok(path)
    }
}

fn draw(folder: &Path, stem: &str, drawn: &Drawn) -> Result<(), WriteError> {
    if let Some(svg) = &drawn.svg {
        write_whole(&folder.join(format!("{stem}.svg")), svg)?;
        write_whole(&folder.join(format!("{stem}.csv")), &series_csv(&drawn.figure)?)?;
    }
    for (i, table) in drawn.figure.tables.iter().enumerate() {
        let name = match (&drawn.svg, drawn.figure.tables.len()) {
            (None, 1) => format!("{stem}.csv"),
            _ => format!("{stem}-table-{}.csv", i + 1),
        };
        write_whole(&folder.join(name), &table_csv(table)?)?;
    }
    Ok(())
}

/// Writes a file under a temporary name and renames it, so that no reader sees a part of it.
///
/// # Errors
/// If it cannot be written; the previous file then remains.
pub fn write_whole(path: &Path, text: &str) -> Result<(), WriteError> {
    let mut aside = path.as_os_str().to_owned();
    aside.push(format!(".{}.new", std::process::id()));
    std::fs::write(&aside, text)
        .and_then(|()| std::fs::rename(&aside, path))
        .map_err(|source| WriteError::Io { path: path.to_owned(), source })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn records_stay_until_they_are_replaced_or_dropped() {
        let path = std::env::temp_dir().join(format!("carom-files-{}", std::process::id()));
        let folder = Folder::new(path.clone()).unwrap();
        let entry = Entry::figure("5.3", "");
        assert_eq!(folder.load(entry), None);
        let page = Page::failed(entry, "first".to_owned(), Duration::from_secs(1));
        folder.save(entry, &page).unwrap();
        assert_eq!(Folder::new(path.clone()).unwrap().load(entry), Some(page));
        std::fs::write(folder.record(entry), "{\"id\": \"of another version\"}").unwrap();
        assert_eq!(folder.load(entry), None);
        folder.forget(entry).unwrap();
        folder.forget(entry).unwrap();
        assert!(!folder.record(entry).exists());
        std::fs::remove_dir_all(path).unwrap();
    }
}
