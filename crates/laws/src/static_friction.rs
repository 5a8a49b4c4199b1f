//! Static friction above kinetic friction: the pair of coefficients.

use carom_special::RangeError;

use crate::friction::Friction;

/// A coefficient of static friction f_s, and one of kinetic friction f_k, at most as large.
///
/// A contact whose whole area slides has the tangential force f_k F_z. Before that, every part of
/// the contact sticks or slips up to f_s times its pressure, and all of it begins to slide where the
/// force reaches f_s F_z.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::static_friction::StaticFriction;
/// let [f_s, f_k] = [Friction::new(0.3)?, Friction::new(0.2)?];
/// let friction = StaticFriction::new(f_s, f_k)?;
/// assert_eq!(friction.kinetic().get(), 0.2);
/// let error = StaticFriction::new(f_k, f_s).unwrap_err();
/// assert_eq!(error.field, "static_friction");
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StaticFriction {
    threshold: Friction,
    kinetic: Friction,
}

impl StaticFriction {
    /// From the coefficients f_s and f_k.
    ///
    /// # Errors
    /// [`RangeError`] if f_s is below f_k, or if it is infinite and f_k is not.
    pub fn new(threshold: Friction, kinetic: Friction) -> Result<Self, RangeError> {
        let holds = threshold >= kinetic && (threshold.get().is_finite() || threshold == kinetic);
        let allowed = "finite and at least the coefficient of kinetic friction";
        RangeError::check("static_friction", threshold.get(), holds, allowed)?;
        Ok(Self { threshold, kinetic })
    }

    /// f_s.
    #[must_use]
    pub const fn threshold(self) -> Friction {
        self.threshold
    }

    /// f_k.
    #[must_use]
    pub const fn kinetic(self) -> Friction {
        self.kinetic
    }

    /// Whether f_s exceeds f_k, so that the force drops where sliding begins.
    #[must_use]
    pub fn drops(self) -> bool {
        self.threshold > self.kinetic
    }

    /// f_k/f_s, or 1 if they are equal.
    pub(crate) fn ratio(self) -> f64 {
        if self.drops() { self.kinetic.get() / self.threshold.get() } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn static_friction_is_at_least_kinetic_friction() {
        let of = |f: f64| Friction::new(f).unwrap();
        let inf = f64::INFINITY;
        for (f_s, f_k, ratio) in
            [(0.4, 0.1, 0.25), (0.3, 0.3, 1.0), (0.3, 0.0, 0.0), (0.0, 0.0, 1.0), (inf, inf, 1.0)]
        {
            let friction = StaticFriction::new(of(f_s), of(f_k)).unwrap();
            assert_eq!((friction.ratio(), friction.drops()), (ratio, f_s > f_k));
        }
        for (f_s, f_k) in [(0.1, 0.2), (0.0, 1e-30), (inf, 0.2), (1e30, inf)] {
            let error = StaticFriction::new(of(f_s), of(f_k)).unwrap_err();
            assert_eq!((error.field, error.value), ("static_friction", f_s));
        }
    }
}
