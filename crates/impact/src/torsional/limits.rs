//! Closed forms and limits of the torsional restitution: small spin, sliding, small epsilon.

use super::adhesion::Adhesion;
use super::error::TorsionalError;
use super::groups::{SMALL_OMEGA, TorsionalGroups};
use super::trajectory::{Trajectory, TrajectoryError};
use crate::normal::DURATION;
use carom_special::ode::OdeError;

/// `15 pi^(3/2) Gamma(6/5) / (32 Gamma(17/10))`, the coefficient of (10.52), (10.64) as corrected
/// (printed with 21 in place of 15).
pub const SLIDING_LOSS: f64 = 2.637_529_634_267_598;

/// The restitution of small spin or infinite friction, `2 y_1^2 - 1`; y_1 is the spin at maximum
/// compression over the initial one, under complete adhesion. Corrects (10.40), (10.63).
///
/// ```
/// let ratio = carom_impact::torsional::limits::no_slip(0.0625)?;
/// assert!((ratio - 0.907_213_33).abs() < 1e-8);
/// # Ok::<(), carom_impact::torsional::TorsionalError>(())
/// ```
///
/// # Errors
/// [`TorsionalError::Range`] unless epsilon is in [0, 100].
pub fn no_slip(epsilon: f64) -> Result<f64, TorsionalError> {
    Ok(1.0 - no_slip_loss(epsilon)?)
}

/// `1 - no_slip`, computed as `2 (1 - y_1) (1 + y_1)` without cancellation for small epsilon.
pub(super) fn no_slip_loss(epsilon: f64) -> Result<f64, TorsionalError> {
    let epsilon = TorsionalGroups::new(epsilon, 0.0)?.epsilon();
    let lost = epsilon * Adhesion::new(epsilon, 0.0)?.at_onset().impulse;
    Ok(2.0 * lost * (2.0 - lost))
}

/// [`no_slip`] to first order in the spin at maximum compression:
/// `2 [1 - (2/5) eps (T - 2)]^2 - 1`, from (10.12) to (10.24), (10.63) corrected.
#[must_use]
pub fn no_slip_first_order(epsilon: f64) -> f64 {
    let y_1 = 1.0 - 0.4 * epsilon * (DURATION - 2.0);
    2.0 * y_1 * y_1 - 1.0
}

/// (10.40), (10.63) as printed, `[1 - (5/2) delta (T - 2)] [1 - 5 delta (T - 2)]` with
/// `delta = (4/25) eps`: wrong at first order, for comparison only.
#[must_use]
pub fn no_slip_as_printed(epsilon: f64) -> f64 {
    let x = 0.4 * epsilon * (DURATION - 2.0);
    (1.0 - x) * (1.0 - 2.0 * x)
}

/// The restitution of complete sliding, `1 - 0.42200 eps/Omega`: (10.64) corrected. The true one
/// lies above it and tends to it for large Omega.
///
/// ```
/// let ratio = carom_impact::torsional::limits::sliding(0.0625, 5.0);
/// assert!((ratio - 0.994_724_9).abs() < 1e-7);
/// ```
#[must_use]
pub fn sliding(epsilon: f64, omega: f64) -> f64 {
    1.0 - sliding_loss(epsilon, omega)
}

/// `1 - sliding`, without cancellation for large Omega.
pub(super) fn sliding_loss(epsilon: f64, omega: f64) -> f64 {
    0.16 * SLIDING_LOSS * epsilon / omega
}

/// (10.64) as printed, with 21 in place of 15: for comparison only.
#[must_use]
pub fn sliding_as_printed(epsilon: f64, omega: f64) -> f64 {
    1.0 - 0.16 * 1.4 * SLIDING_LOSS * epsilon / omega
}

/// `h(0) = (8/5) (T - 2)`, the limit of [`first_order_loss`] at small spin.
pub const SMALL_SPIN_LOSS: f64 = 1.6 * (DURATION - 2.0);

/// The function h of `ratio = 1 - eps h(Omega)` for small epsilon: the impulse of the torque at
/// constant spin.
///
/// ```
/// let h = carom_impact::torsional::limits::first_order_loss(0.3)?;
/// assert!((h - 0.970_346_115).abs() < 1e-9);
/// # Ok::<(), carom_impact::torsional::TorsionalError>(())
/// ```
///
/// # Errors
/// [`TorsionalError::Range`] unless Omega is in [0, 1e15].
pub fn first_order_loss(omega: f64) -> Result<f64, TorsionalError> {
    let groups = TorsionalGroups::new(0.0, omega)?;
    if omega < SMALL_OMEGA {
        // Linear from the limit, accurate to about the square of Omega.
        let slope = (first_order_loss(SMALL_OMEGA)? - SMALL_SPIN_LOSS) / SMALL_OMEGA;
        return Ok(SMALL_SPIN_LOSS + omega * slope);
    }
    let history = Adhesion::new(0.0, omega)?;
    match Trajectory::new(groups, &history).advance_to(-1.0) {
        Ok(end) => Ok(end.turn.impulse),
        Err(TrajectoryError::Failed(error)) => Err(error),
        // A constant spin does not reverse.
        Err(TrajectoryError::TurnsBack) => Err(OdeError::NotFinite { x: omega }.into()),
    }
}
