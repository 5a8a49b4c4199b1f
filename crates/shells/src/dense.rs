//! Dense linear systems, with an error where they have no solution.

use carom_dense::{Mat, c64};

/// A matrix without an inverse, in floating point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the matrix of {unknowns} unknowns has no inverse")]
pub struct Singular {
    /// Number of unknowns.
    pub unknowns: usize,
}

/// A factorised real matrix.
pub(crate) struct Factors(carom_dense::Factors);

impl Factors {
    pub(crate) fn new(matrix: &Mat<f64>) -> Self {
        Self(carom_dense::Factors::new(matrix))
    }

    /// Whether the determinant is negative.
    pub(crate) fn is_negative(&self) -> bool {
        self.0.is_negative()
    }

    /// The solution for one right-hand side.
    pub(crate) fn solve(&self, right: &[f64]) -> Result<Vec<f64>, Singular> {
        let found = self.0.solve(right);
        let is_finite = found.iter().all(|x| x.is_finite());
        if is_finite { Ok(found) } else { Err(Singular { unknowns: found.len() }) }
    }
}

/// The solution of a complex system.
pub(crate) fn solve(matrix: &Mat<c64>, right: &Mat<c64>) -> Result<Mat<c64>, Singular> {
    let solution = carom_dense::solve_complex(matrix, right);
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
