//! Why a coupled impact cannot be computed.

use carom_special::RangeError;

use super::LawFailure;
use crate::oblique::ObliqueError;

/// Why a coupled impact cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CoupledError<E: std::error::Error + 'static = RangeError> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The exact walk of an uncoupled impact failed.
    #[error(transparent)]
    Oblique(#[from] ObliqueError),
    /// A step of the contact law failed.
    #[error(transparent)]
    Law(LawFailure<E>),
    /// The bodies stay together for 2^14 times the steps of a free impact.
    #[error(
        "the bodies do not separate within 2^14 times the steps of a free impact of {duration:e}"
    )]
    NoSeparation {
        /// The duration of the free impact.
        duration: f64,
    },
    /// Ever finer runs did not agree to the tolerance before they became too long.
    #[error(
        "not settled: {steps} steps and {rings} rings leave an error of {error_estimate:e} of |v_A|, \
         asked for {tolerance:e}"
    )]
    NotSettled {
        /// How far the best velocity may be off, over |v_A|.
        error_estimate: f64,
        /// What was asked for.
        tolerance: f64,
        /// Steps of the finest run.
        steps: usize,
        /// Its rings, where the law has rings.
        rings: usize,
    },
}
