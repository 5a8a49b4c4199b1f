//! Advances many contacts in one call.

use std::array::from_fn;

use carom_laws::grains::{Grain, Heats, Rolling, Surface, TOGETHER, Touching, advance_together};

use super::bodies::Second;
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
    // SAFETY: checked above; the touches are distinct.
    let mut pairs = from_fn(|i| unsafe {
        let at = &mut *all.at(from + i);
        let law = &*at.law;
        let place = Place::<ShiftTouch>::of(at.touch, law);
        let (contact, load, shares) = (&mut *place.contact, at.load.as_load(), law.shares);
        let rolling = law.rolling().zip(place.roll.as_mut());
        let rolling = rolling.and_then(|(resistance, roll)| {
            let relative_radius = relative_radius([at.one.radius, at.two.radius]).ok()?;
            Some(Rolling { resistance, relative_radius, roll })
        });
        Touching { contact, bodies: [&at.one, &at.two], shares, rolling, load }
    });
    let send_for_next = |i: usize| {
        let next = from + TOGETHER + i;
        if next < count {
            // SAFETY: the caller's promise.
            send_for(unsafe { (*all.at(next)).touch }.cast::<ShiftTouch>());
        }
    };
    advance_together(&mut pairs, dt, send_for_next).ok()
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
    let place = Place::<ShiftTouch>::of(at.touch, law);
    // SAFETY: the caller's promise.
    let Ok(Some(contact)) = (unsafe { place.seen() }) else { return false };
    // SAFETY: the caller's promise.
    let roll = unsafe { place.roll.as_ref() };
    let radii = [at.one.radius, at.two.radius];
    if roll.is_some_and(|roll| roll.check().is_err() || relative_radius(radii).is_err()) {
        return false;
    }
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
