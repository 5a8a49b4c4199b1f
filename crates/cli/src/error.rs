//! What can go wrong in a command, and the exit code for it.

use carom_cases::{Error, is_bad_collision};
use carom_impact::oblique::ObliqueError;
use carom_impact::scene::SceneError;
use carom_impact::uncertain::UncertainError;
use carom_numerical::CollisionLawError;
use carom_plot::PlotError;
use carom_rolling::RollingError;
use carom_special::RangeError;
use std::path::{Path, PathBuf};

/// Why a command did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A case cannot be read or followed, or a file not be written.
    #[error(transparent)]
    Case(Error),
    /// The scene of a case cannot be run.
    #[error("{}: {source}", path.display())]
    Scene {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: SceneError<CollisionLawError>,
    },
    /// No sample of an uncertain case gives an outcome.
    #[error("{}: {source}", path.display())]
    Uncertain {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: UncertainError<CollisionLawError>,
    },
    /// A rolling contact could not be solved.
    #[error("{}: row {row}: {source}", path.display())]
    Rolling {
        /// The case file.
        path: PathBuf,
        /// The number of the creepage or step, from 1.
        row: usize,
        /// Why.
        source: Box<RollingError>,
    },
    /// Standard error goes to an input: there is nowhere to tell it.
    #[error("{}: standard error goes to this input", path.display())]
    Messages {
        /// The input.
        path: PathBuf,
    },
    /// An output cannot go where it was asked for.
    #[error("--{option} {}: {reason}", path.display())]
    Destination {
        /// The option.
        option: &'static str,
        /// Its value.
        path: PathBuf,
        /// Why not.
        reason: &'static str,
    },
    /// The impact could not be followed to its end.
    #[error(transparent)]
    Impact(#[from] ObliqueError),
    /// The numbers of a case are so large or small that a result is none.
    #[error(
        "{}: {quantity} = {value}, no finite number: some values of the case are too large or too \
         small together",
        path.display()
    )]
    Overflow {
        /// The case file.
        path: PathBuf,
        /// The result.
        quantity: String,
        /// What came out.
        value: f64,
    },
    /// An option has a value that cannot be.
    #[error("--{0}")]
    Option(#[from] RangeError),
    /// Options that exclude each other, or the case.
    #[error("{0}")]
    Options(&'static str),
    /// The system gives no such number of threads.
    #[error("cannot start {count} threads: {source}")]
    Threads {
        /// How many were asked for.
        count: usize,
        /// Why not.
        source: Box<dyn std::error::Error + Send + Sync>,
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
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Case(source) => 1 + u8::from(source.is_bad_input()),
            Self::Scene { source: SceneError::Collision { source, .. }, .. }
            | Self::Uncertain { source: UncertainError::Collision { source, .. }, .. } => {
                1 + u8::from(is_bad_collision(source))
            }
            Self::Rolling { source, .. } => match **source {
                RollingError::Range(_) => 2,
                _ => 1,
            },
            Self::Overflow { .. }
            | Self::Uncertain { .. }
            | Self::Scene { .. }
            | Self::Messages { .. }
            | Self::Destination { .. }
            | Self::Option(_)
            | Self::Options(_) => 2,
            Self::Impact(_) | Self::Threads { .. } | Self::Format(_) | Self::Plot(_) => 1,
        }
    }

    /// A refusal of the system while reading or writing `path`.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::Case(Error::io(action, path, source))
    }
}

/// What this command told a reader of cases is told as it was.
impl From<Error> for CliError {
    fn from(error: Error) -> Self {
        match error {
            Error::Refused(source) => match source.downcast::<Self>() {
                Ok(own) => *own,
                Err(other) => Self::Case(Error::Refused(other)),
            },
            error => Self::Case(error),
        }
    }
}
