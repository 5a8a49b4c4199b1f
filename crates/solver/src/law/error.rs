//! Errors of the numerical law.

use carom_special::RangeError;

use crate::frictional::FrictionalError;
use crate::problem::ProblemError;

/// Why a step of the numerical law failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NumericalLawError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The contact problem could not be built.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The step could not be solved.
    #[error(transparent)]
    Step(#[from] FrictionalError),
}
