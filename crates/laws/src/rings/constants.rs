//! Constants of a contact for the law of rings, and the tolerance of its steps.

use carom_special::RangeError;

use crate::bounds::constant;
use crate::friction::Friction;
use crate::hertz::Hertz;

/// Allowed deviation of the axis ratio of a circle from 1.
const ROUND: f64 = 1e-9;
/// Range of kappa: at Poisson's ratio -1 and 1/2.
const KAPPA: [f64; 2] = [0.75, 1.5];
/// Largest gamma: Poisson's ratio -1 against a rigid body.
const GAMMA: f64 = 0.75;
/// Largest gamma under any friction: Poisson's ratio 0 against a rigid body. Beyond it, under friction above
/// [`STABLE_FRICTION`], tractions grow without bound where a contact recedes and grows again and again: without slip by
/// 1.6 % a step at gamma = 3/4. Measured on random paths: up to it they stay bounded under friction of 3, 10, 30, 100,
/// 1e4, 1e6 and without slip, up to this friction they do at gamma = 3/4 (300 to 4000 steps, 4 to 24 rings).
const STABLE_GAMMA: f64 = 0.5;
const STABLE_FRICTION: f64 = 2.0;
/// Allowance for rounding at the ends of these ranges.
const ROUNDING: f64 = 1e-12;

/// The constants of a circular contact in the law of rings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingConstants {
    /// Normal stiffness of Hertz, `F_z = (2/3) c_z zeta^(3/2)`.
    pub c_z: f64,
    /// The contact radius at unit approach, `a = radius zeta^(1/2)`.
    pub radius: f64,
    /// Ratio of normal to tangential stiffness, c_z/c_x (15.1).
    pub kappa: f64,
    /// The coupling of normal and tangential displacements (15.2); positive if pressure draws the surface of
    /// body 1 inwards more than that of body 2.
    pub gamma: f64,
}

impl RingConstants {
    /// The constants of a Hertz contact.
    ///
    /// # Errors
    /// [`RangeError`] unless the contact is a circle.
    pub fn of(hertz: &Hertz) -> Result<Self, RangeError> {
        let curvature = hertz.curvature();
        let ratio = curvature.b() / curvature.a();
        let holds = (ratio - 1.0).abs() <= ROUND;
        RangeError::check("curvature ratio", ratio, holds, "1: a circular contact")?;
        let materials = hertz.materials();
        let radius = hertz.ellipse(1.0)?.semi_axis_a();
        let c_z = hertz.stiffness().c_z;
        Self { c_z, radius, kappa: materials.kappa(), gamma: materials.gamma() }.checked()
    }

    /// Checks that each constant is within its range.
    ///
    /// # Errors
    /// [`RangeError`] for the first that is not.
    pub fn checked(self) -> Result<Self, RangeError> {
        constant("c_z", self.c_z)?;
        constant("radius", self.radius)?;
        let [low, high] = KAPPA;
        let holds = self.kappa >= low - ROUNDING && self.kappa <= high + ROUNDING;
        RangeError::check("kappa", self.kappa, holds, "from 3/4 to 3/2")?;
        let holds = self.gamma.abs() <= GAMMA + ROUNDING;
        RangeError::check("gamma", self.gamma, holds, "from -3/4 to 3/4")?;
        Ok(self)
    }

    /// Checks that the tractions of a contact with this friction stay bounded.
    ///
    /// # Errors
    /// [`RangeError`] for gamma beyond -1/2 to 1/2, which asks for a negative Poisson's ratio, and friction above 2.
    pub(super) fn stable(self, friction: Friction) -> Result<Self, RangeError> {
        let holds =
            self.gamma.abs() <= STABLE_GAMMA + ROUNDING || friction.get() <= STABLE_FRICTION;
        RangeError::check("gamma", self.gamma, holds, "from -1/2 to 1/2 under friction above 2")?;
        Ok(self)
    }
}

/// How accurately the tractions of a step satisfy Coulomb's law, relative to the peak pressure.
///
/// It ends the iteration of a step. The error of the law is that of the rings and is not bounded by it; with
/// six rings no increase of that error was found up to 1e-2.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance(f64);

impl Tolerance {
    /// For many particles: 1e-2.
    pub const PARTICLES: Self = Self(1e-2);
    /// For grains that collide in some 100 steps: 3e-3.
    ///
    /// In impacts of five common pairs of materials in 100 steps, with a tangential velocity from f/2 to 5 f
    /// times the normal one, the error of R_x was at most 8e-3, and 13e-3 at a tolerance of 1e-2.
    pub const GRAINS: Self = Self(3e-3);
    /// For single contacts: 1e-3.
    pub const FINE: Self = Self(1e-3);

    /// A tolerance from a number.
    ///
    /// # Errors
    /// [`RangeError`] unless it is from 1e-6 to 0.1.
    pub fn new(tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-6..=0.1).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-6 to 0.1").map(Self)
    }

    /// The number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self::PARTICLES
    }
}
