//! The kink of a moment under a radial force, summed in closed form.
//!
//! Equilibrium alone gives M_k = P R e^(-ik phi_0)/(2 pi (k^2 - 1)) of a radial force P, whatever
//! the stiffness. The terms beyond a truncation are the closed sum less its first terms.

use std::f64::consts::{PI, TAU};

/// Sums over |k| > n of e^(ikx)/(k^2-1) and e^(ikx)/(k^2-1)^2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tails {
    pub(super) second: f64,
    pub(super) fourth: f64,
}

impl Tails {
    pub(super) fn new(angle: f64, order: usize) -> Self {
        let x = angle.rem_euclid(TAU);
        let y = PI - x;
        let (cosine, sine) = (libm::cos(x), libm::sin(x));
        let (mut second, mut fourth) =
            (0.5 + 0.25 * cosine - 0.5 * y * sine, closed_fourth(y, cosine, sine));
        for k in 2..=order {
            let k = k as f64;
            let inverse = 1.0 / (k * k - 1.0);
            let wave = libm::cos(k * x);
            second -= wave * inverse;
            fourth -= wave * inverse * inverse;
        }
        Self { second: 2.0 * second, fourth: 2.0 * fourth }
    }
}

/// sum over k >= 2 of cos kx/(k^2-1)^2, with y = pi - x.
fn closed_fourth(y: f64, cosine: f64, sine: f64) -> f64 {
    -0.5 + 0.25 * y * sine + (0.125 * y * y - 3.0 / 16.0 - PI * PI / 24.0) * cosine
}
