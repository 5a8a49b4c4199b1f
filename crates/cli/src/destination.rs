//! Where a picture goes: a file that is no input, written aside and put in place at the end, or
//! standard output.

use crate::error::CliError;
use crate::input::STANDARD_INPUT;
use crate::output::Format;
use std::fs::{File, Metadata};
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// Kind of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Vectors.
    Svg,
    /// Pixels.
    Png,
}

/// A place for a picture that may be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Destination {
    /// Standard output, as SVG.
    StandardOutput,
    /// A file.
    File {
        /// Where it is, past all links.
        path: PathBuf,
        /// What goes there.
        kind: Kind,
    },
}

impl Destination {
    /// The place that `option` asks for; nothing is written yet.
    ///
    /// # Errors
    /// [`CliError::Destination`] unless the name ends in `.svg` or `.png` and means none of
    /// `inputs` by any way, nor standard output, nor a thing that is no file; or it is `-`
    /// while standard output has nothing else to take.
    pub fn new(
        option: &'static str,
        path: &Path,
        format: Format,
        inputs: &[&Path],
    ) -> Result<Self, CliError> {
        let refused = |reason| CliError::Destination { option, path: path.to_owned(), reason };
        if path == Path::new("-") {
            return match format {
                Format::None => Ok(Self::StandardOutput),
                _ => Err(refused("standard output takes the results; add --format none")),
            };
        }
        let kind = kind(path).ok_or_else(|| refused(KINDS))?;
        Ok(Self::File { path: place(option, path, inputs)?, kind })
    }

    /// The kind of picture that goes there.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::StandardOutput => Kind::Svg,
            Self::File { kind, .. } => *kind,
        }
    }
}

/// The file that `option` asks for, past all links; nothing is written yet.
///
/// # Errors
/// [`CliError::Destination`] if it is one of `inputs` by any way, or standard output, or no file;
/// [`CliError::Io`] if its folder cannot be read.
pub fn place(option: &'static str, path: &Path, inputs: &[&Path]) -> Result<PathBuf, CliError> {
    let refused = |reason| CliError::Destination { option, path: path.to_owned(), reason };
    let place = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    if let Ok(metadata) = std::fs::metadata(&place) {
        check_replaceable(&metadata).map_err(refused)?;
        if inputs.iter().any(|input| is_same(input, &place)) {
            return Err(refused("this is an input of the same run; name another file"));
        }
        if identity_of_output().is_some_and(|output| Some(output) == identity(&place)) {
            return Err(refused("standard output goes to the same file; name another one"));
        }
    } else {
        let folder = folder(&place);
        std::fs::read_dir(folder).map_err(|error| CliError::io("write", path, error))?;
    }
    Ok(place)
}

const KINDS: &str = "a picture's name must end in .svg or .png, or be - for SVG on standard output";

fn kind(path: &Path) -> Option<Kind> {
    let ending = path.extension()?.to_str()?;
    match () {
        () if ending.eq_ignore_ascii_case("svg") => Some(Kind::Svg),
        () if ending.eq_ignore_ascii_case("png") => Some(Kind::Png),
        () => None,
    }
}

fn check_replaceable(metadata: &Metadata) -> Result<(), &'static str> {
    match metadata {
        _ if !metadata.is_file() => Err("this is no file that could be replaced"),
        _ if metadata.permissions().readonly() => Err("this file is protected against writing"),
        _ => Ok(()),
    }
}

/// Refuses to append the results to an input.
///
/// # Errors
/// [`CliError::Input`] if standard output is the file `input`.
pub fn check_output(input: &Path) -> Result<(), CliError> {
    let output = identity_of_output();
    if output.is_some() && output == identity(input) {
        let reason = "standard output goes to this input; name another file".to_owned();
        return Err(CliError::Input { path: input.to_owned(), reason });
    }
    Ok(())
}

fn is_same(one: &Path, other: &Path) -> bool {
    let identities = identity(one);
    identities.is_some() && identities == identity(other)
}

/// Device and number of a file: the same by every name, also of one that standard input comes from.
#[cfg(unix)]
fn identity(path: &Path) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    if path == Path::new(STANDARD_INPUT) {
        return identity_of(std::io::stdin());
    }
    std::fs::metadata(path).ok().map(|metadata| (metadata.dev(), metadata.ino()))
}

/// The same of standard output, if that is a file.
#[cfg(unix)]
fn identity_of_output() -> Option<(u64, u64)> {
    identity_of(std::io::stdout())
}

#[cfg(unix)]
fn identity_of(stream: impl std::os::fd::AsFd) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    let file = File::from(stream.as_fd().try_clone_to_owned().ok()?);
    let metadata = file.metadata().ok().filter(Metadata::is_file)?;
    Some((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

#[cfg(not(unix))]
fn identity_of_output() -> Option<PathBuf> {
    None
}

/// A file written beside its place; gone again unless it is [put](Aside::put_in_place) there.
#[derive(Debug)]
pub struct Aside<'a> {
    path: &'a Path,
    aside: PathBuf,
    is_done: bool,
}

impl<'a> Aside<'a> {
    /// Writes `bytes` beside `path`.
    ///
    /// # Errors
    /// [`CliError::Io`].
    pub fn write(path: &'a Path, bytes: &[u8]) -> Result<Self, CliError> {
        let mut name = std::ffi::OsString::from(".");
        name.push(path.file_name().unwrap_or_default());
        name.push(format!(".{}", std::process::id()));
        let written = Self { path, aside: folder(path).join(name), is_done: false };
        written.fill(bytes).map_err(|error| CliError::io("write", path, error))?;
        Ok(written)
    }

    fn fill(&self, bytes: &[u8]) -> std::io::Result<()> {
        let mut file = File::create(&self.aside)?;
        file.write_all(bytes)?;
        if let Ok(metadata) = std::fs::metadata(self.path) {
            file.set_permissions(metadata.permissions())?;
        }
        file.sync_all()
    }

    /// Puts it in its place, whole.
    ///
    /// # Errors
    /// [`CliError::Io`].
    pub fn put_in_place(mut self) -> Result<(), CliError> {
        std::fs::rename(&self.aside, self.path)
            .map_err(|error| CliError::io("write", self.path, error))?;
        self.is_done = true;
        Ok(())
    }
}

impl Drop for Aside<'_> {
    fn drop(&mut self) {
        if !self.is_done {
            let _ = std::fs::remove_file(&self.aside);
        }
    }
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}
