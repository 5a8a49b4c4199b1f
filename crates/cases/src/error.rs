//! Why a case cannot be read or followed.

use crate::case::CaseError;
use crate::history::StepsError;
use carom_classic::DirectError;
use carom_impact::{CollisionError, RingImpactError};
use carom_numerical::{CollisionLawError, NumericalImpactError};
use carom_solver::{FitError, FrictionalError, ProblemError};
use carom_special::RangeError;
use carom_special::quadrature::QuadratureError;
use std::path::{Path, PathBuf};

/// Why a case cannot be read or followed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A case file says something that cannot be.
    #[error("{}: {source}", path.display())]
    Case {
        /// The case file.
        path: PathBuf,
        /// What is wrong with it.
        source: CaseError,
    },
    /// The collision of a case could not be followed.
    #[error("{}: {source}", path.display())]
    Collision {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<CollisionError>,
    },
    /// The collision of a case could not be followed with its contact law.
    #[error("{}: {source}", path.display())]
    CollisionLaw {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<CollisionLawError>,
    },
    /// A law refuses a value of a case.
    #[error("{}: {source}", path.display())]
    Law {
        /// The case file.
        path: PathBuf,
        /// Which value, and what is allowed.
        source: RangeError,
    },
    /// A step on a grid could not be solved.
    #[error("{}: step {step}: {source}", path.display())]
    Step {
        /// The case file.
        path: PathBuf,
        /// The number of the step, from 1.
        step: usize,
        /// Why.
        source: Box<FrictionalError>,
    },
    /// A step could not be solved by the method that the case asks for.
    #[error("{}: step {step}: {source}{}", path.display(), advice(source))]
    Classic {
        /// The case file.
        path: PathBuf,
        /// The number of the step, from 1; 0 before the first.
        step: usize,
        /// Why.
        source: Box<DirectError>,
    },
    /// A contact does not fit on its grid.
    #[error("{}: step {step}: the contact reaches the {side} border of the grid; `grid.size` must be larger", path.display())]
    Border {
        /// The case file.
        path: PathBuf,
        /// The number of the step, from 1.
        step: usize,
        /// Left, right, lower or upper.
        side: &'static str,
    },
    /// No grid fits a contact.
    #[error("{}: {source}; give `grid.cells` and `grid.size` instead of an accuracy", path.display())]
    Fit {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<FitError<FrictionalError>>,
    },
    /// A contact problem could not be set up.
    #[error("{}: {source}", path.display())]
    Problem {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<ProblemError>,
    },
    /// A file of steps says something that cannot be.
    #[error("{}: {source}", path.display())]
    Steps {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: StepsError,
    },
    /// An input is no text file of an allowed size, or is written to in the same run.
    #[error("{}: {reason}", path.display())]
    Input {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
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
    /// The guard of a case refuses an input.
    #[error(transparent)]
    Refused(Box<dyn std::error::Error + Send + Sync>),
    /// A case with distributions has no single outcome.
    #[error("{}: a case with [uncertainty] is for `carom impact` alone", path.display())]
    Uncertainty {
        /// The case file.
        path: PathBuf,
    },
    /// A traction could not be integrated.
    #[error("cannot work out a traction: {0}")]
    Quadrature(#[from] QuadratureError),
    /// An argument out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
}

impl Error {
    /// Whether the input is to blame, and not the computation or the system.
    #[must_use]
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Collision { source, .. } => is_bad(source),
            Self::CollisionLaw { source, .. } => is_bad_collision(source),
            Self::Step { source, .. } => is_beyond(source),
            Self::Fit { source, .. } => match &**source {
                FitError::Range(_)
                | FitError::Problem(_)
                | FitError::NoWindow { .. }
                | FitError::Endless { .. } => true,
                FitError::Method(source) => is_beyond(source),
                _ => false,
            },
            Self::Classic { source, .. } => {
                !matches!(**source, DirectError::NotConverged { .. } | DirectError::Singular { .. })
            }
            Self::Case { .. }
            | Self::Law { .. }
            | Self::Border { .. }
            | Self::Problem { .. }
            | Self::Steps { .. }
            | Self::Input { .. }
            | Self::Refused(_)
            | Self::Uncertainty { .. }
            | Self::Range(_) => true,
            Self::Io { .. } | Self::Quadrature(_) => false,
        }
    }

    /// A refusal of the system while reading or writing `path`.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::Io { action, path: path.to_owned(), source }
    }
}

/// What applies where an older method does not.
const fn advice(error: &DirectError) -> &'static str {
    match error {
        DirectError::Range(_) | DirectError::Operator(_) => "",
        _ => "; `contact.method` = \"newton\", the default, takes it",
    }
}

/// Whether a step asks for what cannot be.
const fn is_beyond(error: &FrictionalError) -> bool {
    matches!(
        error,
        FrictionalError::Range(_)
            | FrictionalError::Period(_)
            | FrictionalError::Slides { .. }
            | FrictionalError::Turns { .. }
    )
}

/// Whether a collision asks for what cannot be: one that could not be followed does not.
#[must_use]
const fn is_bad(error: &CollisionError) -> bool {
    !matches!(
        error,
        CollisionError::Oblique(_) | CollisionError::Coupled(_) | CollisionError::NoSeparation
    )
}

/// The same of a collision with a law.
#[must_use]
pub const fn is_bad_collision(error: &CollisionLawError) -> bool {
    match error {
        CollisionLawError::Collision(error) => is_bad(error),
        CollisionLawError::Rings(RingImpactError::Collision(error)) => is_bad(error),
        CollisionLawError::Rings(error) => matches!(error, RingImpactError::Range(_)),
        CollisionLawError::Numerical(error) => matches!(error, NumericalImpactError::Range(_)),
    }
}
