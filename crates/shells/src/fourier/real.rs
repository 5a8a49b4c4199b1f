//! Series of cosines and of sines, with the matrices of their products.

use std::f64::consts::TAU;

use carom_special::RangeError;

/// An even function f = sum of f_k cos k xi, k from 0.
///
/// ```
/// use carom_shells::fourier::EvenSeries;
/// let f = EvenSeries::new(&[1.0, 0.5])?; // 1 + (cos xi)/2
/// // f sin xi = sin xi + (sin 2 xi)/4
/// assert_eq!([f.sin_to_sin(1, 1), f.sin_to_sin(2, 1)], [1.0, 0.25]);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EvenSeries {
    coefficients: Vec<f64>,
}

impl EvenSeries {
    /// The series of coefficients of cos 0, cos xi, cos 2 xi, ...
    ///
    /// # Errors
    /// [`RangeError`] if one is not finite.
    pub fn new(coefficients: &[f64]) -> Result<Self, RangeError> {
        finite(coefficients).map(|coefficients| Self { coefficients })
    }

    pub(crate) const fn from_coefficients(coefficients: Vec<f64>) -> Self {
        Self { coefficients }
    }

    /// Coefficient of cos k xi; 0 beyond the order.
    #[must_use]
    pub fn coefficient(&self, k: usize) -> f64 {
        self.coefficients.get(k).copied().unwrap_or(0.0)
    }

    /// All coefficients.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The value at an angle.
    #[must_use]
    pub fn at(&self, angle: f64) -> f64 {
        let each = self.coefficients.iter().enumerate();
        each.map(|(k, f)| f * libm::cos(k as f64 * angle)).sum()
    }

    /// Entry of the product matrix of f from cosines to cosines: the coefficient of cos k xi in
    /// f cos j xi. With the sum and difference of angles
    /// C_kj = (f_|k-j| (1 + delta_kj) + f_(k+j))/2 for k, j >= 1, C_0j = f_j/2, C_k0 = f_k.
    #[must_use]
    pub fn cos_to_cos(&self, k: usize, j: usize) -> f64 {
        match (k, j) {
            (_, 0) => self.coefficient(k),
            (0, _) => 0.5 * self.coefficient(j),
            _ => 0.5 * (self.apart(k, j) + self.coefficient(k + j)),
        }
    }

    /// Entry of the product matrix of f from sines to sines: the coefficient of sin k xi in
    /// f sin j xi, S_kj = (f_|k-j| (1 + delta_kj) - f_(k+j))/2.
    #[must_use]
    pub fn sin_to_sin(&self, k: usize, j: usize) -> f64 {
        if k == 0 || j == 0 { 0.0 } else { 0.5 * (self.apart(k, j) - self.coefficient(k + j)) }
    }

    fn apart(&self, k: usize, j: usize) -> f64 {
        let value = self.coefficient(k.abs_diff(j));
        if k == j { 2.0 * value } else { value }
    }
}

/// An odd function f = sum of f_k sin k xi, k from 1.
///
/// ```
/// use carom_shells::fourier::OddSeries;
/// let f = OddSeries::new(&[1.0])?; // sin xi
/// // sin xi sin xi = 1/2 - (cos 2 xi)/2
/// assert_eq!([f.sin_to_cos(0, 1), f.sin_to_cos(2, 1)], [0.5, -0.5]);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OddSeries {
    /// That of sin xi first.
    coefficients: Vec<f64>,
}

impl OddSeries {
    /// The series of coefficients of sin xi, sin 2 xi, ...
    ///
    /// # Errors
    /// [`RangeError`] if one is not finite.
    pub fn new(coefficients: &[f64]) -> Result<Self, RangeError> {
        finite(coefficients).map(|coefficients| Self { coefficients })
    }

    pub(crate) const fn from_coefficients(coefficients: Vec<f64>) -> Self {
        Self { coefficients }
    }

    /// Coefficient of sin k xi; 0 for k = 0 and beyond the order.
    #[must_use]
    pub fn coefficient(&self, k: usize) -> f64 {
        k.checked_sub(1).and_then(|i| self.coefficients.get(i)).copied().unwrap_or(0.0)
    }

    /// All coefficients, that of sin xi first.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The value at an angle.
    #[must_use]
    pub fn at(&self, angle: f64) -> f64 {
        let each = self.coefficients.iter().enumerate();
        each.map(|(i, f)| f * libm::sin((i + 1) as f64 * angle)).sum()
    }

    /// Entry of the product matrix of f from sines to cosines: the coefficient of cos k xi in
    /// f sin j xi, P_kj = (f_(j+k) + f_(j-k) - f_(k-j))/2 for k >= 1, P_0j = f_j/2; f_k = 0 for
    /// k <= 0.
    #[must_use]
    pub fn sin_to_cos(&self, k: usize, j: usize) -> f64 {
        match (k, j) {
            (_, 0) => 0.0,
            (0, _) => 0.5 * self.coefficient(j),
            _ => 0.5 * (self.coefficient(j + k) + self.after(j, k) - self.after(k, j)),
        }
    }

