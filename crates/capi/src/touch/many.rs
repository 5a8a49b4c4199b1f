//! Advances many contacts in one call.

use std::array::from_fn;

use carom_laws::grains::{
    Grain, Heats, Meeting, RollTrial, Surface, TOGETHER, Touching, advance_together,
};

use super::bodies::{Bodies as _, Second};
use super::parts::Pressed;
use super::step::{CaromGrainLoad, Step};
use super::{CaromTouch, Place, ShiftTouch};
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::law::unit::relative_radius;
use crate::pointers::{Strided, is_place, read, write, write_or_null};

/// A grain, what it touches and their contact, for a call that advances many.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromEncounter {
    /// The law of the contact.
    pub law: *const CaromLaw,
    /// The state of their contact; no two encounters may share one.
    pub touch: *mut CaromTouch,
    /// The wall that body 1 touches; null for body 2.
    pub wall: *const Surface,
    /// Body 1.
    pub one: Grain,
    /// Body 2, unless there is a wall.
    pub two: Grain,
    /// Output: the load on body 1 at the end of the step.
    pub load: CaromGrainLoad,
}

impl CaromEncounter {
    /// # Safety
    /// The wall is null or may be read.
    pub(crate) unsafe fn second(&self) -> Result<Second<'_>, Failure> {
        match self.wall.is_null() {
            true => Ok(Second::Grain(&self.two)),
            // SAFETY: the caller's promise.
            false => Ok(Second::Wall(unsafe { read(self.wall, "wall")? })),
        }
    }

    /// # Safety
    /// As `carom_touch_step_many`, of one encounter.
    unsafe fn step(&mut self, dt: f64, heats: Option<&mut Heats>) -> Result<(), Failure> {
        let Self { law, touch, wall, one, two, load } = self;
        // SAFETY: the caller's promise.
        unsafe {
            let law = read(*law, "law")?;
            write(*touch, "touch")?;
            let second = match wall.is_null() {
                true => Second::Grain(two),
                false => Second::Wall(read(*wall, "wall")?),
            };
            Step { law, touch: *touch, one, second, dt }.make(load, heats)
        }
    }
}

