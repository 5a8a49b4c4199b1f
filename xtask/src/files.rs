//! Files of the workspace by their endings.

use anyhow::Context as _;
use std::path::{Path, PathBuf};

/// The files of a folder with this ending, in order.
pub(crate) fn files(folder: &Path, ending: &str) -> anyhow::Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    let paths = entries.map(|entry| Ok(entry?.path())).collect::<std::io::Result<Vec<_>>>()?;
    let has = |path: &PathBuf| path.extension().is_some_and(|end| end == ending);
    let mut paths: Vec<_> = paths.into_iter().filter(has).collect();
    paths.sort();
    Ok(paths)
}

/// Those of a folder and of the folders below it, but for what was built there.
pub(crate) fn files_below(folder: &Path, ending: &str) -> anyhow::Result<Vec<PathBuf>> {
    let mut found = files(folder, ending)?;
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let is_built = ["target", "node_modules"].iter().any(|name| path.ends_with(name));
        if path.is_dir() && !is_built {
            found.extend(files_below(&path, ending)?);
        }
    }
    found.sort();
    Ok(found)
}
