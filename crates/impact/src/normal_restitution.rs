//! Energy lost in the material in an impact, beyond the elastic theory.
//!
//! Elastic bodies without friction separate with the speed at which they met. Real bodies lose energy by internal friction,
//! waves and plastic flow. A restitution e or a relaxation time A mean one material everywhere: each stress has a viscous
//! companion ([`crate::viscoelastic`]); e is that of the material where nothing couples normal and tangential motion.
//!
//! A loss by yield is another cause, for which no exact theory is at hand: [`NormalRestitution::by_yield`] scales the elastic
//! impulse J to `s J`, `s = (1 + e)/2` if normal and tangential motion are uncoupled. Of the kinetic energy, friction then
//! takes `s Q`, Q the heat of the elastic impact, and the material `s (1 - s) J.D.J/2`, D the mobility.

use crate::normal::NormalImpact;
use crate::restitution_by_speed::RestitutionBySpeed;
use crate::viscoelastic::{Rheology, ViscousLoss};
use carom_special::{RangeError, WordError};
use nalgebra::Vector3;

/// Coefficient of normal restitution e, from 0 to 1, and the cause of the loss: the normal velocity after an impact over that
/// before, where normal and tangential motion are uncoupled.
///
/// What the loss does to friction depends on its cause ([`LossCause`]).
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
#[derive(Debug, Clone, PartialEq)]
pub struct NormalRestitution(Cause);

#[derive(Debug, Clone, PartialEq)]
enum Cause {
    /// The restitution of a viscous material.
    Viscous(ViscousLoss),
    /// That of a viscous material that loses what waves carry away.
    Waves,
    /// The relaxation time of a viscous material, s.
    Relaxation(f64),
    /// The restitution of bodies that yield.
    Yield(f64),
    /// One of each speed of approach.
    BySpeed(LossCause, RestitutionBySpeed),
}

/// What makes bodies lose energy along the normal, where the restitution is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LossCause {
    /// The viscosity of the material, with the exact impact of [`crate::viscoelastic`]: of Kelvin's and Voigt's kind.
    #[default]
    Viscous,
    /// The same of [`Rheology::Maxwell`], where nothing couples normal and tangential motion.
    Maxwell,
    /// The same of [`Rheology::StandardSolid`] that relaxes to a tenth of its modulus.
    StandardSolid,
    /// The same of [`Rheology::ConstantLossTangent`].
    ConstantLossTangent,
    /// Yield: the elastic impulse times (1 + e)/2 ([`NormalRestitution::by_yield`]).
    Yield,
}

/// E_inf/E_0 of a standard solid that is named without it.
const RELAXED: f64 = 0.1;

impl LossCause {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Viscous, Self::Maxwell, Self::StandardSolid, Self::ConstantLossTangent, Self::Yield];
    const NAMES: [&'static str; 5] = [
        Self::Viscous.name(),
        Self::Maxwell.name(),
        Self::StandardSolid.name(),
        Self::ConstantLossTangent.name(),
        Self::Yield.name(),
    ];

    /// `viscous`, `maxwell`, `standard-solid`, `constant-loss-tangent` or `yield`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Viscous => "viscous",
            Self::Maxwell => "maxwell",
            Self::StandardSolid => "standard-solid",
            Self::ConstantLossTangent => "constant-loss-tangent",
            Self::Yield => "yield",
        }
    }

    /// What a material with this loss does, in words.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Viscous => {
                "the material is viscous (Kelvin and Voigt), along the normal and across"
            }
            Self::Maxwell => {
                "all stress relaxes (Maxwell); like spheres and planes without spin only"
            }
            Self::StandardSolid => "stress relaxes to a tenth (standard solid); as maxwell",
            Self::ConstantLossTangent => {
                "the loss tangent is the same at any frequency; as maxwell"
            }
            Self::Yield => "the bodies yield: the elastic impulse times (1 + e)/2",
        }
    }

    /// How the stress relaxes in a viscous material.
    const fn rheology(self) -> Option<Rheology> {
        match self {
            Self::Viscous => Some(Rheology::KelvinVoigt),
            Self::Maxwell => Some(Rheology::Maxwell),
            Self::StandardSolid => Some(Rheology::StandardSolid { relaxed: RELAXED }),
            Self::ConstantLossTangent => Some(Rheology::ConstantLossTangent),
            Self::Yield => None,
        }
    }
}

