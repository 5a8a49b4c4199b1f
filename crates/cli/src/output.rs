//! Output of a command: results on standard output, an optional picture, messages on standard
//! error.
//!
//! A command first computes everything and returns it as an [`Answer`]; nothing is written before
//! it succeeded. The exception are tables too large to hold in memory, which are written as they
//! are computed.

use crate::atomic_file::{self, AtomicFile};
use crate::destination::{Destination, Kind};
use crate::error::CliError;
pub use crate::format::Format;
use crate::global_options::Messages;
use crate::page::Page;
use crate::place::Place;
use carom_plot::{Panel, PlotError, render, render_pdf, render_png};
use serde::Serialize;
use std::io::{BufWriter, ErrorKind, Stdout, Write};
use std::path::Path;

/// The complete output of a command.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Answer {
    /// Text for standard output.
    pub text: String,
    /// A warning that must be read first.
    pub caution: Option<Caution>,
    /// Warnings for standard error.
    pub warnings: Vec<String>,
    /// A picture and its destination.
    pub picture: Option<(Destination, Picture)>,
    /// Other files and their contents.
    pub files: Vec<(Place, Vec<u8>)>,
}

/// A warning that must not be missed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Caution {
    line: String,
    /// Whether it is printed above the results; otherwise it is the first of the warnings.
    is_read_first: bool,
}

/// Panels under a title.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    title: String,
    panels: Vec<Panel>,
    /// Further panels, shown on request.
    rest: Vec<Panel>,
}

/// Which panels of a picture are shown.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Shown {
    /// Those that say most.
    #[default]
    Main,
    /// All.
    All,
}

impl Picture {
    /// The panels under `title`.
    #[must_use]
    pub fn new(title: &str, panels: impl Into<Vec<Panel>>) -> Self {
        Self { title: title.to_owned(), panels: panels.into(), rest: Vec::new() }
    }

    /// The same with further panels, which are shown on request.
    #[must_use]
    pub fn with(self, rest: impl Into<Vec<Panel>>) -> Self {
        Self { rest: rest.into(), ..self }
    }

    /// The same with these of its panels; the further ones too if there are no others.
    #[must_use]
    pub fn showing(mut self, shown: Shown) -> Self {
        if shown == Shown::All || self.panels.is_empty() {
            self.panels.append(&mut self.rest);
        }
        self
    }

    fn encode(&self, kind: Kind) -> Result<Vec<u8>, PlotError> {
        match kind {
            Kind::Svg => render(&self.title, &self.panels).map(String::into_bytes),
            Kind::Png => render_png(&self.title, &self.panels),
            Kind::Pdf => render_pdf(&self.title, &self.panels),
        }
    }
}

impl Answer {
    /// Whether something is told beside the results.
    #[must_use]
    pub const fn has_warnings(&self) -> bool {
        self.caution.is_some() || !self.warnings.is_empty()
    }

    /// Adds a warning that must be read first: above the results in a table to read, otherwise as
    /// the first warning.
    #[must_use]
    pub fn cautioned(mut self, caution: Option<String>, format: Format) -> Self {
        self.caution = caution.map(|line| Caution { line, is_read_first: format.is_table() });
        self
    }

    /// Writes picture and file under temporary names, then warnings and results; if this succeeds,
    /// moves the files into place.
    ///
    /// # Errors
    /// If the picture cannot be drawn, or a file or standard output cannot be written.
    pub fn write(&self, results: &mut Results, messages: &Messages) -> Result<(), CliError> {
        let encoded = match &self.picture {
            Some((to, picture)) => Some((to, picture.encode(to.kind())?)),
            None => None,
        };
        let mut files = Vec::new();
        match &encoded {
            Some((Destination::File { place, .. }, bytes)) => {
                atomic_file::clear(place);
                files.push(AtomicFile::write(place, bytes)?);
            }
            Some((Destination::StandardOutput, bytes)) => results.put(bytes)?,
            None => {}
        }
        for (place, bytes) in &self.files {
            atomic_file::clear(place);
            files.push(AtomicFile::write(place, bytes)?);
        }
        match &self.caution {
            Some(Caution { line, is_read_first: true }) => {
                results.put(Page::of_terminal().fold(&format!("{line}\n")).as_bytes())?;
                results.finish()?;
            }
            Some(Caution { line, .. }) => messages.warning(line),
            None => {}
        }
        for warning in &self.warnings {
            messages.warning(warning);
        }
        results.put(self.text.as_bytes())?;
        results.finish()?;
        files.into_iter().try_for_each(AtomicFile::put_in_place)
    }
}

/// Standard output. Results are held until [finished](Results::finish) or until they are too large
/// to hold. If the reader closes standard output early, further output is dropped without an error.
#[derive(Debug)]
pub struct Results {
    out: BufWriter<Stdout>,
    buffer: Vec<u8>,
    is_flowing: bool,
    is_closed: bool,
    /// Whether it was checked that standard output is open.
    is_checked: bool,
}

/// Largest number of bytes of results held in memory.
const MAX_BYTES_HELD: usize = 16 << 20;

