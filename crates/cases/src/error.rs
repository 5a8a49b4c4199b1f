//! Errors of reading or computing a case.

use crate::case::CaseError;
use crate::history::StepsError;
use crate::solve::ChosenError;
use carom_classic::DirectError;
use carom_impact::scene::SceneError;
use carom_impact::{CollisionError, RingImpactError};
use carom_numerical::{CollisionLawError, NumericalImpactError};
use carom_rolling::RollingError;
use carom_shells::bellows::BellowsError;
use carom_shells::flange::FlangeError;
use carom_solver::{FitError, FrictionalError, NormalError, ProblemError};
use carom_special::RangeError;
use carom_special::quadrature::QuadratureError;
use std::path::{Path, PathBuf};

/// An error of reading or computing a case.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The computation was [ended](carom_special::interrupt) from outside.
    #[error("interrupted")]
    Interrupted,
    /// The case file has an error.
    #[error("{}: {message}", path.display())]
    Case {
        /// The case file.
        path: PathBuf,
        /// The error.
        source: Box<CaseError>,
        /// The error with the lines of the file that are wrong.
        message: String,
    },
    /// The collision of a case could not be computed.
    #[error("{}: {source}", path.display())]
    Collision {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<CollisionError>,
    },
    /// The collision of a case could not be computed with its contact law.
    #[error("{}: {source}", path.display())]
    CollisionLaw {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<CollisionLawError>,
    },
    /// A law rejects a value of a case.
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
    /// A step without friction, as on a plate, could not be solved.
    #[error("{}: step {step}: {source}", path.display())]
    Frictionless {
        /// The case file.
        path: PathBuf,
        /// The number of the step, from 1; 0 before the first.
        step: usize,
        /// Why.
        source: Box<NormalError>,
    },
    /// A step could not be solved by the requested method.
    #[error("{}: step {step}: {source}{}", path.display(), advice(source))]
    Classic {
        /// The case file.
        path: PathBuf,
        /// The number of the step, from 1; 0 before the first.
        step: usize,
        /// Why.
        source: Box<DirectError>,
    },
    /// The contact reaches the border of its grid.
    #[error("{}: step {step}: the contact reaches the {side} border of the grid; `grid.size` must be larger", path.display())]
    Border {
        /// The case file.
        path: PathBuf,
        /// The number of the step, from 1.
        step: usize,
        /// Left, right, lower or upper.
        side: &'static str,
    },
    /// No grid was found for the contact.
    #[error("{}: {source}; or give `grid.cells` and `grid.size` instead of an accuracy", path.display())]
    Fit {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<FitError<ChosenError>>,
    },
    /// No grid reaches the accuracy of steady rolling.
    #[error("{}: {source}", path.display())]
    RollingFit {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<FitError<RollingError>>,
    },
    /// A contact problem could not be set up.
    #[error("{}: {source}", path.display())]
    Problem {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<ProblemError>,
    },
    /// A bellows could not be computed under one of its loads.
    #[error("{}: {}{source}", path.display(), of_load(*load))]
    Bellows {
        /// The case file.
        path: PathBuf,
        /// The number of the load, from 1; 0 before the first.
        load: usize,
        /// Why.
        source: Box<BellowsError>,
    },
    /// A flange could not be computed.
    #[error("{}: {source}", path.display())]
    Flange {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: Box<FlangeError>,
    },
    /// The scene of a case cannot be computed.
    #[error("{}: {source}", path.display())]
    Scene {
        /// The case file.
        path: PathBuf,
        /// The cause.
        source: Box<SceneError<CollisionLawError>>,
    },
    /// A rolling contact could not be solved.
    #[error("{}: row {row}: {source}", path.display())]
    Rolling {
        /// The case file.
        path: PathBuf,
        /// The number of the creepage or step, from 1.
        row: usize,
        /// The cause.
        source: Box<RollingError>,
    },
    /// A file of steps has an error.
    #[error("{}: {source}", path.display())]
    Steps {
        /// The file.
        path: PathBuf,
        /// The error.
        source: StepsError,
    },
    /// An input is not a text file of an allowed size, or the same run writes it.
    #[error("{}: {reason}", path.display())]
    Input {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
    /// A file could not be read or written.
    #[error("cannot {action} {}: {source}{hint}", path.display())]
    Io {
        /// `read` or `write`.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
        /// What was expected, or an empty text.
        hint: &'static str,
    },
    /// The caller's guard does not allow an input.
    #[error(transparent)]
    Refused(Box<dyn std::error::Error + Send + Sync>),
    /// A case with distributions has no single result.
    #[error("{}: only `carom impact` computes a case with [uncertainty]", path.display())]
    Uncertainty {
        /// The case file.
        path: PathBuf,
    },
    /// A traction could not be integrated.
    #[error("cannot integrate a traction: {0}")]
    Quadrature(#[from] QuadratureError),
    /// An argument out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
}

impl Error {
    /// Whether the input causes the error, not the computation or the system.
    #[must_use]
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Interrupted => false,
            Self::Collision { source, .. } => is_bad(source),
            Self::CollisionLaw { source, .. } => is_bad_collision(source),
            Self::Step { source, .. } => is_beyond(source),
            Self::Frictionless { source, .. } => is_beyond_normal(source),
            Self::Fit { source, .. } => match &**source {
                FitError::Range(_)
                | FitError::Problem(_)
                | FitError::NoWindow { .. }
                | FitError::Endless { .. } => true,
                FitError::Method(ChosenError::Today(source)) => is_beyond(source),
                FitError::Method(ChosenError::Normal(source)) => is_beyond_normal(source),
                _ => false,
            },
            Self::Classic { source, .. } => {
                !matches!(**source, DirectError::NotConverged { .. } | DirectError::Singular { .. })
            }
            Self::Scene { source, .. } => match &**source {
                SceneError::Collision { source, .. } => is_bad_collision(source),
                _ => true,
            },
            Self::Rolling { source, .. } => is_beyond_rolling(source),
            Self::RollingFit { source, .. } => match &**source {
                FitError::Range(_)
                | FitError::Problem(_)
                | FitError::NoWindow { .. }
                | FitError::Endless { .. } => true,
                FitError::Method(source) => is_beyond_rolling(source),
                _ => false,
            },
            Self::Bellows { source, .. } => matches!(**source, BellowsError::Range(_)),
            Self::Flange { source, .. } => matches!(**source, FlangeError::Range(_)),
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

    /// The error of the system in reading or writing `path`.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::Io { action, path: path.to_owned(), source, hint: "" }
    }

    /// The same error; of a path where no file is, with what was expected there.
    #[must_use]
    pub(crate) fn hinting(mut self, expected: &'static str) -> Self {
        use std::io::ErrorKind::{IsADirectory, NotFound};
        if let Self::Io { source, hint, .. } = &mut self
            && matches!(source.kind(), NotFound | IsADirectory)
        {
            *hint = expected;
        }
        self
    }
}

