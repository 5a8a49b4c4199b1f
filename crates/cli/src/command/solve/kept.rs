//! The folder of `--keep`: it belongs to one case, and to one run at a time.
//!
//! A manifest names the case, and a lock shows whether a run uses the folder. A folder with files
//! but without a manifest is rejected unchanged.

use crate::atomic_file::{self, AtomicFile};
use crate::columns;
use crate::error::CliError;
use crate::output::Format;
use crate::outputs::Place;
use carom_cases::Error;
use carom_cases::input;
use carom_solver::StepSummary;
use std::ffi::{OsStr, OsString};
use std::fs::{File, TryLockError};
use std::io::{ErrorKind, Read as _};
use std::path::{Path, PathBuf};

const MANIFEST: &str = "carom-kept.txt";
const LOCK: &str = "carom-kept.lock";
/// The file with the loads of all steps.
pub(super) const LOADS: &str = "loads.csv";
/// First line of the manifest.
const HEAD: &str = "The steps of one run of carom solve: carom alone writes here.\n";
/// Largest size of a manifest in bytes.
const MAX_MANIFEST_BYTES: u64 = 4096;

const FOREIGN: &str = "the folder contains files, but no manifest of carom: `--keep` requires a folder \
                       of its own; name another one";
const EARLIER: &str = "the folder contains steps of an earlier run; add --resume to continue them, or \
                       name another folder";
const OTHER: &str = "the steps in the folder belong to another case or another version of carom";

/// The file name of a step.
pub(super) fn step_name(number: usize) -> String {
    format!("step-{number:06}.npz")
}

/// The step number in a file name.
fn step_number(name: &OsStr) -> Option<usize> {
    let number = name.to_str()?.strip_prefix("step-")?.strip_suffix(".npz")?.parse().ok()?;
    (*name == *step_name(number)).then_some(number)
}

/// A folder for the steps of one case.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    /// Fingerprint of the case and of all files it reads.
    fingerprint: u64,
    is_resumed: bool,
}

/// A folder to which no other run writes while this value exists.
#[derive(Debug)]
pub(super) struct Owned {
    folder: Folder,
    steps: usize,
    /// Released by the system when the process ends for any reason.
    _lock: File,
}

impl Folder {
    /// The folder for a case of these inputs; with `is_resumed`, to continue its steps.
    pub(super) fn new(path: PathBuf, inputs: &[&[u8]], is_resumed: bool) -> Self {
        Self { path, fingerprint: fingerprint(inputs), is_resumed }
    }

    /// The number of steps in the folder, if a run may write to it; nothing is written yet.
    ///
    /// # Errors
    /// [`CliError::Input`] if it contains anything but steps of the same case, or steps that are
    /// not to be resumed; [`CliError::Io`] if it cannot be read.
    pub(super) fn check(&self) -> Result<usize, CliError> {
        let failed = |error| CliError::io("read", &self.path, error);
        let entries = match std::fs::read_dir(&self.path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(0),
            entries => entries.map_err(failed)?,
        };
        let mut names = Vec::new();
        for entry in entries {
            names.push(entry.map_err(failed)?.file_name());
        }
        let has = |name: &str| names.iter().any(|own| own == name);
        if !has(MANIFEST) {
            // Another run ended, or is active, before it wrote the manifest.
            let is_foreign = |name: &&OsString| **name != *LOCK && !atomic_file::is_temporary(name);
            return match names.iter().find(is_foreign) {
                Some(other) => Err(input_error(&self.path.join(other), FOREIGN)),
                None => Ok(0),
            };
        }
        for name in names.iter().filter(|name| is_own(name)) {
            let path = self.path.join(name);
            if !std::fs::symlink_metadata(&path).map_err(failed)?.is_file() {
                return Err(input_error(&path, "this is not a file of carom"));
            }
        }
        let mut steps: Vec<usize> = names.iter().filter_map(|name| step_number(name)).collect();
        steps.sort_unstable();
        self.check_manifest(steps.len())?;
        if let Some((last, next)) = steps.iter().zip(1..).find(|(step, want)| *step != want) {
            let reason = format!("step {next} is missing before this one");
            return Err(input_error(&self.path.join(step_name(*last)), &reason));
        }
        if has(LOADS) {
            self.check_loads(steps.len())?;
        }
        Ok(steps.len())
    }