impl Default for Results {
    fn default() -> Self {
        let out = BufWriter::with_capacity(1 << 16, std::io::stdout());
        Self { out, buffer: Vec::new(), is_flowing: false, is_closed: false, is_checked: false }
    }
}

impl Results {
    /// Whether the reader has closed standard output.
    #[must_use]
    pub const fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Writes `bytes`, or holds them until the end.
    ///
    /// # Errors
    /// [`carom_cases::ErrorKind::Io`] if they cannot be written, for example on a full disk or if
    /// standard output was never open.
    pub fn put(&mut self, bytes: &[u8]) -> Result<(), CliError> {
        if !bytes.is_empty() && !self.is_checked {
            is_open()?;
            self.is_checked = true;
        }
        if !self.is_flowing && self.buffer.len() + bytes.len() <= MAX_BYTES_HELD {
            self.buffer.extend_from_slice(bytes);
            return Ok(());
        }
        self.is_flowing = true;
        self.release()?;
        self.write_all(bytes).map_err(write_error)
    }

    /// Flushes all held results.
    ///
    /// # Errors
    /// As [`Results::put`].
    pub fn finish(&mut self) -> Result<(), CliError> {
        self.release()?;
        self.flush().map_err(write_error)
    }

    fn release(&mut self) -> Result<(), CliError> {
        let buffer = std::mem::take(&mut self.buffer);
        self.write_all(&buffer).map_err(write_error)
    }

    fn unless_closed<T>(
        &mut self,
        dropped: T,
        act: impl FnOnce(&mut BufWriter<Stdout>) -> std::io::Result<T>,
    ) -> std::io::Result<T> {
        if self.is_closed {
            return Ok(dropped);
        }
        match act(&mut self.out) {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                self.is_closed = true;
                Ok(dropped)
            }
            result => result,
        }
    }
}

impl Write for Results {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.unless_closed(bytes.len(), |out| out.write(bytes))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.unless_closed((), BufWriter::flush)
    }
}

/// Checks that standard output is open.
///
/// A program that is started without standard output gets `/dev/null` instead, open for reading and
/// writing. A shell opens `/dev/null` for writing only. Therefore `/dev/null` counts as closed if
/// it is open for both, even if the caller opened it so; to discard results, use `--format none`.
/// Checked on Linux only.
///
/// # Errors
/// [`carom_cases::ErrorKind::Io`] if it is closed.
pub fn is_open() -> Result<(), CliError> {
    const CLOSED: &str = "it is closed, or the null device open for reading and writing; redirect it, or \
                          add --format none";
    let goes_nowhere = std::fs::read_link("/proc/self/fd/1").is_ok_and(|to| to == Path::new(NULL));
    let flags = std::fs::read_to_string("/proc/self/fdinfo/1").unwrap_or_default();
    let flags = flags.lines().find_map(|line| line.strip_prefix("flags:"));
    let flags = flags.and_then(|flags| u32::from_str_radix(flags.trim(), 8).ok());
    let is_both = flags.is_some_and(|flags| flags & ACCESS == READ_AND_WRITE);
    if goes_nowhere && is_both {
        return Err(write_error(std::io::Error::other(CLOSED)));
    }
    Ok(())
}

const NULL: &str = "/dev/null";
/// The access mode bits of the flags of an open file.
const ACCESS: u32 = 0o3;
const READ_AND_WRITE: u32 = 0o2;

fn write_error(source: std::io::Error) -> CliError {
    CliError::io("write", Path::new("standard output"), source)
}

/// `results` as JSON.
///
/// # Errors
/// If they cannot be expressed in JSON.
pub fn json<T: Serialize>(results: &T) -> Result<String, CliError> {
    let mut text =
        serde_json::to_string_pretty(results).map_err(|error| CliError::Format(error.into()))?;
    text.push('\n');
    Ok(text)
}

/// `rows` as comma-separated values, with column heads.
///
/// # Errors
/// If a row is not as long as the heads.
pub fn csv(heads: &[impl AsRef<str>], rows: &[Vec<String>]) -> Result<String, CliError> {
    csv_rows(Some(heads), rows)
}

/// `rows` as comma-separated values, with column heads if given.
///
/// # Errors
/// If a row is not as long as the first.
pub fn csv_rows(
    heads: Option<&[impl AsRef<str>]>,
    rows: &[Vec<String>],
) -> Result<String, CliError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    if let Some(heads) = heads {
        writer
            .write_record(heads.iter().map(AsRef::as_ref))
            .map_err(|error| CliError::Format(error.into()))?;
    }
    for row in rows {
        writer.write_record(row).map_err(|error| CliError::Format(error.into()))?;
    }
    let bytes = writer.into_inner().map_err(|error| CliError::Format(error.into_error().into()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_in_every_format() {
        let rows = [vec!["1".to_owned(), "a, b".to_owned()]];
        assert_eq!(csv(&["x", "name"], &rows).unwrap(), "x,name\n1,\"a, b\"\n");
        assert!(csv(&["x"], &rows).is_err());
    }
}
