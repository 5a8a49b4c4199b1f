//! Reading what the user gives: text files of a bounded size.

use crate::case::CaseError;
use crate::error::CliError;
use crate::outputs::Outputs;
use std::fs::{File, FileType};
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
    /// What no input may be.
    outputs: Outputs,
}

impl CaseFile {
    /// Reads the case file at `path`, once; `-` is standard input.
    ///
    /// # Errors
    /// As [`CaseFile::read_for`].
    pub fn read(path: &Path) -> Result<Self, CliError> {
        Self::read_for(path, Outputs::default())
    }

    /// The same in a run that writes these outputs.
    ///
    /// # Errors
    /// If an output goes to it, it cannot be read, is a device or a pipe, larger than 1 MiB, or no UTF-8.
    pub fn read_for(path: &Path, outputs: Outputs) -> Result<Self, CliError> {
        outputs.check_input(path)?;
        let text = if path == Path::new(STANDARD_INPUT) {
            let bytes = bounded(std::io::stdin().lock(), path, MOST_OF_CASE, TEXT)?;
            text(bytes, path, MOST_OF_CASE)?
        } else {
            read_text(path, MOST_OF_CASE)?
        };
        Ok(Self { path: path.to_owned(), text, outputs })
    }

    /// The whole text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Where a file is that the case names: beside the case, or in the present folder.
    #[must_use]
    pub fn beside(&self, name: &Path) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    /// Reads the table that the case names.
    ///
    /// # Errors
    /// If an output goes to it, it cannot be read, is a device or a pipe, larger than 64 MiB, or no UTF-8.
    pub fn table(&self, name: &Path) -> Result<String, CliError> {
        let path = self.beside(name);
        self.outputs.check_input(&path)?;
        read_text(&path, MOST_OF_TABLE)
    }

    /// Reads the file that the case names, whatever it holds.
    ///
    /// # Errors
    /// As [`CaseFile::table`], but for UTF-8.
    pub fn bytes(&self, name: &Path) -> Result<Vec<u8>, CliError> {
        let path = self.beside(name);
        self.outputs.check_input(&path)?;
        read(&path, MOST_OF_TABLE, "a file")
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

/// Reads the file at `path`, of at most so many bytes.
///
/// # Errors
/// If it cannot be read, is a device or a pipe, or larger.
pub(crate) fn read(path: &Path, most: u64, kind: &str) -> Result<Vec<u8>, CliError> {
    bounded(open(path, &allowed(most, kind))?, path, most, kind)
}

/// Opens the file at `path`, which must be what is `allowed`.
///
/// # Errors
/// If it cannot be opened, or is a device or a pipe: those are not opened, as a pipe waits for a writer
/// and a device does what it likes.
pub(crate) fn open(path: &Path, allowed: &str) -> Result<File, CliError> {
    let failed = |error| CliError::io("read", path, error);
    let check = |of: FileType| match special(of) {
        Some(what) => {
            let reason = format!("this is {what}; it {allowed}");
            Err(CliError::Input { path: path.to_owned(), reason })
        }
        None => Ok(()),
    };
    check(std::fs::metadata(path).map_err(failed)?.file_type())?;
    let file = File::open(path).map_err(failed)?;
    check(file.metadata().map_err(failed)?.file_type())?;
    Ok(file)
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

/// What the file is, if it is neither a file nor a folder, which cannot be read anyway.
fn special(of: FileType) -> Option<&'static str> {
    match () {
        () if of.is_file() || of.is_dir() => None,
        () if is_device(of) => Some("a device"),
        () => Some("a pipe or socket (a case comes from one as `-`)"),
    }
}

#[cfg(unix)]
fn is_device(of: FileType) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    of.is_char_device() || of.is_block_device()
}

#[cfg(not(unix))]
fn is_device(_: FileType) -> bool {
    true
}