impl std::str::FromStr for LossCause {
    type Err = WordError;

    fn from_str(word: &str) -> Result<Self, WordError> {
        let cause = Self::ALL.into_iter().find(|cause| cause.name() == word);
        cause.ok_or_else(|| WordError::new("loss", word, &Self::NAMES))
    }
}

impl NormalRestitution {
    /// No energy is lost in the material.
    pub const ELASTIC: Self = Self(Cause::Viscous(ViscousLoss::NONE));

    /// The coefficient e of a viscous material.
    ///
    /// # Errors
    /// [`RangeError`] if it is not in [0, 1].
    pub fn new(coefficient: f64) -> Result<Self, RangeError> {
        Self::in_material(Rheology::KelvinVoigt, coefficient)
    }

    /// The coefficient e of bodies that yield: the elastic impulse times (1 + e)/2, along the normal and across.
    ///
    /// Yield dissipates in compression only and leaves the tangential springs elastic; no exact theory is at hand. Against
    /// a crude estimate with springs that yield, R_x was off by .03 to .23 from e = .95 to .5 at lambda >= 1.5; below, it is
    /// no better than the elastic value.
    ///
    /// ```
    /// use carom_impact::NormalRestitution;
    /// assert_ne!(NormalRestitution::by_yield(0.5)?, NormalRestitution::new(0.5)?);
    /// assert_eq!(NormalRestitution::by_yield(1.0)?, NormalRestitution::ELASTIC);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if it is not in [0, 1].
    pub fn by_yield(coefficient: f64) -> Result<Self, RangeError> {
        let e = Self::check(coefficient)?;
        Ok(if e == 1.0 { Self::ELASTIC } else { Self(Cause::Yield(e)) })
    }

    /// The coefficient e by this cause.
    ///
    /// # Errors
    /// [`RangeError`] if it is not in [0, 1].
    pub fn by(cause: LossCause, coefficient: f64) -> Result<Self, RangeError> {
        match cause.rheology() {
            None => Self::by_yield(coefficient),
            Some(rheology) => Self::in_material(rheology, coefficient),
        }
    }

    /// The coefficient e by this cause at each speed of approach.
    ///
    /// # Errors
    /// [`RangeError`] as [`NormalRestitution::by`], for each restitution.
    pub fn by_speed(cause: LossCause, table: RestitutionBySpeed) -> Result<Self, RangeError> {
        if !matches!(cause, LossCause::Viscous | LossCause::Yield) {
            table.restitutions().try_for_each(|e| Self::by(cause, e).map(|_| ()))?;
        }
        Ok(Self(Cause::BySpeed(cause, table)))
    }

    /// That of impacts with this speed of approach along the normal, m/s; the same at all speeds, unless it was given by
    /// speed.
    ///
    /// # Errors
    /// As [`NormalRestitution::by`].
    pub fn at(&self, speed: f64) -> Result<Self, RangeError> {
        match &self.0 {
            Cause::BySpeed(cause, table) => Self::by(*cause, table.at(speed)),
            _ => Ok(self.clone()),
        }
    }

    /// The coefficient e of a material whose stress relaxes so. Others than Kelvin's and Voigt's are for impacts in which
    /// nothing couples normal and tangential motion, and e from 0.1.
    ///
    /// # Errors
    /// [`RangeError`] as [`ViscousLoss::of_restitution_in`].
    pub fn in_material(rheology: Rheology, coefficient: f64) -> Result<Self, RangeError> {
        let e = Self::check(coefficient)?;
        Ok(Self(Cause::Viscous(ViscousLoss::of_restitution_in(rheology, e)?)))
    }

