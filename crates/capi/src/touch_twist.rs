//! The twist of two grains, or of a grain and a wall, about their common normal.

use carom_laws::grains::{Grain, GrainTwist, Heats, Surface, Wall};
use carom_laws::law::ContactLaw as _;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::grains::{Bodies, CaromGrainLoad, CaromGrains, relative_radius};
use crate::pointers::{read, write};
use crate::twist::CaromTwist;

/// One step of the twist of two grains about their normal, for use after `carom_touch_grains` in the same
/// step. It neglects the shift of the contact. Its torque is added to those of `load`, its heat to `heats`,
/// which may be null.
///
/// The twist is zero for separated grains. A step of duration zero returns the torque after the last step,
/// except for a new contact. Where the grains separate, the history is lost. It costs about ten times as much
/// as a touch.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_twist_grains(
    grains: *const CaromGrains,
    twist: *mut CaromTwist,
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
        let torque = turn(grains, twist, bodies, dt, load, heats)?;
        let load = write(load, "load")?;
        add(&mut load.torque_1, torque, 1.0);
        add(&mut load.torque_2, torque, -1.0);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the twist of a grain, body 1, and a wall, whose torque is zero, as `carom_touch_twist_grains`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_twist_wall(
    grains: *const CaromGrains,
    twist: *mut CaromTwist,
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
        let torque = turn(grains, twist, bodies, dt, load, heats)?;
        add(&mut write(load, "load")?.torque_1, torque, 1.0);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the twist of a grain, body 1, and a wall of any shape, as `carom_touch_twist_wall`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_twist_surface(
    grains: *const CaromGrains,
    twist: *mut CaromTwist,
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
        let torque = turn(grains, twist, bodies, dt, load, heats)?;
        add(&mut write(load, "load")?.torque_1, torque, 1.0);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The elastic energy of the twist of two grains, J. The radius of a wall is infinite.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_twist_energy(
    grains: *const CaromGrains,
    twist: *const CaromTwist,
    radius_1: f64,
    radius_2: f64,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (grains, twist) = (read(grains, "grains")?, read(twist, "twist")?);
        grains.check_constant_friction()?;
        let pair = grains.pair(relative_radius(radius_1, radius_2)?);
        let stored = twist.law(&pair)?.twist_energy();
        *write(energy, "energy")? = RangeError::finite("energy", stored)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// # Safety
/// As `carom_touch_twist_grains`.
unsafe fn turn(
    grains: *const CaromGrains,
    twist: *mut CaromTwist,
    bodies: impl Bodies,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
) -> Result<[f64; 3], Failure> {
    // SAFETY: the caller's promise. All are checked before anything moves.
    let (grains, twist, _) =
        unsafe { (read(grains, "grains")?, write(twist, "twist")?, write(load, "load")?) };
    grains.check_constant_friction()?;
    let meeting = bodies.meeting(bodies.apart()?, grains);
    let [one, two] = bodies.radii();
    let pair = grains.pair(relative_radius(one, two)?);
    let mut turned = GrainTwist::new(twist.law(&pair)?);
    let is_new = turned.law().shift().zeta <= 0.0;
    if dt == 0.0 && !is_new && !meeting.is_apart() {
        return Ok(turned.torque(&meeting));
    }
    let torque = if heats.is_null() {
        turned.advance(&meeting, dt)?
    } else {
        // SAFETY: the caller's promise.
        turned.advance_accounted(&meeting, dt, unsafe { write(heats, "heats")? })?
    };
    match meeting.zeta > 0.0 {
        true => turned.law().pack(&mut twist.numbers).map(|_| ())?,
        false => twist.numbers.fill(0.0),
    }
    Ok(torque)
}

pub(crate) fn add(to: &mut [f64; 3], torque: [f64; 3], sign: f64) {
    for (to, torque) in to.iter_mut().zip(torque) {
        *to += sign * torque;
    }
}
