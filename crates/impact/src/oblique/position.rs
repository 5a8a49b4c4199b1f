//! Position of the normal motion, by a coordinate in which it is analytic from first contact to
//! separation.
//!
//! `tau` runs from 1 (first contact) through 0 (maximum compression) to -1 (separation): contact
//! radius `a = (1 - tau^2)/(1 + tau^2)`, normal velocity `w = tau omega(a)` with
//! `omega^2 = (1 - a^5)/tau^2 = (1 + a)(1 + a + a^2 + a^3 + a^4)`. In this coordinate neither the
//! root of the compression at first contact nor that of the velocity at its maximum appears.

use crate::normal;

/// One position of the normal motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Position {
    pub(super) tau: f64,
    /// Contact radius over its maximum.
    pub(super) radius: f64,
    pub(super) omega: f64,
    /// Normal velocity w.
    pub(super) w: f64,
}

impl Position {
    pub(super) const TOUCH: Self = Self { tau: 1.0, radius: 0.0, omega: 1.0, w: 1.0 };
    pub(super) const MAXIMUM: Self =
        Self { tau: 0.0, radius: 1.0, omega: 3.162_277_660_168_379_5, w: 0.0 };
    pub(super) const SEPARATION: Self = Self { tau: -1.0, radius: 0.0, omega: 1.0, w: -1.0 };

    #[inline(always)]
    pub(super) fn at(tau: f64) -> Self {
        let radius = (1.0 - tau) * (1.0 + tau) / (1.0 + tau * tau);
        let omega = omega(radius);
        Self { tau, radius, omega, w: tau * omega }
    }

    /// The place with the normal velocity `w` in [-1, 1].
    pub(super) fn of_velocity(w: f64) -> Self {
        let radius = normal::radius(w);
        let omega = omega(radius);
        Self { tau: w / omega, radius, omega, w }
    }

    /// Compression.
    pub(super) fn zeta(&self) -> f64 {
        self.radius * self.radius
    }

    /// zeta^(3/2)
    pub(super) fn cube(&self) -> f64 {
        self.radius * self.radius * self.radius
    }

    /// d tau/dt, from d(a^2)/dt = w.
    #[inline(always)]
    pub(super) fn rate(&self) -> f64 {
        let one_more = 1.0 + self.radius;
        -0.5 * self.omega / (self.radius * one_more * one_more)
    }
}

#[inline(always)]
fn omega(radius: f64) -> f64 {
    let squared = radius * radius;
    ((1.0 + radius) * ((1.0 + radius) + squared * (1.0 + radius + squared))).sqrt()
}

/// Differences of two positions, without cancellation if their radii are nearly equal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Difference {
    /// (a^n - a'^n)/(a - a') for n = 2, 3, 5.
    pub(super) linear: f64,
    pub(super) quadratic: f64,
    pub(super) fifth: f64,
    /// (omega - omega')/(a - a')
    pub(super) omega: f64,
}

impl Difference {
    #[inline(always)]
    pub(super) fn new(one: &Position, two: &Position) -> Self {
        let (a, b) = (one.radius, two.radius);
        let (squares, product) = (a * a + b * b, a * b);
        let linear = a + b;
        let quadratic = squares + product;
        // omega^2 = 1 + 2 a + 2 a^2 + 2 a^3 + 2 a^4 + a^5 in divided differences
        let fifth = squares * squares - product * product + product * squares;
        let powers = 2.0 * ((1.0 + quadratic) + linear * (1.0 + squares)) + fifth;
        Self { linear, quadratic, fifth, omega: powers / (one.omega + two.omega) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_consistent() {
        for i in 0..=40 {
            let position = Position::at(1.0 - 0.05 * f64::from(i));
            let again = Position::of_velocity(position.w);
            assert!(
                (position.radius - again.radius).abs() < 1e-3 * (1.0 - position.w.abs()) + 4e-4
            );
            assert!((position.w * position.w + position.radius.powi(5) - 1.0).abs() < 5e-16);
            if position.radius > 0.1 {
                assert!((position.tau - again.tau).abs() < 1e-12);
            }
        }
        assert_eq!(Position::at(1.0), Position::TOUCH);
        assert_eq!(Position::at(0.0), Position::MAXIMUM);
        assert_eq!(Position::at(-1.0), Position::SEPARATION);
    }

    #[test]
    fn divided_differences() {
        let (one, two) = (Position::at(-0.4), Position::at(0.7));
        let difference = Difference::new(&one, &two);
        let gap = one.radius - two.radius;
        assert!((difference.omega * gap - (one.omega - two.omega)).abs() < 4e-15);
        assert!((difference.quadratic * gap - (one.cube() - two.cube())).abs() < 1e-15);
    }
}
