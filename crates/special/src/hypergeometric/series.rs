//! Sums of hypergeometric series, with the sum of the magnitudes of their terms.

/// The series is truncated where its terms are below this fraction of the sum.
const NEGLIGIBLE: f64 = 1e-18;

/// More terms than any series needs at |x| <= 1/2 in the parameter range.
const MOST_TERMS: usize = 2000;

/// A sum and the sum of the absolute values of its terms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sum {
    pub(super) value: f64,
    pub(super) size: f64,
}

impl Sum {
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self { value: self.value * factor, size: self.size * factor.abs() }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size }
    }
}

/// `sum weight(n) (a)_n (b)_n / ((c)_n n!) x^n` for `|x| <= 1/2` or a terminating series.
///
/// The weights must not grow faster than the terms decrease.
pub(super) fn weighted(a: f64, b: f64, c: f64, x: f64, weight: impl Fn(f64) -> f64) -> Sum {
    let mut coefficient = 1.0;
    let mut sum = Compensated::default();
    let settled = a.abs().max(b.abs()).max(c.abs());
    for n in 0..MOST_TERMS {
        let n = n as f64;
        let term = coefficient * weight(n);
        sum.add(term);
        coefficient *= (a + n) * (b + n) / ((c + n) * (n + 1.0)) * x;
        if coefficient == 0.0 {
            break;
        }
        if n > settled && term.abs() < NEGLIGIBLE * sum.high.abs().max(NEGLIGIBLE) {
            break;
        }
    }
    Sum { value: sum.high + sum.low, size: sum.size }
}

/// Neumaier's compensated sum.
#[derive(Default)]
struct Compensated {
    high: f64,
    low: f64,
    size: f64,
}

impl Compensated {
    fn add(&mut self, term: f64) {
        let sum = self.high + term;
        self.low += if self.high.abs() >= term.abs() {
            (self.high - sum) + term
        } else {
            (term - sum) + self.high
        };
        self.high = sum;
        self.size += term.abs();
    }
}
