//! The coefficient of friction, with its two limits.

use carom_special::RangeError;

/// Coulomb's coefficient of friction f, the same at rest and in motion.
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

    /// A coefficient of friction, zero and infinity included.
    ///
    /// # Errors
    /// [`RangeError`] if it is negative or not a number.
    pub fn new(coefficient: f64) -> Result<Self, RangeError> {
        RangeError::check("friction", coefficient, coefficient >= 0.0, ">= 0 (inf: no slip)")
            .map(Self)
    }

    /// The coefficient f; infinite for bodies that never slip.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }

    /// The coefficient if it is finite, none if the bodies never slip.
    #[must_use]
    pub fn coefficient(self) -> Option<f64> {
        self.0.is_finite().then_some(self.0)
    }
}
