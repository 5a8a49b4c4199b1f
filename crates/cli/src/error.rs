//! The errors of a command and their exit codes.

use carom_cases::{Error, ErrorKind};
use carom_impact::RingImpactError;
use carom_impact::oblique::ObliqueError;
use carom_impact::restitution::RestitutionError;
use carom_plot::PlotError;
use carom_special::RangeError;
use std::path::{Path, PathBuf};

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A case cannot be read or computed, or a file cannot be written.
    #[error(transparent)]
    Case(Error),
    /// Standard error is redirected to an input, so that no message can be written.
    #[error("{}: standard error goes to this input", path.display())]
    Messages {
        /// The input.
        path: PathBuf,
    },
    /// The output of an option cannot be written to the given path.
    #[error("--{option} {}: {reason}", path.display())]
    Destination {
        /// The option.
        option: &'static str,
        /// Its value.
        path: PathBuf,
        /// The cause.
        reason: &'static str,
    },
    /// The impact could not be solved to separation.
    #[error(transparent)]
    Impact(#[from] ObliqueError),
    /// The impact of dissimilar spheres could not be followed by rings.
    #[error(transparent)]
    Rings(#[from] RingImpactError),
    /// The value of an option is out of range.
    #[error("--{0}")]
    Option(#[from] RangeError),
    /// An option conflicts with another one or with the case.
    #[error("{0}")]
    Options(&'static str),
    /// A column that the results do not have.
    #[error("--columns: there is no column `{name}`{meant}\n  the columns are {columns}")]
    Column {
        /// What was asked for.
        name: String,
        /// What it is called now, or a similar name.
        meant: String,
        /// The heads that there are.
        columns: String,
    },
    /// The system cannot start this number of threads.
    #[error("cannot start {count} threads: {source}")]
    Threads {
        /// The requested number.
        count: usize,
        /// The cause.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// The results could not be written in the requested format.
    #[error("cannot write the results: {0}")]
    Format(Box<dyn std::error::Error + Send + Sync>),
    /// Data could not be fitted.
    #[error("{}: {source}", path.display())]
    Fit {
        /// The data.
        path: PathBuf,
        /// The cause.
        source: Box<carom_fit::FitError>,
    },
    /// The results could not be drawn.
    #[error("cannot draw the results: {0}")]
    Plot(#[from] PlotError),
}

impl From<RestitutionError> for CliError {
    fn from(error: RestitutionError) -> Self {
        match error {
            RestitutionError::Range(error) => Self::Option(error),
            RestitutionError::Oblique(error) => Self::Impact(error),
        }
    }
}

impl CliError {
    /// The exit code: 2 for bad input, 1 for anything else.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Case(source) => 1 + u8::from(source.is_bad_input()),
            Self::Rings(source) => 1 + u8::from(matches!(source, RingImpactError::Range(_))),
            Self::Messages { .. }
            | Self::Destination { .. }
            | Self::Option(_)
            | Self::Options(_)
            | Self::Column { .. } => 2,
            Self::Impact(_)
            | Self::Fit { .. }
            | Self::Threads { .. }
            | Self::Format(_)
            | Self::Plot(_) => 1,
        }
    }

    /// An input/output error of the system while reading or writing `path`.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::Case(Error::io(action, path, source))
    }

    /// The same error; that of a case is one in this file, unless it names another one.
    #[must_use]
    pub fn of_file(self, path: &Path) -> Self {
        match self {
            Self::Case(error) => Self::Case(error.of_file(path)),
            error => error,
        }
    }
}

/// Unwraps an error of this crate that was passed through the reader of cases.
impl From<Error> for CliError {
    fn from(error: Error) -> Self {
        match *error.kind {
            ErrorKind::Refused(source) => match source.downcast::<Self>() {
                Ok(own) => *own,
                Err(other) => Self::Case(ErrorKind::Refused(other).into()),
            },
            kind => Self::Case(Error { kind: Box::new(kind), ..error }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range() -> RangeError {
        RangeError::finite("x", f64::NAN).unwrap_err()
    }

    /// 2 where the user has to write something else, 1 where what was asked for failed.
    #[test]
    fn the_exit_code_says_whether_the_input_was_bad() {
        let lost = || std::io::Error::other("lost");
        let path = || PathBuf::from("here");
        let bad = [
            CliError::Case(Error::input("unknown")),
            CliError::Rings(RingImpactError::Range(range())),
            CliError::Messages { path: path() },
            CliError::Destination { option: "plot", path: path(), reason: "no" },
            CliError::Option(range()),
            CliError::Options("these exclude each other"),
        ];
        let failed = [
            CliError::io("write", &path(), lost()),
            CliError::Impact(ObliqueError::TooManyPhases { phases: 9, w: 0.5 }),
            CliError::Threads { count: 3, source: lost().into() },
            CliError::Format(lost().into()),
        ];
        assert!(bad.iter().all(|error| error.exit_code() == 2), "{bad:?}");
        assert!(failed.iter().all(|error| error.exit_code() == 1), "{failed:?}");
    }
}
