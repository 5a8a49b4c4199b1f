//! Identity of a file, however its name is written.

use carom_cases::input::STANDARD_INPUT;
use std::ffi::OsString;
#[cfg(unix)]
use std::fs::{File, Metadata};
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

/// Largest number of links followed one after another.
const MAX_LINKS: usize = 40;

/// Device and inode number of a file.
#[cfg(unix)]
type Number = (u64, u64);
/// The path with all links resolved.
#[cfg(not(unix))]
type Number = PathBuf;

/// Identity of a file: equal for all its names, through links, hard links and folders.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Identity {
    /// A file that exists.
    There(Number),
    /// A file that does not exist yet: its folder, and its name there.
    Absent(Number, OsString),
}

impl Identity {
    /// The identity of `path`; `-` is standard input, if that is a file.
    ///
    /// # Errors
    /// If neither the file nor its folder exists.
    pub(crate) fn of(path: &Path) -> Result<Self, Error> {
        if path == Path::new(STANDARD_INPUT) {
            return Self::of_input().ok_or_else(|| ErrorKind::NotFound.into());
        }
        let place = resolved(path)?;
        match number(&place) {
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let name = place.file_name().ok_or(ErrorKind::InvalidInput)?.to_owned();
                Ok(Self::Absent(number(folder(&place))?, name))
            }
            number => number.map(Self::There),
        }
    }

    /// The identity of the file that standard input reads, if it is a file.
    #[cfg(unix)]
    fn of_input() -> Option<Self> {
        of_stream(std::io::stdin())
    }

    /// The identity of the file that standard output writes, if it is a file.
    #[cfg(unix)]
    pub(crate) fn of_output() -> Option<Self> {
        of_stream(std::io::stdout())
    }

    /// The identity of the file that standard error writes, if it is a file.
    #[cfg(unix)]
    pub(crate) fn of_messages() -> Option<Self> {
        of_stream(std::io::stderr())
    }

    #[cfg(not(unix))]
    fn of_input() -> Option<Self> {
        None
    }

    #[cfg(not(unix))]
    pub(crate) fn of_output() -> Option<Self> {
        None
    }

    #[cfg(not(unix))]
    pub(crate) fn of_messages() -> Option<Self> {
        None
    }
}

#[cfg(unix)]
fn of_stream(stream: impl std::os::fd::AsFd) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt as _;
    let file = File::from(stream.as_fd().try_clone_to_owned().ok()?);
    let metadata = file.metadata().ok().filter(Metadata::is_file)?;
    Some(Identity::There((metadata.dev(), metadata.ino())))
}

#[cfg(unix)]
fn number(path: &Path) -> Result<Number, Error> {
    use std::os::unix::fs::MetadataExt as _;
    std::fs::metadata(path).map(|metadata| (metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn number(path: &Path) -> Result<Number, Error> {
    path.canonicalize()
}

/// The path with all links resolved, also if the target does not exist yet: a dangling link is
/// resolved to its target.
///
/// # Errors
/// If its folder does not exist, or links form a cycle.
pub(crate) fn resolved(path: &Path) -> Result<PathBuf, Error> {
    let mut place = path.to_owned();
    for _ in 0..MAX_LINKS {
        match place.canonicalize() {
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            known => return known,
        }
        match std::fs::read_link(&place) {
            Ok(target) => place = folder(&place).join(target),
            Err(_) => {
                let name = place.file_name().ok_or(ErrorKind::NotFound)?;
                return Ok(folder(&place).canonicalize()?.join(name));
            }
        }
    }
    Err(Error::other("too many links"))
}

/// The folder of a file.
pub(crate) fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}
