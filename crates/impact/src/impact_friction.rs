//! The friction of an impact.

use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::static_friction::StaticFriction;
use carom_special::RangeError;
use nalgebra::Vector3;

/// The friction of an impact: a constant coefficient, one that depends on the slip speed at the first touch, or static
/// friction above kinetic friction.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::slip_speed::SlipSpeedFriction;
/// let steel = Material::from_young(208e9, 0.3)?;
/// let ball = Body::sphere(0.01, steel, 0.033)?.moving(Motion::new([3.0, 0.0, -0.5], [0.0; 3])?);
/// let friction = SlipSpeedFriction::new(0.05, 0.1, 0.2)?;
/// let collision = Collision::new(ball, Body::plane(steel), friction)?;
/// assert_eq!(collision.friction(), friction.at(3.0)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ImpactFriction {
    /// A constant coefficient.
    Constant(Friction),
    /// A coefficient that depends on the slip speed at the first touch, and is constant during the impact.
    SlipSpeed(SlipSpeedFriction),
    /// Static friction as a threshold of full sliding, with kinetic friction beyond it.
    ///
    /// The laws of rings and of the grid and the torsional impact refuse it.
    Static(StaticFriction),
}

impl ImpactFriction {
    /// The coefficient of an impact with this velocity of the contact points, in contact axes; that of kinetic
    /// friction.
    ///
    /// # Errors
    /// [`RangeError`] if the slip speed is not finite.
    pub(crate) fn at(self, velocity: &Vector3<f64>) -> Result<Friction, RangeError> {
        match self {
            Self::Constant(friction) => Ok(friction),
            Self::SlipSpeed(friction) => friction.at(libm::hypot(velocity.x, velocity.y)),
            Self::Static(friction) => Ok(friction.kinetic()),
        }
    }

    /// Both coefficients, if static friction exceeds kinetic friction.
    #[must_use]
    pub fn static_friction(self) -> Option<StaticFriction> {
        match self {
            Self::Static(friction) if friction.drops() => Some(friction),
            _ => None,
        }
    }

    /// Whether the coefficient is infinite, so that the bodies never slip.
    #[must_use]
    pub fn is_infinite(self) -> bool {
        match self {
            Self::Constant(friction) => friction == Friction::INFINITE,
            Self::SlipSpeed(_) => false,
            Self::Static(friction) => friction.kinetic() == Friction::INFINITE,
        }
    }
}

impl From<Friction> for ImpactFriction {
    fn from(friction: Friction) -> Self {
        Self::Constant(friction)
    }
}

impl From<StaticFriction> for ImpactFriction {
    fn from(friction: StaticFriction) -> Self {
        Self::Static(friction)
    }
}

impl From<SlipSpeedFriction> for ImpactFriction {
    fn from(friction: SlipSpeedFriction) -> Self {
        Self::SlipSpeed(friction)
    }
}
