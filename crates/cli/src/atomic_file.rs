//! A file that is written under a temporary name and moved into place when it is complete.
//!
//! The temporary name contains the final name and the process number, and the file is locked until
//! it is in place. A file left by a killed process can thus be distinguished from one being
//! written.

use crate::error::CliError;
use crate::identity::folder;
use crate::place::Place;
use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io::{Error, Write as _};
use std::path::{Path, PathBuf};

/// Ending of temporary names.
const ENDING: &str = ".carom";

/// A file under a temporary name; removed unless it is [put in place](AtomicFile::put_in_place).
#[derive(Debug)]
pub(crate) struct AtomicFile<'a> {
    place: &'a Path,
    temporary: PathBuf,
    /// Locked while it is open.
    file: Option<File>,
}

impl<'a> AtomicFile<'a> {
    /// Writes `bytes` under a temporary name beside `place`.
    ///
    /// # Errors
    /// [`CliError::Io`].
    pub(crate) fn write(place: &'a Place, bytes: &[u8]) -> Result<Self, CliError> {
        let place = place.path();
        let mut name = OsString::from(".");
        name.push(place.file_name().unwrap_or_default());
        name.push(format!(".{}{ENDING}", std::process::id()));
        let temporary = folder(place).join(name);
        let failed = |error| CliError::io("write", place, error);
        // Follows no link and replaces no file.
        let file = File::options().write(true).create_new(true).open(&temporary).map_err(failed)?;
        let mut written = Self { place, temporary, file: Some(file) };
        written.fill(bytes).map_err(failed)?;
        Ok(written)
    }

    fn fill(&mut self, bytes: &[u8]) -> Result<(), Error> {
        let Some(file) = &mut self.file else { return Ok(()) };
        // On file systems without locks, the process number alone identifies the owner.
        let _ = file.try_lock();
        file.write_all(bytes)?;
        if let Ok(metadata) = std::fs::metadata(self.place) {
            file.set_permissions(metadata.permissions())?;
        }
        file.sync_all()
    }

    /// Moves the complete file into place.
    ///
    /// # Errors
    /// [`CliError::Io`].
    pub(crate) fn put_in_place(mut self) -> Result<(), CliError> {
        std::fs::rename(&self.temporary, self.place)
            .map_err(|error| CliError::io("write", self.place, error))?;
        self.file = None;
        Ok(())
    }
}

impl Drop for AtomicFile<'_> {
    fn drop(&mut self) {
        if self.file.is_some() {
            let _ = std::fs::remove_file(&self.temporary);
        }
    }
}

/// Removes temporary files of ended processes beside `place`.
pub(crate) fn clear(place: &Place) {
    let name = place.path().file_name().unwrap_or_default().to_owned();
    clear_in(folder(place.path()), |is_own| *is_own == *name);
}

/// Removes temporary files of ended processes in `folder`, for final names that satisfy `is_own`.
pub(crate) fn clear_in(folder: &Path, is_own: impl Fn(&OsStr) -> bool) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let Some((of, process)) = name.to_str().and_then(parts) else { continue };
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if is_file && is_own(of.as_ref()) && is_dead(&entry.path(), process) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Whether this is the name of a temporary file.
pub(crate) fn is_temporary(name: &OsStr) -> bool {
    name.to_str().and_then(parts).is_some()
}

/// The final name and the process number in a temporary name.
fn parts(name: &str) -> Option<(&str, u32)> {
    let (of, process) = name.strip_prefix('.')?.strip_suffix(ENDING)?.rsplit_once('.')?;
    Some((of, process.parse().ok()?))
}

/// Whether the writing process has ended: no process has its number, and the file is not locked.
fn is_dead(path: &Path, process: u32) -> bool {
    // The command line of a zombie process is empty.
    let line = std::fs::read(format!("/proc/{process}/cmdline"));
    let is_there = process != std::process::id() && line.is_ok_and(|line| !line.is_empty());
    !is_there && File::open(path).is_ok_and(|file| file.try_lock().is_ok())
}
