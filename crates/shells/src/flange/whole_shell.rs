//! The edge of a semi-infinite tube by the shell theory of Koiter and Sanders.
//!
//! In harmonic n the displacements are (u cos, v sin, w cos) e^(px), with lengths in units of R.
//! Six strains e(p) of (u, v, w), elastic matrix H: equilibrium is e(-p)^T H e(p) a = 0. Four of
//! the eight p decay. The stiffness is the energy of their sum:
//! E_ij = -s_i^H H s_j/(conj p_i + p_j) with s = e(p) a, K = Y^-H E Y^-1, where column i of Y is
//! (w, v, u, pw). Being an energy, it is insensitive to the rounding of p and a.

use std::f64::consts::PI;

use carom_dense::c64;
use nalgebra::{Matrix3, Matrix4, SMatrix, Vector3, Vector4};

use super::polynomial::{Polynomial, product, quartic_roots, reflected, square_root, sum};
use super::tube::Tube;
use crate::dense::Singular;

type Strains = SMatrix<c64, 6, 3>;

/// Stiffness against (w, v, u, beta) in harmonic k, |k| >= 2.
pub(super) fn stiffness(tube: &Tube, k: i64) -> Result<Matrix4<c64>, Singular> {
    let shell = Shell::new(tube, k.unsigned_abs() as f64);
    let unit = by_cosines(&shell)?;
    let r = tube.radius();
    // Energy 2 pi R^2 C times the pure number; v sin n phi is i sign(k) v e^(ik phi).
    let scale = 2.0 * PI * r * r * tube.wall().stretching_stiffness();
    let turn = c64::new(0.0, if k < 0 { -1.0 } else { 1.0 });
    let one = c64::new(1.0, 0.0);
    let to_cosines = Vector4::new(one / r, turn / r, one / r, one);
    let entry = |i: usize, j: usize| to_cosines[i].conj() * (unit[(i, j)] * scale) * to_cosines[j];
    Ok(Matrix4::from_fn(entry))
}

/// Strains of a harmonic, each times the root of its stiffness, so that the energy density is
/// half the sum of their squares.
struct Shell {
    harmonic: f64,
    poisson: f64,
    /// D/(C R^2) = t^2/(12 R^2).
    bending: f64,
}

impl Shell {
    fn new(tube: &Tube, harmonic: f64) -> Self {
        let thinness = tube.wall().thickness() / tube.radius();
        Self { harmonic, poisson: tube.wall().poisson(), bending: thinness * thinness / 12.0 }
    }

    /// Coefficients of 1, p, p^2 of each weighted strain by each of (u, v, w).
    fn strains(&self) -> [[[f64; 3]; 3]; 6] {
        let (n, nu) = (self.harmonic, self.poisson);
        let zero = [0.0; 3];
        let axial = [[0.0, 1.0, 0.0], zero, zero];
        let hoop = [zero, [n, 0.0, 0.0], [1.0, 0.0, 0.0]];
        let shear = [[-n, 0.0, 0.0], [0.0, 1.0, 0.0], zero];
        let axial_curvature = [zero, zero, [0.0, 0.0, -1.0]];
        let hoop_curvature = [zero, [n, 0.0, 0.0], [n * n, 0.0, 0.0]];
        let twist = [[0.25 * n, 0.0, 0.0], [0.0, 0.75, 0.0], [0.0, n, 0.0]];
        let across = (1.0 - nu * nu).sqrt();
        let bend = self.bending.sqrt();
        let combine = |a: f64, one: [[f64; 3]; 3], b: f64, other: [[f64; 3]; 3]| {
            std::array::from_fn(|i| std::array::from_fn(|j| a * one[i][j] + b * other[i][j]))
        };
        [
            combine(1.0, axial, nu, hoop),
            combine(across, hoop, 0.0, hoop),
            combine((0.5 * (1.0 - nu)).sqrt(), shear, 0.0, shear),
            combine(bend, axial_curvature, bend * nu, hoop_curvature),
            combine(bend * across, hoop_curvature, 0.0, hoop_curvature),
            combine(bend * (2.0 * (1.0 - nu)).sqrt(), twist, 0.0, twist),
        ]
    }

    fn strains_at(strains: &[[[f64; 3]; 3]; 6], p: c64) -> Strains {
        Strains::from_fn(|i, j| {
            let [a, b, c] = strains[i][j];
            (p * c + b) * p + a
        })
    }

