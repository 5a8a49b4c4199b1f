//! The outputs of a run. All are known before the first input is read, so that no input is
//! overwritten.
//!
//! A command first claims the places of its outputs. Each input is compared with all of them before
//! it is opened, and each output with the earlier ones. A [`Place`] can only be obtained by a
//! claim, and only places are written to.

use crate::atomic_file::is_temporary;
use crate::destination::{Destination, Kind};
use crate::error::CliError;
use crate::identity::{Identity, folder, resolved};
use crate::output::{Format, is_open};
pub use crate::place::Place;
use carom_cases::Error;
use carom_cases::input::{CaseFile, Expected};
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// All outputs of a run.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Outputs {
    results: Option<Identity>,
    messages: Option<Identity>,
    files: Vec<Claim>,
    folder: Option<(&'static str, PathBuf)>,
}

/// A file that is the value of an option.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Claim {
    option: &'static str,
    path: PathBuf,
    identity: Identity,
}

impl Claim {
    fn destination_error(&self, reason: &'static str) -> CliError {
        CliError::Destination { option: self.option, path: self.path.clone(), reason }
    }
}

impl Outputs {
    /// The outputs of every command: standard output and standard error.
    ///
    /// # Errors
    /// [`carom_cases::ErrorKind::Io`] if results are requested and standard output is closed.
    pub fn of_command(format: Format) -> Result<Self, CliError> {
        if format != Format::None {
            is_open()?;
        }
        let (results, messages) = (Identity::of_output(), Identity::of_messages());
        Ok(Self { results, messages, ..Self::default() })
    }

    /// Claims the place of the picture of `option`; nothing is written yet.
    ///
    /// # Errors
    /// [`CliError::Destination`] unless the name ends in `.svg`, `.png` or `.pdf`, or if it is `-` while
    /// results go to standard output; otherwise as [`Outputs::file`].
    pub fn picture(
        &mut self,
        option: &'static str,
        path: &Path,
        format: Format,
    ) -> Result<Destination, CliError> {
        let destination_error =
            |reason| CliError::Destination { option, path: path.to_owned(), reason };
        if path == Path::new("-") {
            return match format {
                Format::None => is_open().map(|()| Destination::StandardOutput),
                _ => Err(destination_error("results go to standard output; add --format none")),
            };
        }
        let kind = Kind::of(path).map_err(destination_error)?;
        Ok(Destination::File { place: self.file(option, path)?, kind })
    }

    /// Claims the place of the file of `option`; nothing is written yet. Links are followed, also
    /// dangling ones.
    ///
    /// # Errors
    /// [`CliError::Destination`] if it is standard output, another output, or not a file that may
    /// be replaced; [`carom_cases::ErrorKind::Io`] if its folder cannot be read.
    pub fn file(&mut self, option: &'static str, path: &Path) -> Result<Place, CliError> {
        let failed = |error| CliError::io("write", path, error);
        let place = resolved(path).map_err(failed)?;
        let identity = Identity::of(&place).map_err(failed)?;
        let claim = Claim { option, path: path.to_owned(), identity };
        match std::fs::metadata(&place) {
            Ok(metadata) => {
                check_replaceable(&metadata).map_err(|reason| claim.destination_error(reason))?
            }
            Err(_) => std::fs::read_dir(folder(&place)).map(|_| ()).map_err(failed)?,
        }
        let is_same = |other: &Option<Identity>| other.as_ref() == Some(&claim.identity);
        if is_same(&self.results) {
            return Err(
                claim.destination_error("standard output goes to the same file; name another one")
            );
        }
        if is_same(&self.messages) {
            return Err(
                claim.destination_error("standard error goes to the same file; name another one")
            );
        }
        if self.files.iter().any(|other| other.identity == claim.identity) {
            return Err(
                claim.destination_error("another output goes to the same file; name another one")
            );
        }
        self.files.push(claim);
        Ok(Place::claimed(place))
    }

    /// Claims the folder of `option` for files of this run alone; it need not exist.
    ///
    /// # Errors
    /// [`CliError::Destination`] if standard output or standard error is a file in it.
    pub fn folder(&mut self, option: &'static str, path: &Path) -> Result<PathBuf, CliError> {
        if [&self.results, &self.messages].into_iter().flatten().any(|of| holds(path, of)) {
            let reason =
                "standard output or standard error goes to a file in this folder; name another one";
            return Err(CliError::Destination { option, path: path.to_owned(), reason });
        }
        self.folder = Some((option, path.to_owned()));
        Ok(path.to_owned())
    }

    /// Reads the case file at `path`, after checking that no output overwrites it.
    ///
    /// # Errors
    /// As [`CaseFile::read_guarded`] and [`Outputs::check_input`].
    pub fn read_case(self, path: &Path) -> Result<CaseFile, CliError> {
        self.read_expected(path, Expected::CASE)
    }

    /// The same for a file of other cases.
    ///
    /// # Errors
    /// As [`Outputs::read_case`].
    pub fn read_expected(self, path: &Path, expected: Expected) -> Result<CaseFile, CliError> {
        let guard = move |input: &Path| self.check_input(input).map_err(Into::into);
        Ok(CaseFile::read_guarded(path, expected, Arc::new(guard))?)
    }

    /// Checks that no output goes to `input`, so that it may be read.
    ///
    /// # Errors
    /// [`carom_cases::ErrorKind::Input`] if standard output or standard error goes there,
    /// [`CliError::Destination`] if another output does, or if the input lies in the folder of one.
    pub fn check_input(&self, input: &Path) -> Result<(), CliError> {
        // An input that does not exist or is no file is reported when it is opened.
        let Ok(identity) = Identity::of(input) else { return Ok(()) };
        let destination_error = |reason: &str| Error::input(reason).of_file(input).into();
        if resolved(input).is_ok_and(|place| place.file_name().is_some_and(is_temporary)) {
            return Err(destination_error(
                "this is a temporary file of an interrupted run of carom; rename it",
            ));
        }
        if self.results.as_ref() == Some(&identity) {
            return Err(destination_error("standard output goes to this input; name another file"));
        }
        if self.messages.as_ref() == Some(&identity) {
            return Err(CliError::Messages { path: input.to_owned() });
        }
        if let Some(claim) = self.files.iter().find(|claim| claim.identity == identity) {
            return Err(
                claim.destination_error("this is an input of the same run; name another file")
            );
        }
        match &self.folder {
            Some((option, path)) if holds(path, &identity) => Err(CliError::Destination {
                option,
                path: path.clone(),
                reason: "an input of the same run is in this folder; name another folder",
            }),
            _ => Ok(()),
        }
    }
}

/// Whether the folder contains this file.
fn holds(folder: &Path, identity: &Identity) -> bool {
    std::fs::read_dir(folder).is_ok_and(|entries| {
        entries.flatten().any(|entry| Identity::of(&entry.path()).is_ok_and(|of| of == *identity))
    })
}

fn check_replaceable(metadata: &Metadata) -> Result<(), &'static str> {
    match metadata {
        _ if !metadata.is_file() => Err("this is not a regular file"),
        _ if metadata.permissions().readonly() => Err("this file is read-only"),
        _ => Ok(()),
    }
}
