//! The two kinds of contacts that a touch may hold: with a law of shifts, or with rings.

use carom_laws::grains::{
    GrainContact, GrainFrame, GrainLaw, Twisted, grain_numbers, ring_grain_numbers,
};
use carom_laws::law::ContactLaw as _;
use carom_laws::rings::{RingLaw, RingMemory};
use carom_laws::static_friction::StaticFriction;

use super::report::{CaromRegime, CaromReport};
use crate::error::Failure;
use crate::law::CaromLaw;
use crate::law::unit::relative_radius;
use crate::shift::{Law, VERTICES};
use crate::stored::Stored;

/// A contact that a touch may hold.
pub(crate) trait Kind: Stored {
    /// Number of numbers of its stored form.
    const NUMBERS: usize;

    /// The law that carries it.
    type Law: GrainLaw;

    /// A contact of bodies of this relative radius with this friction, if the law does not give it.
    fn fresh(
        law: &CaromLaw,
        relative_radius: f64,
        friction: StaticFriction,
    ) -> Result<Self, Failure>;

    /// Whether the bodies overlapped at the end of the last step.
    fn overlaps(&self) -> bool;

    /// Whether the bodies have not touched yet.
    fn is_new(&self) -> bool;

    /// Changes the contact of bodies of these radii, unless that fails.
    fn change<T>(
        &mut self,
        of: (&CaromLaw, [f64; 2]),
        change: impl FnOnce(&mut GrainContact<Self::Law>) -> Result<T, Failure>,
    ) -> Result<T, Failure>;

    fn report(&self, law: &CaromLaw) -> Result<CaromReport, Failure>;

    /// The coefficient of friction that it keeps.
    fn friction(&self) -> f64;
}

/// A contact with a law of shifts.
pub(crate) type ShiftTouch = GrainContact<Law>;

impl Kind for ShiftTouch {
    const NUMBERS: usize = grain_numbers(VERTICES);

    type Law = Law;

    #[cold]
    #[inline(never)]
    fn fresh(
        law: &CaromLaw,
        relative_radius: f64,
        friction: StaticFriction,
    ) -> Result<Self, Failure> {
        law.damped(law.shift_law(relative_radius, friction)?)
    }

    #[inline(always)]
    fn overlaps(&self) -> bool {
        Self::overlaps(self)
    }

    #[inline(always)]
    fn is_new(&self) -> bool {
        Self::is_new(self)
    }

    #[inline(always)]
    fn change<T>(
        &mut self,
        _of: (&CaromLaw, [f64; 2]),
        change: impl FnOnce(&mut Self) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        change(self)
    }

    fn report(&self, _law: &CaromLaw) -> Result<CaromReport, Failure> {
        let law = self.law();
        Ok(CaromReport { sticking: law.stick_depth(), regime: law.regime().into() })
    }

    fn friction(&self) -> f64 {
        self.law().friction().get()
    }
}

/// A contact with rings, without the matrices of its law.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub(crate) struct RingTouch {
    pub(crate) memory: RingMemory,
    frame: GrainFrame<Twisted>,
}

impl RingTouch {
    fn of(contact: &GrainContact<RingLaw>) -> Self {
        Self { memory: *contact.law().memory(), frame: *contact.frame() }
    }
}

impl Kind for RingTouch {
    const NUMBERS: usize = ring_grain_numbers(6, 8);

    type Law = RingLaw;

    fn fresh(
        law: &CaromLaw,
        relative_radius: f64,
        _friction: StaticFriction,
    ) -> Result<Self, Failure> {
        let its = law.ring_law(relative_radius, RingMemory::default())?;
        Ok(Self::of(&law.damped(its)?))
    }

    fn overlaps(&self) -> bool {
        self.memory.shift().zeta > 0.0
    }

    fn is_new(&self) -> bool {
        self.frame.is_new()
    }

    fn change<T>(
        &mut self,
        (law, radii): (&CaromLaw, [f64; 2]),
        change: impl FnOnce(&mut GrainContact<RingLaw>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let its = law.ring_law(relative_radius(radii)?, self.memory)?;
        let mut contact = GrainContact::of_parts(its, self.frame);
        let told = change(&mut contact)?;
        *self = Self::of(&contact);
        Ok(told)
    }

    fn report(&self, law: &CaromLaw) -> Result<CaromReport, Failure> {
        let its = law.ring_law(1.0, self.memory)?;
        if its.shift().zeta <= 0.0 {
            return Ok(CaromReport::APART);
        }
        let sticking = its.sticking();
        let regime = match sticking {
            1.0.. => CaromRegime::Adhesion,
            0.0 => CaromRegime::Sliding,
            _ => CaromRegime::Slip,
        };
        Ok(CaromReport { sticking, regime })
    }

    fn friction(&self) -> f64 {
        0.0
    }
}