    fn check(coefficient: f64) -> Result<f64, RangeError> {
        let holds = (0.0..=1.0).contains(&coefficient);
        RangeError::check("normal_restitution", coefficient, holds, "from 0 to 1")
    }

    /// The coefficient that follows from the energy radiated by elastic waves,
    /// `e = sqrt(1 - share)`. The share is that of (3.2), as in [`carom_laws::validity::Limit::Waves`]: for
    /// the body that would lose most to a half-space of its own material.
    #[must_use]
    pub const fn by_waves() -> Self {
        Self(Cause::Waves)
    }

    /// The relaxation time A of a viscous material, s, of both bodies together. e falls as the speed grows: for slow
    /// impacts `1 - e` grows as v^(1/5).
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
            false => Ok(Self(Cause::Relaxation(relaxation))),
        }
    }

    /// Whether no energy is lost.
    pub(crate) fn is_elastic(&self) -> bool {
        *self == Self::ELASTIC
    }

    /// The loss of a viscous material in an impact; `pulse` is its elastic normal motion without friction. None without
    /// one.
    ///
    /// # Errors
    /// [`RangeError`] if the relaxation takes longer than the impact by far.
    pub(crate) fn viscous(
        &self,
        wave_share: impl FnOnce() -> f64,
        pulse: &NormalImpact,
    ) -> Result<Option<ViscousLoss>, RangeError> {
        let loss = match self.0 {
            Cause::BySpeed(..) => return self.at(pulse.velocity())?.viscous(wave_share, pulse),
            Cause::Yield(_) => return Ok(None),
            Cause::Viscous(loss) => loss,
            Cause::Waves => ViscousLoss::of_restitution((1.0 - wave_share()).max(0.0).sqrt())?,
            Cause::Relaxation(relaxation) => {
                // zeta_max/v is (5/4)^(2/5) times the unit of time.
                let unit = pulse.time_unit() / libm::pow(1.25, 0.4);
                let allowed = "at most 25 times the time of the impact, (m/K)^(2/5) v^(-1/5)";
                ViscousLoss::of_relaxation(relaxation / unit)
                    .map_err(|_| RangeError::new("relaxation", relaxation, allowed))?
            }
        };
        Ok((loss.restitution() < 1.0).then_some(loss))
    }

    /// The restitution e, and whether the bodies yield; none unless one number e of a Kelvin-Voigt material or of yield was
    /// given.
    pub(crate) fn constant(&self) -> Option<(f64, bool)> {
        match self.0 {
            Cause::Viscous(loss) if loss.rheology() == Rheology::KelvinVoigt => {
                Some((loss.restitution(), false))
            }
            Cause::Yield(e) => Some((e, true)),
            _ => None,
        }
    }

    /// Whether it is stated what loses the energy, beside how much.
    pub(crate) fn is_cause_known(&self) -> bool {
        match self.0 {
            Cause::Viscous(loss) => loss.rheology() != Rheology::KelvinVoigt,
            Cause::BySpeed(cause, _) => cause != LossCause::Viscous,
            Cause::Waves | Cause::Relaxation(_) | Cause::Yield(_) => true,
        }
    }

    /// (1 + e)/2 of bodies that yield, 1 of others.
    pub(crate) fn part_of_yield(&self) -> f64 {
        match self.0 {
            Cause::Yield(e) => 0.5 * (1.0 + e),
            _ => 1.0,
        }
    }

    /// The reduction of an impact of bodies that yield, with these elastic normal velocities before and after.
    pub(crate) fn damped(&self, [before, after]: [f64; 2]) -> Damped {
        match self.0 {
            Cause::Yield(e) => Damped { part: (before - e * after) / (before - after) },
            _ => Damped { part: 1.0 },
        }
    }
}

impl Default for NormalRestitution {
    fn default() -> Self {
        Self::ELASTIC
    }
}

/// The reduction of an elastic impact by yield; none for other losses, which its solution contains.
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
