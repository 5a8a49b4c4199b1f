//! Snapshots: the inputs, claims and rounded numbers of a figure as text files in the repository.
//!
//! A stored number stands for the interval that rounds to it. A new value is compared with that
//! interval, widened by a tenth, so that a difference in the last bit between machines does not
//! matter, even next to a rounding boundary. Therefore these are not snapshots of `insta`, which
//! compares text. A new snapshot is accepted only if all claims hold.

mod difference;
mod lines;

use crate::figure::Figure;
pub use difference::{Change, Difference};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Result of the comparison of a figure with its snapshot.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Comparison {
    /// Equal to the stored digits.
    Same,
    /// The snapshot was missing or different, and the new one was written.
    Written,
    /// The snapshot is missing.
    Missing,
    /// The snapshot is different.
    Differs(Difference),
}

impl Comparison {
    /// Whether the snapshot agrees with the figure.
    #[must_use]
    pub const fn agrees(&self) -> bool {
        matches!(self, Self::Same | Self::Written)
    }

    /// The result as a word.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Same | Self::Written => "agrees",
            Self::Missing => "none",
            Self::Differs(_) => "differs",
        }
    }
}

/// What to do with a snapshot that is missing or different.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Policy {
    /// Report it.
    Check,
    /// Write the new one, if every claim of the page holds.
    Update,
}

/// Compares `figure` with its snapshot in `folder`.
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

/// The new snapshot of `figure`.
#[must_use]
pub fn text(figure: &Figure) -> String {
    lines::text(&lines::of(figure))
}

/// Writes `text` as the snapshot of figure `id`. If this fails, the old one remains.
///
/// # Errors
/// If it cannot be written.
pub fn accept(folder: &Path, id: &str, text: &str) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    let aside = folder.join(format!(".{id}.new"));
    std::fs::write(&aside, text)?;
    std::fs::rename(aside, path(folder, id))
}

/// The snapshot file of figure `id`.
#[must_use]
pub fn path(folder: &Path, id: &str) -> PathBuf {
    folder.join(format!("{id}.txt"))
}

/// The files in `folder` that are snapshots of none of `ids`, sorted by name.
///
/// # Errors
/// If the folder cannot be read; a folder that does not exist has no files.
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