/// One step of duration `dt` for many contacts. Gives the same bits as `carom_touch_step` for each, in less time, since
/// several pairs of grains with laws of shifts share vector instructions.
///
/// An encounter that fails ends the call, and `error->index` names it; those before it have been advanced.
/// The heat of all is added to `heats`, which may be null; computing it costs several times the force.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `encounters` must have `count` entries, of which no two have the same touch.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_step_many(
    encounters: *mut CaromEncounter,
    count: usize,
    dt: f64,
    heats: *mut Heats,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let all = Strided::new(encounters, size_of::<CaromEncounter>(), count, "encounters")?;
        let mut next = 0;
        while next < count {
            let together = heats.is_null() && count - next >= TOGETHER;
            if together && step_together(&all, next, count, dt).is_some() {
                next += TOGETHER;
                continue;
            }
            let some = if together { TOGETHER } else { count - next };
            for i in next..next + some {
                let heats = write_or_null(heats, "heats").map_err(|failure| failure.at(i))?;
                (*all.at(i)).step(dt, heats).map_err(|failure| failure.at(i))?;
            }
            next += some;
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Advances several encounters together, starting with one. Returns nothing and changes nothing if one of
/// them is not yet in contact, has another kind of law or fails.
///
/// # Safety
/// As `carom_touch_step_many`.
#[inline(always)]
unsafe fn step_together(
    all: &Strided<CaromEncounter>,
    from: usize,
    count: usize,
    dt: f64,
) -> Option<()> {
    // SAFETY: the caller's promise.
    let is_ready = |i: usize| unsafe {
        let at = &*all.at(i);
        is_place(at.law) && is_place(at.touch) && at.wall.is_null() && is_ready(at)
    };
    if !(from..from + TOGETHER).all(is_ready) {
        return None;
    }
    let mut rolls: [Option<Rolls>; TOGETHER] = [const { None }; TOGETHER];
    for (i, rolls) in rolls.iter_mut().enumerate() {
        // SAFETY: checked above.
        *rolls = unsafe { Rolls::of(all.at(from + i), dt).ok()? };
    }
    // SAFETY: checked above; the touches are distinct.
    let mut pairs = from_fn(|i| unsafe {
        let at = &mut *all.at(from + i);
        let law = &*at.law;
        let contact = &mut *Place::<ShiftTouch>::of(at.touch, law).contact;
        let load = at.load.as_load();
        Touching { contact, bodies: [&at.one, &at.two], shares: law.shares, load }
    });
    let send_for_next = |i: usize| {
        let next = from + TOGETHER + i;
        if next < count {
            // SAFETY: the caller's promise.
            send_for(unsafe { (*all.at(next)).touch }.cast::<ShiftTouch>());
        }
    };
    advance_together(&mut pairs, dt, send_for_next).ok()?;
    for (i, rolls) in rolls.iter().enumerate() {
        if let Some(rolls) = rolls {
            // SAFETY: as above.
            unsafe { rolls.end(all.at(from + i)) };
        }
    }
    Some(())
}

/// A resistance to rolling in a step.
struct Rolls {
    meeting: Meeting,
    relative_radius: f64,
    trial: RollTrial,
}

impl Rolls {
    /// None if the law has no resistance.
    ///
    /// # Safety
    /// The encounter is ready.
    #[inline(always)]
    unsafe fn of(at: *const CaromEncounter, dt: f64) -> Result<Option<Self>, Failure> {
        // SAFETY: the caller's promise.
        let (at, law) = unsafe { (&*at, &*(*at).law) };
        if law.is_alone() {
            return Ok(None);
        }
        let bodies = [&at.one, &at.two];
        let meeting = bodies.meeting(bodies.apart()?, law);
        // SAFETY: the caller's promise.
        let roll = unsafe { &*Place::<ShiftTouch>::of(at.touch, law).roll };
        roll.check()?;
        let relative_radius = relative_radius(bodies.radii())?;
        let trial = Pressed { law, relative_radius, meeting: &meeting }.trial(roll, dt)?;
        Ok(Some(Self { meeting, relative_radius, trial }))
    }

    /// # Safety
    /// As [`Rolls::of`], and nobody else uses the encounter.
    unsafe fn end(&self, at: *mut CaromEncounter) {
        // SAFETY: the caller's promise.
        let (at, law) = unsafe { (&mut *at, &*(*at).law) };
        // SAFETY: the caller's promise.
        let roll = unsafe { &mut *Place::<ShiftTouch>::of(at.touch, law).roll };
        let pressed =
            Pressed { law, relative_radius: self.relative_radius, meeting: &self.meeting };
        pressed.roll((roll, &self.trial), at.load.as_load(), None);
    }
}

/// Whether a pair of grains has a contact with a law of shifts without torsion, for which nothing but its step and its
/// rolling can fail.
///
/// # Safety
/// As `carom_touch_step_many`; law and touch may be read.
#[inline(always)]
unsafe fn is_ready(at: &CaromEncounter) -> bool {
    // SAFETY: the caller's promise.
    let law = unsafe { &*at.law };
    if law.is_by_rings() || law.has_torsion() {
        return false;
    }
    // SAFETY: the caller's promise.
    let Ok(Some(contact)) = (unsafe { Place::<ShiftTouch>::of(at.touch, law).seen() }) else {
        return false;
    };
    // Masses that a restitution cannot use are refused one by one, and a first touch takes its friction there.
    (!law.weighs() || is_massive(&at.one, &at.two)) && (!law.is_by_slip() || contact.overlaps())
}

/// Whether both masses are > 0 and one of them finite.
fn is_massive(one: &Grain, two: &Grain) -> bool {
    one.mass > 0.0 && two.mass > 0.0 && one.mass.min(two.mass).is_finite()
}

/// Prefetches the cache lines of a value. It has no other effect, and any address is allowed.
#[inline(always)]
fn send_for<T>(place: *const T) {
    #[cfg(target_arch = "x86_64")]
    for line in 0..size_of::<T>().div_ceil(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a prefetch reads nothing and never faults.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(place.cast::<i8>().wrapping_add(64 * line)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = place;
}
