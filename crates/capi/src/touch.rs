//! The state of the contact of two grains, or of a grain and a wall, and its steps.

use std::mem::MaybeUninit;

use carom_laws::grains::{Grain, GrainContact, Heats, Meeting, Surface, Wall, grain_numbers};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::grains::{Bodies, CaromGrainLoad, CaromGrains, Contact, relative_radius};
use crate::law::CaromReport;
use crate::law::VERTICES;
use crate::pointers::{read, write};
use crate::stored::{find, present, present_mut, store};

/// Number of 8-byte words in a `carom_touch`, without its mark.
pub const CAROM_TOUCH_WORDS: usize = 161;
/// Number of numbers into which a `carom_touch` packs.
pub const CAROM_TOUCH_NUMBERS: usize = 82;

const _: () = assert!(CAROM_TOUCH_NUMBERS == grain_numbers(VERTICES));

/// The state of the contact of two grains, in memory of the caller: 1296 bytes, aligned to 8, that may be
/// copied as bytes. Zero bytes stand for two separated grains. Only the build that wrote it can read it;
/// `carom_touch_pack` converts it to numbers that any build of this `carom_state_version()` can read.
///
/// The constants are those of the step in which contact began. To change them, set the touch to zero.
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
    pub(crate) fn present(&self) -> Result<Option<&Contact>, Failure> {
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

    /// Whether it holds bodies in contact, written by this build.
    #[inline]
    pub(crate) fn holds_bodies_in_contact(&self) -> bool {
        find::<Contact, CAROM_TOUCH_WORDS>(self.mark, &self.words).is_some_and(touches)
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

    /// Makes it the contact that the numbers are.
    pub(crate) fn unpack(
        &mut self,
        grains: &CaromGrains,
        [radius_1, radius_2]: [f64; 2],
        numbers: &[f64; CAROM_TOUCH_NUMBERS],
    ) -> Result<(), Failure> {
        if numbers[0] == 0.0 {
            self.mark = 0;
            return Ok(());
        }
        let mut contact = grains.contact(relative_radius(radius_1, radius_2)?)?;
        contact.unpack(numbers).map_err(|error| Failure::from(error).in_state())?;
        self.keep(&contact);
        Ok(())
    }

    #[inline(always)]
    pub(crate) fn advance(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: Option<&mut Heats>,
        load: &mut CaromGrainLoad,
        (is_renewed, fresh): (bool, impl FnOnce() -> Result<Contact, Failure>),
    ) -> Result<(), Failure> {
        // Bodies that were apart touch anew, if their friction is that of the first touch.
        let goes_on = |contact: &&mut Contact| !is_renewed || touches(contact);
        let Some(contact) = self.present_mut()?.filter(goes_on) else {
            let mut contact = fresh()?;
            step(&mut contact, meeting, dt, heats, load)?;
            if !contact.is_new() {
                self.keep(&contact);
            }
            return Ok(());
        };
        Ok(step(contact, meeting, dt, heats, load)?)
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

fn touches(contact: &Contact) -> bool {
    contact.overlaps()
}

#[inline(always)]
fn step(
    contact: &mut Contact,
    meeting: &Meeting,
    dt: f64,
    heats: Option<&mut Heats>,
    load: &mut CaromGrainLoad,
) -> Result<(), RangeError> {
    match heats {
        None => contact.advance_into(meeting, dt, load.as_load()),
        // A copy, so that the meeting itself stays in registers where no heat is asked for.
        Some(sums) => {
            *load = contact.advance_accounted(&{ *meeting }, dt, sums)?.into();
            Ok(())
        }
    }
}

/// # Safety
/// As `carom_touch_grains`.
#[inline(always)]
pub(crate) unsafe fn advance(
    grains: *const CaromGrains,
    touch: *mut CaromTouch,
    bodies: impl Bodies,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
) -> Result<(), Failure> {
    // SAFETY: the caller's promise.
    let (grains, touch, load) =
        unsafe { (read(grains, "grains")?, write(touch, "touch")?, write(load, "load")?) };
    // SAFETY: the caller's promise.
    let heats = if heats.is_null() { None } else { Some(unsafe { write(heats, "heats")? }) };
    let apart = bodies.apart()?;
    let meeting = bodies.meeting(apart, grains);
    grains.check_masses(&meeting)?;
    let fresh = || bodies.fresh(apart, grains);
    touch.advance(&meeting, dt, heats, load, (grains.has_slip_friction(), fresh))
}

/// # Safety
/// As `carom_touch_grains_load`.
unsafe fn load_of(
    grains: *const CaromGrains,
    touch: *const CaromTouch,
    bodies: impl Bodies,
    load: *mut CaromGrainLoad,
) -> Result<(), Failure> {
    // SAFETY: the caller's promise.
    let (grains, touch) = unsafe { (read(grains, "grains")?, read(touch, "touch")?) };
    let apart = bodies.apart()?;
    let meeting = bodies.meeting(apart, grains);
    grains.check_masses(&meeting)?;
    // SAFETY: the caller's promise.
    let to = unsafe { write(load, "load")? };
    *to = touch.load(&meeting, || bodies.fresh(apart, grains))?.checked()?;
    Ok(())
}

/// One step of duration `dt` of the contact of two grains. Positions are those at the end of the step.
/// Velocities are those that led there; in a leapfrog scheme, those of the half step between. The heat of the
/// step is added to `heats`, which may be null; computing it costs several times the force.
///
/// Where the grains separate, the history is lost; if heat is computed, it contains the energy released then.
/// Grains that are separated and stay so need no call.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_grains(
    grains: *const CaromGrains,
    touch: *mut CaromTouch,
    one: *const Grain,
    two: *const Grain,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let bodies = [read(one, "one")?, read(two, "two")?];
        advance(grains, touch, bodies, dt, load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the contact of a grain, body 1, and a wall, as `carom_touch_grains`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_wall(
    grains: *const CaromGrains,
    touch: *mut CaromTouch,
    one: *const Grain,
    wall: *const Wall,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let bodies = (read(one, "one")?, read(wall, "wall")?);
        advance(grains, touch, bodies, dt, load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the contact of a grain, body 1, and a wall of any shape, which may turn, as `carom_touch_grains`.
/// With a curved wall `grains` are those of `carom_grains_on_curved_wall`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_surface(
    grains: *const CaromGrains,
    touch: *mut CaromTouch,
    one: *const Grain,
    surface: *const Surface,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let bodies = (read(one, "one")?, read(surface, "surface")?);
        advance(grains, touch, bodies, dt, load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The load of two grains after the last step, without a new one: the same bits if the positions are the
/// same. A touch that is zero carries only the force of Hertz.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_grains_load(
    grains: *const CaromGrains,
    touch: *const CaromTouch,
    one: *const Grain,
    two: *const Grain,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe { load_of(grains, touch, [read(one, "one")?, read(two, "two")?], load) };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The load of a grain, body 1, and a wall after the last step, as `carom_touch_grains_load`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_wall_load(
    grains: *const CaromGrains,
    touch: *const CaromTouch,
    one: *const Grain,
    wall: *const Wall,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe { load_of(grains, touch, (read(one, "one")?, read(wall, "wall")?), load) };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The load of a grain, body 1, and a wall of any shape after the last step, as `carom_touch_grains_load`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_surface_load(
    grains: *const CaromGrains,
    touch: *const CaromTouch,
    one: *const Grain,
    surface: *const Surface,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call =
        || unsafe { load_of(grains, touch, (read(one, "one")?, read(surface, "surface")?), load) };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The elastic energy of a contact, compression included, J: of Hertz at the approach, and of the tangential load.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_energy(
    touch: *const CaromTouch,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let contact = read(touch, "touch")?.present()?;
        let stored = contact.map_or(0.0, GrainContact::stored_energy);
        *write(energy, "energy")? = RangeError::finite("energy", stored)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The regime of the last step, and the share of the contact that sticks.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
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
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have room for CAROM_TOUCH_NUMBERS entries.
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
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have CAROM_TOUCH_NUMBERS entries.
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
        if numbers[0] != 0.0 {
            let (b, allowed) =
                (grains.slip_friction_b, "0: carom_touch_unpack_with_friction knows");
            RangeError::check("slip_friction_b", b, !grains.has_slip_friction(), allowed)?;
        }
        touch.unpack(grains, [radius_1, radius_2], numbers)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
