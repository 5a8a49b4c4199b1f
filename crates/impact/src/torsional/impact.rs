//! The torsional impact of a circular contact, from touch to separation.

use super::adhesion::Adhesion;
use super::error::TorsionalError;
use super::groups::{SMALL_OMEGA, TorsionalGroups};
use super::limits;
use super::stepped::{self, Settled};
use super::trajectory::{Trajectory, TrajectoryError};

/// A torsional impact, solved: complete adhesion first, then a slip ring that grows from the rim
/// until separation (chapter 10, with (10.7), (10.25)-(10.29) corrected).
///
/// Accurate to about 1e-12 for epsilon <= 0.826, and beyond as long as the slip keeps its direction.
/// Where the spin turns back so fast that a second ring slips, the general history of a twisted
/// contact is stepped instead; [`TorsionalImpact::error_estimate`] tells.
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

/// The error of the solution with one slip ring.
const EXACT: f64 = 1e-12;

impl TorsionalImpact {
    /// Follows the impact to separation.
    ///
    /// # Errors
    /// [`TorsionalError`] if an integration fails; not seen.
    pub fn new(groups: TorsionalGroups) -> Result<Self, TorsionalError> {
        let history = Adhesion::new(groups.epsilon(), groups.omega())?;
        let onset_radius = history.onset();
        if groups.omega() >= SMALL_OMEGA {
            return match Trajectory::new(groups, &history).advance_to(-1.0) {
                Ok(end) => {
                    let spin_loss = groups.epsilon() * end.turn.impulse;
                    Ok(Self { groups, onset_radius, spin_loss, error_estimate: EXACT })
                }
                Err(TrajectoryError::TurnsBack) => {
                    let Settled { spin_ratio, change } = stepped::settle(groups)?;
                    let error_estimate = change.max(EXACT);
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
        let error_estimate = EXACT.max(share * nearby.error_estimate);
        Ok(Self { groups, onset_radius, spin_loss, error_estimate })
    }

    /// The groups it was solved for.
    #[must_use]
    pub const fn groups(&self) -> TorsionalGroups {
        self.groups
    }

    /// The torsional restitution `beta'(T)/beta'(0)`: the relative spin after over that before.
    #[must_use]
    pub const fn spin_ratio(&self) -> f64 {
        1.0 - self.spin_loss
    }

    /// The part of the relative spin that is lost, one less the ratio: with its digits where that is next
    /// to nothing, as of fast spins and little friction.
    #[must_use]
    pub const fn spin_loss(&self) -> f64 {
        self.spin_loss
    }

    /// What the spin ratio may be off by: about 1e-12, or in steps what the last doubling of their
    /// number changed.
    #[must_use]
    pub const fn error_estimate(&self) -> f64 {
        self.error_estimate
    }

    /// The contact radius a/a_max at which slip begins, always in compression; 1 without slip.
    #[must_use]
    pub const fn onset_radius(&self) -> f64 {
        self.onset_radius
    }

    /// The part of the energy of the relative spin that friction takes, `1 - ratio^2`.
    #[must_use]
    pub fn energy_loss(&self) -> f64 {
        self.spin_loss * (2.0 - self.spin_loss)
    }
}
