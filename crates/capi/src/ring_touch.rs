//! The contact of two grains, or of a grain and a wall, with the law of rings.

use std::mem::MaybeUninit;

use carom_laws::grains::{
    Grain, GrainRings, Heats, RING_GRAIN_MARK, Surface, Wall, ring_grain_numbers,
};
use carom_laws::rings::Rings;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::grains::{Bodies, CaromGrainLoad, CaromGrains, relative_radius};
use crate::law::{CaromRegime, CaromReport};
use crate::pointers::{read, write};
use crate::rings::CaromRings;
use crate::stored::{present, present_mut, store};

/// Number of 8-byte words in a `carom_ring_touch`, without its mark.
pub const CAROM_RING_TOUCH_WORDS: usize = 425;
/// Number of numbers into which a `carom_ring_touch` packs.
pub const CAROM_RING_TOUCH_NUMBERS: usize = 314;

/// The first packed number of grains in contact; it names the format.
pub const CAROM_RING_TOUCH_MARK: f64 = 30002.0;

const _: () = assert!(CAROM_RING_TOUCH_MARK == RING_GRAIN_MARK);
const _: () = assert!(CAROM_RING_TOUCH_NUMBERS == ring_grain_numbers(6, 8));

/// The state of the contact of two grains with CAROM_LAW_RINGS, in memory of the caller: 3408 bytes, aligned
/// to 8, that may be copied as bytes. Zero bytes stand for two separated grains. Only the build that wrote it
/// can read it; `carom_ring_touch_pack` converts it to numbers that any build of this `carom_state_version()`
/// can read.
///
/// Shift, twist and the coupling of dissimilar materials act together, so that no `carom_twist` is needed.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromRingTouch {
    /// Identifies the build that wrote the contact. Written by this library only.
    pub mark: u64,
    /// The bytes of the contact.
    pub words: [MaybeUninit<u64>; CAROM_RING_TOUCH_WORDS],
}

impl CaromRingTouch {
    fn present(&self) -> Result<Option<&GrainRings>, Failure> {
        present(self.mark, &self.words)
    }

    fn keep(&mut self, contact: &GrainRings) {
        self.mark = store(contact, &mut self.words);
    }
}

/// The constants of the contact of two bodies.
fn constants<'a>(
    grains: &CaromGrains,
    rings: &'a CaromRings,
    radii: [f64; 2],
) -> Result<Rings<'a>, Failure> {
    let [one, two] = radii;
    grains.pair(relative_radius(one, two)?).rings(rings)
}

/// # Safety
/// As `carom_ring_touch_grains`.
unsafe fn advance(
    (grains, rings): (*const CaromGrains, *const CaromRings),
    touch: *mut CaromRingTouch,
    bodies: impl Bodies,
    dt: f64,
    load: *mut CaromGrainLoad,
    heats: *mut Heats,
) -> Result<(), Failure> {
    // SAFETY: the caller's promise.
    let (grains, rings) = unsafe { (read(grains, "grains")?, read(rings, "rings")?) };
    // SAFETY: the caller's promise.
    let (touch, load) = unsafe { (write(touch, "touch")?, write(load, "load")?) };
    // SAFETY: the caller's promise.
    let sums = if heats.is_null() { None } else { Some(unsafe { write(heats, "heats")? }) };
    let meeting = bodies.meeting(bodies.apart()?, grains);
    grains.check_masses(&meeting)?;
    let rings = constants(grains, rings, bodies.radii())?;
    let mut unasked = Heats::default();
    let heats = sums.unwrap_or(&mut unasked);
    if let Some(contact) = present_mut::<GrainRings, _>(touch.mark, &mut touch.words)? {
        *load = contact.advance_accounted(&rings, &meeting, dt, heats)?.into();
    } else {
        let mut contact = grains.ring_contact(&rings)?;
        *load = contact.advance_accounted(&rings, &meeting, dt, heats)?.into();
        if !contact.is_new() {
            touch.keep(&contact);
        }
    }
    Ok(())
}

/// # Safety
/// As `carom_ring_touch_grains_load`.
unsafe fn load_of(
    (grains, rings): (*const CaromGrains, *const CaromRings),
    touch: *const CaromRingTouch,
    bodies: impl Bodies,
    load: *mut CaromGrainLoad,
) -> Result<(), Failure> {
    // SAFETY: the caller's promise.
    let (grains, rings) = unsafe { (read(grains, "grains")?, read(rings, "rings")?) };
    // SAFETY: the caller's promise.
    let (touch, load) = unsafe { (read(touch, "touch")?, write(load, "load")?) };
    let meeting = bodies.meeting(bodies.apart()?, grains);
    grains.check_masses(&meeting)?;
    let rings = constants(grains, rings, bodies.radii())?;
    let told: CaromGrainLoad = match touch.present()? {
        Some(contact) => contact.load(&rings, &meeting),
        None => grains.ring_contact(&rings)?.load(&rings, &meeting),
    }
    .into();
    *load = told.checked()?;
    Ok(())
}

