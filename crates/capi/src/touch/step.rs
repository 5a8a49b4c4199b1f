//! A step of the contact of two bodies.

use carom_laws::grains::{Grain, GrainLoad, Heats, Meeting, Surface};
use carom_special::RangeError;

use super::bodies::{Bodies, Second};
use super::kind::{Kind, RingTouch, ShiftTouch};
use super::parts::{Pressed, TWIST_NUMBERS};
use super::{CaromTouch, Place, Roll, Twist};
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::law::unit::relative_radius;
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
        // SAFETY: the caller's promise.
        let present = unsafe { place.present()? };
        // Bodies that were apart touch anew, if their friction is that of the first touch.
        let present = present.filter(|contact| !self.law.is_by_slip() || contact.overlaps());
        if !self.law.is_alone() {
            let radii = bodies.radii();
            // SAFETY: the caller's promise.
            return unsafe { self.with_parts(&place, present, radii, &{ meeting }, (load, heats)) };
        }
        let of = (self.law, bodies.radii());
        let Some(contact) = present else {
            let mut contact =
                K::fresh(self.law, of.1, bodies.meeting(apart, self.law).slip_speed())?;
            contact.advance(of, &meeting, self.dt, load, heats)?;
            if !contact.is_new() {
                // SAFETY: the caller's promise.
                unsafe { place.keep(contact) };
            }
            return Ok(());
        };
        contact.advance(of, &meeting, self.dt, load, heats)
    }

    /// A step with torsion or rolling. What may fail of them comes first, on copies; the contact itself stays as it was
    /// if its step fails.
    ///
    /// # Safety
    /// As [`Step::make`].
    #[inline(never)]
    unsafe fn with_parts<K: Kind>(
        self,
        place: &Place<K>,
        present: Option<&mut K>,
        radii: [f64; 2],
        meeting: &Meeting,
        (load, mut heats): (&mut GrainLoad, Option<&mut Heats>),
    ) -> Result<(), Failure> {
        let (law, dt) = (self.law, self.dt);
        let pressed = Pressed { law, relative_radius: relative_radius(radii)?, meeting };
        // SAFETY: the caller's promise.
        let mut roll = unsafe { place.rolled(law)? };
        let trial = pressed.trial(&roll, dt)?;
        let (mut turned, mut made) = (None, Heats::default());
        if law.has_torsion() {
            let made = heats.is_some().then_some(&mut made);
            // SAFETY: the caller's promise.
            turned = Some(pressed.turned(unsafe { place.twisted() }, dt, made)?);
        }
        let of = (law, radii);
        let is_kept = match present {
            Some(contact) => {
                contact.advance(of, meeting, dt, load, heats.as_deref_mut())?;
                true
            }
            None => {
                let mut contact = K::fresh(law, radii, meeting.slip_speed())?;
                contact.advance(of, meeting, dt, load, heats.as_deref_mut())?;
                if !contact.is_new() {
                    // SAFETY: the caller's promise.
                    unsafe { place.keep(contact) };
                }
                !contact.is_new()
            }
        };
        if let Some(turned) = &turned {
            pressed.add(load, turned.torque);
        }
        pressed.roll((&mut roll, &trial), load, heats.as_deref_mut());
        if let Some(heats) = heats {
            heats.friction += made.friction;
        }
        if is_kept {
            // SAFETY: the caller's promise.
            unsafe { place.keep_roll(law, roll) };
        }
        if let (true, Some(turned)) = (is_kept, &turned) {
            // SAFETY: the caller's promise.
            pressed.keep(turned, unsafe { &mut *place.twist });
        }
        Ok(())
    }
}

/// A twist of bodies that are apart.
const UNTWISTED: &Twist = &[0.0; TWIST_NUMBERS];

impl<K: Kind> Place<K> {
    /// The twist of a law with torsion.
    ///
    /// # Safety
    /// As [`Place::seen`].
    pub(super) unsafe fn twisted<'a>(&self) -> &'a Twist {
        // SAFETY: the caller's promise; any bytes are numbers.
        unsafe { if *self.mark == 0 { UNTWISTED } else { &*self.twist } }
    }

    /// The rolling; that of bodies that are apart if there is no contact, or no resistance.
    ///
    /// # Safety
    /// As [`Place::seen`].
    pub(super) unsafe fn rolled(&self, law: &CaromLaw) -> Result<Roll, Failure> {
        // SAFETY: the caller's promise; any bytes are numbers.
        let is_there = unsafe { *self.mark != 0 } && law.rolling().is_some();
        // SAFETY: as above.
        let roll = if is_there { unsafe { *self.roll } } else { Roll::default() };
        roll.check().map_err(|error| Failure::from(error).in_state())?;
        Ok(roll)
    }

    /// # Safety
    /// As [`Place::present`].
    pub(super) unsafe fn keep_roll(&self, law: &CaromLaw, roll: Roll) {
        if law.rolling().is_some() {
            // SAFETY: the caller's promise.
            unsafe { *self.roll = roll };
        }
    }
}

/// One step of duration `dt` of the contact of a grain, body 1, with another grain, `two`, or with a wall of any shape,
/// `wall`, which may turn; the other one of both is null. Positions are those at the end of the step. Velocities are
/// those that led there; in a leapfrog scheme, those of the half step between. The heat of the step is added to
/// `heats`, which may be null; computing it costs several times the force, but nothing with CAROM_LAW_RINGS.
///
/// Where the bodies separate, the history is lost; if heat is computed, it contains the energy released then. Bodies
/// that are separated and stay so need no call.
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
