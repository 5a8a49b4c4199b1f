//! A touch as plain numbers, for a file or another process.

use carom_laws::friction::Friction;
use carom_laws::grains::GrainRoll;
use carom_laws::static_friction::StaticFriction;
use carom_laws::torsion::law::StoredTwist;
use carom_special::RangeError;

use super::kind::{Kind, RingTouch, ShiftTouch};
use super::parts::Parts;
use super::{CaromTouch, Place};
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::law::unit::relative_radius;
use crate::pointers::{read, write};

/// The number of numbers of a touch, the last of which is its coefficient of friction if that goes by the slip speed.
fn count<K: Kind>(law: &CaromLaw) -> usize {
    let twist = if law.has_torsion() { StoredTwist::NUMBERS } else { 0 };
    let roll = if law.rolling().is_some() { GrainRoll::NUMBERS } else { 0 };
    K::NUMBERS + twist + roll + usize::from(law.is_by_slip())
}

/// # Safety
/// The touch has the size that the law tells, and nobody writes it; there is room for all numbers.
unsafe fn pack<K: Kind>(
    law: &CaromLaw,
    touch: *const CaromTouch,
    numbers: *mut f64,
) -> Result<(), Failure> {
    // SAFETY: the caller's promise.
    let parts = unsafe { Place::<K>::of(touch, law).copied()? };
    // SAFETY: the caller's promise.
    let numbers = unsafe { std::slice::from_raw_parts_mut(numbers, count::<K>(law)) };
    let Some(mut parts) = parts else {
        numbers.fill(0.0);
        return Ok(());
    };
    let (numbers, last) = numbers.split_at_mut(numbers.len() - usize::from(law.is_by_slip()));
    last.fill(parts.contact.friction());
    // No number depends on the radii.
    parts.held().change((law, [1.0; 2]), |whole| Ok(whole.pack(numbers)?))
}

/// # Safety
/// As [`pack`].
unsafe fn unpack<K: Kind>(
    law: &CaromLaw,
    radii: [f64; 2],
    numbers: *const f64,
    touch: *mut CaromTouch,
) -> Result<(), Failure> {
    let place = Place::<K>::of(touch, law);
    // SAFETY: the caller's promise.
    let numbers = unsafe { std::slice::from_raw_parts(numbers, count::<K>(law)) };
    if numbers[0] == 0.0 {
        // SAFETY: the caller's promise.
        unsafe { place.clear() };
        return Ok(());
    }
    let parts = unpacked(law, radii, numbers)?;
    // SAFETY: the caller's promise.
    unsafe { place.keep(parts) };
    Ok(())
}

fn unpacked<K: Kind>(
    law: &CaromLaw,
    radii: [f64; 2],
    numbers: &[f64],
) -> Result<Parts<K>, Failure> {
    relative_radius(radii)?;
    let (numbers, friction) = match numbers {
        [numbers @ .., friction] if law.is_by_slip() => (numbers, kept(*friction)),
        _ => (numbers, law.friction_at(0.0)),
    };
    let parts = friction.and_then(|friction| {
        let mut parts = Parts::<K>::fresh((law, radii), friction)?;
        parts.held().change((law, radii), |whole| Ok(whole.unpack(numbers)?))?;
        Ok(parts)
    });
    parts.map_err(Failure::in_state)
}

/// A coefficient of friction that was stored.
fn kept(friction: f64) -> Result<StaticFriction, Failure> {
    RangeError::check("friction", friction, friction.is_finite(), "finite")?;
    let friction = Friction::new(friction)?;
    Ok(StaticFriction::new(friction, friction)?)
}

/// The number of numbers into which a touch of this law packs: 82 of a law of shifts, 319 of CAROM_LAW_RINGS; 83 more
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
            true => count::<RingTouch>(law),
            false => count::<ShiftTouch>(law),
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
