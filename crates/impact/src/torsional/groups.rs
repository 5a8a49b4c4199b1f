//! The two numbers that govern a torsional impact.

use carom_special::RangeError;

/// The largest epsilon accepted; beyond about 2 the spin of small Omega swings more than once.
const MOST_EPSILON: f64 = 100.0;
/// The largest Omega accepted: beyond, what the impact takes off the spin is below rounding.
pub(super) const MOST_OMEGA: f64 = 1e15;

/// Below this Omega the ratio is linear in it, from the limit of no slip, to about its square.
pub(super) const SMALL_OMEGA: f64 = 1e-6;

/// The governing numbers of the torsional impact of a circular contact.
///
/// `epsilon` (10.10) weighs the torsional stiffness against the inertia,
/// `(5/2) (D_M/D_zz) (1 - nu) R zeta_max` with the mobilities D_M = 1/theta of the spin and D_zz of
/// the normal motion; a solid sphere on a fixed plane has `(25/4) (1 - nu) zeta_max/R`.
/// `omega` is the initial spin, `((1 - nu)/f) (R beta'/zeta') sqrt(zeta_max/R)`.
///
/// ```
/// use carom_impact::torsional::TorsionalGroups;
/// let groups = TorsionalGroups::new(0.0625, 0.5)?;
/// assert_eq!(groups.omega(), 0.5);
/// assert!(TorsionalGroups::new(0.0625, f64::NAN).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionalGroups {
    epsilon: f64,
    omega: f64,
}

impl TorsionalGroups {
    /// From epsilon in [0, 100] and Omega in [0, 1e15].
    ///
    /// Omega = 0 stands for the limit of small spin or of infinite friction.
    ///
    /// # Errors
    /// [`RangeError`] outside these ranges.
    pub fn new(epsilon: f64, omega: f64) -> Result<Self, RangeError> {
        let holds = (0.0..=MOST_EPSILON).contains(&epsilon);
        RangeError::check("epsilon", epsilon, holds, "in [0, 100]")?;
        let holds = (0.0..=MOST_OMEGA).contains(&omega);
        RangeError::check("omega", omega, holds, "in [0, 1e15]")?;
        Ok(Self { epsilon, omega })
    }

    /// The same with an Omega that leaves digits for the slip ring.
    pub(super) fn away_from_zero(self) -> Self {
        Self { omega: self.omega.max(SMALL_OMEGA), ..self }
    }

    /// Torsional stiffness against inertia.
    #[must_use]
    pub const fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// The normalised initial spin.
    #[must_use]
    pub const fn omega(&self) -> f64 {
        self.omega
    }
}