    /// Entry of the product matrix of f from cosines to sines: the coefficient of sin k xi in
    /// f cos j xi, Q_kj = (f_(k-j) + f_(k+j) - f_(j-k))/2, Q_k0 = f_k; f_k = 0 for k <= 0.
    #[must_use]
    pub fn cos_to_sin(&self, k: usize, j: usize) -> f64 {
        match (k, j) {
            (0, _) => 0.0,
            (_, 0) => self.coefficient(k),
            _ => 0.5 * (self.after(k, j) + self.coefficient(k + j) - self.after(j, k)),
        }
    }

    /// Coefficient k - j, or 0 if that is not positive.
    fn after(&self, k: usize, j: usize) -> f64 {
        self.coefficient(k.saturating_sub(j))
    }
}

fn finite(coefficients: &[f64]) -> Result<Vec<f64>, RangeError> {
    coefficients.iter().map(|value| RangeError::finite("coefficient", *value)).collect()
}

/// The most samples around a circle.
pub(crate) const MOST_SAMPLES: usize = 1 << 14;

/// Samples of even and odd functions at xi_j = 2 pi j/m, j from 0 to m/2: the other half follows
/// from symmetry.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HalfCircle {
    /// cos and sin of 2 pi j/m for j from 0 to m - 1.
    cosines: Vec<f64>,
    sines: Vec<f64>,
}

impl HalfCircle {
    /// `around` = m, even.
    pub(crate) fn new(around: usize) -> Self {
        let angle = |j: usize| TAU * j as f64 / around as f64;
        Self {
            cosines: (0..around).map(|j| libm::cos(angle(j))).collect(),
            sines: (0..around).map(|j| libm::sin(angle(j))).collect(),
        }
    }

    fn around(&self) -> usize {
        self.cosines.len()
    }

    /// Number of samples, m/2 + 1.
    pub(crate) fn count(&self) -> usize {
        self.around() / 2 + 1
    }

    /// Angle of sample j.
    pub(crate) fn angle(&self, j: usize) -> f64 {
        TAU * j as f64 / self.around() as f64
    }

    /// Weight of a sample and its image in a mean over the circle.
    pub(crate) fn weight(&self, j: usize) -> f64 {
        let is_end = j == 0 || 2 * j == self.around();
        (if is_end { 1.0 } else { 2.0 }) / self.around() as f64
    }

    /// The mean over the circle of an even function.
    pub(crate) fn mean(&self, samples: &[f64]) -> f64 {
        samples.iter().enumerate().map(|(j, f)| self.weight(j) * f).sum()
    }

    /// Coefficients of the cosines from 0 to `order` of the sampled even function.
    pub(crate) fn even(&self, samples: &[f64], order: usize) -> EvenSeries {
        let coefficients = self.project(&self.cosines, samples, 0..=order);
        let mut coefficients: Vec<f64> = coefficients.collect();
        coefficients[0] *= 0.5;
        EvenSeries::from_coefficients(coefficients)
    }

    /// Coefficients of the sines from 1 to `order` of the sampled odd function.
    pub(crate) fn odd(&self, samples: &[f64], order: usize) -> OddSeries {
        OddSeries::from_coefficients(self.project(&self.sines, samples, 1..=order).collect())
    }

    fn project<'a>(
        &'a self,
        wave: &'a [f64],
        samples: &'a [f64],
        orders: std::ops::RangeInclusive<usize>,
    ) -> impl Iterator<Item = f64> + 'a {
        let around = self.around();
        let weighted: Vec<f64> =
            samples.iter().enumerate().map(|(j, f)| 2.0 * self.weight(j) * f).collect();
        orders.map(move |k| {
            // Four sums at once: additions of one would wait for each other.
            let mut sums = [0.0; 4];
            let mut places = [0, k, 2 * k, 3 * k].map(|place| place % around);
            let step = 4 * k % around;
            for four in weighted.chunks(4) {
                for ((f, place), sum) in four.iter().zip(&mut places).zip(&mut sums) {
                    *sum += f * wave[*place];
                    *place += step;
                    if *place >= around {
                        *place -= around;
                    }
                }
            }
            (sums[0] + sums[1]) + (sums[2] + sums[3])
        })
    }

    /// Samples of sum f_k cos k xi.
    pub(crate) fn cosine_sum(&self, coefficients: &[f64]) -> Vec<f64> {
        self.sum(&self.cosines, coefficients, 0)
    }

    /// Samples of sum f_k sin k xi, that of sin xi first.
    pub(crate) fn sine_sum(&self, coefficients: &[f64]) -> Vec<f64> {
        self.sum(&self.sines, coefficients, 1)
    }

    fn sum(&self, wave: &[f64], coefficients: &[f64], first: usize) -> Vec<f64> {
        let around = self.around();
        let at = |j: usize| -> f64 {
            let mut place = j * first;
            let mut sum = 0.0;
            for f in coefficients {
                sum += f * wave[place];
                place += j;
                if place >= around {
                    place -= around;
                }
            }
            sum
        };
        (0..self.count()).map(at).collect()
    }
}
