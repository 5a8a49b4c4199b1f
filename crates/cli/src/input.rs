//! Reading what the user gives: text files of a bounded size.

use crate::case::CaseError;
use crate::error::CliError;
use std::fs::{File, Metadata};
use std::io::Read;
use std::path::{Path, PathBuf};

/// Standard input, in the place of a file.
pub const STANDARD_INPUT: &str = "-";
/// Bytes of a case file, at most.
const MOST_OF_CASE: u64 = 1 << 20;
/// Bytes of a table, at most.
const MOST_OF_TABLE: u64 = 64 << 20;
const TEXT: &str = "a text file";

/// The text of a case file and where it came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseFile {
    /// The file.
    pub path: PathBuf,
    text: String,
}

impl CaseFile {
    /// Reads the case file at `path`, once; `-` is standard input. Files that the case names lie beside
    /// it, or in the present folder.
    ///
    /// # Errors
    /// If it cannot be read, is a device, larger than 1 MiB, or no UTF-8.
    pub fn read(path: &Path) -> Result<Self, CliError> {
        let text = if path == Path::new(STANDARD_INPUT) {
            let bytes = bounded(std::io::stdin().lock(), path, MOST_OF_CASE, TEXT)?;
            text(bytes, path, MOST_OF_CASE)?
        } else {
            read_text(path, MOST_OF_CASE)?
        };
        Ok(Self { path: path.to_owned(), text })
    }

    /// The whole text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
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

fn allowed(most: u64, kind: &str) -> String {
    format!("must be {kind} of at most {} MiB", most >> 20)
}

fn read_text(path: &Path, most: u64) -> Result<String, CliError> {
    text(read(path, most, TEXT)?, path, most)
}

fn text(bytes: Vec<u8>, path: &Path, most: u64) -> Result<String, CliError> {
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to() + 1;
        let allowed = allowed(most, TEXT);
        let reason = format!("byte {place} is no UTF-8 text; it {allowed}, saved as UTF-8");
        CliError::Input { path: path.to_owned(), reason }
    })
}

fn read(path: &Path, most: u64, kind: &str) -> Result<Vec<u8>, CliError> {
    let refused = |reason: String| CliError::Input { path: path.to_owned(), reason };
    let failed = |error| CliError::io("read", path, error);
    if is_device(&std::fs::metadata(path).map_err(failed)?) {
        return Err(refused(format!("this is a device; it {}", allowed(most, kind))));
    }
    bounded(File::open(path).map_err(failed)?, path, most, kind)
}

/// All that comes, if it is not too much.
fn bounded(source: impl Read, path: &Path, most: u64, kind: &str) -> Result<Vec<u8>, CliError> {
    let mut bytes = Vec::new();
    source
        .take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| CliError::io("read", path, error))?;
    if bytes.len() as u64 > most {
        let allowed = allowed(most, kind);
        let reason = format!("the file is larger; it {allowed}");
        return Err(CliError::Input { path: path.to_owned(), reason });
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
