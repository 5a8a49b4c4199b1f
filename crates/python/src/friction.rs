//! The friction of impacts: a number, two with static friction, or three for friction by the slip speed.

use carom::impact::ImpactFriction;
use carom::laws::slip_speed::SlipSpeedFriction;
use carom::laws::static_friction::StaticFriction;
use carom::prelude::Friction;
use carom::special::RangeError;
use pyo3::prelude::*;

use crate::error::Fault;

/// The friction of an impact: the numbers a, b and c of friction by the slip speed, if they are there, in place of a
/// constant coefficient, or a coefficient of static friction beside it.
pub(crate) fn checked(
    coefficient: f64,
    (by_speed, at_rest): Beside,
) -> Result<ImpactFriction, RangeError> {
    if let Some([a, b, c]) = by_speed {
        return SlipSpeedFriction::new(a, b, c).map(Into::into);
    }
    match at_rest {
        None => Friction::new(coefficient).map(Into::into),
        Some(threshold) => with_threshold(coefficient, threshold).map(Into::into),
    }
}

/// Friction with a threshold of sliding above it.
pub(crate) fn with_threshold(kinetic: f64, threshold: f64) -> Result<StaticFriction, RangeError> {
    let kinetic = Friction::new(kinetic)?;
    let named = |error: RangeError| RangeError::new("static_friction", threshold, error.allowed);
    StaticFriction::new(Friction::new(threshold).map_err(named)?, kinetic)
}

/// What an impact is told beside a coefficient: friction by the slip speed, and static friction.
pub(crate) type Beside = (Option<[f64; 3]>, Option<f64>);

/// The coefficients of friction by the slip speed, at these speeds.
#[pyfunction]
pub(crate) fn slip_speed_friction(by_speed: [f64; 3], speeds: Vec<f64>) -> PyResult<Vec<f64>> {
    let [a, b, c] = by_speed;
    let friction = SlipSpeedFriction::new(a, b, c).map_err(Fault::from)?;
    let at = |speed| friction.at(speed).map(Friction::get);
    Ok(speeds.into_iter().map(at).collect::<Result<_, _>>().map_err(Fault::from)?)
}
