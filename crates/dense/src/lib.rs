//! Dense linear systems: elimination with row exchange, eigenvalues, products.
//!
//! The library `faer` is generic, so that each crate that factorises a matrix compiles it anew, in half a minute. The
//! functions here are not generic: only this crate compiles it. A system without a solution, in floating point, gives
//! values that are not finite; callers check them. Sizes that do not fit together are faults of the caller and panic.
//!
//! ```
//! use carom_dense::{Factors, Mat};
//! let matrix = Mat::from_fn(2, 2, |row, column| [[2.0, 1.0], [0.0, 4.0]][row][column]);
//! assert_eq!(Factors::new(&matrix).solve(&[4.0, 8.0]), [1.0, 2.0]);
//! ```
#![forbid(unsafe_code)]

pub use faer::{Mat, MatRef, c64};

use faer::Col;
use faer::linalg::solvers::{PartialPivLu, Solve as _};

/// A square real matrix as the product of triangular factors, P A = L U.
#[derive(Debug, Clone)]
pub struct Factors(PartialPivLu<f64>);

impl Factors {
    /// Factorises a square matrix.
    pub fn new(matrix: &Mat<f64>) -> Self {
        Self(matrix.partial_piv_lu())
    }

    /// The solution for one right-hand side, which has as many numbers as the matrix has rows.
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let solution = self.0.solve(&Col::from_fn(right.len(), |row| right[row]));
        solution.iter().copied().collect()
    }

    /// The solutions for the columns of a matrix.
    pub fn solve_columns(&self, right: &Mat<f64>) -> Mat<f64> {
        self.0.solve(right)
    }

    /// Whether the determinant is negative: minus signs on the diagonal of U, and exchanges of rows, are odd in number.
    pub fn is_negative(&self) -> bool {
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
}

/// The solutions of a complex system for the columns of a matrix.
pub fn solve_complex(matrix: &Mat<c64>, right: &Mat<c64>) -> Mat<c64> {
    matrix.partial_piv_lu().solve(right)
}

/// The eigenvalues of a square real matrix; `None` if an entry is not finite or the iteration does not converge.
pub fn eigenvalues(matrix: &Mat<f64>) -> Option<Vec<c64>> {
    let is_finite =
        (0..matrix.ncols()).all(|k| matrix.col(k).iter().all(|value| value.is_finite()));
    if is_finite { matrix.eigenvalues().ok() } else { None }
}

/// The product of two matrices.
pub fn product(left: MatRef<'_, f64>, right: MatRef<'_, f64>) -> Mat<f64> {
    left * right
}

/// The root of the sum of the squares of all entries.
pub fn norm(matrix: &Mat<f64>) -> f64 {
    matrix.norm_l2()
}
