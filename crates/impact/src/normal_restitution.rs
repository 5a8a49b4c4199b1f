//! Energy lost in the material in an impact, beyond the elastic theory.
//!
//! Elastic bodies without friction separate with the speed at which they met. Real bodies lose
//! energy by plastic flow, internal friction and waves. [`NormalRestitution`] describes this by
//! scaling the elastic impulse J to `s J`, such that the share e of the elastic normal velocity
//! remains: `s = (1 + e)/2` if normal and tangential motion are uncoupled. All parts of the pulse
//! are scaled alike: the friction limit holds as before, sliding throughout is right, and `e = 1`
//! is the elastic impact. Of the kinetic energy, friction takes `s Q`, Q the heat of the elastic
//! impact, and the material `s (1 - s) J.D.J/2`, D the mobility: `(1 - e^2) v^2/(2 D_zz)` for a
//! normal impact at v. Neither is negative.

use crate::normal::NormalImpact;
use carom_laws::damping::viscoelastic_restitution;
use carom_special::RangeError;
use nalgebra::Vector3;

/// Coefficient of normal restitution e, from 0 to 1: the normal velocity after an impact over that
/// of the elastic impact. If normal and tangential motion are uncoupled, this is the ratio to the
/// velocity before.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion, NormalRestitution};
/// use carom_laws::friction::Friction;
/// let rubber = Material::from_young(20e6, 0.5)?;
/// let ball = Body::sphere(0.02, rubber, 0.03)?
///     .moving(Motion::new([0.0, 0.0, -2.0], [0.0; 3])?);
/// let floor = Body::plane(Material::RIGID);
/// let outcome = Collision::new(ball, floor, Friction::new(0.3)?)?
///     .with_normal_restitution(NormalRestitution::new(0.8)?)
///     .solve()?;
/// assert!((outcome.motions()[0].velocity.z - 1.6).abs() < 1e-14);
/// let energy = outcome.rebound().ok_or("they meet")?.energy;
/// assert!((energy.lost - 0.5 * 0.03 * (2.0 * 2.0 - 1.6 * 1.6)).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalRestitution(Cause);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Cause {
    Given(f64),
    Waves,
    /// The relaxation time, s.
    Viscoelastic(f64),
}

impl NormalRestitution {
    /// No energy is lost in the material.
    pub const ELASTIC: Self = Self(Cause::Given(1.0));

    /// A given coefficient e.
    ///
    /// # Errors
    /// [`RangeError`] if it is not in [0, 1].
    pub fn new(coefficient: f64) -> Result<Self, RangeError> {
        let holds = (0.0..=1.0).contains(&coefficient);
        RangeError::check("normal restitution", coefficient, holds, "from 0 to 1")
            .map(|e| Self(Cause::Given(e)))
    }

    /// The coefficient that follows from the energy radiated by elastic waves,
    /// `e = sqrt(1 - share)`. The share is that of (3.2), as in [`carom_laws::validity::Limit::Waves`]: for
    /// the body that would lose most to a half-space of its own material.
    #[must_use]
    pub const fn by_waves() -> Self {
        Self(Cause::Waves)
    }

    /// The coefficient of viscoelastic bodies, which falls as the speed grows (Kuwabara and Kono): Hertz's force
    /// K zeta^(3/2) has a companion `K (3/2) A sqrt(zeta) dzeta/dt`, A the relaxation time of both bodies together, s.
    ///
    /// See [`viscoelastic_restitution`]. For slow impacts `1 - e` grows as v^(1/5).
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::{Body, Collision, Motion, NormalRestitution};
    /// use carom_laws::friction::Friction;
    /// let ice = Material::from_young(7e9, 0.3)?;
    /// let floor = Body::plane(ice);
    /// let at = |speed: f64| -> Result<f64, Box<dyn std::error::Error>> {
    ///     let ball = Body::sphere(0.01, ice, 0.004)?.moving(Motion::new([0.0, 0.0, -speed], [0.0; 3])?);
    ///     let outcome = Collision::new(ball, floor.clone(), Friction::NONE)?
    ///         .with_normal_restitution(NormalRestitution::viscoelastic(1e-6)?)
    ///         .solve()?;
    ///     Ok(outcome.motions()[0].velocity.z / speed)
    /// };
    /// assert!(at(1e-3)? > at(1.0)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and >= 0.
    pub fn viscoelastic(relaxation: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("relaxation", relaxation)?;
        match relaxation == 0.0 {
            true => Ok(Self::ELASTIC),
            false => Ok(Self(Cause::Viscoelastic(relaxation))),
        }
    }

    /// Whether no energy is lost.
    pub(crate) fn is_elastic(self) -> bool {
        self == Self::ELASTIC
    }

    /// The reduction of an impact with these elastic normal velocities, before and after; `pulse` is its normal
    /// motion without friction.
    ///
    /// # Errors
    /// [`RangeError`] if the relaxation takes longer than the impact by far.
    pub(crate) fn damped(
        self,
        wave_share: f64,
        pulse: &NormalImpact,
        [before, after]: [f64; 2],
    ) -> Result<Damped, RangeError> {
        let e = match self.0 {
            Cause::Given(e) => e,
            Cause::Waves => (1.0 - wave_share).max(0.0).sqrt(),
            Cause::Viscoelastic(relaxation) => {
                // zeta_max/v is (5/4)^(2/5) times the unit of time.
                let unit = pulse.time_unit() / libm::pow(1.25, 0.4);
                let allowed = "at most 66 times the time of the impact, (m/K)^(2/5) v^(-1/5)";
                viscoelastic_restitution(1.5 * relaxation / unit)
                    .map_err(|_| RangeError::new("relaxation", relaxation, allowed))?
            }
        };
        Ok(Damped { part: (before - e * after) / (before - after) })
    }
}

impl Default for NormalRestitution {
    fn default() -> Self {
        Self::ELASTIC
    }
}

/// The reduction of an elastic impact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Damped {
    /// Share s of the elastic impulse.
    pub(crate) part: f64,
}

impl Damped {
    /// The impulse and the relative velocity after, from those of the elastic impact.
    pub(crate) fn motion(
        self,
        impulse: Vector3<f64>,
        [before, after]: [&Vector3<f64>; 2],
    ) -> [Vector3<f64>; 2] {
        if self.part == 1.0 {
            return [impulse, *after];
        }
        [self.part * impulse, before + self.part * (after - before)]
    }

    /// R_x from that of the elastic impact.
    pub(crate) fn restitution(self, elastic: f64) -> f64 {
        if self.part == 1.0 { elastic } else { self.part * (1.0 + elastic) - 1.0 }
    }

    /// The energy lost in the material, given J.D.J/2 of the elastic impact.
    pub(crate) fn lost(self, exchanged: f64) -> f64 {
        self.part * (1.0 - self.part) * exchanged.max(0.0)
    }
}
