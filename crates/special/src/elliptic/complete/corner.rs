//! The logarithmic series about k' = 0.
//!
//! With `q = k'^2`, `L = ln(4/k')`, `a_n = ((1/2)_n/n!)^2` and `h_n = sum_(j<=n) 1/(j (2j - 1))`
//! DLMF 19.12.1 reads `K = sum a_n q^n (L - h_n)`. The others follow by differentiation in `k'`
//! (`B = -k' dK/dk'`, `D = K - B`, `C = -dB/dk'/k'`) or from DLMF 19.12.2 (E).

use std::f64::consts::LN_2;

/// Number of terms at `q = 0.1716`: the last is below 1e-17 of the sum.
const TERMS: usize = 26;

/// A sum of `q^n (logarithmic_n L - regular_n)`.
struct Series {
    logarithmic: [f64; TERMS],
    regular: [f64; TERMS],
}

impl Series {
    /// From the factors of `a_n (L - h_n) q^n` and of `a_n q^n`, as functions of n.
    const fn new(factors: [[f64; 2]; TERMS]) -> Self {
        let mut series = Self { logarithmic: [0.0; TERMS], regular: [0.0; TERMS] };
        let mut coefficient = 1.0;
        let mut harmonic = 0.0;
        let mut n = 0;
        while n < TERMS {
            let [with_logarithm, without] = factors[n];
            series.logarithmic[n] = coefficient * with_logarithm;
            series.regular[n] = coefficient * (with_logarithm * harmonic - without);
            let j = (n + 1) as f64;
            coefficient *= (1.0 - 0.5 / j) * (1.0 - 0.5 / j);
            harmonic += 1.0 / (j * (2.0 * j - 1.0));
            n += 1;
        }
        series
    }

    fn sum(&self, kc: f64) -> f64 {
        let q = kc * kc;
        let log_kc = libm::log(kc);
        let logarithm = 2.0 * LN_2 - log_kc;
        let (mut p, mut r) = (0.0, 0.0);
        for n in (1..TERMS).rev() {
            p = p * q + self.logarithmic[n];
            r = r * q + self.regular[n];
        }
        // ln 4 is added to the constant first: L - 2 of C is small compared with L.
        let constant = self.logarithmic[0] * (2.0 * LN_2) - self.regular[0];
        let first = constant - self.logarithmic[0] * log_kc;
        first + q * (p * logarithm - r)
    }
}

/// The factors of each n, `[of a_n (L - h_n), of a_n]`.
macro_rules! factors {
    ($n:ident => $factors:expr) => {{
        let mut list = [[0.0; 2]; TERMS];
        let mut i = 0;
        while i < TERMS {
            let $n = i as f64;
            list[i] = $factors;
            i += 1;
        }
        list
    }};
}

pub(super) fn k(kc: f64) -> f64 {
    const SERIES: Series = Series::new([[1.0, 0.0]; TERMS]);
    SERIES.sum(kc)
}

pub(super) fn b(kc: f64) -> f64 {
    const SERIES: Series = Series::new(factors!(n => [-2.0 * n, 1.0]));
    SERIES.sum(kc)
}

pub(super) fn d(kc: f64) -> f64 {
    const SERIES: Series = Series::new(factors!(n => [2.0 * n + 1.0, -1.0]));
    SERIES.sum(kc)
}

/// `E = 1 + q sum a_n (2n + 1)/(2n + 2) q^n (L - h_n - 1/((2n + 1)(2n + 2)))`.
pub(super) fn e(kc: f64) -> f64 {
    const SERIES: Series = Series::new(factors!(n => {
        let ratio = (2.0 * n + 1.0) / (2.0 * n + 2.0);
        [ratio, -ratio / ((2.0 * n + 1.0) * (2.0 * n + 2.0))]
    }));
    1.0 + kc * kc * SERIES.sum(kc)
}

/// With `a_(n+1) (2n + 2)^2 = a_n (2n + 1)^2` and `h_(n+1) = h_n + 1/((n + 1)(2n + 1))`.
pub(super) fn c(kc: f64) -> f64 {
    const SERIES: Series = Series::new(factors!(n => {
        let odd = 2.0 * n + 1.0;
        [odd * odd, -2.0 * odd]
    }));
    SERIES.sum(kc)
}

/// `D - C`.
pub(super) fn cos4(kc: f64) -> f64 {
    const SERIES: Series = Series::new(factors!(n => [-2.0 * n * (2.0 * n + 1.0), 4.0 * n + 1.0]));
    SERIES.sum(kc)
}