    /// The four p with negative real part.
    fn exponents(&self, strains: &[[[f64; 3]; 3]; 6]) -> [c64; 4] {
        let determinant = determinant(strains);
        // Donnell: (q - n^2)^2 = +-i a q for q = p^2.
        let a = ((1.0 - self.poisson * self.poisson) / self.bending).sqrt();
        let square = self.harmonic * self.harmonic;
        let half = c64::new(square, 0.5 * a);
        let root = square_root(half * half - square * square);
        let great = half + root;
        let small = c64::new(square * square, 0.0) / great;
        let guesses = [great, great.conj(), small, small.conj()];
        let even = std::array::from_fn(|i| determinant[2 * i]);
        quartic_roots(even, guesses).map(|q| -square_root(q))
    }
}

/// det(g(-p)^T g(p)) of the weighted strains g: the sum of products of 3 by 3 minors (Cauchy,
/// Binet). Its terms at p = 0 are squares, so that bending is not lost beside stretching.
fn determinant(strains: &[[[f64; 3]; 3]; 6]) -> Polynomial {
    let mut total = [0.0; 9];
    for i in 0..6 {
        for j in i + 1..6 {
            for k in j + 1..6 {
                let minor = minor([&strains[i], &strains[j], &strains[k]]);
                total = sum(&total, 1.0, &product(&reflected(&minor), &minor));
            }
        }
    }
    total
}

fn minor(rows: [&[[f64; 3]; 3]; 3]) -> Polynomial {
    let entry = |row: usize, column: usize| -> Polynomial {
        let [a, b, c] = rows[row][column];
        [a, b, c, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    let mut total = [0.0; 9];
    for column in 0..3 {
        let (next, last) = ((column + 1) % 3, (column + 2) % 3);
        let plus = product(&entry(1, next), &entry(2, last));
        let cofactor = sum(&plus, -1.0, &product(&entry(1, last), &entry(2, next)));
        total = sum(&total, 1.0, &product(&entry(0, column), &cofactor));
    }
    total
}

/// The stiffness against (w, v, u, beta) as amplitudes of (cos, sin, cos, cos), without unit.
fn by_cosines(shell: &Shell) -> Result<Matrix4<f64>, Singular> {
    let polynomials = shell.strains();
    let exponents = shell.exponents(&polynomials);
    let parts = exponents.map(|p| Part::new(p, &polynomials));
    let motions = Matrix4::from_columns(&parts.each_ref().map(|part| part.motion));
    let energies = Matrix4::from_fn(|i, j| {
        let product = parts[i].strains.adjoint() * parts[j].strains;
        -product[(0, 0)] / (parts[i].exponent.conj() + parts[j].exponent)
    });
    let singular = Singular { unknowns: 4 };
    let inverse = motions.try_inverse().ok_or(singular)?;
    let stiffness = (inverse.adjoint() * energies * inverse).map(|entry| entry.re);
    let stiffness = (stiffness + stiffness.transpose()) * 0.5;
    if stiffness.cholesky().is_some() { Ok(stiffness) } else { Err(singular) }
}

/// One decaying solution.
struct Part {
    exponent: c64,
    /// Weighted strains.
    strains: SMatrix<c64, 6, 1>,
    /// (w, v, u, pw).
    motion: Vector4<c64>,
}

impl Part {
    fn new(exponent: c64, polynomials: &[[[f64; 3]; 3]; 6]) -> Self {
        let strains = Shell::strains_at(polynomials, exponent);
        let matrix = Shell::strains_at(polynomials, -exponent).transpose() * strains;
        let shape = null_vector(&matrix);
        let motion = Vector4::new(shape[2], shape[1], shape[0], exponent * shape[2]);
        let size = motion.iter().map(|x| x.norm_sqr()).sum::<f64>().sqrt();
        let unit = c64::new(1.0 / size, 0.0);
        Self { exponent, strains: strains * (shape * unit), motion: motion * unit }
    }
}

/// The vector that a singular matrix maps to zero: the greatest cross product of two rows.
fn null_vector(matrix: &Matrix3<c64>) -> Vector3<c64> {
    let row = |i: usize| matrix.row(i).transpose();
    let candidates = [row(1).cross(&row(2)), row(2).cross(&row(0)), row(0).cross(&row(1))];
    let size = |v: &Vector3<c64>| v.iter().map(|x| x.norm_sqr()).sum::<f64>();
    let mut best = candidates[0];
    for candidate in &candidates[1..] {
        if size(candidate) > size(&best) {
            best = *candidate;
        }
    }
    best / c64::new(size(&best).sqrt(), 0.0)
}
