//! Where the normal motion stands, by a coordinate in which it is analytic from touch to
//! separation.
//!
//! `tau` runs from 1 (touch) over 0 (maximal compression) to -1 (separation):
//! contact radius `a = (1 - tau^2)/(1 + tau^2)`, normal velocity `w = tau omega(a)` with
//! `omega^2 = (1 - a^5)/tau^2 = (1 + a)(1 + a + a^2 + a^3 + a^4)`. Neither the root of the
//! compression at touch nor that of the velocity at its maximum remains.

use crate::normal;

/// One position of the normal motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) tau: f64,
    /// Contact radius over its maximum.
    pub(super) radius: f64,
    pub(super) omega: f64,
    /// Normal velocity w.
    pub(super) w: f64,
}

impl Place {
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

/// How two places differ, without cancellation where they have nearly the same radius.
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
    pub(super) fn new(one: &Place, two: &Place) -> Self {
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
            let place = Place::at(1.0 - 0.05 * f64::from(i));
            let again = Place::of_velocity(place.w);
            assert!((place.radius - again.radius).abs() < 1e-3 * (1.0 - place.w.abs()) + 4e-4);
            assert!((place.w * place.w + place.radius.powi(5) - 1.0).abs() < 5e-16);
            if place.radius > 0.1 {
                assert!((place.tau - again.tau).abs() < 1e-12);
            }
        }
        assert_eq!(Place::at(1.0), Place::TOUCH);
        assert_eq!(Place::at(0.0), Place::MAXIMUM);
        assert_eq!(Place::at(-1.0), Place::SEPARATION);
    }

    #[test]
    fn divided_differences() {
        let (one, two) = (Place::at(-0.4), Place::at(0.7));
        let difference = Difference::new(&one, &two);
        let gap = one.radius - two.radius;
        assert!((difference.omega * gap - (one.omega - two.omega)).abs() < 4e-15);
        assert!((difference.quadratic * gap - (one.cube() - two.cube())).abs() < 1e-15);
    }
}
