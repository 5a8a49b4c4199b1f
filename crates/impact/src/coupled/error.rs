//! Errors of a coupled impact.

use carom_special::RangeError;

use super::LawFailure;
use crate::oblique::ObliqueError;

/// Why a coupled impact cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CoupledError<E: std::error::Error + 'static = RangeError> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The exact solution of an uncoupled impact failed.
    #[error(transparent)]
    Oblique(#[from] ObliqueError),
    /// A step of the contact law failed.
    #[error(transparent)]
    Law(LawFailure<E>),
    /// The bodies do not separate within 2^14 times the steps of a free impact.
    #[error(
        "the bodies do not separate within 2^14 times the steps of a free impact of {duration:e}"
    )]
    NoSeparation {
        /// The duration of the free impact.
        duration: f64,
    },
    /// The refinement did not converge to the tolerance before the runs became too long.
    #[error(
        "not converged: after {steps} steps with {rings} annuli the estimated error is \
         {error_estimate:e} of |v_A|, above the tolerance {tolerance:e}"
    )]
    NotSettled {
        /// Estimated error of the best velocity, over |v_A|.
        error_estimate: f64,
        /// The requested tolerance.
        tolerance: f64,
        /// Steps of the finest run.
        steps: usize,
        /// Number of annuli of that run, if the law has annuli.
        rings: usize,
    },
}
