//! Snapshots: what a figure says, as text beside the code: its inputs, its claims and its
//! numbers, rounded.
//!
//! A stored number stands for the interval that rounds to it. A new value is held against that
//! interval, widened by a tenth, so that a last-bit difference between machines never shows,
//! however close a value lies to the edge between two roundings. (That is why these are not
//! snapshots of `insta`, which compares text; and accepting one asks for claims that hold.)

mod difference;
mod lines;

use crate::figure::Figure;
pub use difference::{Change, Difference};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// How a figure compares with its snapshot.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Comparison {
    /// The same to the digits kept.
    Same,
    /// There was none, or another one: the new one has been written.
    Written,
    /// There is none.
    Missing,
    /// They differ.
    Differs(Difference),
}

impl Comparison {
    /// Whether the snapshot is that of the figure.
    #[must_use]
    pub const fn agrees(&self) -> bool {
        matches!(self, Self::Same | Self::Written)
    }

    /// The word for it.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Same | Self::Written => "agrees",
            Self::Missing => "none",
            Self::Differs(_) => "differs",
        }
    }
}

/// What to do with a snapshot that is missing or differs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Policy {
    /// Report it.
    Check,
    /// Write the new one, if every claim of the page holds.
    Update,
}

/// Holds `figure` against its snapshot in `folder`.
///
/// # Errors
/// If the snapshot cannot be read.
pub fn compare(folder: &Path, figure: &Figure) -> std::io::Result<Comparison> {
    match std::fs::read_to_string(path(folder, &figure.id)) {
        Ok(stored) => Ok(difference::find(&stored, &lines::of(figure))
            .map_or(Comparison::Same, Comparison::Differs)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Comparison::Missing),
        Err(error) => Err(error),
    }
}

/// The snapshot of `figure` as it would be now.
#[must_use]
pub fn text(figure: &Figure) -> String {
    lines::text(&lines::of(figure))
}

/// Makes `text` the snapshot of figure `id`; the old one stays whole if this fails.
///
/// # Errors
/// If it cannot be written.
pub fn accept(folder: &Path, id: &str, text: &str) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    let aside = folder.join(format!(".{id}.new"));
    std::fs::write(&aside, text)?;
    std::fs::rename(aside, path(folder, id))
}

/// The file of the snapshot of figure `id`.
#[must_use]
pub fn path(folder: &Path, id: &str) -> PathBuf {
    folder.join(format!("{id}.txt"))
}

/// The files in `folder` that are not the snapshot of any of `ids`, in order of their names.
///
/// # Errors
/// If the folder cannot be read; one that does not exist has no files.
pub fn orphans<'a>(
    folder: &Path,
    ids: impl IntoIterator<Item = &'a str>,
) -> std::io::Result<Vec<PathBuf>> {
    let known: Vec<PathBuf> = ids.into_iter().map(|id| path(folder, id)).collect();
    let entries = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries?,
    };
    let mut found = Vec::new();
    for entry in entries {
        let path = entry?.path();
        if !known.contains(&path) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Table;

    fn figure() -> Figure {
        let mut figure = Figure { id: "0.1".to_owned(), ..Figure::new() };
        let mut table = Table::new("numbers", ["value"]);
        table.row([1.0]);
        figure.table(table);
        figure
    }

    #[test]
    fn missing_until_accepted_and_an_orphan_without_its_page() {
        let folder = std::env::temp_dir().join(format!("carom-snapshot-{}", std::process::id()));
        assert!(orphans(&folder, []).unwrap().is_empty());
        let figure = figure();
        assert_eq!(compare(&folder, &figure).unwrap(), Comparison::Missing);
        accept(&folder, "0.1", &text(&figure)).unwrap();
        assert_eq!(compare(&folder, &figure).unwrap(), Comparison::Same);
        assert!(orphans(&folder, ["0.1", "0.2"]).unwrap().is_empty());
        assert_eq!(orphans(&folder, ["0.2"]).unwrap(), [path(&folder, "0.1")]);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
