//! The series about the circle after one descending Landen step.
//!
//! With `s = 1/(1 + k')`, `l = ((1 - k')/(1 + k'))^2` and the integrals K1, B1, D1 of parameter l:
//!
//! ```text
//! K = 2 s K1      B = s (B1 + 2 k' s D1)      E = (pi/4) (1 + k') 2F1(-1/2, -1/2; 1; l)
//!                 D = s (B1 + 2 s D1)         C = 2 s^3 D1
//! ```
//!
//! Source: DLMF 19.8.12 (K), 19.5 (series), 19.30.4 with Ivory's form (E); B and D follow by
//! splitting K1, C by the quadratic transformation of its hypergeometric series.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Number of terms at `l = 0.1716` (k' = 0.41): the last is below 1e-17 of the sum.
const SHORT: usize = 22;

/// Number of terms at `l = 0.29` (k' = 0.3), the limit of [`c`].
const TERMS: usize = 34;

/// `((1/2)_n/n!)^2`, the coefficients of `2 K1/pi`.
const K1: [f64; TERMS] = {
    let mut list = [1.0; TERMS];
    let mut n = 1;
    while n < TERMS {
        let factor = 1.0 - 0.5 / n as f64;
        list[n] = list[n - 1] * factor * factor;
        n += 1;
    }
    list
};

/// The coefficients of `4 B1/pi`.
const B1: [f64; TERMS] = {
    let mut list = K1;
    let mut n = 0;
    while n < TERMS {
        list[n] /= n as f64 + 1.0;
        n += 1;
    }
    list
};

/// The coefficients of `4 D1/pi`.
const D1: [f64; TERMS] = {
    let mut list = B1;
    let mut n = 0;
    while n < TERMS {
        list[n] *= 2.0 * n as f64 + 1.0;
        n += 1;
    }
    list
};

/// The coefficients of `2F1(-1/2, -1/2; 1; l)`.
const IVORY: [f64; TERMS] = {
    let mut list = K1;
    let mut n = 0;
    while n < TERMS {
        let odd = 2.0 * n as f64 - 1.0;
        list[n] /= odd * odd;
        n += 1;
    }
    list
};

fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

fn step(kc: f64) -> f64 {
    let modulus = (1.0 - kc) / (1.0 + kc);
    modulus * modulus
}

pub(super) fn k(kc: f64) -> f64 {
    FRAC_PI_2 * polynomial(&K1[..SHORT], step(kc)) * 2.0 / (1.0 + kc)
}

pub(super) fn e(kc: f64) -> f64 {
    FRAC_PI_4 * (1.0 + kc) * polynomial(&IVORY[..SHORT], step(kc))
}

pub(super) fn b(kc: f64) -> f64 {
    b_or_d(kc, kc)
}

pub(super) fn d(kc: f64) -> f64 {
    b_or_d(kc, 1.0)
}

fn b_or_d(kc: f64, weight: f64) -> f64 {
    let (l, sum) = (step(kc), 1.0 + kc);
    let d1 = polynomial(&D1[..SHORT], l) * (2.0 * weight / sum);
    FRAC_PI_4 * (polynomial(&B1[..SHORT], l) + d1) / sum
}

/// Valid for k' >= 0.3.
pub(super) fn c(kc: f64) -> f64 {
    let sum = 1.0 + kc;
    2.0 * FRAC_PI_4 * polynomial(&D1, step(kc)) / (sum * sum * sum)
}
