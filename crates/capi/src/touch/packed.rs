//! A touch as plain numbers, for a file or another process.

use carom_laws::grains::GrainRoll;

use super::kind::{Kind, RingTouch, ShiftTouch};
use super::parts::{TWIST_NUMBERS, roll_of, torsion};
use super::{CaromTouch, Place, Roll};
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::law::unit::relative_radius;
use crate::pointers::{read, write};

/// Where the parts of a touch lie among its numbers: those of its contact, of its twist, of its rolling, and its
/// coefficient of friction.
struct Layout {
    twist: usize,
    roll: usize,
    friction: usize,
    whole: usize,
}

impl Layout {
    fn of<K: Kind>(law: &CaromLaw) -> Self {
        let twist = K::NUMBERS;
        let roll = twist + if law.has_torsion() { TWIST_NUMBERS } else { 0 };
        let friction = roll + if law.rolling().is_some() { GrainRoll::NUMBERS } else { 0 };
        Self { twist, roll, friction, whole: friction + usize::from(law.is_by_slip()) }
    }
}

/// # Safety
/// The touch has the size that the law tells, and nobody writes it; there is room for all numbers.
unsafe fn pack<K: Kind>(
    law: &CaromLaw,
    touch: *const CaromTouch,
    numbers: *mut f64,
) -> Result<(), Failure> {
    let (place, layout) = (Place::<K>::of(touch, law), Layout::of::<K>(law));
    // SAFETY: the caller's promise.
    let contact = unsafe { place.seen()? };
    // SAFETY: the caller's promise.
    let roll = unsafe { place.rolled(law)? };
    // SAFETY: the caller's promise.
    let numbers = unsafe { std::slice::from_raw_parts_mut(numbers, layout.whole) };
    let Some(contact) = contact else {
        numbers.fill(0.0);
        return Ok(());
    };
    contact.pack(law, &mut numbers[..layout.twist])?;
    if law.has_torsion() {
        // SAFETY: the caller's promise.
        numbers[layout.twist..layout.roll].copy_from_slice(unsafe { place.twisted() });
    }
    if law.rolling().is_some() {
        numbers[layout.roll..layout.friction].copy_from_slice(&roll.packed());
    }
    if law.is_by_slip() {
        numbers[layout.friction] = contact.friction();
    }
    Ok(())
}

/// # Safety
/// As [`pack`].
unsafe fn unpack<K: Kind>(
    law: &CaromLaw,
    radii: [f64; 2],
    numbers: *const f64,
    touch: *mut CaromTouch,
) -> Result<(), Failure> {
    let (place, layout) = (Place::<K>::of(touch, law), Layout::of::<K>(law));
    // SAFETY: the caller's promise.
    let numbers = unsafe { std::slice::from_raw_parts(numbers, layout.whole) };
    if numbers[0] == 0.0 {
        // SAFETY: the caller's promise.
        unsafe { place.clear() };
        return Ok(());
    }
    let (mut twist, mut roll) = ([0.0; TWIST_NUMBERS], Roll::default());
    if law.has_torsion() {
        twist.copy_from_slice(&numbers[layout.twist..layout.roll]);
        torsion(law, relative_radius(radii)?, &twist)?;
    }
    if law.rolling().is_some() {
        let mut its = [0.0; GrainRoll::NUMBERS];
        its.copy_from_slice(&numbers[layout.roll..layout.friction]);
        roll = roll_of(&its)?;
    }
    relative_radius(radii)?;
    let friction = law.is_by_slip().then(|| numbers[layout.friction]);
    let contact = K::unpacked((law, radii), friction, &numbers[..layout.twist]);
    let contact = contact.map_err(Failure::in_state)?;
    // SAFETY: the caller's promise.
    unsafe {
        place.keep(contact);
        place.keep_roll(law, roll);
        if law.has_torsion() {
            *place.twist = twist;
        }
    }
    Ok(())
}

/// The number of numbers into which a touch of this law packs: 82 of a law of shifts, 314 of CAROM_LAW_RINGS; 83 more
/// with torsion, 9 with a resistance to rolling, 1 with friction by the slip speed. 0 for null.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_pack_size(law: *const CaromLaw) -> usize {
    let mut size = 0;
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let law = read(law, "law")?;
        size = match law.is_by_rings() {
            true => Layout::of::<RingTouch>(law).whole,
            false => Layout::of::<ShiftTouch>(law).whole,
        };
        Ok(())
    };
    // SAFETY: there is no place for an error.
    unsafe { border(std::ptr::null_mut(), call) };
    size
}

/// Writes a touch as `carom_touch_pack_size(law)` numbers. All are zero for separated bodies; otherwise the first is
/// positive.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have room for all of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_pack(
    law: *const CaromLaw,
    touch: *const CaromTouch,
    numbers: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let law = read(law, "law")?;
        read(touch, "touch")?;
        write(numbers, "numbers")?;
        match law.is_by_rings() {
            true => pack::<RingTouch>(law, touch, numbers),
            false => pack::<ShiftTouch>(law, touch, numbers),
        }
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Makes a touch from the numbers of `carom_touch_pack`. The options of the law and the radii must be the same as then;
/// the radius of a wall is infinite. The contact continues as the packed one, but for the
/// rounding of sums; contacts made from the same numbers continue with the same bits.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have `carom_touch_pack_size(law)` entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_unpack(
    law: *const CaromLaw,
    radius_1: f64,
    radius_2: f64,
    numbers: *const f64,
    touch: *mut CaromTouch,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (law, radii) = (read(law, "law")?, [radius_1, radius_2]);
        read(numbers, "numbers")?;
        write(touch, "touch")?;
        match law.is_by_rings() {
            true => unpack::<RingTouch>(law, radii, numbers, touch),
            false => unpack::<ShiftTouch>(law, radii, numbers, touch),
        }
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
