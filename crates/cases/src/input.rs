//! Reads input files of limited size.

use crate::case::{Case, CaseError, CaseFault, meant};
use crate::{Error, ErrorKind};
use std::fmt;
use std::fs::{File, FileType};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The path that stands for standard input.
pub const STANDARD_INPUT: &str = "-";
/// Largest case file, in bytes.
const MOST_OF_CASE: u64 = 1 << 20;
/// Largest table, in bytes.
const MOST_OF_TABLE: u64 = 64 << 20;
/// Largest map of heights, in bytes.
pub const MOST_OF_MAP: u64 = 4 << 30;
const TEXT: &str = "a text file";

/// What a file of cases must be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expected {
    what: &'static str,
    most: u64,
    hint: &'static str,
}

impl Expected {
    /// A case in TOML.
    pub const CASE: Self = Self {
        what: "a case in TOML, a text file",
        most: MOST_OF_CASE,
        hint: "; a case in TOML is expected there: `carom new` prints one, and - is standard input",
    };
    /// An input of CONTACT.
    pub const CONTACT: Self = Self {
        what: "an input of CONTACT, a text file",
        most: MOST_OF_TABLE,
        hint: "; an input of CONTACT is expected there, and - is standard input",
    };
}

/// Decides whether a file may be read; a file that the same run writes may not.
pub type Guard =
    Arc<dyn Fn(&Path) -> Result<(), Box<dyn std::error::Error + Send + Sync>> + Send + Sync>;

/// The text of a case file and where it came from.
#[derive(Clone)]
pub struct CaseFile {
    /// The file.
    pub path: PathBuf,
    text: String,
    guard: Option<Guard>,
}

impl fmt::Debug for CaseFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, text, .. } = self;
        f.debug_struct("CaseFile").field("path", path).field("text", text).finish_non_exhaustive()
    }
}

/// What errors call a case that is given as a text.
const GIVEN: &str = "the case given";

impl CaseFile {
    /// Reads the case file at `path`; `-` is standard input.
    ///
    /// # Errors
    /// As [`CaseFile::read_guarded`].
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::read_unguarded(path, Expected::CASE, None)
    }

    /// A case from its text; files that it names are beside the present folder.
    #[must_use]
    pub fn from_text(text: impl Into<String>) -> Self {
        Self { path: PathBuf::from(STANDARD_INPUT), text: text.into(), guard: None }
    }

    /// Reads a case file if the guard allows it; files that the case names are checked by the guard too.
    ///
    /// # Errors
    /// If the guard does not allow it, or it cannot be read, is a device or a pipe, is larger than 1 MiB (an
    /// input of CONTACT: 64 MiB), or is not UTF-8.
    pub fn read_guarded(path: &Path, expected: Expected, guard: Guard) -> Result<Self, Error> {
        guard(path).map_err(ErrorKind::Refused)?;
        Self::read_unguarded(path, expected, Some(guard))
    }

    /// A case that is given as a text; files that it names are relative to the present folder.
    #[must_use]
    pub fn of_text(text: String) -> Self {
        Self { path: GIVEN.into(), text, guard: None }
    }

    fn read_unguarded(
        path: &Path,
        Expected { what, most, hint }: Expected,
        guard: Option<Guard>,
    ) -> Result<Self, Error> {
        let text = if path == Path::new(STANDARD_INPUT) {
            let bytes = bounded(std::io::stdin().lock(), path, most, what)?;
            text(bytes, path, most, what)?
        } else {
            read_text(path, most, what).map_err(|error| error.hinting(hint))?
        };
        Ok(Self { path: path.to_owned(), text, guard })
    }

    /// The whole text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The path of a file that the case names: relative to the case file, or to the present folder for
    /// standard input.
    #[must_use]
    pub fn beside(&self, name: &Path) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    /// Reads a table that the case names.
    ///
    /// # Errors
    /// If the guard does not allow it, or it cannot be read, is a device or a pipe, is larger than 64 MiB, or
    /// is not UTF-8.
    pub fn table(&self, name: &Path) -> Result<String, Error> {
        let path = self.beside(name);
        self.check(&path)?;
        read_text(&path, MOST_OF_TABLE, TEXT)
    }

    /// Reads a file that the case names, of any format.
    ///
    /// # Errors
    /// As [`CaseFile::table`], except for UTF-8.
    pub fn bytes(&self, name: &Path) -> Result<Vec<u8>, Error> {
        let path = self.beside(name);
        self.check(&path)?;
        read(&path, MOST_OF_TABLE, "a file")
    }

    /// Reads a map of heights that the case names.
    ///
    /// # Errors
    /// As [`CaseFile::bytes`]; it may have 4096 MiB.
    pub fn map(&self, name: &Path) -> Result<Vec<u8>, Error> {
        let path = self.beside(name);
        self.check(&path)?;
        read(&path, MOST_OF_MAP, "a file")
    }

    fn check(&self, path: &Path) -> Result<(), Error> {
        let guarded = self.guard.as_ref().map_or(Ok(()), |guard| guard(path));
        guarded.map_err(|refused| ErrorKind::Refused(refused).into())
    }

    /// Parses the text as a case of one kind.
    ///
    /// # Errors
    /// [`ErrorKind::Case`] if the text has an error, or looks like a case of another kind.
    pub fn parse<'a, C: Case<'a>>(&'a self) -> Result<C, Error> {
        self.parse_by(C::parse)
    }

    /// The same by a reader of its own.
    ///
    /// # Errors
    /// As [`CaseFile::parse`].
    pub fn parse_by<'a, C: Case<'a>>(
        &'a self,
        parse: impl Fn(&'a str) -> Result<C, CaseError>,
    ) -> Result<C, Error> {
        self.told(|source| parse(source).map_err(|error| meant(&C::SCHEMA, source, error)))
    }

    /// What `tell` finds in the text.
    ///
    /// # Errors
    /// [`ErrorKind::Case`] for an error in the text.
    pub fn told<'a, T>(
        &'a self,
        tell: impl Fn(&'a str) -> Result<T, CaseError>,
    ) -> Result<T, Error> {
        let told = |mut source: CaseError| {
            if let CaseFault::Syntax { message, .. } = &mut source.fault {
                *message += &of_ending(&self.path);
            }
            let message = source.shown_in(&self.text);
            Error::from(ErrorKind::Case { source, message }).of_file(&self.path)
        };
        tell(&self.text).map_err(told)
    }

    /// The result of a computation of this case; an error that names no file names this one.
    ///
    /// # Errors
    /// Those of `compute`.
    pub fn follow<T>(&self, compute: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
        compute().map_err(|error| error.of_file(&self.path))
    }
}

