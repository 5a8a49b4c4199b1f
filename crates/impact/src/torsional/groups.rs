//! The two dimensionless groups of a torsional impact.

use carom_special::RangeError;

/// Largest epsilon accepted. Above about 2, for small Omega, the spin oscillates more than once.
const MAX_EPSILON: f64 = 100.0;
/// Largest Omega accepted. Above it the change of the spin is below round-off.
pub(super) const MAX_OMEGA: f64 = 1e15;

/// Below this Omega the spin ratio is linear in Omega to about its square, starting from the limit
/// of no slip.
pub(super) const SMALL_OMEGA: f64 = 1e-6;

/// The governing numbers of the torsional impact of a circular contact.
///
/// `epsilon` (10.10) is the ratio of torsional stiffness to inertia,
/// `(5/2) (D_M/D_zz) (1 - nu) R zeta_max`, with the mobilities D_M = 1/theta of the spin and D_zz
/// of the normal motion. A solid sphere on a fixed plane has `(25/4) (1 - nu) zeta_max/R`.
///
/// `omega` is the normalised initial spin, `((1 - nu)/f) (R beta'/zeta') sqrt(zeta_max/R)`.
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
    /// Groups with epsilon in [0, 100] and Omega in [0, 1e15].
    ///
    /// Omega = 0 is the limit of small spin or of infinite friction.
    ///
    /// # Errors
    /// [`RangeError`] outside these ranges.
    pub fn new(epsilon: f64, omega: f64) -> Result<Self, RangeError> {
        let holds = (0.0..=MAX_EPSILON).contains(&epsilon);
        RangeError::check("epsilon", epsilon, holds, "in [0, 100]")?;
        let holds = (0.0..=MAX_OMEGA).contains(&omega);
        RangeError::check("omega", omega, holds, "in [0, 1e15]")?;
        Ok(Self { epsilon, omega })
    }

    /// The same, with Omega large enough for the slip annulus to have digits.
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
