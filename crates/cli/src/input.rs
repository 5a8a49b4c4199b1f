//! Reading what the user gives: text files of a bounded size.

use crate::case::CaseError;
use crate::error::CliError;
use std::fs::{File, Metadata};
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// Bytes of a case file, at most.
const MOST_OF_CASE: u64 = 1 << 20;
/// Bytes of a table, at most.
const MOST_OF_TABLE: u64 = 64 << 20;

/// The text of a case file and where it came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseFile {
    /// The file.
    pub path: PathBuf,
    text: String,
}

impl CaseFile {
    /// Reads the case file at `path`, once.
    ///
    /// # Errors
    /// If it cannot be read, is a device, larger than 1 MiB, or no UTF-8.
    pub fn read(path: &Path) -> Result<Self, CliError> {
        Ok(Self { path: path.to_owned(), text: read_text(path, MOST_OF_CASE)? })
    }

    /// What the text says.
    ///
    /// # Errors
    /// [`CliError::Case`] if it says something that cannot be.
    pub fn parse<'a, T>(
        &'a self,
        parse: impl Fn(&'a str) -> Result<T, CaseError>,
    ) -> Result<T, CliError> {
        parse(&self.text).map_err(|source| CliError::Case { path: self.path.clone(), source })
    }
}

/// Reads the table at `path`.
///
/// # Errors
/// If it cannot be read, is a device, larger than 64 MiB, or no UTF-8.
pub fn read_table(path: &Path) -> Result<String, CliError> {
    read_text(path, MOST_OF_TABLE)
}

/// Reads the file at `path`, whatever it holds.
///
/// # Errors
/// If it cannot be read, is a device, or larger than 64 MiB.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, CliError> {
    read(path, MOST_OF_TABLE, "a file")
}

fn read_text(path: &Path, most: u64) -> Result<String, CliError> {
    String::from_utf8(read(path, most, "a text file")?).map_err(|error| {
        let place = error.utf8_error().valid_up_to() + 1;
        let allowed = format!("must be a text file of at most {} MiB", most >> 20);
        let reason = format!("byte {place} is no UTF-8 text; it {allowed}, saved as UTF-8");
        CliError::Input { path: path.to_owned(), reason }
    })
}

fn read(path: &Path, most: u64, kind: &str) -> Result<Vec<u8>, CliError> {
    let refused = |reason: String| CliError::Input { path: path.to_owned(), reason };
    let failed = |error| CliError::io("read", path, error);
    let allowed = format!("must be {kind} of at most {} MiB", most >> 20);
    if is_device(&std::fs::metadata(path).map_err(failed)?) {
        return Err(refused(format!("this is a device; it {allowed}")));
    }
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(most + 1).read_to_end(&mut bytes))
        .map_err(failed)?;
    if bytes.len() as u64 > most {
        return Err(refused(format!("the file is larger; it {allowed}")));
    }
    Ok(bytes)
}

#[cfg(unix)]
fn is_device(metadata: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    metadata.file_type().is_char_device() || metadata.file_type().is_block_device()
}

#[cfg(not(unix))]
fn is_device(_: &Metadata) -> bool {
    false
}