/// Which load of a bellows it was.
fn of_load(load: usize) -> String {
    if load == 0 { String::new() } else { format!("load {load}: ") }
}

/// A hint for the case that an older method cannot solve it.
const fn advice(error: &DirectError) -> &'static str {
    match error {
        DirectError::Range(_) | DirectError::Operator(_) => "",
        _ => "; `contact.method` = \"newton\", the default, solves it",
    }
}

/// Whether the prescribed step itself is impossible.
const fn is_beyond(error: &FrictionalError) -> bool {
    matches!(
        error,
        FrictionalError::Range(_)
            | FrictionalError::Operator(_)
            | FrictionalError::Period(_)
            | FrictionalError::Slides { .. }
            | FrictionalError::Turns { .. }
    )
}

/// The same of rolling.
const fn is_beyond_rolling(error: &RollingError) -> bool {
    match error {
        RollingError::Step(error) => is_beyond(error),
        RollingError::Range(_) | RollingError::NoRoomAhead { .. } => true,
        _ => false,
    }
}

/// The same without friction.
const fn is_beyond_normal(error: &NormalError) -> bool {
    !matches!(error, NormalError::NotConverged { .. })
}

/// Whether the prescribed collision itself is impossible; a failed computation is not.
#[must_use]
const fn is_bad(error: &CollisionError) -> bool {
    !matches!(
        error,
        CollisionError::Oblique(_) | CollisionError::Coupled(_) | CollisionError::NoSeparation
    )
}

/// Whether the prescribed collision with its law is impossible.
#[must_use]
pub const fn is_bad_collision(error: &CollisionLawError) -> bool {
    match error {
        CollisionLawError::Collision(error) => is_bad(error),
        CollisionLawError::Rings(RingImpactError::Collision(error)) => is_bad(error),
        CollisionLawError::Rings(error) => matches!(error, RingImpactError::Range(_)),
        CollisionLawError::Numerical(error) => matches!(error, NumericalImpactError::Range(_)),
    }
}
