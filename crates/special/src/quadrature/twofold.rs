//! Double-double arithmetic for functions evaluated at compile time.
//!
//! Source: T. J. Dekker, A floating-point technique for extending the available precision (1971).

/// The unevaluated sum `high + low`; `low` is at most half a unit in the last place of `high`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Twofold {
    pub(super) high: f64,
    low: f64,
}

impl Twofold {
    pub(super) const fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// The exact sum of two doubles.
    const fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// The exact product of two doubles.
    const fn product(a: f64, b: f64) -> Self {
        let ([a_0, a_1], [b_0, b_1]) = (halves(a), halves(b));
        let high = a * b;
        Self { high, low: ((a_0 * b_0 - high) + a_0 * b_1 + a_1 * b_0) + a_1 * b_1 }
    }

    pub(super) const fn plus(self, other: Self) -> Self {
        let sum = Self::sum(self.high, other.high);
        Self::sum(sum.high, sum.low + self.low + other.low)
    }

    pub(super) const fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low })
    }

    pub(super) const fn times(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::sum(product.high, product.low + self.high * other.low + self.low * other.high)
    }

    pub(super) const fn over(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self.minus(other.times(Self::new(quotient)));
        Self::sum(quotient, rest.high / other.high)
    }
}

/// Splits a double into two with half of its digits.
const fn halves(a: f64) -> [f64; 2] {
    let wide = 134_217_729.0 * a; // 2^27 + 1
    let upper = wide - (wide - a);
    [upper, a - upper]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_third_has_32_digits() {
        let three = Twofold::new(3.0);
        let third = Twofold::new(1.0).over(three);
        let rest = third.times(three).minus(Twofold::new(1.0));
        assert!(rest.high.abs() < 1e-31);
        // 1/3 - fl(1/3) = 2^-54/3
        assert!((third.low - 2.0_f64.powi(-54) / 3.0).abs() < 1e-32);
        let root = Twofold::new(2.0_f64.sqrt());
        assert!((root.times(root).minus(Twofold::new(2.0)).high - 2.734_323_3e-16).abs() < 1e-22);
    }
}
