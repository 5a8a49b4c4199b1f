//! The folder that `--keep` names: it belongs to one case, and to one run at a time.
//!
//! A manifest says whose it is, and a lock whether a run is at work. What is in it without a manifest is
//! not touched: the folder is refused.

use crate::aside::{self, Aside};
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
/// The loads of all steps.
pub(super) const LOADS: &str = "loads.csv";
/// The manifest's first line.
const HEAD: &str = "The steps of one run of carom solve: carom alone writes here.\n";
/// Bytes of a manifest, at most.
const MOST_OF_MANIFEST: u64 = 4096;

const FOREIGN: &str = "the folder has files, but no manifest of carom: `--keep` takes a folder of its \
                       own; name another one";
const EARLIER: &str = "steps of an earlier run are here; add --resume to go on with them, or name \
                       another folder";
const OTHER: &str = "the steps here belong to another case, or to another version of carom";

/// The name of a step's file.
pub(super) fn step_name(number: usize) -> String {
    format!("step-{number:06}.npz")
}

/// The number of the step that a file of this name holds.
fn step_number(name: &OsStr) -> Option<usize> {
    let number = name.to_str()?.strip_prefix("step-")?.strip_suffix(".npz")?.parse().ok()?;
    (*name == *step_name(number)).then_some(number)
}

/// A folder for the steps of one case.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    /// Of the case and all that it reads.
    fingerprint: u64,
    is_resumed: bool,
}

/// One that no other run writes to while this lives.
#[derive(Debug)]
pub(super) struct Owned {
    folder: Folder,
    steps: usize,
    /// Released by the system when the process ends, however it ends.
    _lock: File,
}

impl Folder {
    /// The folder for a case of these inputs; with `is_resumed` for going on with its steps.
    pub(super) fn new(path: PathBuf, inputs: &[&[u8]], is_resumed: bool) -> Self {
        Self { path, fingerprint: fingerprint(inputs), is_resumed }
    }

    /// The number of steps in the folder, if a run may write to it; nothing is written yet.
    ///
    /// # Errors
    /// [`CliError::Input`] if it holds something else than steps of the same case, or steps that are not
    /// to be resumed; [`CliError::Io`] if it cannot be read.
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
            // A run that died, or is at work, before it wrote the manifest.
            let is_foreign = |name: &&OsString| **name != *LOCK && !aside::is_aside(name);
            return match names.iter().find(is_foreign) {
                Some(other) => Err(refused(&self.path.join(other), FOREIGN)),
                None => Ok(0),
            };
        }
        for name in names.iter().filter(|name| is_own(name)) {
            let path = self.path.join(name);
            if !std::fs::symlink_metadata(&path).map_err(failed)?.is_file() {
                return Err(refused(&path, "this is no file of carom"));
            }
        }
        let mut steps: Vec<usize> = names.iter().filter_map(|name| step_number(name)).collect();
        steps.sort_unstable();
        self.check_manifest(steps.len())?;
        if let Some((last, next)) = steps.iter().zip(1..).find(|(step, want)| *step != want) {
            let reason = format!("step {next} is missing before this one");
            return Err(refused(&self.path.join(step_name(*last)), &reason));
        }
        if has(LOADS) {
            self.check_loads(steps.len())?;
        }
        Ok(steps.len())
    }

    fn check_manifest(&self, steps: usize) -> Result<(), CliError> {
        let path = self.path.join(MANIFEST);
        let text = input::read(&path, MOST_OF_MANIFEST, "a manifest")?;
        if !text.starts_with(HEAD.as_bytes()) {
            return Err(refused(&path, "this is no manifest of carom"));
        }
        match self.is_resumed {
            _ if steps == 0 => Ok(()),
            false => Err(refused(&self.path, EARLIER)),
            true if text != self.manifest().as_bytes() => Err(refused(&self.path, OTHER)),
            true => Ok(()),
        }
    }

    /// Whether the table of loads is one of carom: with its heads, and not before the first step.
    fn check_loads(&self, steps: usize) -> Result<(), CliError> {
        let path = self.path.join(LOADS);
        let heads = columns::rows(Format::Csv, &StepSummary::columns(), &[])?;
        let mut found = Vec::new();
        input::open(&path, "must be a table")?
            .take(heads.len() as u64)
            .read_to_end(&mut found)
            .map_err(|error| CliError::io("read", &path, error))?;
        if steps == 0 || found != heads.as_bytes() {
            return Err(refused(&path, "this is no table of loads of this run; move it elsewhere"));
        }
        Ok(())
    }

    fn manifest(&self) -> String {
        format!("{HEAD}version {}\ncase {:016x}\n", env!("CARGO_PKG_VERSION"), self.fingerprint)
    }

    /// Makes it what the run owns, and removes what runs that died have left half written.
    ///
    /// # Errors
    /// As [`Folder::check`]; [`CliError::Input`] if another run is at work there, [`CliError::Io`] if it
    /// cannot be written.
    pub(super) fn open(self) -> Result<Owned, CliError> {
        let failed = |error| CliError::io("write", &self.path, error);
        std::fs::create_dir_all(&self.path).map_err(failed)?;
        self.check()?;
        let mut lock = File::options();
        let lock = lock.write(true).create(true).truncate(false).open(self.path.join(LOCK));
        let lock = lock.map_err(failed)?;
        lock.try_lock().map_err(|error| match error {
            TryLockError::WouldBlock => refused(&self.path, "another run keeps its steps here now"),
            TryLockError::Error(error) => failed(error),
        })?;
        // Another run may have come and gone in the meantime.
        let steps = self.check()?;
        aside::clear_in(&self.path, is_own);
        if steps == 0 {
            let place = Place::owned(&self.path, MANIFEST);
            Aside::write(&place, self.manifest().as_bytes())?.put_in_place()?;
        }
        Ok(Owned { folder: self, steps, _lock: lock })
    }
}

impl Owned {
    /// Steps that were there when it was opened.
    pub(super) const fn steps(&self) -> usize {
        self.steps
    }

    /// Of the case and all that it reads.
    pub(super) const fn fingerprint(&self) -> u64 {
        self.folder.fingerprint
    }

    /// Reads one of its files.
    ///
    /// # Errors
    /// If it cannot be read, is none of `most` bytes at most, or not there.
    pub(super) fn read(&self, name: &str, most: u64) -> Result<Vec<u8>, CliError> {
        Ok(input::read(&self.folder.path.join(name), most, "a step")?)
    }

    /// Writes one of its files: whole, or not at all.
    ///
    /// # Errors
    /// [`CliError::Io`].
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), CliError> {
        Aside::write(&Place::owned(&self.folder.path, name), bytes)?.put_in_place()
    }

    /// What is wrong with one of its files.
    pub(super) fn refused(&self, name: &str, reason: &str) -> CliError {
        refused(&self.folder.path.join(name), reason)
    }
}

/// Whether files of this name are written here.
fn is_own(name: &OsStr) -> bool {
    [MANIFEST, LOCK, LOADS].iter().any(|own| *name == **own) || step_number(name).is_some()
}

fn refused(path: &Path, reason: &str) -> CliError {
    Error::Input { path: path.to_owned(), reason: reason.to_owned() }.into()
}

/// FNV-1a, 64 bits, of all inputs with their lengths and of the program's version.
fn fingerprint(inputs: &[&[u8]]) -> u64 {
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
