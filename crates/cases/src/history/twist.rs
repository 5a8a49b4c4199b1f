//! The twist of a history: torque, stick area and circumferential traction.

use crate::Error;
use carom_laws::friction::Friction;
use carom_laws::hertz::HertzState;
use carom_laws::law::ContactLaw as _;
use carom_laws::torsion::adhesion::sliding_torque_arm;
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::law::TorsionLaw;
use carom_special::quadrature::{Tolerance, adaptive};

/// Smallest fraction of the contact radius at which the traction is evaluated.
const CENTRE: f64 = 1e-9;
/// Tolerances of the traction, relative to its maximum: the second for states with many jumps, which the
/// solve on rings leaves.
const TOLERANCES: [f64; 2] = [1e-6, 1e-3];

/// Quantities of the twist after a step.
#[derive(Debug, Clone, Copy)]
pub struct Twist {
    /// Regime of the twist.
    pub regime: &'static str,
    /// Semi-axis of the stick area along x.
    pub stick_semi_axis_a: f64,
    /// Semi-axis of the stick area along y.
    pub stick_semi_axis_b: f64,
    /// The torque over that of complete sliding.
    pub share: f64,
}

/// The present state of the law; `state` is that of the contact, none if the bodies are separated.
pub(super) fn twist(law: &TorsionLaw, state: Option<&HertzState>, friction: Friction) -> Twist {
    let (stick, m_z) = (law.stick_radius(), law.load().m_z);
    let [a, b] =
        state.map_or([0.0; 2], |state| [state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b()]);
    let limit = state
        .map_or(0.0, |state| friction.get() * state.force * sliding_torque_arm(&state.ellipse));
    Twist {
        regime: match stick {
            _ if state.is_none() => "separated",
            _ if stick < CENTRE => "sliding",
            _ if stick < 1.0 - CENTRE => "slip",
            _ => "adhesion",
        },
        stick_semi_axis_a: stick * a,
        stick_semi_axis_b: stick * b,
        share: if limit > 0.0 { m_z.abs() / limit } else { 0.0 },
    }
}

/// The circumferential traction at a fraction `radius` of the contact radius, over that of sliding at the
/// centre. For a circle it is `rho int_rho^al b(s)/sqrt(s^2 - rho^2) ds/al`, which is `sqrt(1 - radius^2)` in
/// sliding.
pub(super) fn traction(history: &TwistHistory, radius: f64) -> Result<f64, Error> {
    let edge = history.radius();
    if edge <= 0.0 || radius >= 1.0 {
        return Ok(0.0);
    }
    // s = rho cosh u
    let rho = radius.max(CENTRE);
    let upper = libm::acosh(1.0 / rho);
    let density = |u: f64| rho * history.density(rho * edge * libm::cosh(u));
    let [fine, coarse] = TOLERANCES;
    let integral = adaptive(0.0, upper, Tolerance::new(fine, fine)?, density)
        .or_else(|_| adaptive(0.0, upper, Tolerance::new(coarse, coarse)?, density))?;
    Ok(integral.value)
}
