//! The slip annulus of a contact that grows while it is twisted at a constant rate r > 1 relative to its edge.
//!
//! Its depth v = ln(al/c) is constant, `(2/pi) K(k) = r` with `k' = exp(-v)`, and so is the density
//! `(2/pi) E(k)/k'` that it leaves behind. Both are analytic in `x = K - pi/2` and tabulated, so that a step needs no
//! elliptic integrals. Since `dK/dv` is the integral B, `x = int_0^v B du` has no cancellation in thin annuli.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, LN_2};
use std::sync::LazyLock;

use carom_special::elliptic::complete;
use carom_special::quadrature::FixedRule;

use super::sliding::{LENGTH, Piece, fitted, horner_value, interval, with_ratio};

/// Number of intervals in x.
const PIECES: usize = 48;
/// Beyond this depth the stick radius counts as zero.
const DEEPEST: f64 = 690.0;
/// The depth beyond which K and E are their logarithms to rounding.
const LOGARITHMIC: f64 = 40.0;

struct Table {
    /// v(x)/x on the first interval, v(x) on the others.
    depth: [Piece; PIECES],
    /// E(x).
    e: [Piece; PIECES],
}

static TABLE: LazyLock<Table> = LazyLock::new(|| Table {
    depth: std::array::from_fn(|i| fitted(i, depth_at, 1)),
    e: std::array::from_fn(|i| fitted(i, |x| with_ratio(libm::exp(-depth_at(x)), complete::e), 0)),
});

static RULE: FixedRule<16> = FixedRule::fixed();

/// The annulus of a rate above 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SteadyAnnulus {
    /// `ln(al/c)`.
    pub(super) depth: f64,
    /// c/al; zero where the contact sticks at its centre alone.
    pub(super) ratio: f64,
    e: f64,
}

impl SteadyAnnulus {
    pub(super) fn new(rate: f64) -> Self {
        let (depth, e) = depth_and_e(rate);
        let ratio = if depth < DEEPEST { libm::exp(-depth) } else { 0.0 };
        Self { depth, ratio, e }
    }

    /// `(2/pi) E/k'`, the density that it leaves behind.
    pub(super) fn density(&self) -> f64 {
        FRAC_2_PI * self.e / self.ratio
    }
}

/// Depth and E where `(2/pi) K` has a value of at least 1.
fn depth_and_e(rate: f64) -> (f64, f64) {
    let x = FRAC_PI_2 * (rate - 1.0);
    if x < LENGTH * PIECES as f64 {
        // Negative by rounding only.
        let x = x.max(0.0);
        let (piece, t) = interval(x);
        let Table { depth, e } = &*TABLE;
        let [depth, e] = [depth, e].map(|pieces| horner_value(&pieces[piece], t));
        return (if piece == 0 { x * depth } else { depth }, e);
    }
    // K = L + (L - 1) k'^2/4 and E = 1 + (L - 1/2) k'^2/2 with L = ln(4/k') (DLMF 19.12).
    let logarithm = rate / FRAC_2_PI;
    let deep = logarithm - 2.0 * LN_2;
    if deep >= LOGARITHMIC {
        return (deep.min(1e3), 1.0);
    }
    let square = libm::exp(-2.0 * deep);
    (deep - 0.25 * (logarithm - 1.0) * square, 1.0 + 0.5 * (logarithm - 0.5) * square)
}

/// The depth at which `K - pi/2` has a value, by Newton's method.
fn depth_at(x: f64) -> f64 {
    let mut v = x;
    for _ in 0..40 {
        let step = (x - beyond_circle(v)) / with_ratio(libm::exp(-v), complete::b);
        let next = (v + step).max(0.5 * v);
        let done = (next - v).abs() <= 4e-16 * v;
        v = next;
        if done {
            break;
        }
    }
    v
}

/// `K - pi/2` at a depth.
fn beyond_circle(v: f64) -> f64 {
    if v > 2.0 {
        return with_ratio(libm::exp(-v), complete::k) - FRAC_PI_2;
    }
    let b = |u: f64| with_ratio(libm::exp(-u), complete::b);
    RULE.integrate(0.0, 0.5 * v, b) + RULE.integrate(0.5 * v, v, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rate_of_a_steady_annulus_is_its_elliptic_integral() {
        for i in 0..30_000 {
            let rate: f64 = 1.0 + 1e-12 * libm::exp(1.25e-3 * f64::from(i));
            let (depth, e) = depth_and_e(rate);
            if depth > 600.0 {
                continue;
            }
            let ratio = libm::exp(-depth);
            let got = FRAC_2_PI * with_ratio(ratio, complete::k);
            assert!((got - rate).abs() <= 3e-15 * rate, "{rate}: {got}");
            let want = with_ratio(ratio, complete::e);
            assert!((e - want).abs() <= 5e-15 * want, "{rate}: {e} {want}");
        }
    }

    #[test]
    fn thin_steady_annuli_keep_their_digits() {
        // The series of K in powers of m = k^2.
        for i in 0..2000 {
            let above = 1e-12 * libm::exp(1e-2 * f64::from(i));
            let rate = 1.0 + above;
            let m = -libm::expm1(-2.0 * depth_and_e(rate).0);
            let series = m / 4.0
                * (1.0 + m * 9.0 / 16.0 * (1.0 + m * 25.0 / 36.0 * (1.0 + m * 49.0 / 64.0)));
            let want = rate - 1.0;
            assert!(
                (series - want).abs() <= 1e-14 * want + m.powi(5),
                "{rate}: {series:e} {want:e}"
            );
        }
    }

    #[test]
    fn a_contact_that_is_hardly_pressed_sticks_nowhere() {
        for rate in [1e3, 1e9, 1e300, f64::INFINITY] {
            let annulus = SteadyAnnulus::new(rate);
            assert_eq!((annulus.ratio, annulus.e), (0.0, 1.0), "{rate}");
            assert!(annulus.depth.is_finite(), "{rate}");
        }
    }
}
