//! What can go wrong in a command, and the exit code for it.

use crate::case::CaseError;
use crate::command::StepsError;
use carom_classic::DirectError;
use carom_impact::oblique::ObliqueError;
use carom_impact::scene::SceneError;
use carom_impact::uncertain::UncertainError;
use carom_impact::{CollisionError, RingImpactError};
use carom_numerical::{CollisionLawError, NumericalImpactError};
use carom_plot::PlotError;
use carom_rolling::RollingError;
use carom_solver::{FitError, FrictionalError, ProblemError};
use carom_special::RangeError;
use carom_special::quadrature::QuadratureError;
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
    /// The scene of a case cannot be run.
    #[error("{}: {source}", path.display())]
    Scene {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: SceneError,
    },
    /// No sample of an uncertain case gives an outcome.
    #[error("{}: {source}", path.display())]
    Uncertain {
        /// The case file.
        path: PathBuf,
        /// Why.
        source: UncertainError,
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
    /// A traction could not be integrated.
    #[error("cannot work out a traction: {0}")]
    Quadrature(#[from] QuadratureError),
    /// An option has a value that cannot be.
    #[error("--{0}")]
    Option(#[from] RangeError),
    /// Options that exclude each other, or the case.
    #[error("{0}")]
    Options(&'static str),
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
            Self::Collision { source, .. } => of_collision(source),
            Self::Scene { source: SceneError::Collision { source, .. }, .. }
            | Self::Uncertain { source: UncertainError::Collision { source, .. }, .. } => {
                of_collision(source)
            }
            Self::CollisionLaw { source, .. } => match **source {
                CollisionLawError::Rings(RingImpactError::Range(_))
                | CollisionLawError::Numerical(NumericalImpactError::Range(_)) => 2,
                _ => 1,
            },
            Self::Step { source, .. } => match **source {
                FrictionalError::Range(_)
                | FrictionalError::Period(_)
                | FrictionalError::Slides { .. }
                | FrictionalError::Turns { .. } => 2,
                _ => 1,
            },
            Self::Fit { source, .. } => match **source {
                FitError::Range(_)
                | FitError::Problem(_)
                | FitError::NoWindow { .. }
                | FitError::Endless { .. }
                | FitError::Method(
                    FrictionalError::Range(_)
                    | FrictionalError::Period(_)
                    | FrictionalError::Slides { .. }
                    | FrictionalError::Turns { .. },
                ) => 2,
                _ => 1,
            },
            Self::Classic { source, .. } => match **source {
                DirectError::NotConverged { .. } | DirectError::Singular { .. } => 1,
                _ => 2,
            },
            Self::Rolling { source, .. } => match **source {
                RollingError::Range(_) => 2,
                _ => 1,
            },
            Self::Case { .. }
            | Self::Border { .. }
            | Self::Problem { .. }
            | Self::Overflow { .. }
            | Self::Uncertain { .. }
            | Self::Scene { .. }
            | Self::Law { .. }
            | Self::Steps { .. }
            | Self::Input { .. }
            | Self::Messages { .. }
            | Self::Destination { .. }
            | Self::Option(_)
            | Self::Options(_) => 2,
            Self::Impact(_)
            | Self::Quadrature(_)
            | Self::Io { .. }
            | Self::Threads { .. }
            | Self::Format(_)
            | Self::Plot(_) => 1,
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

/// An impact that could not be followed is no bad input.
const fn of_collision(error: &CollisionError) -> u8 {
    match error {
        CollisionError::Oblique(_) | CollisionError::Coupled(_) => 1,
        _ => 2,
    }
}
