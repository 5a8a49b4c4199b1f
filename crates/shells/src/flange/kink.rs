//! Kinks and jumps of loads where forces act, summed in closed form.
//!
//! Beyond the first harmonic equilibrium alone gives the loads of a bare ring, whatever its stiffness.
//! A force (P, Q, S) outward, along phi and along x with a couple C on beta, at phi = 0, has
//!
//! - M_k = R (P + Q/(ik))/(2 pi (k^2-1)), N_k = -M_k/R - Q/(2 pi ik),
//! - M_o,k = (R S - C)/(2 pi (k^2-1)), T_k = (R S - C)/(2 pi ik (k^2-1)) - C/(2 pi ik).
//!
//! A tube changes them by terms of higher order. What lies beyond a truncation is the closed sum less
//! its first terms.

use std::f64::consts::{PI, TAU};

/// Sums over |k| > n of e^(ikx) times 1/(ik), 1/(k^2-1), 1/(ik(k^2-1)) and 1/(k^2-1)^2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tails {
    /// At x = 0, where the sum jumps, it is the mean of both sides.
    pub(super) first: f64,
    pub(super) second: f64,
    pub(super) third: f64,
    pub(super) fourth: f64,
}

impl Tails {
    pub(super) fn new(angle: f64, order: usize) -> Self {
        let x = angle.rem_euclid(TAU);
        let y = if x == 0.0 || x >= TAU { 0.0 } else { PI - x };
        let (cosine, sine) = (libm::cos(x), libm::sin(x));
        let mut first = 0.5 * y - sine;
        let mut second = 0.5 + 0.25 * cosine - 0.5 * y * sine;
        let mut third = 0.75 * sine - 0.5 * y * (1.0 - cosine);
        let mut fourth = closed_fourth(PI - x, cosine, sine);
        for k in 2..=order {
            let k = k as f64;
            let inverse = 1.0 / (k * k - 1.0);
            let (wave, turned) = (libm::cos(k * x), libm::sin(k * x) / k);
            first -= turned;
            second -= wave * inverse;
            third -= turned * inverse;
            fourth -= wave * inverse * inverse;
        }
        let [first, second, third, fourth] =
            [first, second, third, fourth].map(|one_side| 2.0 * one_side);
        Self { first, second, third, fourth }
    }
}

/// sum over k >= 2 of cos kx/(k^2-1)^2, with y = pi - x.
fn closed_fourth(y: f64, cosine: f64, sine: f64) -> f64 {
    -0.5 + 0.25 * y * sine + (0.125 * y * y - 3.0 / 16.0 - PI * PI / 24.0) * cosine
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_sums_are_those_of_a_hundred_thousand_terms() {
        for angle in [0.0, 1e-3, 0.4, 2.0, PI, 4.0, 6.0, -0.7, 7.0] {
            let tails = Tails::new(angle, 3);
            let mut sums = [0.0; 4];
            for k in (4..100_000).rev() {
                let k = f64::from(k);
                let (cosine, sine) = ((k * angle).cos(), (k * angle).sin());
                let inverse = 1.0 / (k * k - 1.0);
                let terms =
                    [sine / k, cosine * inverse, sine / k * inverse, cosine * inverse * inverse];
                sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += 2.0 * term);
            }
            // The rest of the first sum is below 1/(k sin(x/2)), of the second below 1/k.
            let errors = [2e-2, 2.1e-5, 1e-9, 1e-14];
            let found = [tails.first, tails.second, tails.third, tails.fourth];
            for i in 0..4 {
                let error = (found[i] - sums[i]).abs();
                assert!(error < errors[i], "{angle} {i}: {} {}", found[i], sums[i]);
            }
        }
    }
}
