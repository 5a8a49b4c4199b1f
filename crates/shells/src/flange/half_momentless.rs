//! The edge of a tube by the half-momentless theory and the edge effect.
//!
//! The main part follows v and u of the edge: without hoop strain and shear W = -ik v and
//! W_x = -k^2 u/R. The boundary part takes what is left, w - W and beta - W_x.

use std::f64::consts::PI;

use carom_dense::c64;
use nalgebra::{Matrix2, Matrix2x4, Matrix4};

use super::tube::Tube;

/// Beyond this mu L the far end is not felt: e^(-2 * 18) = 2e-16.
const LONG: f64 = 18.0;

/// mu of harmonic n.
pub(super) fn main_decay(tube: &Tube, n: f64) -> f64 {
    let (r, t, nu) = (tube.radius(), tube.wall().thickness(), tube.wall().poisson());
    if n < 2.0 {
        return 0.0;
    }
    // mu^2 = n^2 (n^2 - 1) t/(2 R^3 sqrt(12(1 - nu^2)))
    (0.5 * n * n * (n * n - 1.0) * (t / r) / (12.0 * (1.0 - nu * nu)).sqrt()).sqrt() / r
}

/// lambda.
pub(super) fn boundary_decay(tube: &Tube) -> f64 {
    let (r, t, nu) = (tube.radius(), tube.wall().thickness(), tube.wall().poisson());
    (3.0 * (1.0 - nu * nu)).sqrt().sqrt() / (r * t).sqrt()
}

/// Stiffness against (w, v, u, beta) of the edge in harmonic k.
pub(super) fn stiffness(tube: &Tube, k: i64) -> Matrix4<c64> {
    let k = k as f64;
    let mut main_motion = Matrix2x4::<c64>::zeros();
    main_motion[(0, 1)] = c64::new(0.0, -k);
    main_motion[(1, 2)] = c64::new(-k * k / tube.radius(), 0.0);
    let mut rest = -main_motion;
    rest[(0, 0)] += 1.0;
    rest[(1, 3)] += 1.0;
    let by_rest = rest.adjoint() * complex(boundary(tube)) * rest;
    if k == 0.0 {
        return by_rest;
    }
    by_rest + main_motion.adjoint() * complex(main(tube, k.abs())) * main_motion
}

fn complex(matrix: Matrix2<f64>) -> Matrix2<c64> {
    matrix.map(|value| c64::new(value, 0.0))
}

/// The edge effect, on (w_e, w_e,x): 2 pi R D [[4 lambda^3, 2 lambda^2], [2 lambda^2, 2 lambda]].
fn boundary(tube: &Tube) -> Matrix2<f64> {
    let lambda = boundary_decay(tube);
    semi_infinite(2.0 * PI * tube.radius() * tube.wall().bending_stiffness(), lambda)
}

/// A semi-infinite beam of stiffness b on a foundation.
fn semi_infinite(b: f64, decay: f64) -> Matrix2<f64> {
    let both = 2.0 * b * decay * decay;
    Matrix2::new(2.0 * both * decay, both, both, 2.0 * b * decay)
}

/// The main part of harmonic n >= 1, on (W, W_x).
fn main(tube: &Tube, n: f64) -> Matrix2<f64> {
    let r = tube.radius();
    let wall = tube.wall();
    let b = 2.0 * PI * wall.young_modulus() * wall.thickness() * r * r * r / (n * n * n * n);
    let mu = main_decay(tube, n);
    match tube.length() {
        Some(length) if mu * length < LONG => clamped(b, mu, length),
        _ => semi_infinite(b, mu),
    }
}

/// A beam of stiffness b and length l on a foundation, clamped at its far end (Hetenyi). With
/// S, C, s, c = sinh, cosh, sin, cos of mu l and d = S^2 - s^2:
/// 4 b mu^3 (S C + s c)/d, 2 b mu^2 (S^2 + s^2)/d, 2 b mu (S C - s c)/d.
fn clamped(b: f64, mu: f64, length: f64) -> Matrix2<f64> {
    let x = mu * length;
    let [plus, squares, minus] = if x < 1.0 { by_series(x) } else { by_functions(x) };
    let (one, two, three) = (b / length, b / (length * length), b / (length * length * length));
    Matrix2::new(three * plus, two * squares, two * squares, one * minus)
}

/// The three numbers that are 12, 6 and 4 for a beam without foundation.
fn by_functions(x: f64) -> [f64; 3] {
    let (big_s, big_c, s, c) = (libm::sinh(x), libm::cosh(x), libm::sin(x), libm::cos(x));
    let d = (big_s - s) * (big_s + s);
    [
        4.0 * x * x * x * (big_s * big_c + s * c) / d,
        2.0 * x * x * (big_s * big_s + s * s) / d,
        2.0 * x * (big_s * big_c - s * c) / d,
    ]
}

/// The same without cancellation for small x: the products are sums of (2x)^(4k+i)/(4k+i)!.
fn by_series(x: f64) -> [f64; 3] {
    let z = libm::pow(2.0 * x, 4.0);
    // sum of z^k/(4k + i)!
    let sum = |i: u32| {
        let factorial: f64 = (1..=i).map(f64::from).product();
        let mut term = 1.0 / factorial;
        let mut total = term;
        for k in 1..8 {
            let last = f64::from(4 * k + i);
            term *= z / (last * (last - 1.0) * (last - 2.0) * (last - 3.0));
            total += term;
        }
        total
    };
    let d = sum(4);
    [0.5 * sum(1) / d, 0.5 * sum(2) / d, sum(3) / d]
}
