//! The two kinds of contacts that a touch may hold: with a law of shifts, or with rings.

use carom_laws::friction::Friction;
use carom_laws::grains::{
    GrainContact, GrainFrame, GrainLoad, Heats, Meeting, Twisted, grain_numbers, ring_grain_numbers,
};
use carom_laws::law::ContactLaw as _;
use carom_laws::rings::{RingLaw, RingMemory};
use carom_laws::static_friction::StaticFriction;
use carom_special::RangeError;

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

    /// A contact of bodies of these radii that first touch at a slip speed.
    fn fresh(law: &CaromLaw, radii: [f64; 2], slip_speed: f64) -> Result<Self, Failure>;

    /// Whether the bodies have not touched yet.
    fn is_new(&self) -> bool;

    /// Whether the bodies overlapped at the end of the last step.
    fn overlaps(&self) -> bool;

    /// A step, whose load goes to its place, and its heat to the sums if they are asked for.
    fn advance(
        &mut self,
        of: (&CaromLaw, [f64; 2]),
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) -> Result<(), Failure>;

    /// The load after the last step.
    fn load(&self, of: (&CaromLaw, [f64; 2]), meeting: &Meeting) -> Result<GrainLoad, Failure>;

    fn stored_energy(&self, of: (&CaromLaw, [f64; 2])) -> Result<f64, Failure>;

    fn report(&self, law: &CaromLaw) -> Result<CaromReport, Failure>;

    /// The coefficient of friction that it keeps.
    fn friction(&self) -> f64;

    fn pack(&self, law: &CaromLaw, numbers: &mut [f64]) -> Result<(), Failure>;

    /// The contact that numbers are, whose friction is that of the law or, if it goes by the slip speed, this one.
    fn unpacked(
        of: (&CaromLaw, [f64; 2]),
        friction: Option<f64>,
        numbers: &[f64],
    ) -> Result<Self, Failure>;
}

/// A contact with a law of shifts.
pub(crate) type ShiftTouch = GrainContact<Law>;

impl Kind for ShiftTouch {
    const NUMBERS: usize = grain_numbers(VERTICES);

    #[cold]
    #[inline(never)]
    fn fresh(law: &CaromLaw, radii: [f64; 2], slip_speed: f64) -> Result<Self, Failure> {
        law.damped(law.shift_law(relative_radius(radii)?, slip_speed)?)
    }

    #[inline(always)]
    fn is_new(&self) -> bool {
        Self::is_new(self)
    }

    #[inline(always)]
    fn overlaps(&self) -> bool {
        Self::overlaps(self)
    }

    #[inline(always)]
    fn advance(
        &mut self,
        _of: (&CaromLaw, [f64; 2]),
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) -> Result<(), Failure> {
        match heats {
            None => self.advance_into(meeting, dt, load)?,
            // A copy, so that the meeting itself stays in registers where no heat is asked for.
            Some(sums) => *load = self.advance_accounted(&{ *meeting }, dt, sums)?,
        }
        Ok(())
    }

    fn load(&self, _of: (&CaromLaw, [f64; 2]), meeting: &Meeting) -> Result<GrainLoad, Failure> {
        Ok(Self::load(self, meeting))
    }

    fn stored_energy(&self, _of: (&CaromLaw, [f64; 2])) -> Result<f64, Failure> {
        Ok(Self::stored_energy(self))
    }

    fn report(&self, _law: &CaromLaw) -> Result<CaromReport, Failure> {
        let law = self.law();
        Ok(CaromReport { sticking: law.stick_depth(), regime: law.regime().into() })
    }

    fn friction(&self) -> f64 {
        self.law().friction().get()
    }

    fn pack(&self, _law: &CaromLaw, numbers: &mut [f64]) -> Result<(), Failure> {
        Ok(Self::pack(self, numbers)?)
    }

    fn unpacked(
        (law, radii): (&CaromLaw, [f64; 2]),
        friction: Option<f64>,
        numbers: &[f64],
    ) -> Result<Self, Failure> {
        let radius = relative_radius(radii)?;
        let its = match friction {
            None => law.shift_law(radius, 0.0)?,
            Some(friction) => {
                let holds = friction.is_finite();
                RangeError::check("friction", friction, holds, "finite")?;
                let friction = Friction::new(friction)?;
                law.shift_law_with(radius, StaticFriction::new(friction, friction)?)?
            }
        };
        let mut contact = law.damped(its)?;
        contact.unpack(numbers)?;
        Ok(contact)
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
    /// The contact with its law.
    fn whole(&self, (law, radii): (&CaromLaw, [f64; 2])) -> Result<GrainContact<RingLaw>, Failure> {
        let its = law.ring_law(relative_radius(radii)?, self.memory)?;
        Ok(GrainContact::of_parts(its, self.frame))
    }

    fn of(contact: &GrainContact<RingLaw>) -> Self {
        Self { memory: *contact.law().memory(), frame: *contact.frame() }
    }
}

impl Kind for RingTouch {
    const NUMBERS: usize = ring_grain_numbers(6, 8);

    fn fresh(law: &CaromLaw, radii: [f64; 2], _slip_speed: f64) -> Result<Self, Failure> {
        let its = law.ring_law(relative_radius(radii)?, RingMemory::default())?;
        Ok(Self::of(&law.damped(its)?))
    }

    fn is_new(&self) -> bool {
        self.frame.is_new()
    }

    fn overlaps(&self) -> bool {
        self.memory.shift().zeta > 0.0
    }

    fn advance(
        &mut self,
        of: (&CaromLaw, [f64; 2]),
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) -> Result<(), Failure> {
        let mut unasked = Heats::default();
        let heats = heats.unwrap_or(&mut unasked);
        let (contact, told) = self.whole(of)?.advanced(meeting, dt, heats)?;
        *self = Self::of(&contact);
        *load = told;
        Ok(())
    }

    fn load(&self, of: (&CaromLaw, [f64; 2]), meeting: &Meeting) -> Result<GrainLoad, Failure> {
        Ok(self.whole(of)?.load(meeting))
    }

    fn stored_energy(&self, of: (&CaromLaw, [f64; 2])) -> Result<f64, Failure> {
        Ok(self.whole(of)?.stored_energy())
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

    fn pack(&self, law: &CaromLaw, numbers: &mut [f64]) -> Result<(), Failure> {
        Ok(self.whole((law, [1.0; 2]))?.pack(numbers)?)
    }

    fn unpacked(
        of: (&CaromLaw, [f64; 2]),
        _friction: Option<f64>,
        numbers: &[f64],
    ) -> Result<Self, Failure> {
        let mut contact = Self::fresh(of.0, of.1, 0.0)?.whole(of)?;
        contact.unpack(numbers)?;
        Ok(Self::of(&contact))
    }
}
