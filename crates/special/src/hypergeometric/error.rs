//! Errors of the hypergeometric functions.

use crate::RangeError;

/// Why a hypergeometric function cannot be evaluated.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum HypergeometricError {
    /// A parameter or the argument is out of its range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The series diverges at unit argument, as its parametric excess is not positive.
    #[error("the function is infinite at 1: the parametric excess {excess} is not positive")]
    Divergent {
        /// Sum of the lower parameters minus that of the upper ones.
        excess: f64,
    },
    /// The value exceeds the largest finite number.
    #[error("the value overflows")]
    Overflow,
    /// Cancellation between the terms leaves fewer correct digits than specified.
    #[error("the terms cancel: the value {value} has an estimated error of {bound}")]
    Cancellation {
        /// The computed value.
        value: f64,
        /// An estimate of its absolute error.
        bound: f64,
    },
}