/// What a file with this ending is, if it is no case.
fn of_ending(path: &Path) -> String {
    match path.extension().and_then(|ending| ending.to_str()) {
        None | Some("toml" | "txt") => String::new(),
        Some("inp") => {
            "; .inp is an input of CONTACT, which `carom contact` solves; a case ends in .toml"
                .to_owned()
        }
        Some(ending) => format!("; a case ends in .toml, not in .{ending}"),
    }
}

fn allowed(most: u64, kind: &str) -> String {
    format!("must be {kind} of at most {} MiB", most >> 20)
}

/// Reads a text of the size of a table that stands beside a case.
///
/// # Errors
/// If it cannot be read, is a device or a pipe, is larger than 64 MiB, or is not UTF-8.
pub fn read_table(path: &Path) -> Result<String, Error> {
    read_text(path, MOST_OF_TABLE, TEXT)
}

fn read_text(path: &Path, most: u64, kind: &str) -> Result<String, Error> {
    text(read(path, most, kind)?, path, most, kind)
}

fn text(bytes: Vec<u8>, path: &Path, most: u64, kind: &str) -> Result<String, Error> {
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to() + 1;
        let allowed = allowed(most, kind);
        // The marks of UTF-16 at the beginning of a file.
        let is_wide = matches!(error.as_bytes(), [0xff, 0xfe, ..] | [0xfe, 0xff, ..]);
        let found = if is_wide { ", but UTF-16, as PowerShell writes it" } else { "" };
        let reason = format!("byte {place} is not UTF-8 text{found}; it {allowed}, saved as UTF-8");
        Error::input(reason).of_file(path)
    })
}

/// Reads the file at `path`, of at most `most` bytes.
///
/// # Errors
/// If it cannot be read, is a device or a pipe, or larger.
pub fn read(path: &Path, most: u64, kind: &str) -> Result<Vec<u8>, Error> {
    bounded(open(path, &allowed(most, kind))?, path, most, kind)
}

/// Opens the file at `path`; `allowed` describes in errors what it must be.
///
/// # Errors
/// If it cannot be opened, or is a device or a pipe. Those are not opened: a pipe waits for a writer, and
/// opening a device may have side effects.
pub fn open(path: &Path, allowed: &str) -> Result<File, Error> {
    let failed = |error| Error::io("read", path, error);
    let check = |of: FileType| match special(of) {
        Some(what) => {
            let reason = format!("this is {what}; it {allowed}");
            Err(Error::input(reason).of_file(path))
        }
        None => Ok(()),
    };
    check(std::fs::metadata(path).map_err(failed)?.file_type())?;
    let file = File::open(path).map_err(failed)?;
    check(file.metadata().map_err(failed)?.file_type())?;
    Ok(file)
}

/// Reads everything, up to `most` bytes.
fn bounded(source: impl Read, path: &Path, most: u64, kind: &str) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    source
        .take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| Error::io("read", path, error))?;
    if bytes.len() as u64 > most {
        let allowed = allowed(most, kind);
        let reason = format!("the file is larger; it {allowed}");
        return Err(Error::input(reason).of_file(path));
    }
    Ok(bytes)
}

/// The name of a special file; none for regular files and folders, which fail on reading.
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
