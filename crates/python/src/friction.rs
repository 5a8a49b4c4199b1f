//! The friction of impacts: a number, or three for friction by the slip speed.

use carom::impact::ImpactFriction;
use carom::laws::slip_speed::SlipSpeedFriction;
use carom::prelude::Friction;
use carom::special::RangeError;
use pyo3::prelude::*;

use crate::error::Fault;

/// The friction of an impact: the numbers a, b and c of friction by the slip speed, if they are there, in place of a
/// constant coefficient.
pub(crate) fn checked(
    coefficient: f64,
    by_speed: Option<[f64; 3]>,
) -> Result<ImpactFriction, RangeError> {
    match by_speed {
        None => Friction::new(coefficient).map(Into::into),
        Some([a, b, c]) => SlipSpeedFriction::new(a, b, c).map(Into::into),
    }
}

/// The coefficients of friction by the slip speed, at these speeds.
#[pyfunction]
pub(crate) fn slip_speed_friction(by_speed: [f64; 3], speeds: Vec<f64>) -> PyResult<Vec<f64>> {
    let [a, b, c] = by_speed;
    let friction = SlipSpeedFriction::new(a, b, c).map_err(Fault::from)?;
    let at = |speed| friction.at(speed).map(Friction::get);
    Ok(speeds.into_iter().map(at).collect::<Result<_, _>>().map_err(Fault::from)?)
}
