//! What can go wrong in a command, and the exit code for it.

use crate::case::CaseError;
use carom_plot::PlotError;
use carom_special::RangeError;
use std::path::{Path, PathBuf};

/// Why a command did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A case file says something that cannot be.
    #[error("{}: {source}", path.display())]
    Case {
        /// The case file.
        path: PathBuf,
        /// What is wrong with it.
        source: CaseError,
    },
    /// An option has a value that cannot be.
    #[error("--{0}")]
    Option(#[from] RangeError),
    /// A file could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// `read` or `write`.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// The results could not be put into the format asked for.
    #[error("cannot write the results: {0}")]
    Format(Box<dyn std::error::Error + Send + Sync>),
    /// The results could not be drawn.
    #[error("cannot draw the results: {0}")]
    Plot(#[from] PlotError),
}

impl CliError {
    /// The exit code: 2 for bad input, 1 for anything else.
    #[must_use]
    pub const fn exit_code(&self) -> u8 {
        match self {
            Self::Case { .. } | Self::Option(_) => 2,
            Self::Io { .. } | Self::Format(_) | Self::Plot(_) => 1,
        }
    }

    /// A refusal of the system while reading or writing `path`.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::Io { action, path: path.to_owned(), source }
    }
}
