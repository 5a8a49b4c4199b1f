//! Solutions, signs, eigenvalues and products of matrices whose answers are known.

use approx::assert_abs_diff_eq;
use carom_dense::{Factors, Mat, c64, eigenvalues, norm, product, solve_complex};

fn matrix<const N: usize>(rows: [[f64; N]; N]) -> Mat<f64> {
    Mat::from_fn(N, N, |row, column| rows[row][column])
}

/// A cyclic exchange of rows with factors: its pivots are elsewhere than on the diagonal.
const TURNED: [[f64; 3]; 3] = [[0.0, 2.0, 1.0], [0.0, 0.0, -3.0], [4.0, 1.0, 0.0]];

#[test]
fn solutions_meet_their_equations() {
    let turned = matrix(TURNED);
    let factors = Factors::new(&turned);
    // By hand: the second row gives z, the first y, the third x.
    assert_eq!(factors.solve(&[5.0, -3.0, 6.0]), [1.0, 2.0, 1.0]);
    let right = Mat::from_fn(3, 2, |row, column| (3 * row + column) as f64 - 2.0);
    let left = product(turned.as_ref(), factors.solve_columns(&right).as_ref());
    assert_abs_diff_eq!(norm(&(left - right)), 0.0, epsilon = 1e-14);
}

#[test]
fn complex_solutions_meet_their_equations() {
    let i = c64::new(0.0, 1.0);
    let matrix =
        Mat::from_fn(2, 2, |row, column| if row == column { i } else { c64::new(2.0, 0.0) });
    let right = Mat::from_fn(2, 1, |row, _| if row == 0 { i } else { c64::new(2.0, 0.0) });
    let found = solve_complex(&matrix, &right);
    assert_abs_diff_eq!((found[(0, 0)] - c64::new(1.0, 0.0)).norm(), 0.0, epsilon = 1e-15);
    assert_abs_diff_eq!(found[(1, 0)].norm(), 0.0, epsilon = 1e-15);
}

#[test]
fn a_determinant_has_its_sign() {
    // -24, 24 after an exchange of rows, and 24 with the signs of two rows.
    let [a, b, c] = TURNED;
    let minus = |row: [f64; 3]| row.map(|x| -x);
    for (rows, is_negative) in [
        ([a, b, c], true),
        ([b, a, c], false),
        ([minus(a), b, c], false),
        ([minus(a), minus(b), c], true),
    ] {
        assert_eq!(Factors::new(&matrix(rows)).is_negative(), is_negative, "{rows:?}");
    }
}

#[test]
fn a_singular_system_has_no_finite_solution() {
    let factors = Factors::new(&matrix([[1.0, 1.0], [1.0, 1.0]]));
    assert!(factors.solve(&[1.0, 2.0]).iter().any(|x| !x.is_finite()));
}

#[test]
fn eigenvalues_are_the_roots_of_the_polynomial() {
    // Companion of (x - 3)(x^2 + 4).
    let mut found =
        eigenvalues(&matrix([[3.0, -4.0, 12.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])).unwrap();
    found.sort_by(|one, other| one.im.total_cmp(&other.im));
    for (found, exact) in found.iter().zip([[0.0, -2.0], [3.0, 0.0], [0.0, 2.0]]) {
        assert_abs_diff_eq!(found.re, exact[0], epsilon = 1e-13);
        assert_abs_diff_eq!(found.im, exact[1], epsilon = 1e-13);
    }
    assert!(eigenvalues(&matrix([[f64::NAN, 0.0], [0.0, 1.0]])).is_none());
}
