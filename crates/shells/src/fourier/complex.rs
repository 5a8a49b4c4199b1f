//! Series of e^(ik phi).

use carom_dense::{Mat, c64};
use carom_special::RangeError;
use nalgebra::Complex;

use super::Singular;
use crate::dense;

/// A truncated series f = sum of f_k e^(ik phi), |k| <= order.
///
/// ```
/// use carom_shells::fourier::{Complex, ComplexSeries};
/// // cos phi times itself: 1/2 + (cos 2 phi)/2.
/// let [half, zero] = [0.5, 0.0].map(|real| Complex::new(real, 0.0));
/// let cosine = ComplexSeries::new(&[half, zero, half])?;
/// let square = cosine.times(&cosine, 2);
/// assert_eq!(square.at(0.0), Complex::new(1.0, 0.0));
/// assert!((square.at(0.3).re - 0.3_f64.cos().powi(2)).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexSeries {
    /// From -order to order.
    coefficients: Vec<c64>,
}

impl ComplexSeries {
    /// The series of coefficients from k = -order to order.
    ///
    /// # Errors
    /// [`RangeError`] unless their number is odd and all are finite.
    pub fn new(coefficients: &[Complex<f64>]) -> Result<Self, RangeError> {
        let count = coefficients.len();
        RangeError::check("number of coefficients", count as f64, count % 2 == 1, "odd")?;
        for value in coefficients {
            RangeError::finite("real part of a coefficient", value.re)?;
            RangeError::finite("imaginary part of a coefficient", value.im)?;
        }
        Ok(Self { coefficients: coefficients.to_vec() })
    }

    pub(crate) const fn from_coefficients(coefficients: Vec<c64>) -> Self {
        Self { coefficients }
    }

    /// The greatest |k|.
    #[must_use]
    pub const fn order(&self) -> usize {
        self.coefficients.len() / 2
    }

    /// Coefficient k; 0 beyond the order.
    #[must_use]
    pub fn coefficient(&self, k: i64) -> Complex<f64> {
        let index = k.checked_add(self.order() as i64).and_then(|i| usize::try_from(i).ok());
        index.and_then(|i| self.coefficients.get(i)).copied().unwrap_or_default()
    }

    /// The value at an angle.
    #[must_use]
    pub fn at(&self, angle: f64) -> Complex<f64> {
        let order = self.order() as i64;
        (-order..=order).map(|k| self.coefficient(k) * turn(k as f64 * angle)).sum()
    }

    /// The derivative with respect to the angle: coefficients ik f_k.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let order = self.order() as i64;
        let factor = |k: i64| self.coefficient(k) * c64::new(0.0, k as f64);
        Self { coefficients: (-order..=order).map(factor).collect() }
    }

    /// The product f g, truncated to `order`: T(f) g.
    #[must_use]
    pub fn times(&self, other: &Self, order: usize) -> Self {
        let (order, own) = (order as i64, other.order() as i64);
        let product =
            |k: i64| (-own..=own).map(|j| self.coefficient(k - j) * other.coefficient(j)).sum();
        Self { coefficients: (-order..=order).map(product).collect() }
    }

    /// The quotient g/f of order n, that of g: T(f)^-1 g. This series, f, should have order 2n.
    ///
    /// # Errors
    /// [`Singular`] if the product matrix has no inverse, as for f = 0.
    pub fn divide(&self, other: &Self) -> Result<Self, Singular> {
        let matrix = toeplitz(self, other.order());
        let right = Mat::from_fn(matrix.nrows(), 1, |i, _| other.coefficients[i]);
        let solution = dense::solve(&matrix, &right)?;
        Ok(Self { coefficients: (0..solution.nrows()).map(|i| solution[(i, 0)]).collect() })
    }

    /// The product f g of two functions that jump at the same place, where f g does not:
    /// T(1/f)^-1 g with `reciprocal` = 1/f. The order is that of g.
    ///
    /// # Errors
    /// [`Singular`] if the matrix of the reciprocal has no inverse.
    pub fn times_across_jump(reciprocal: &Self, other: &Self) -> Result<Self, Singular> {
        reciprocal.divide(other)
    }
}

/// The product matrix T(f) for series up to `order`.
pub(crate) fn toeplitz(series: &ComplexSeries, order: usize) -> Mat<c64> {
    let size = 2 * order + 1;
    Mat::from_fn(size, size, |k, j| series.coefficient(k as i64 - j as i64))
}

/// e^(i angle).
pub(crate) fn turn(angle: f64) -> c64 {
    c64::new(libm::cos(angle), libm::sin(angle))
}
