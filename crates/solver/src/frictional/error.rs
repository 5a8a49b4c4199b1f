//! Errors of a step with friction.

use carom_halfspace::operator::OperatorError;
use carom_special::{RangeError, Readable};

use crate::convergence::{Convergence, Stop};
use crate::problem::PeriodError;

/// Why a step with friction failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FrictionalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// No load on a periodic surface gives the prescribed shift.
    #[error(transparent)]
    Period(#[from] PeriodError),
    /// The prescribed tangential force exceeds what friction can hold: the bodies slide.
    #[error(
        "the tangential force {force} is not below the friction limit {}: the bodies slide",
        rounded(*.limit)
    )]
    Slides {
        /// The tangential force.
        force: f64,
        /// The greatest force that friction can hold, the sum of f p over the cells; relative error
        /// 1e-12.
        limit: f64,
    },
    /// The prescribed torque, alone or with a force, exceeds what friction can hold: the bodies
    /// rotate on each other.
    #[error(
        "friction can hold less than {part} times the torque {torque} and the tangential force {force}: \
         the bodies slide"
    )]
    Turns {
        /// The torque.
        torque: f64,
        /// The tangential force.
        force: f64,
        /// The fraction of the prescribed loads that friction can hold; at most 1.
        part: f64,
    },
    /// The iterations ended before the tolerance was reached.
    #[error(
        "the {what} did not converge to {tolerance:.1e}: {:.1e} (normal), {:.1e} (tangential) after \
         {} iterations ({})",
        .reached.residuals.normal, .reached.residuals.tangential, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// The unknowns that did not converge: pressures, tractions, or both together.
        what: &'static str,
        /// The tolerance.
        tolerance: f64,
        /// The convergence up to then.
        reached: Convergence,
    },
}

/// What is solved for when pressures and tractions are in equilibrium with each other.
pub(super) const TOGETHER: &str = "pressures and tractions together";

impl FrictionalError {
    /// Whether iterations ended on their own without a solution, so that others may find one.
    pub(super) fn lets_others_try(&self) -> bool {
        matches!(self, Self::NotConverged { reached, .. } if reached.stop != Stop::Observer)
    }
}

pub(super) fn converged(
    what: &'static str,
    tolerance: f64,
    reached: Convergence,
) -> Result<Convergence, FrictionalError> {
    if reached.stop == Stop::Converged {
        Ok(reached)
    } else {
        Err(FrictionalError::NotConverged { what, tolerance, reached })
    }
}

/// As many digits of a limit as are known.
fn rounded(limit: f64) -> Readable {
    Readable(format!("{limit:.9e}").parse().unwrap_or(limit))
}
