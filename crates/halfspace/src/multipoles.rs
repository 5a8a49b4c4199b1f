//! The integral of 1/r over a rectangle that is far away, by its multipoles.
//!
//! Of a source at s from the centre, seen from R at the angle gamma between them,
//! 1/|R - s| = sum over n of s^n P_n(cos gamma)/R^(n + 1), and P_n(cos gamma) is the sum over k = -n, -n + 2, ..., n of
//! g_((n - k)/2) g_((n + k)/2) cos(k gamma), g_j = (2 j)!/(2^j j!)^2. Only even n and k are left of a rectangle, each with
//! one moment, the integral of s^n cos(k psi).

use crate::{Offset, Rectangle, gauss};

/// Terms beyond the total, of order n = 2, 4, ...
const ORDERS: usize = 6;

/// Greatest (d/R)^2 for which 1, 2, ... orders are accurate to rounding, of half a diagonal d: each order adds a factor of
/// it, and the first one left out is 1.4e-17.
const REACH: [f64; ORDERS] = [3.7e-9, 2.4e-6, 6.1e-5, 4.2e-4, 1.5e-3, 3.9e-3];

type Factors = [[f64; ORDERS + 1]; ORDERS + 1];

/// Moments of a rectangle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Multipoles {
    half_diagonal: f64,
    /// The factor of cos(2 phi)^j (d/R)^(2 m + 1) at `[m][j]`; 0 for j > m.
    factors: Factors,
}

impl Multipoles {
    pub(crate) fn of(rectangle: Rectangle) -> Self {
        let (x, y) = (0.5 * rectangle.width_x(), 0.5 * rectangle.width_y());
        let half_diagonal = libm::hypot(x, y);
        let mut factors = Factors::default();
        // Exact for the polynomials of degree 2 ORDERS.
        let rule = gauss::rule(gauss::NEAREST);
        for (across, along) in rule.iter().flat_map(|y| rule.iter().map(move |x| (y, x))) {
            let (u, v) = (x / half_diagonal * along.position, y / half_diagonal * across.position);
            let (square, psi) = (u * u + v * v, libm::atan2(v, u));
            let weight = along.weight * across.weight;
            for (m, row) in factors.iter_mut().enumerate() {
                for (j, factor) in row[..=m].iter_mut().enumerate() {
                    let moment = square.powi(m as i32) * libm::cos(2.0 * j as f64 * psi);
                    *factor += weight * legendre(m, j) * moment;
                }
            }
        }
        let unit = rectangle.width_x() * (rectangle.width_y() / half_diagonal) / factors[0][0];
        factors.iter_mut().flatten().for_each(|factor| *factor *= unit);
        Self { half_diagonal, factors: factors.map(|row| powers(&row)) }
    }

    /// The integral of 1/r, in units of length; `None` if the rectangle is not far enough. Its error is a few 1e-16 of it.
    pub(crate) fn inverse_distance(&self, offset: Offset) -> Option<f64> {
        let (x, y) = (offset.x / self.half_diagonal, offset.y / self.half_diagonal);
        let near = 1.0 / (x * x + y * y);
        let orders = 1 + REACH.iter().position(|reach| near <= *reach)?;
        let cosine = (x - y) * (x + y) * near;
        let sum = (0..=orders).rev().fold(0.0, |sum, m| {
            let own = self.factors[m][..=m].iter().rev();
            sum * near + own.fold(0.0, |own, factor| own * cosine + factor)
        });
        Some(sum * near.sqrt())
    }
}

/// The factors of the powers of cos(2 phi) in a sum of cos(2 j phi), from their factors.
fn powers(factors: &[f64; ORDERS + 1]) -> [f64; ORDERS + 1] {
    // Chebyshev polynomials, T_(j + 1) = 2 c T_j - T_(j - 1).
    let (mut last, mut next) = ([0.0; ORDERS + 1], [0.0; ORDERS + 1]);
    (last[1], next[0]) = (1.0, 1.0);
    let mut sums = [0.0; ORDERS + 1];
    for factor in factors {
        sums.iter_mut().zip(next).for_each(|(sum, part)| *sum += factor * part);
        let mut after = last.map(|part| -part);
        for (k, part) in next[..ORDERS].iter().enumerate() {
            after[k + 1] += 2.0 * part;
        }
        (last, next) = (next, after);
    }
    sums
}

/// The factor of cos(2 j gamma) in P_n(cos gamma), n = 2 m.
fn legendre(m: usize, j: usize) -> f64 {
    let twice = if j > 0 { 2.0 } else { 1.0 };
    twice * binomial(m - j) * binomial(m + j)
}

/// (2 j)!/(2^j j!)^2 = Gamma(j + 1/2)/(Gamma(1/2) j!).
fn binomial(j: usize) -> f64 {
    (1..=j).fold(1.0, |product, i| product * (1.0 - 0.5 / i as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_rectangles_have_the_integral_of_any_rectangle() {
        for [width_x, width_y] in [[2.0, 2.0], [0.3, 0.7], [1e-6, 4e-8], [5.0, 1e-3]] {
            let rectangle = Rectangle::new(width_x, width_y).unwrap();
            let far = Multipoles::of(rectangle);
            let d = 0.5 * width_x.hypot(width_y);
            assert_eq!(far.inverse_distance(Offset { x: 15.9 * d, y: 0.0 }), None);
            for (i, k) in (0..60).flat_map(|i| (0..13).map(move |k| (i, k))) {
                let (r, turn) = (16.1 * d * 1.3_f64.powi(i), f64::from(k) * 0.13);
                let offset = Offset { x: -r * turn.cos(), y: r * turn.sin() };
                let exact = rectangle.integrals(offset).unwrap().inverse_distance;
                let found = far.inverse_distance(offset).unwrap();
                assert!((found / exact - 1.0).abs() < 1.2e-15, "{offset:?} {found} {exact}");
            }
        }
    }
}
