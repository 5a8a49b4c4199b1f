//! The state of the contact of two grains.

use std::mem::MaybeUninit;

use carom_laws::grains::{GrainContact, GrainLoad, Heats, Meeting, grain_numbers};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::grains::{CaromGrainLoad, CaromGrains, relative_radius};
use crate::law::CaromReport;
use crate::pointers::{read, write};
use crate::stored::{Stack, VERTICES, find, present, present_mut, store};

/// Number of 8-byte words in a `carom_touch`, without its mark.
pub const CAROM_TOUCH_WORDS: usize = 158;
/// Number of numbers into which a `carom_touch` packs.
pub const CAROM_TOUCH_NUMBERS: usize = 79;

pub(crate) type Contact = GrainContact<Stack>;

const _: () = assert!(CAROM_TOUCH_NUMBERS == grain_numbers(VERTICES));

/// The state of the contact of two grains, in memory of the caller: 1280 bytes, aligned to 8, that may be
/// copied as bytes. Zero bytes stand for two separated grains. Only the build that wrote it can read it;
/// `carom_touch_pack` converts it to numbers that any build of this `carom_state_version()` can read.
///
/// The constants are those of the step in which contact began. To change them, set the touch to zero.
/// The constants are those of the step in which it began; to change them, make it zero.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromTouch {
    /// Identifies the build that wrote the contact. Written by this library only.
    pub mark: u64,
    /// The bytes of the contact.
    pub words: [MaybeUninit<u64>; CAROM_TOUCH_WORDS],
}

impl CaromTouch {
    #[inline(always)]
    fn present(&self) -> Result<Option<&Contact>, Failure> {
        present(self.mark, &self.words)
    }

    #[inline(always)]
    pub(crate) fn present_mut(&mut self) -> Result<Option<&mut Contact>, Failure> {
        present_mut(self.mark, &mut self.words)
    }

    /// Whether it holds a contact written by this build.
    #[inline(always)]
    pub(crate) fn holds_one(&self) -> bool {
        find::<Contact, CAROM_TOUCH_WORDS>(self.mark, &self.words).is_some()
    }

    /// The contact, without a check.
    ///
    /// # Safety
    /// [`CaromTouch::holds_one`] must be true.
    #[inline]
    pub(crate) unsafe fn present_unchecked(&mut self) -> &mut Contact {
        // SAFETY: the caller's promise.
        unsafe { &mut *self.words.as_mut_ptr().cast() }
    }

    fn keep(&mut self, contact: &Contact) {
        self.mark = store(contact, &mut self.words);
    }

    #[inline(always)]
    pub(crate) fn advance(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: Option<&mut Heats>,
        load: &mut CaromGrainLoad,
        fresh: impl FnOnce() -> Result<Contact, Failure>,
    ) -> Result<(), Failure> {
        let Some(contact) = self.present_mut()? else {
            let mut contact = fresh()?;
            *load = step(&mut contact, meeting, dt, heats)?.into();
            self.keep(&contact);
            return Ok(());
        };
        *load = step(contact, meeting, dt, heats)?.into();
        Ok(())
    }

    #[inline]
    pub(crate) fn load(
        &self,
        meeting: &Meeting,
        fresh: impl FnOnce() -> Result<Contact, Failure>,
    ) -> Result<CaromGrainLoad, Failure> {
        let load = match self.present()? {
            Some(contact) => contact.load(meeting),
            None => fresh()?.load(meeting),
        };
        Ok(load.into())
    }
}

#[inline(always)]
fn step(
    contact: &mut Contact,
    meeting: &Meeting,
    dt: f64,
    heats: Option<&mut Heats>,
) -> Result<GrainLoad, RangeError> {
    match heats {
        None => contact.advance(meeting, dt),
        Some(sums) => contact.advance_accounted(meeting, dt, sums),
    }
}

/// The elastic energy of a contact, compression included, J.
///
/// # Safety
/// `touch` is null or may be read; `energy` and `error` are null or may be written. The touch is as in
/// `carom_touch_grains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_energy(
    touch: *const CaromTouch,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let contact = read(touch, "touch")?.present()?;
        *write(energy, "energy")? = contact.map_or(0.0, GrainContact::stored_energy);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The regime of the last step, and the share of the contact that sticks.
///
/// # Safety
/// As `carom_touch_energy`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_report(
    touch: *const CaromTouch,
    report: *mut CaromReport,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let contact = read(touch, "touch")?.present()?;
        *write(report, "report")? = contact.map_or(CaromReport::APART, |contact| {
            let law = contact.law();
            CaromReport { sticking: law.stick_depth(), regime: law.regime().into() }
        });
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Writes a contact as CAROM_TOUCH_NUMBERS numbers, for a file or another process. All are zero for separated
/// grains; otherwise the first is positive.
///
/// # Safety
/// `touch` is null or may be read; `numbers` is null or has room for CAROM_TOUCH_NUMBERS entries; `error` is
/// null or may be written. The touch is as in `carom_touch_grains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_pack(
    touch: *const CaromTouch,
    numbers: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let touch = read(touch, "touch")?;
        let numbers = write(numbers.cast::<[f64; CAROM_TOUCH_NUMBERS]>(), "numbers")?;
        match touch.present()? {
            Some(contact) => contact.pack(numbers)?,
            None => numbers.fill(0.0),
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Makes a contact from the numbers of `carom_touch_pack`. Constants and radii must be the same as then; the
/// radius of a wall is infinite. The contact continues with the same bits as the packed one.
///
/// # Safety
/// `grains` is null or may be read, `numbers` null or may be read for CAROM_TOUCH_NUMBERS entries; `touch`
/// and `error` are null or may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_unpack(
    grains: *const CaromGrains,
    radius_1: f64,
    radius_2: f64,
    numbers: *const f64,
    touch: *mut CaromTouch,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let grains = read(grains, "grains")?;
        let numbers = read(numbers.cast::<[f64; CAROM_TOUCH_NUMBERS]>(), "numbers")?;
        let touch = write(touch, "touch")?;
        if numbers[0] == 0.0 {
            touch.mark = 0;
            return Ok(());
        }
        let mut contact = grains.contact(relative_radius(radius_1, radius_2)?)?;
        contact.unpack(numbers).map_err(|error| Failure::from(error).in_state())?;
        touch.keep(&contact);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
