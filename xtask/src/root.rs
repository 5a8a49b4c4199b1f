//! The root of the workspace, found when a task runs: a program that is moved or run elsewhere does not write to where
//! it was built.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Set by `.cargo/config.toml` for all that cargo runs.
const NAME: &str = "CAROM_WORKSPACE";

static FOUND: LazyLock<Option<PathBuf>> = LazyLock::new(|| {
    let named = std::env::var_os(NAME).map(PathBuf::from);
    let package = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let starts = [named, package, std::env::current_dir().ok()];
    let root = starts.into_iter().flatten().find_map(|start| above(&start))?;
    root.canonicalize().ok()
});

/// The root: the folder in the environment variable `CAROM_WORKSPACE`, that of the package which cargo runs, or the
/// current folder, or the first above one of these whose Cargo.toml has the workspace of carom.
///
/// # Errors
/// If there is none.
pub(crate) fn found() -> Result<&'static Path, std::io::Error> {
    FOUND.as_deref().ok_or_else(|| {
        let text = format!(
            "no workspace of carom here: run this in a folder of its sources, or set {NAME} to that of its Cargo.toml"
        );
        std::io::Error::new(std::io::ErrorKind::NotFound, text)
    })
}

/// The root; the current folder if there is none, which [`found`] tells at the start.
pub(crate) fn root() -> PathBuf {
    found().map_or_else(|_| PathBuf::from("."), Path::to_owned)
}

/// The first folder from `start` upwards with the workspace of carom.
fn above(start: &Path) -> Option<PathBuf> {
    let start = std::path::absolute(start).ok()?;
    start.ancestors().find(|folder| is_root(folder)).map(Path::to_owned)
}

fn is_root(folder: &Path) -> bool {
    let text = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
    let is = |line: &str| text.lines().any(|own| own.starts_with(line));
    is("[workspace]") && is("carom = {")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_workspace_is_found_from_below_and_not_from_elsewhere() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap();
        assert_eq!(found().unwrap(), root);
        assert_eq!(above(&root.join("xtask/src")), Some(root.clone()));
        assert_eq!(above(&root.join("no/such/folder")), Some(root.clone()));
        assert_eq!(above(root.parent().unwrap()), None);
    }
}
