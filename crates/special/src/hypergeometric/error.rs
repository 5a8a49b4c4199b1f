//! Why a hypergeometric function has no value here.

use crate::RangeError;

/// Why a hypergeometric function has no value here.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum HypergeometricError {
    /// A parameter or the argument is out of its range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The series diverges at unit argument, as its parametric excess is not positive.
    #[error("the function is infinite at 1: the parametric excess {excess} is not positive")]
    Divergent {
        /// Sum of the lower parameters less that of the upper ones.
        excess: f64,
    },
    /// The value is beyond the largest number.
    #[error("the value overflows")]
    Overflow,
    /// Cancellation between the terms leaves fewer digits than promised.
    #[error("cancellation: the value {value} has an estimated error of {bound}")]
    Cancellation {
        /// The value found.
        value: f64,
        /// An estimate of its absolute error.
        bound: f64,
    },
}
