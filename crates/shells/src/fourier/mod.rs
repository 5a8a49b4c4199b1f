//! Fourier series as vectors, products with known functions as matrices (Axelrad 1983).
//!
//! A periodic function f = sum f_k e^(ik phi) is the vector of its coefficients. Then
//!
//! | operation | complex series | even (cosine) and odd (sine) series |
//! |---|---|---|
//! | product with f | Toeplitz matrix T(f), entry f_(k-j) | [`EvenSeries::cos_to_cos`], [`EvenSeries::sin_to_sin`], [`OddSeries::sin_to_cos`], [`OddSeries::cos_to_sin`] |
//! | derivative | diagonal ik | cosine to sine with -k, sine to cosine with k |
//! | division by f | solution with T(f) | solution with the product matrix |
//!
//! A product of orders n and m has order n + m, so the matrix for order n needs the coefficients
//! of f up to order 2n. T(f) T(g) is T(f g) only without truncation: known functions are
//! multiplied before the matrix is made.
//!
//! **The rule of the jump.** If f and g jump at the same place but their product does not (bending
//! stiffness and curvature of a ring at a bolt hole), T(f) converges slowly, T(1/f)^-1 as for a
//! smooth function ([`ComplexSeries::times_across_jump`]; L. Li, J. Opt. Soc. Am. A 13 (1996) 1870).

mod complex;
mod real;
mod sector;

pub use complex::ComplexSeries;
pub(crate) use complex::toeplitz;
pub use real::{EvenSeries, OddSeries};
pub(crate) use real::{HalfCircle, MOST_SAMPLES};
pub use sector::{PiecewiseConstant, Sector};

pub use crate::dense::Singular;
pub use nalgebra::Complex;
