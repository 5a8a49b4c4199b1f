//! The coefficient of friction, including the limits zero and infinity.

use carom_special::RangeError;

/// Coulomb's coefficient of friction f, the same for static and kinetic friction.
///
/// Zero (no tangential force) and infinity (no slip) are valid limits.
///
/// ```
/// use carom_laws::friction::Friction;
/// assert_eq!(Friction::new(0.3)?.coefficient(), Some(0.3));
/// assert_eq!(Friction::INFINITE.coefficient(), None);
/// assert!(Friction::new(-0.1).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Friction(f64);

impl Friction {
    /// Frictionless bodies.
    pub const NONE: Self = Self(0.0);
    /// Bodies that never slip.
    pub const INFINITE: Self = Self(f64::INFINITY);

    /// From a coefficient of friction; zero and infinity are allowed.
    ///
    /// # Errors
    /// [`RangeError`] if it is negative or NaN, or finite but below 1e-30 or above 1e30, where
    /// displacements divided by it could overflow.
    pub fn new(coefficient: f64) -> Result<Self, RangeError> {
        let limit = coefficient == 0.0 || coefficient == f64::INFINITY;
        let holds = limit || (1e-30..=1e30).contains(&coefficient);
        RangeError::check(
            "friction",
            coefficient,
            holds,
            ">= 0 (0, 1e-30 to 1e30, or inf: no slip)",
        )
        .map(Self)
    }

    /// The coefficient f; infinite for bodies that never slip.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }

    /// The coefficient f whose product with a factor is this, to the bit, for a product that was
    /// made so.
    pub(crate) fn from_product(product: f64, factor: f64) -> Self {
        let quotient = product / factor;
        let near = |step: i64| f64::from_bits(quotient.to_bits().wrapping_add_signed(step));
        let exact = |f: &f64| *f * factor == product;
        Self([0, 1, -1, 2, -2].map(near).into_iter().find(exact).unwrap_or(quotient))
    }

    /// The coefficient if it is finite; `None` for bodies that never slip.
    #[must_use]
    pub fn coefficient(self) -> Option<f64> {
        self.0.is_finite().then_some(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coefficient_is_found_again_in_its_product() {
        let mut seed = 1_u64;
        let mut unit = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..100_000 {
            let (f, c_z) = (2.0 * unit() + 1e-9, 1e9 * unit() + 1e-3);
            let found = Friction::from_product(f * c_z, c_z).get();
            assert_eq!((found * c_z).to_bits(), (f * c_z).to_bits(), "{f:e} {c_z:e}");
            assert!((found / f - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn limits_are_values_and_extremes_are_none() {
        for valid in [0.0, -0.0, 1e-30, 0.3, 1e30, f64::INFINITY] {
            assert_eq!(Friction::new(valid).map(Friction::get), Ok(valid));
        }
        for bad in [-0.1, f64::NAN, -f64::INFINITY, 1e-31, 1e31, 5e-324] {
            let error = Friction::new(bad).unwrap_err();
            assert_eq!(error.field, "friction");
            assert!(error.to_string().contains("1e-30 to 1e30"), "{error}");
        }
    }
}
