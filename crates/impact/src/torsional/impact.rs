//! The torsional impact of a circular contact, from first contact to separation.

use super::adhesion::Adhesion;
use super::error::TorsionalError;
use super::groups::{SMALL_OMEGA, TorsionalGroups};
use super::limits;
use super::stepped::{self, Settled};
use super::trajectory::{Trajectory, TrajectoryError};

/// A solved torsional impact: complete adhesion, then a slip annulus that grows inwards from the
/// edge until separation (chapter 10, with (10.7), (10.25)-(10.29) corrected).
///
/// The error is about 1e-12 for epsilon <= 0.826, and beyond if the slip keeps its direction. If
/// the spin reverses so fast that a second annulus slips, the general history of a twisted contact
/// is integrated in steps; [`TorsionalImpact::error_estimate`] gives the error.
///
/// ```
/// use carom_impact::torsional::{TorsionalGroups, TorsionalImpact};
/// let impact = TorsionalImpact::new(TorsionalGroups::new(0.0625, 0.5)?)?;
/// assert!((impact.spin_ratio() - 0.954_152_209_372_2).abs() < 1e-11);
/// assert!((impact.onset_radius() - 0.809_405_359_750).abs() < 1e-11);
/// # Ok::<(), carom_impact::torsional::TorsionalError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionalImpact {
    groups: TorsionalGroups,
    onset_radius: f64,
    spin_loss: f64,
    error_estimate: f64,
}

/// The error of the solution with one slip annulus.
const ERROR_WITH_ONE_ANNULUS: f64 = 1e-12;

impl TorsionalImpact {
    /// Solves the impact up to separation.
    ///
    /// # Errors
    /// [`TorsionalError`] if an integration fails; this has not been observed.
    pub fn new(groups: TorsionalGroups) -> Result<Self, TorsionalError> {
        let history = Adhesion::new(groups.epsilon(), groups.omega())?;
        let onset_radius = history.onset();
        if groups.omega() >= SMALL_OMEGA {
            return match Trajectory::new(groups, &history).advance_to(-1.0) {
                Ok(end) => {
                    let spin_loss = groups.epsilon() * end.turn.impulse;
                    Ok(Self {
                        groups,
                        onset_radius,
                        spin_loss,
                        error_estimate: ERROR_WITH_ONE_ANNULUS,
                    })
                }
                Err(TrajectoryError::TurnsBack) => {
                    let Settled { spin_ratio, change } = stepped::settle(groups)?;
                    let error_estimate = change.max(ERROR_WITH_ONE_ANNULUS);
                    let spin_loss = 1.0 - spin_ratio;
                    Ok(Self { groups, onset_radius, spin_loss, error_estimate })
                }
                Err(TrajectoryError::Failed(error)) => Err(error),
            };
        }
        let limit = limits::no_slip_loss(groups.epsilon())?;
        let nearby = Self::new(TorsionalGroups::new(groups.epsilon(), SMALL_OMEGA)?)?;
        let share = groups.omega() / SMALL_OMEGA;
        let spin_loss = limit + share * (nearby.spin_loss - limit);
        let error_estimate = ERROR_WITH_ONE_ANNULUS.max(share * nearby.error_estimate);
        Ok(Self { groups, onset_radius, spin_loss, error_estimate })
    }

    /// The groups epsilon and Omega.
    #[must_use]
    pub const fn groups(&self) -> TorsionalGroups {
        self.groups
    }

    /// The torsional restitution `beta'(T)/beta'(0)`: the relative spin after over that before.
    #[must_use]
    pub const fn spin_ratio(&self) -> f64 {
        1.0 - self.spin_loss
    }

    /// The share of the relative spin that is lost, `1 - spin_ratio`, without cancellation for fast
    /// spins and low friction.
    #[must_use]
    pub const fn spin_loss(&self) -> f64 {
        self.spin_loss
    }

    /// Estimated error of the spin ratio: about 1e-12; if integrated in steps, the change by the
    /// last doubling of their number.
    #[must_use]
    pub const fn error_estimate(&self) -> f64 {
        self.error_estimate
    }

    /// The contact radius a/a_max at which slip begins, always in compression; 1 without slip.
    #[must_use]
    pub const fn onset_radius(&self) -> f64 {
        self.onset_radius
    }

    /// The share of the energy of the relative spin that friction dissipates, `1 - ratio^2`.
    #[must_use]
    pub fn energy_loss(&self) -> f64 {
        self.spin_loss * (2.0 - self.spin_loss)
    }
}
