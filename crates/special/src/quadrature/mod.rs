//! Integrals over a finite interval: fixed Gauss-Legendre, adaptive Gauss-Kronrod, tanh-sinh.
//!
//! | rule | use |
//! |---|---|
//! | [`GaussLegendre`] | smooth integrand, known order; nothing allocated while integrating |
//! | [`FixedRule`] | the same, with the order fixed at compile time |
//! | [`adaptive`] | piecewise smooth, unknown difficulty; with an error estimate |
//! | [`tanh_sinh`] | algebraic or logarithmic singularities at the ends |
//!
//! If the tolerance is not met, the last two return an error that contains the value and the
//! estimate.

mod gauss_kronrod;
mod gauss_legendre;
mod tanh_sinh;
mod twofold;

pub use gauss_kronrod::adaptive;
pub use gauss_legendre::{FixedRule, GaussLegendre, Node};
pub use tanh_sinh::{Abscissa, tanh_sinh};

use crate::RangeError;

/// The required accuracy of an integral: the estimated error is at most the larger of both
/// tolerances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    absolute: f64,
    relative: f64,
}

impl Tolerance {
    /// An absolute and a relative tolerance.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite and not negative and one is positive.
    pub fn new(absolute: f64, relative: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("absolute_tolerance", absolute)?;
        RangeError::non_negative("relative_tolerance", relative)?;
        let holds = absolute > 0.0 || relative > 0.0;
        RangeError::check(
            "relative_tolerance",
            relative,
            holds,
            "> 0 if the absolute tolerance is 0",
        )?;
        Ok(Self { absolute, relative })
    }

    /// A relative tolerance only.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite and positive.
    pub fn relative(relative: f64) -> Result<Self, RangeError> {
        RangeError::positive("relative_tolerance", relative)?;
        Self::new(0.0, relative)
    }

    fn allows(self, integral: Integral) -> bool {
        integral.error <= self.absolute.max(self.relative * integral.value.abs())
    }
}

/// The value of an integral with its error estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// The value.
    pub value: f64,
    /// The estimated absolute error.
    pub error: f64,
    /// Number of evaluations of the integrand.
    pub evaluations: usize,
}

/// Why an integral could not be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum QuadratureError {
    /// A bound is not finite.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The integrand is infinite or NaN.
    #[error("the integrand is not finite at {position}")]
    Undefined {
        /// The point at which it is not finite.
        position: f64,
    },
    /// The tolerance is not met.
    #[error(
        "no convergence after {} evaluations: {} with an estimated error of {}",
        integral.evaluations, integral.value, integral.error
    )]
    NotConverged {
        /// The best value, with its error estimate.
        integral: Integral,
    },
}

/// The value, or an error if it is not finite.
fn finite(value: f64, position: f64) -> Result<f64, QuadratureError> {
    if value.is_finite() { Ok(value) } else { Err(QuadratureError::Undefined { position }) }
}

/// Checks the bounds.
fn check_bounds(lower: f64, upper: f64) -> Result<(), RangeError> {
    RangeError::finite("lower", lower)?;
    let holds = upper.is_finite() && (upper - lower).is_finite();
    RangeError::check("upper", upper, holds, "finite, with a finite distance to lower")?;
    Ok(())
}
