//! Files for the readers that take paths.

use std::path::{Path, PathBuf};

/// A folder of a target, in memory if there is one for files. The next run takes the same, so that only one process of
/// a target may run at a time.
pub struct Folder(PathBuf);

impl Folder {
    pub fn new(target: &str) -> Self {
        let memory = Path::new("/dev/shm");
        let base = if memory.is_dir() { memory.to_owned() } else { std::env::temp_dir() };
        let folder = base.join(format!("carom-fuzz-{target}"));
        std::fs::create_dir_all(&folder).expect("a folder for files");
        Self(folder)
    }

    /// Writes a file and returns its path.
    pub fn write(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).expect("room for a file");
        path
    }
}
