//! The friction of grains.

use carom_laws::coupling::coupling_bound;
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::static_friction::StaticFriction;
use carom_special::RangeError;

/// One coefficient, or static friction above kinetic friction, or one by the slip speed at the first touch.
#[derive(Debug, Clone, Copy)]
pub(crate) enum GrainFriction {
    Constant(StaticFriction),
    BySlip(SlipSpeedFriction),
}

impl GrainFriction {
    /// Whether a contact that touches anew has another coefficient.
    #[inline(always)]
    pub(crate) fn is_by_slip(&self) -> bool {
        matches!(self, Self::BySlip(_))
    }

    /// The coefficients of a contact that first touches at this slip speed.
    pub(super) fn at(&self, slip_speed: f64) -> Result<StaticFriction, RangeError> {
        match self {
            Self::Constant(friction) => Ok(*friction),
            Self::BySlip(friction) => {
                let friction = friction.at(slip_speed)?;
                StaticFriction::new(friction, friction)
            }
        }
    }

    /// That of sliding; by the slip speed, at great speeds.
    pub(super) fn kinetic(&self) -> Result<Friction, RangeError> {
        match self {
            Self::Constant(friction) => Ok(friction.kinetic()),
            Self::BySlip(friction) => Friction::new(friction.coefficients()[0]),
        }
    }

    /// The bound of the effect of coupling, at any slip speed.
    pub(super) fn coupling_bound(&self, gamma: f64) -> Result<f64, RangeError> {
        let least = match self {
            Self::Constant(friction) => friction.kinetic(),
            // The bound grows as friction falls, also where that tends to zero; it is 0 without friction alone.
            Self::BySlip(friction) => {
                let [at_rest, fast] = [friction.at(0.0)?, self.kinetic()?].map(Friction::get);
                Friction::new(at_rest.min(fast).max(1e-30))?
            }
        };
        Ok(coupling_bound(gamma, least))
    }
}

/// An error of friction by the slip speed, by the name of its option.
pub(crate) fn of_option(error: RangeError) -> RangeError {
    match error.field {
        "a" => RangeError { field: "friction", ..error },
        "b" => RangeError { field: "slip_friction_b", ..error },
        _ => RangeError { field: "slip_friction_c", ..error },
    }
}
