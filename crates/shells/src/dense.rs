//! Dense linear systems, solved by elimination with row exchange.

use faer::linalg::solvers::{PartialPivLu, Solve as _};
use faer::{Mat, c64};

/// A matrix without an inverse, in floating point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the matrix of {unknowns} unknowns has no inverse")]
pub struct Singular {
    /// Number of unknowns.
    pub unknowns: usize,
}

/// A factorised real matrix.
pub(crate) struct Factors(PartialPivLu<f64>);

impl Factors {
    pub(crate) fn new(matrix: &Mat<f64>) -> Self {
        Self(matrix.partial_piv_lu())
    }

    /// Whether the determinant is negative.
    pub(crate) fn is_negative(&self) -> bool {
        let diagonal = self.0.U();
        let minus = (0..diagonal.nrows()).filter(|&i| diagonal[(i, i)] < 0.0).count();
        let (forward, _) = self.0.P().arrays();
        let mut seen = vec![false; forward.len()];
        let mut exchanges = 0;
        for start in 0..forward.len() {
            let mut at = start;
            while !seen[at] {
                seen[at] = true;
                at = forward[at];
                exchanges += usize::from(at != start);
            }
        }
        (minus + exchanges) % 2 == 1
    }

    /// The solution for one right-hand side.
    pub(crate) fn solve(&self, right: &[f64]) -> Result<Vec<f64>, Singular> {
        let right = Mat::from_fn(right.len(), 1, |i, _| right[i]);
        let solution = self.0.solve(&right);
        let found: Vec<f64> = (0..solution.nrows()).map(|i| solution[(i, 0)]).collect();
        let is_finite = found.iter().all(|x| x.is_finite());
        if is_finite { Ok(found) } else { Err(Singular { unknowns: found.len() }) }
    }
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
