//! Calls that make constants, and ask how far they hold.

use std::ffi::CStr;
use std::mem::{MaybeUninit, zeroed};
use std::ptr::null_mut;

use carom_capi::*;

use super::super::world::{GLASS, World};

pub(super) fn validity(world: &mut World) -> CaromStatus {
    let (of, error) = (world.pick(5), world.error());
    let (zeta, radius) = (world.number(0.0, 1e-3), world.number(1e-3, 1.0));
    let mut validity = CaromValidity::default();
    let pair = &raw mut world.pairs[of];
    let (pair, to) = (world.point(pair), world.point(&raw mut validity));
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe { carom_pair_validity(pair, zeta, radius, to, error) }
}

pub(super) fn grains_validity(world: &mut World, which: usize) -> CaromStatus {
    let (of, error) = (world.pick(3), world.error());
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let [mass_1, mass_2] = [world.number(1e-6, 1e-3), world.number(1e-6, 1e-3)];
    let (zeta, velocity, step) =
        (world.number(0.0, 1e-3), world.number(0.0, 10.0), world.number(0.0, 1e-6));
    let mut validity = CaromValidity {
        semi_axis_over_radius: world.number(0.0, 1.0),
        wave_share: world.number(0.0, 1.0),
        step_over_duration: world.number(0.0, 1.0),
        ..CaromValidity::default()
    };
    let grains = &raw mut world.grains[of];
    let (grains, to) = (world.point(grains), world.point(&raw mut validity));
    // Of bytes, none is misaligned: there is room for a shift.
    let mut text = [0; 208];
    let (size, warning) = (world.pick(200), (world.bits() as u32) & (1 << world.pick(10)));
    let text = world.point(text.as_mut_ptr());
    let mut all: [CaromEncounter; 12] = std::array::from_fn(|_| {
        let [one, two] = world.meeting();
        let grains = world.point(grains);
        CaromEncounter { grains, touch: null_mut(), one, two, load: CaromGrainLoad::default() }
    });
    let first = world.point(all.as_mut_ptr());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        match which {
            48 => carom_grains_validity(grains, radius_1, radius_2, zeta, to, error),
            49 => carom_grains_impact_validity(
                grains, radius_1, radius_2, mass_1, mass_2, velocity, step, to, error,
            ),
            50 => carom_encounters_validity(first, all.len(), to, error),
            _ => carom_validity_text(to, warning, text, size, error),
        }
    }
}

pub(super) fn constants(world: &mut World, which: usize) -> CaromStatus {
    let mut one = CaromMaterial {
        young_modulus: world.number(1e5, 1e11),
        poisson: world.number(-0.9, 0.5),
        yield_stress: 0.0,
    };
    let mut two = if world.chance(0.5) { one } else { GLASS };
    if world.chance(0.1) {
        two.young_modulus = f64::INFINITY;
    }
    let [a, b, c] = std::array::from_fn(|_| world.number(1e-3, 1.0));
    let (friction, tolerance) = (world.number(0.0, 1.0), world.number(0.0, 0.1));
    let (law, error) = ([0, 1, 2, u32::MAX][world.pick(40).min(3)], world.error());
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    // SAFETY: all zero are constants that nothing accepts.
    let (mut pair, mut grains) = unsafe { (zeroed(), zeroed()) };
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        match which {
            32 => carom_pair_of_spheres(one, two, a, b, friction, law, tolerance, &mut pair, error),
            33 => {
                carom_pair_of_curvatures(one, two, a, b, friction, law, tolerance, &mut pair, error)
            }
            34 => carom_pair_of_stiffness(a, b, c, friction, law, tolerance, &mut pair, error),
            _ => carom_grains_of(one, two, friction, law, tolerance, 1e-3 * a, &mut grains, error),
        }
    }
}

pub(super) fn friction(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, error, kept) = (world.pick(12), world.pick(3), world.error(), world.pick(4));
    let [a, b, c] = [(0.0, 0.5), (-0.3, 0.5), (0.0, 4.0)].map(|(a, b)| world.number(a, b));
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let (pair, grains) = (&raw mut world.pairs[of], &raw mut world.grains[of]);
    let (pair, grains) = (world.point(pair), world.point(grains));
    let (touch, numbers) = (&raw mut world.touches[at], &raw mut world.packed[kept]);
    let (touch, numbers) = (world.point(touch), world.point(numbers).cast());
    let mut told = 0.0;
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        match which {
            63 => carom_pair_static_friction(pair, a, error),
            64 => carom_grains_static_friction(grains, a, error),
            65 => carom_grains_slip_friction(grains, a, b, c, error),
            66 => carom_touch_friction(touch, world.point(&raw mut told), error),
            _ => carom_touch_unpack_with_friction(
                grains, radius_1, radius_2, a, numbers, touch, error,
            ),
        }
    }
}

pub(super) fn creep(world: &mut World) -> CaromStatus {
    let (ratio, poisson) = (world.number(0.05, 20.0), world.number(0.0, 0.5));
    let (error, mut place) = (world.error(), MaybeUninit::<CaromCreep>::uninit());
    let to = world.point(place.as_mut_ptr());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe { carom_creep_coefficients(ratio, poisson, to, error) }
}

pub(super) fn words(world: &mut World, which: usize) -> CaromStatus {
    let text = match which {
        40 => carom_status_text(world.bits() as i32),
        41 => carom_version(),
        45 => carom_warning_text(world.bits() as u32),
        _ => carom_status_text((carom_abi_version() + carom_state_version()) as i32),
    };
    // SAFETY: ends with a zero.
    assert!(!unsafe { CStr::from_ptr(text) }.is_empty());
    CaromStatus::Ok
}
