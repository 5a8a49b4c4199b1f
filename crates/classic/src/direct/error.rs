//! Why a step of a method of chapters 11 and 12 failed.

use carom_halfspace::operator::OperatorError;
use carom_special::RangeError;

use carom_solver::Convergence;

/// Why a step of a method with direct coefficients failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DirectError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// The load of a motion is prescribed.
    #[error("{load} is prescribed, but this method allows shifts only; `Frictional` allows loads")]
    GivenLoad {
        /// The prescribed load.
        load: &'static str,
    },
    /// Static and kinetic friction differ.
    #[error(
        "static friction {rest} and kinetic friction {motion} differ: this method requires equal ones"
    )]
    TwoFrictions {
        /// The static coefficient.
        rest: f64,
        /// The kinetic coefficient.
        motion: f64,
    },
    /// The materials couple normal and tangential displacements.
    #[error(
        "normal and tangential displacements are coupled: the {method} process takes bodies of \
         similar material; Panagiotopoulos, Kombi, GaussSeidel and Frictional take any"
    )]
    Coupled {
        /// The method that does not apply.
        method: &'static str,
    },
    /// A linear system has no solution.
    #[error("the linear system of {unknowns} unknowns is singular")]
    Singular {
        /// Its size.
        unknowns: usize,
    },
    /// More unknowns than a dense matrix is allowed to have.
    #[error(
        "{unknowns} unknowns need a dense matrix of more than {allowed} rows; GaussSeidel and \
         Frictional need none"
    )]
    TooMany {
        /// Number of unknowns.
        unknowns: usize,
        /// Greatest number allowed.
        allowed: usize,
    },
    /// The iterations ended before the tolerance was reached.
    #[error(
        "pressures and tractions did not converge to {tolerance:.1e}: {:.1e} (normal), {:.1e} \
         (tangential) after {} iterations ({})",
        .reached.residuals.normal, .reached.residuals.tangential, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// The tolerance.
        tolerance: f64,
        /// The convergence up to then.
        reached: Convergence,
    },
}
