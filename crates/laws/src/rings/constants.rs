//! What the law of rings takes from a contact, and how closely it solves a step.

use carom_special::RangeError;

use crate::hertz::Hertz;

/// How far from 1 the axis ratio of a circle may be.
const ROUND: f64 = 1e-9;
/// The smallest kappa, of Poisson's ratio -1, and the largest, of 1/2.
const KAPPA: [f64; 2] = [0.75, 1.5];
/// The largest gamma, of Poisson's ratio -1 against a rigid body.
const GAMMA: f64 = 0.75;
/// What rounding may add to them.
const ROUNDING: f64 = 1e-12;

/// What the law of rings takes from a circular contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingConstants {
    /// `F_z = (2/3) c_z zeta^(3/2)` of Hertz.
    pub c_z: f64,
    /// The contact radius at unit approach, `a = radius zeta^(1/2)`.
    pub radius: f64,
    /// c_z/c_x (15.1).
    pub kappa: f64,
    /// The coupling of normal and tangential displacements (15.2), positive where body 1 is the one whose
    /// surface pressure draws inwards more.
    pub gamma: f64,
}

impl RingConstants {
    /// Of a Hertzian contact.
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

    /// The constants, if each is within its range.
    ///
    /// # Errors
    /// [`RangeError`] for the one that is not.
    pub fn checked(self) -> Result<Self, RangeError> {
        let size = |value: f64| value > 0.0 && value <= 1e150;
        RangeError::check("c_z", self.c_z, size(self.c_z), "> 0 and at most 1e150")?;
        RangeError::check("radius", self.radius, size(self.radius), "> 0 and at most 1e150")?;
        let [low, high] = KAPPA;
        let holds = self.kappa >= low - ROUNDING && self.kappa <= high + ROUNDING;
        RangeError::check("kappa", self.kappa, holds, "from 3/4 to 3/2")?;
        let holds = self.gamma.abs() <= GAMMA + ROUNDING;
        RangeError::check("gamma", self.gamma, holds, "from -3/4 to 3/4")?;
        Ok(self)
    }
}

/// How closely the tractions of a step keep Coulomb's law, over the peak of the pressure.
///
/// It steers the iteration of a step and is no bound of the law's error, which is that of the rings: at
/// 1e-2 that of six rings is not seen to grow.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance(f64);

impl Tolerance {
    /// That of many particles: 1e-2.
    pub const PARTICLES: Self = Self(1e-2);
    /// That of grains that collide in some 100 steps: 3e-3.
    ///
    /// In impacts of five everyday pairs in 100 steps, the tangential velocity over that before at most 5 f times and
    /// at least f/2 times that of approach, R_x was off by 8e-3 at most, by 13e-3 at 1e-2.
    pub const GRAINS: Self = Self(3e-3);
    /// That of single contacts: 1e-3.
    pub const FINE: Self = Self(1e-3);

    /// A tolerance.
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
