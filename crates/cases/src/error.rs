//! Errors of reading or computing a case.

use crate::case::CaseError;
use crate::contact::Fault;
use crate::history::StepsError;
use crate::solve::ChosenError;
use carom_classic::DirectError;
use carom_impact::scene::SceneError;
use carom_impact::uncertain::UncertainError;
use carom_impact::{CollisionError, RingImpactError};
use carom_numerical::{CollisionLawError, NumericalImpactError};
use carom_rolling::RollingError;
use carom_shells::bellows::BellowsError;
use carom_shells::flange::FlangeError;
use carom_solver::{FitError, FrictionalError, NormalError, ProblemError};
use carom_special::RangeError;
use carom_special::quadrature::QuadratureError;
use std::fmt;
use std::path::{Path, PathBuf};

/// An error of reading or computing a case, with the file and the place in it that are at fault.
#[derive(Debug)]
pub struct Error {
    /// The case file, or a file that it names; none while no file is known to be at fault.
    pub path: Option<PathBuf>,
    /// A step, row or load and its number, from 1.
    pub place: Option<(&'static str, usize)>,
    /// What is wrong.
    pub kind: Box<ErrorKind>,
}

/// What is wrong with a case.
#[derive(Debug, thiserror::Error)]
pub enum ErrorKind {
    /// The computation was [ended](carom_special::interrupt) from outside.
    #[error("interrupted")]
    Interrupted,
    /// The text of the case has an error.
    #[error("{message}")]
    Case {
        /// The error.
        source: CaseError,
        /// The error with the lines of the file that are wrong.
        message: String,
    },
    /// The collision of a case could not be computed with its contact law.
    #[error(transparent)]
    Collision(#[from] CollisionLawError),
    /// No sample of an uncertain case gives an outcome.
    #[error(transparent)]
    Uncertain(#[from] UncertainError<CollisionLawError>),
    /// A value of a case, or without a file an argument, is out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// A step on a grid could not be solved.
    #[error("{}{}", .0, advice(.0))]
    Step(#[from] ChosenError),
    /// The contact reaches this border of its grid: left, right, lower or upper.
    #[error(
        "the contact reaches the {0} border of the grid; `grid.size` must be larger, unless the bodies end there \
         (`grid.cut` = true) or repeat themselves (`grid.periodic` = true); is the load in the right unit?"
    )]
    Border(&'static str),
    /// No grid was found for the contact.
    #[error("{0}; or give `grid.cells` and `grid.size` instead of an accuracy")]
    Fit(#[from] FitError<ChosenError>),
    /// No grid reaches the accuracy of steady rolling.
    #[error(transparent)]
    RollingFit(#[from] FitError<RollingError>),
    /// A contact problem could not be set up.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// A bellows could not be computed.
    #[error(transparent)]
    Bellows(#[from] BellowsError),
    /// A flange could not be computed.
    #[error(transparent)]
    Flange(#[from] FlangeError),
    /// The scene of a case cannot be computed.
    #[error(transparent)]
    Scene(#[from] SceneError<CollisionLawError>),
    /// A rolling contact could not be solved.
    #[error(transparent)]
    Rolling(#[from] RollingError),
    /// An input of CONTACT has an error, or asks for what carom does not do.
    #[error(transparent)]
    Contact(#[from] Fault),
    /// A file of steps has an error.
    #[error(transparent)]
    Steps(#[from] StepsError),
    /// An input is not a text file of an allowed size, does not fit the case, or the same run writes it.
    #[error("{0}")]
    Input(String),
    /// A file could not be read or written.
    #[error("cannot {action}: {source}{hint}")]
    Io {
        /// `read` or `write`.
        action: &'static str,
        /// The system's reason.
        source: std::io::Error,
        /// What was expected, or an empty text.
        hint: &'static str,
    },
    /// The caller's guard does not allow an input.
    #[error(transparent)]
    Refused(Box<dyn std::error::Error + Send + Sync>),
    /// A case with distributions has no single result.
    #[error("only `carom impact` computes a case with [uncertainty]")]
    Uncertainty,
    /// A case with unknowns has no single result.
    #[error("`{0}` is unknown; only `carom fit` computes a case with unknowns, from data")]
    Unknown(&'static str),
    /// A traction could not be integrated.
    #[error("cannot integrate a traction: {0}")]
    Quadrature(#[from] QuadratureError),
    /// A result is not finite.
    #[error("{quantity} = {value} is not finite: numbers of the case are too large or too small")]
    Overflow {
        /// The name of the result.
        quantity: String,
        /// Its value.
        value: f64,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, place, kind } = self;
        if let (Some(path), ErrorKind::Io { action, source, hint }) = (path, &**kind) {
            return write!(f, "cannot {action} {}: {source}{hint}", path.display());
        }
        if let Some(path) = path {
            write!(f, "{}: ", path.display())?;
        }
        if let Some((what, number)) = place {
            write!(f, "{what} {number}: ")?;
        }
        write!(f, "{kind}")
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.kind.source()
    }
}

impl<K: Into<ErrorKind>> From<K> for Error {
    fn from(kind: K) -> Self {
        Self { path: None, place: None, kind: Box::new(kind.into()) }
    }
}

impl From<CaseError> for ErrorKind {
    fn from(source: CaseError) -> Self {
        Self::Case { message: source.to_string(), source }
    }
}

impl Error {
    /// The error of an input, with its reason.
    #[must_use]
    pub fn input(reason: impl Into<String>) -> Self {
        ErrorKind::Input(reason.into()).into()
    }

    /// The error of the system in reading or writing `path`.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::from(ErrorKind::Io { action, source, hint: "" }).of_file(path)
    }

    /// The same error in this file, unless it names another one.
    #[must_use]
    pub fn of_file(mut self, path: &Path) -> Self {
        self.path.get_or_insert_with(|| path.to_owned());
        self
    }

    /// The same error in the step, row or load of this number.
    #[must_use]
    pub fn at(self, what: &'static str, number: usize) -> Self {
        Self { place: Some((what, number)), ..self }
    }

    /// The same error; of a path where no file is, with what was expected there.
    #[must_use]
    pub(crate) fn hinting(mut self, expected: &'static str) -> Self {
        use std::io::ErrorKind::{IsADirectory, NotFound};
        if let ErrorKind::Io { source, hint, .. } = &mut *self.kind
            && matches!(source.kind(), NotFound | IsADirectory)
        {
            *hint = expected;
        }
        self
    }

    /// Whether the input causes the error, not the computation or the system.
    #[must_use]
    pub fn is_bad_input(&self) -> bool {
        match &*self.kind {
            ErrorKind::Collision(source) => is_bad_collision(source),
            ErrorKind::Uncertain(UncertainError::Collision { source, .. }) => {
                is_bad_collision(source)
            }
            ErrorKind::Step(source) => is_beyond_chosen(source),
            ErrorKind::Fit(source) => is_bad_fit(source, is_beyond_chosen),
            ErrorKind::Scene(SceneError::Collision { source, .. }) => is_bad_collision(source),
            ErrorKind::Rolling(source) => is_beyond_rolling(source),
            ErrorKind::RollingFit(source) => is_bad_fit(source, is_beyond_rolling),
            ErrorKind::Bellows(source) => matches!(source, BellowsError::Range(_)),
            ErrorKind::Flange(source) => matches!(source, FlangeError::Range(_)),
            ErrorKind::Case { .. }
            | ErrorKind::Range(_)
            | ErrorKind::Unknown(_)
            | ErrorKind::Uncertain(_)
            | ErrorKind::Border(_)
            | ErrorKind::Problem(_)
            | ErrorKind::Scene(_)
            | ErrorKind::Contact(_)
            | ErrorKind::Steps(_)
            | ErrorKind::Input(_)
            | ErrorKind::Refused(_)
            | ErrorKind::Uncertainty
            | ErrorKind::Overflow { .. } => true,
            ErrorKind::Interrupted | ErrorKind::Io { .. } | ErrorKind::Quadrature(_) => false,
        }
    }
}

/// A hint for the case that an older method cannot solve it.
const fn advice(error: &ChosenError) -> &'static str {
    match error {
        ChosenError::Classic(DirectError::Range(_) | DirectError::Operator(_)) => "",
        ChosenError::Classic(_) => "; `contact.method` = \"newton\", the default, solves it",
        _ => "",
    }
}

/// Whether no grid can be found for what is prescribed.
fn is_bad_fit<E: std::error::Error>(error: &FitError<E>, is_beyond: impl Fn(&E) -> bool) -> bool {
    match error {
        FitError::Range(_)
        | FitError::Problem(_)
        | FitError::NoWindow { .. }
        | FitError::Endless { .. } => true,
        FitError::Method(source) => is_beyond(source),
        _ => false,
    }
}

/// Whether the step that a method is to solve is impossible.
const fn is_beyond_chosen(error: &ChosenError) -> bool {
    match error {
        ChosenError::Main(source) => is_beyond(source),
        ChosenError::Normal(source) => !matches!(source, NormalError::NotConverged { .. }),
        ChosenError::Classic(source) => {
            !matches!(source, DirectError::NotConverged { .. } | DirectError::Singular { .. })
        }
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

/// Whether the prescribed collision itself is impossible; a failed computation is not.
const fn is_bad(error: &CollisionError) -> bool {
    !matches!(
        error,
        CollisionError::Oblique(_) | CollisionError::Coupled(_) | CollisionError::NoSeparation
    )
}

/// Whether the prescribed collision with its law is impossible.
const fn is_bad_collision(error: &CollisionLawError) -> bool {
    match error {
        CollisionLawError::Collision(error) => is_bad(error),
        CollisionLawError::Rings(RingImpactError::Collision(error)) => is_bad(error),
        CollisionLawError::Rings(error) => matches!(error, RingImpactError::Range(_)),
        CollisionLawError::Numerical(error) => matches!(error, NumericalImpactError::Range(_)),
    }
}
