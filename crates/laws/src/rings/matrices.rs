//! The matrices of two materials and a coefficient of friction, and the constants of a contact.

use carom_special::RangeError;

use super::constants::{RingConstants, Tolerance};
use super::pair::Pair;
use super::symmetry::{Symmetry, Whole};
use super::units::Units;
use crate::friction::Friction;

/// The matrices of the law of rings for two materials and a coefficient of friction. They serve circular
/// contacts of any radius; make them once and share them. They take some tens of kilobytes.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::law::Shift;
/// use carom_laws::rings::{RingMatrices, RingMemory, Tolerance};
/// let matrices = RingMatrices::<6, 8>::new(1.1, 0.2, Friction::new(0.3)?)?;
/// let rings = matrices.contact(4.0, 1.0, Tolerance::PARTICLES)?;
/// let mut memory = RingMemory::default();
/// memory.advance(&rings, Shift { zeta: 1.0, xi: 0.1, ..Shift::default() })?;
/// assert!(memory.load(&rings).f_x > 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct RingMatrices<const N: usize = 6, const M: usize = 8, S: Symmetry<M> = Whole> {
    /// The matrices for the order of the bodies in which gamma >= 0; none without friction.
    pair: Option<Pair<N, M, S>>,
    kappa: f64,
    gamma: f64,
    friction: Friction,
}

impl<const N: usize, const M: usize> RingMatrices<N, M> {
    /// The matrices for kappa (15.1), gamma (15.2) and friction; see [`RingConstants`].
    ///
    /// The first ones of a size take some 0.01 s, further ones 0.1 ms (6 x 8) to 2 ms.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is out of range, and for gamma beyond -1/2 to 1/2 under friction above 2.
    pub fn new(kappa: f64, gamma: f64, friction: Friction) -> Result<Self, RangeError> {
        Self::at(kappa, gamma, friction)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> RingMatrices<N, M, S> {
    /// As [`RingMatrices::new`], for motions with this symmetry.
    pub(super) fn at(kappa: f64, gamma: f64, friction: Friction) -> Result<Self, RangeError> {
        RingConstants { c_z: 1.0, radius: 1.0, kappa, gamma }.checked()?.stable(friction)?;
        let f = friction.get();
        let pair = (f > 0.0).then(|| Pair::new(kappa, gamma.abs(), f));
        Ok(Self { pair, kappa, gamma, friction })
    }

    /// Kappa (15.1).
    #[must_use]
    pub const fn kappa(&self) -> f64 {
        self.kappa
    }

    /// Gamma (15.2).
    #[must_use]
    pub const fn gamma(&self) -> f64 {
        self.gamma
    }

    /// The coefficient of friction.
    #[must_use]
    pub const fn friction(&self) -> Friction {
        self.friction
    }

    /// The constants of a contact with `F_z = (2/3) c_z zeta^(3/2)` and the radius `radius zeta^(1/2)`.
    ///
    /// # Errors
    /// [`RangeError`] unless both are from 1e-60 to 1e60.
    #[inline]
    pub fn contact(
        &self,
        c_z: f64,
        radius: f64,
        tolerance: Tolerance,
    ) -> Result<Rings<'_, N, M, S>, RangeError> {
        RingConstants { c_z, radius, kappa: self.kappa, gamma: self.gamma }.checked()?;
        Ok(self.rings(Units::new(c_z, radius, self.friction), tolerance.get()))
    }

    pub(super) const fn pair(&self) -> Option<&Pair<N, M, S>> {
        self.pair.as_ref()
    }

    #[inline]
    pub(super) const fn rings(&self, units: Units, tolerance: f64) -> Rings<'_, N, M, S> {
        let side = if self.gamma < 0.0 { -1.0 } else { 1.0 };
        let (kappa, friction) = (self.kappa, self.friction);
        Rings { pair: self.pair.as_ref(), side, units, tolerance, kappa, friction }
    }
}

/// The constants of a contact, with a reference to its matrices.
#[derive(Debug, Clone, Copy)]
pub struct Rings<'a, const N: usize = 6, const M: usize = 8, S: Symmetry<M> = Whole> {
    pub(super) pair: Option<&'a Pair<N, M, S>>,
    /// -1 if the bodies are exchanged to make gamma >= 0: y is then reversed, and so are shift and force,
    /// which gives x this sign.
    pub(super) side: f64,
    pub(super) units: Units,
    pub(super) tolerance: f64,
    kappa: f64,
    friction: Friction,
}

impl<const N: usize, const M: usize, S: Symmetry<M>> Rings<'_, N, M, S> {
    /// Normal stiffness of Hertz, `F_z = (2/3) c_z zeta^(3/2)`.
    #[must_use]
    pub const fn c_z(&self) -> f64 {
        self.units.c_z
    }

    /// Kappa (15.1).
    #[must_use]
    pub const fn kappa(&self) -> f64 {
        self.kappa
    }

    /// The coefficient of friction.
    #[must_use]
    pub const fn friction(&self) -> Friction {
        self.friction
    }
}