/// One step of the contact of two grains with CAROM_LAW_RINGS, as `carom_touch_grains`; the torques include
/// the torque about the normal. `rings` are those of `grains->unit`. The heat of the step is added to `heats`,
/// which may be null; here it costs nothing.
///
/// A step takes 2 to 5 microseconds.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_grains(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *mut CaromRingTouch,
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
        advance((grains, rings), touch, bodies, dt, load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the contact of a grain, body 1, and a wall, whose torque is zero, as
/// `carom_ring_touch_grains`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_wall(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *mut CaromRingTouch,
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
        advance((grains, rings), touch, bodies, dt, load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the contact of a grain, body 1, and a wall of any shape, as `carom_ring_touch_grains`. With a curved
/// wall `grains` are those of `carom_grains_on_curved_wall`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_surface(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *mut CaromRingTouch,
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
        advance((grains, rings), touch, bodies, dt, load, heats)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The load of two grains after the last step, without a new one, as `carom_touch_grains_load`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_grains_load(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *const CaromRingTouch,
    one: *const Grain,
    two: *const Grain,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call =
        || unsafe { load_of((grains, rings), touch, [read(one, "one")?, read(two, "two")?], load) };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The load of a grain, body 1, and a wall after the last step, as `carom_ring_touch_grains_load`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_wall_load(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *const CaromRingTouch,
    one: *const Grain,
    wall: *const Wall,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        load_of((grains, rings), touch, (read(one, "one")?, read(wall, "wall")?), load)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The load of a grain, body 1, and a wall of any shape after the last step, as `carom_ring_touch_grains_load`.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_surface_load(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *const CaromRingTouch,
    one: *const Grain,
    surface: *const Surface,
    load: *mut CaromGrainLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        load_of((grains, rings), touch, (read(one, "one")?, read(surface, "surface")?), load)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The elastic energy of a contact, compression and twist included, J. The radius of a wall is infinite.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_energy(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    touch: *const CaromRingTouch,
    radius_1: f64,
    radius_2: f64,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (grains, rings) = (read(grains, "grains")?, read(rings, "rings")?);
        let (touch, energy) = (read(touch, "touch")?, write(energy, "energy")?);
        let rings = constants(grains, rings, [radius_1, radius_2])?;
        let stored = |contact: &GrainRings| contact.stored_energy(&rings);
        *energy = RangeError::finite("energy", touch.present()?.map_or(0.0, stored))?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The share of the contact that sticks, and the regime of the last step: separated, adhesion, slip or
/// sliding.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_report(
    rings: *const CaromRings,
    touch: *const CaromRingTouch,
    report: *mut CaromReport,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (rings, touch) = (read(rings, "rings")?, read(touch, "touch")?);
        let place = write(report, "report")?;
        let memory = touch.present()?.map(GrainRings::memory);
        *place = match memory.filter(|memory| memory.shift().zeta > 0.0) {
            None => CaromReport::APART,
            Some(memory) => {
                let sticking = rings.sticking(memory);
                let regime = match sticking {
                    1.0.. => CaromRegime::Adhesion,
                    0.0 => CaromRegime::Sliding,
                    _ => CaromRegime::Slip,
                };
                CaromReport { sticking, regime }
            }
        };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Writes a contact as CAROM_RING_TOUCH_NUMBERS numbers, for a file or another process. All are zero for
/// separated grains; otherwise the first is positive.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have room for CAROM_RING_TOUCH_NUMBERS entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_pack(
    touch: *const CaromRingTouch,
    numbers: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let touch = read(touch, "touch")?;
        let numbers = write(numbers.cast::<[f64; CAROM_RING_TOUCH_NUMBERS]>(), "numbers")?;
        match touch.present()? {
            Some(contact) => contact.pack(numbers)?,
            None => numbers.fill(0.0),
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Makes a contact from the numbers of `carom_ring_touch_pack`. Constants and radii must be the same as then;
/// the radius of a wall is infinite. The contact continues with the same bits as the packed one.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have CAROM_RING_TOUCH_NUMBERS entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_ring_touch_unpack(
    grains: *const CaromGrains,
    rings: *const CaromRings,
    radius_1: f64,
    radius_2: f64,
    numbers: *const f64,
    touch: *mut CaromRingTouch,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (grains, rings) = (read(grains, "grains")?, read(rings, "rings")?);
        let numbers = read(numbers.cast::<[f64; CAROM_RING_TOUCH_NUMBERS]>(), "numbers")?;
        let touch = write(touch, "touch")?;
        if numbers[0] == 0.0 {
            touch.mark = 0;
            return Ok(());
        }
        let rings = constants(grains, rings, [radius_1, radius_2])?;
        let mut contact = grains.ring_contact(&rings)?;
        contact.unpack(&rings, numbers).map_err(|error| Failure::from(error).in_state())?;
        touch.keep(&contact);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
