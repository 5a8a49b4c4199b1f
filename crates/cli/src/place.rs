//! A place that a run may write to.

use std::path::{Path, PathBuf};

/// A path that may be written to, with all links resolved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place(PathBuf);

impl Place {
    /// A claimed place; all links in the path are resolved.
    pub(crate) const fn claimed(path: PathBuf) -> Self {
        Self(path)
    }

    /// A place in a folder owned by the run.
    pub(crate) fn owned(folder: &Path, name: &str) -> Self {
        Self(folder.join(name))
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }
}
