//! Friction that depends on the slip speed.

use carom_special::RangeError;

use crate::friction::Friction;

/// The largest coefficient of friction, and the smallest that is not zero, as in [`Friction::new`].
const ENDS: [f64; 2] = [1e-30, 1e30];

/// The coefficient of friction `f = a + b exp(-c v)` at the slip speed v: a + b at rest, a at high
/// speeds.
///
/// An impact evaluates it once, at the tangential speed of the contact point at the first touch. The
/// coefficient is then constant during the impact.
///
/// ```
/// use carom_laws::slip_speed::SlipSpeedFriction;
/// let friction = SlipSpeedFriction::new(0.1, 0.3, 2.0)?;
/// assert!((friction.at(0.0)?.get() - 0.4).abs() < 1e-15);
/// assert!((friction.at(0.5)?.get() - (0.1 + 0.3 / std::f64::consts::E)).abs() < 1e-15);
/// assert!(SlipSpeedFriction::new(0.1, -0.2, 2.0).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipSpeedFriction {
    a: f64,
    b: f64,
    c: f64,
}

impl SlipSpeedFriction {
    /// From a, b (numbers) and c (time over length).
    ///
    /// # Errors
    /// [`RangeError`] unless all are finite, a, a + b and c are not negative, and a and a + b are at
    /// most 1e30.
    pub fn new(a: f64, b: f64, c: f64) -> Result<Self, RangeError> {
        let [_, largest] = ENDS;
        let fits = |coefficient: f64| (0.0..=largest).contains(&coefficient);
        RangeError::check("a", a, fits(a), "finite and >= 0, at most 1e30")?;
        RangeError::check("b", b, fits(a + b), "finite, with a + b >= 0 and at most 1e30")?;
        RangeError::check("c", c, c >= 0.0 && c.is_finite(), "finite and >= 0")?;
        Ok(Self { a, b, c })
    }

    /// The friction at a slip speed. A coefficient below 1e-30 counts as zero.
    ///
    /// # Errors
    /// [`RangeError`] unless the speed is finite and not negative.
    pub fn at(self, speed: f64) -> Result<Friction, RangeError> {
        let holds = speed >= 0.0 && speed.is_finite();
        RangeError::check("slip speed", speed, holds, "finite and >= 0")?;
        let coefficient = self.a + self.b * libm::exp(-self.c * speed);
        Friction::new(if coefficient < ENDS[0] { 0.0 } else { coefficient })
    }

    /// The coefficients a, b and c.
    #[must_use]
    pub const fn coefficients(self) -> [f64; 3] {
        [self.a, self.b, self.c]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_coefficients_are_named() {
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        for (a, b, c, field) in [
            (-0.1, 0.3, 1.0, "a"),
            (nan, 0.3, 1.0, "a"),
            (inf, 0.3, 1.0, "a"),
            (2e30, 0.0, 1.0, "a"),
            (0.1, -0.100_001, 1.0, "b"),
            (0.1, nan, 1.0, "b"),
            (0.1, inf, 1.0, "b"),
            (0.1, 0.3, -1.0, "c"),
            (0.1, 0.3, nan, "c"),
            (0.1, 0.3, inf, "c"),
        ] {
            let error = SlipSpeedFriction::new(a, b, c).unwrap_err();
            assert_eq!(error.field, field, "{a} {b} {c}");
        }
    }

    #[test]
    fn every_speed_has_a_valid_coefficient() {
        for (a, b, c) in [(0.0, 0.4, 1e3), (0.3, -0.3, 2.0), (0.2, 0.0, 0.0), (0.1, 0.2, 1e300)] {
            let friction = SlipSpeedFriction::new(a, b, c).unwrap();
            for speed in [0.0, 5e-324, 1e-9, 0.07, 1.0, 1e9, f64::MAX] {
                let f = friction.at(speed).unwrap().get();
                assert!(f >= a.min(a + b) && f <= a.max(a + b), "{a} {b} {c} at {speed}: {f}");
            }
            assert_eq!(friction.at(0.0).unwrap().get(), a + b);
        }
        let friction = SlipSpeedFriction::new(0.1, 0.2, 1.0).unwrap();
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(friction.at(bad).unwrap_err().field, "slip speed");
        }
    }
}