    fn check_manifest(&self, steps: usize) -> Result<(), CliError> {
        let path = self.path.join(MANIFEST);
        let text = input::read(&path, MAX_MANIFEST_BYTES, "a manifest")?;
        if !text.starts_with(HEAD.as_bytes()) {
            return Err(input_error(&path, "this is not a manifest of carom"));
        }
        match self.is_resumed {
            _ if steps == 0 => Ok(()),
            false => Err(input_error(&self.path, EARLIER)),
            true if text != self.manifest().as_bytes() => Err(input_error(&self.path, OTHER)),
            true => Ok(()),
        }
    }

    /// Checks that the table of loads was written by carom: with its heads, and only if there are
    /// steps.
    fn check_loads(&self, steps: usize) -> Result<(), CliError> {
        let path = self.path.join(LOADS);
        let heads = columns::rows(Format::Csv, &StepSummary::columns(), &[])?;
        let mut found = Vec::new();
        input::open(&path, "must be a table")?
            .take(heads.len() as u64)
            .read_to_end(&mut found)
            .map_err(|error| CliError::io("read", &path, error))?;
        if steps == 0 || found != heads.as_bytes() {
            return Err(input_error(
                &path,
                "this is not the table of loads of this run; move it elsewhere",
            ));
        }
        Ok(())
    }

    fn manifest(&self) -> String {
        format!("{HEAD}version {}\ncase {:016x}\n", env!("CARGO_PKG_VERSION"), self.fingerprint)
    }

    /// Locks the folder, writes the manifest, and removes temporary files of ended runs.
    ///
    /// # Errors
    /// As [`Folder::check`]; [`CliError::Input`] if another run uses it, [`CliError::Io`] if it
    /// cannot be written.
    pub(super) fn open(self) -> Result<Owned, CliError> {
        let failed = |error| CliError::io("write", &self.path, error);
        std::fs::create_dir_all(&self.path).map_err(failed)?;
        self.check()?;
        let mut lock = File::options();
        let lock = lock.write(true).create(true).truncate(false).open(self.path.join(LOCK));
        let lock = lock.map_err(failed)?;
        lock.try_lock().map_err(|error| match error {
            TryLockError::WouldBlock => input_error(&self.path, "another run is using this folder"),
            TryLockError::Error(error) => failed(error),
        })?;
        // Another run may have used it in the meantime.
        let steps = self.check()?;
        atomic_file::clear_in(&self.path, is_own);
        if steps == 0 {
            let place = Place::owned(&self.path, MANIFEST);
            AtomicFile::write(&place, self.manifest().as_bytes())?.put_in_place()?;
        }
        Ok(Owned { folder: self, steps, _lock: lock })
    }
}

impl Owned {
    /// Number of steps when it was opened.
    pub(super) const fn steps(&self) -> usize {
        self.steps
    }

    /// Fingerprint of the case and of all files it reads.
    pub(super) const fn fingerprint(&self) -> u64 {
        self.folder.fingerprint
    }

    /// Reads one of its files, of at most `most` bytes.
    ///
    /// # Errors
    /// If it cannot be read, is larger or does not exist.
    pub(super) fn read(&self, name: &str, most: u64) -> Result<Vec<u8>, CliError> {
        Ok(input::read(&self.folder.path.join(name), most, "a step")?)
    }

    /// Writes one of its files, completely or not at all.
    ///
    /// # Errors
    /// [`CliError::Io`].
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), CliError> {
        AtomicFile::write(&Place::owned(&self.folder.path, name), bytes)?.put_in_place()
    }

    /// The error of one of its files.
    pub(super) fn input_error(&self, name: &str, reason: &str) -> CliError {
        input_error(&self.folder.path.join(name), reason)
    }
}

/// Whether a file of this name belongs to the folder.
fn is_own(name: &OsStr) -> bool {
    [MANIFEST, LOCK, LOADS].iter().any(|own| *name == **own) || step_number(name).is_some()
}

fn input_error(path: &Path, reason: &str) -> CliError {
    Error::input(reason).of_file(path).into()
}

/// FNV-1a, 64 bits, of all inputs with their lengths and of the version of the program.
pub(super) fn fingerprint(inputs: &[&[u8]]) -> u64 {
    let version = env!("CARGO_PKG_VERSION").as_bytes();
    let mut sum = 0xcbf2_9ce4_8422_2325_u64;
    for input in inputs.iter().chain([&version]) {
        let length = (input.len() as u64).to_le_bytes();
        for byte in length.iter().chain(input.iter()) {
            sum = (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    sum
}
