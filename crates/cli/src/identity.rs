//! Which file a name means, whatever the way it is written.

use carom_cases::input::STANDARD_INPUT;
use std::ffi::OsString;
#[cfg(unix)]
use std::fs::{File, Metadata};
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

/// Links that are followed one after another, at most.
const MOST_LINKS: usize = 40;

/// Device and number of a file.
#[cfg(unix)]
type Number = (u64, u64);
/// The path past all links.
#[cfg(not(unix))]
type Number = PathBuf;

/// A file: equal for all names of one, through links, hard links and folders.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Identity {
    /// One that exists.
    There(Number),
    /// One that does not exist yet: its folder, and its name there.
    Absent(Number, OsString),
}

impl Identity {
    /// That of `path`; `-` is standard input, where that comes from a file.
    ///
    /// # Errors
    /// If neither the file nor its folder is there.
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

    /// That of the file that standard input comes from, if it is one.
    #[cfg(unix)]
    fn of_input() -> Option<Self> {
        of_stream(std::io::stdin())
    }

    /// That of the file that standard output goes to, if it is one.
    #[cfg(unix)]
    pub(crate) fn of_output() -> Option<Self> {
        of_stream(std::io::stdout())
    }

    /// That of the file that standard error goes to, if it is one.
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

/// The place that `path` means past all links, also where nothing is yet: a link to nothing means the
/// place that it names.
///
/// # Errors
/// If its folder is not there, or links lead round.
pub(crate) fn resolved(path: &Path) -> Result<PathBuf, Error> {
    let mut place = path.to_owned();
    for _ in 0..MOST_LINKS {
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

/// The folder that a file is in.
pub(crate) fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}
