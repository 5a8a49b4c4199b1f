//! A step of the contact of two bodies.

use carom_laws::grains::{Grain, GrainLoad, Heats, Meeting, Surface};
use carom_special::RangeError;

use super::bodies::{Bodies, Second};
use super::kind::{Kind, RingTouch, ShiftTouch};
use super::parts::{Held, Parts};
use super::{CaromTouch, Place};
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::pointers::{read, write, write_or_null};

/// The load that body 2 exerts on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromGrainLoad {
    /// The force on body 1, N; the force on body 2 is opposite.
    pub force: [f64; 3],
    /// The torque on body 1 about its centre, N m.
    pub torque_1: [f64; 3],
    /// The torque on body 2 about its centre, N m; zero for a wall.
    pub torque_2: [f64; 3],
}

const _: () = assert!(size_of::<CaromGrainLoad>() == size_of::<GrainLoad>());

impl CaromGrainLoad {
    /// The place of the load that a contact writes.
    #[inline(always)]
    pub(crate) fn as_load(&mut self) -> &mut GrainLoad {
        // SAFETY: both are nine numbers in C's order: a force, the torque on body 1 and that on body 2.
        unsafe { &mut *(&raw mut *self).cast() }
    }
}

impl From<GrainLoad> for CaromGrainLoad {
    #[inline]
    fn from(GrainLoad { force, torques: [torque_1, torque_2] }: GrainLoad) -> Self {
        Self { force, torque_1, torque_2 }
    }
}

/// A load, unless positions or motions beyond all range have made a part of it infinite or no number.
pub(super) fn finite(load: GrainLoad) -> Result<GrainLoad, RangeError> {
    for part in load.torques.iter().chain([&load.force]).flatten() {
        RangeError::finite("load", *part)?;
    }
    Ok(load)
}

/// A contact of any law, and its bodies.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub(super) law: &'a CaromLaw,
    pub(super) touch: *mut CaromTouch,
    pub(super) one: &'a Grain,
    pub(super) second: Second<'a>,
    pub(super) dt: f64,
}

impl Step<'_> {
    /// Makes the step, whatever the law and the bodies are.
    ///
    /// # Safety
    /// The touch has the size that the law tells, and nobody else uses it.
    #[inline(always)]
    pub(super) unsafe fn make(
        self,
        load: &mut CaromGrainLoad,
        heats: Option<&mut Heats>,
    ) -> Result<(), Failure> {
        let load = load.as_load();
        // SAFETY: the caller's promise.
        unsafe {
            match (self.law.is_by_rings(), self.second) {
                (false, Second::Grain(two)) => {
                    self.with::<ShiftTouch>([self.one, two], load, heats)
                }
                (false, Second::Wall(wall)) => {
                    self.with::<ShiftTouch>((self.one, wall), load, heats)
                }
                (true, Second::Grain(two)) => self.with::<RingTouch>([self.one, two], load, heats),
                (true, Second::Wall(wall)) => self.with::<RingTouch>((self.one, wall), load, heats),
            }
        }
    }

    /// # Safety
    /// As [`Step::make`].
    #[inline(always)]
    unsafe fn with<K: Kind>(
        self,
        bodies: impl Bodies,
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) -> Result<(), Failure> {
        let apart = bodies.apart()?;
        let meeting = bodies.meeting(apart, self.law);
        self.law.check_masses(&meeting)?;
        let place = Place::<K>::of(self.touch, self.law);
        let of = (self.law, bodies.radii());
        // SAFETY: the caller's promise.
        let held = unsafe { place.held()? };
        // Bodies that were apart touch anew, if their friction is that of the first touch.
        let held = held.filter(|held| !self.law.is_by_slip() || held.contact.overlaps());
        match held {
            Some(held) if self.law.is_alone() => held
                .contact
                .change(of, |contact| Ok(contact.advance_with(&meeting, self.dt, load, heats)?)),
            Some(held) => self.whole(held.checked()?, of.1, &{ meeting }, (load, heats)),
            None => {
                let meeting = bodies.meeting(apart, self.law);
                let mut parts = Parts::<K>::met(of, &meeting)?;
                self.whole(parts.held(), of.1, &meeting, (load, heats))?;
                if !parts.contact.is_new() {
                    // SAFETY: the caller's promise.
                    unsafe { place.keep(parts) };
                }
                Ok(())
            }
        }
    }

    #[inline(never)]
    fn whole<K: Kind>(
        self,
        mut held: Held<'_, K>,
        radii: [f64; 2],
        meeting: &Meeting,
        (load, heats): (&mut GrainLoad, Option<&mut Heats>),
    ) -> Result<(), Failure> {
        held.change((self.law, radii), |whole| Ok(whole.advance(meeting, self.dt, load, heats)?))
    }
}

/// One step of duration `dt` of the contact of a grain, body 1, with another grain, `two`, or with a wall of any shape,
/// `wall`, which may turn; the other one of both is null. Positions are those at the end of the step. Velocities are
/// those that led there; in a leapfrog scheme, those of the half step between. The heat of the step is added to
/// `heats`, which may be null; computing it costs several times the force, but nothing with CAROM_LAW_RINGS.
///
/// Where the bodies separate, the history is lost; if heat is computed, it contains the energy released then. Bodies
/// that are separated and stay so need no call. Without damping, friction of the last four steps before is the mean over
/// each of them, as the motion needs it, and may exceed the friction limit of the force at their end.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_step(
    law: *const CaromLaw,
    touch: *mut CaromTouch,
    one: *const Grain,
    two: *const Grain,
    wall: *const Surface,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (law, one) = (read(law, "law")?, read(one, "one")?);
        let second = Second::of(two, wall)?;
        write(touch, "touch")?;
        let (load, heats) = (write(load, "load")?, write_or_null(heats, "heats")?);
        Step { law, touch, one, second, dt }.make(load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
