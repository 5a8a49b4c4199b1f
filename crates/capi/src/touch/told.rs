//! What a touch tells without a step: load, energy, report.

use carom_laws::grains::{Grain, GrainLoad, Surface};
use carom_special::RangeError;

use super::bodies::{Bodies, Second};
use super::kind::{Kind, RingTouch, ShiftTouch};
use super::parts::Parts;
use super::report::CaromReport;
use super::step::{CaromGrainLoad, finite};
use super::{CaromTouch, Place};
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::pointers::{read, write};

/// # Safety
/// The touch has the size that the law tells, and nobody writes it.
unsafe fn load_of<K: Kind>(
    law: &CaromLaw,
    touch: *const CaromTouch,
    bodies: impl Bodies,
) -> Result<GrainLoad, Failure> {
    let meeting = bodies.meeting(bodies.apart()?, law);
    law.check_masses(&meeting)?;
    let of = (law, bodies.radii());
    // SAFETY: the caller's promise.
    let mut parts = match unsafe { Place::<K>::of(touch, law).copied()? } {
        Some(parts) => parts,
        None => Parts::met(of, &meeting)?,
    };
    parts.held().change(of, |whole| Ok(whole.load(&meeting)))
}

/// The load of two bodies after the last step, without a new one: the same bits if the positions are the same. A touch
/// that is zero carries only the force of Hertz. Body 2 is `two` or `wall`, as in `carom_touch_step`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_load(
    law: *const CaromLaw,
    touch: *const CaromTouch,
    one: *const Grain,
    two: *const Grain,
    wall: *const Surface,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (law, one) = (read(law, "law")?, read(one, "one")?);
        let second = Second::of(two, wall)?;
        read(touch, "touch")?;
        let place = write(load, "load")?;
        let told = match (law.is_by_rings(), second) {
            (false, Second::Grain(two)) => load_of::<ShiftTouch>(law, touch, [one, two]),
            (false, Second::Wall(wall)) => load_of::<ShiftTouch>(law, touch, (one, wall)),
            (true, Second::Grain(two)) => load_of::<RingTouch>(law, touch, [one, two]),
            (true, Second::Wall(wall)) => load_of::<RingTouch>(law, touch, (one, wall)),
        };
        *place = finite(told?)?.into();
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// # Safety
/// As [`load_of`].
unsafe fn energy_of<K: Kind>(
    law: &CaromLaw,
    touch: *const CaromTouch,
    radii: [f64; 2],
) -> Result<f64, Failure> {
    // SAFETY: the caller's promise.
    let Some(mut parts) = (unsafe { Place::<K>::of(touch, law).copied()? }) else { return Ok(0.0) };
    let energy = parts.held().change((law, radii), |whole| Ok(whole.stored_energy()))?;
    Ok(RangeError::finite("energy", energy)?)
}

/// The elastic energy of a contact, J: of compression, of the tangential load, of twist and of rolling. The radius of a
/// wall is infinite.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_energy(
    law: *const CaromLaw,
    touch: *const CaromTouch,
    radius_1: f64,
    radius_2: f64,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (law, radii) = (read(law, "law")?, [radius_1, radius_2]);
        read(touch, "touch")?;
        let place = write(energy, "energy")?;
        *place = match law.is_by_rings() {
            true => energy_of::<RingTouch>(law, touch, radii)?,
            false => energy_of::<ShiftTouch>(law, touch, radii)?,
        };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// # Safety
/// As [`load_of`].
unsafe fn report_of<K: Kind>(
    law: &CaromLaw,
    touch: *const CaromTouch,
) -> Result<CaromReport, Failure> {
    // SAFETY: the caller's promise.
    match unsafe { Place::<K>::of(touch, law).seen()? } {
        Some(contact) => contact.report(law),
        None => Ok(CaromReport::APART),
    }
}

/// The share of the contact that sticks, and the regime of the last step; with CAROM_LAW_RINGS separated, adhesion, slip
/// or sliding.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_report(
    law: *const CaromLaw,
    touch: *const CaromTouch,
    report: *mut CaromReport,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let law = read(law, "law")?;
        read(touch, "touch")?;
        let place = write(report, "report")?;
        *place = match law.is_by_rings() {
            true => report_of::<RingTouch>(law, touch)?,
            false => report_of::<ShiftTouch>(law, touch)?,
        };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
