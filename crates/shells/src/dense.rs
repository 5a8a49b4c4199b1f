//! Dense linear systems, solved by elimination with row exchange.

use faer::linalg::solvers::Solve as _;
use faer::{Mat, c64};

/// A matrix without an inverse, in floating point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the matrix of {unknowns} unknowns has no inverse")]
pub struct Singular {
    /// Number of unknowns.
    pub unknowns: usize,
}

/// The solution of a complex system.
pub(crate) fn solve(matrix: &Mat<c64>, right: &Mat<c64>) -> Result<Mat<c64>, Singular> {
    let solution = matrix.partial_piv_lu().solve(right);
    let is_finite = (0..solution.ncols()).all(|j| {
        (0..solution.nrows())
            .all(|i| solution[(i, j)].re.is_finite() && solution[(i, j)].im.is_finite())
    });
    if is_finite { Ok(solution) } else { Err(Singular { unknowns: matrix.nrows() }) }
}

/// The inverse of a complex matrix.
pub(crate) fn inverse(matrix: &Mat<c64>) -> Result<Mat<c64>, Singular> {
    solve(matrix, &Mat::identity(matrix.nrows(), matrix.nrows()))
}
