//! Calls that make constants, and ask how far they hold.

use std::ffi::CStr;
use std::mem::{MaybeUninit, size_of, zeroed};
use std::ptr::null_mut;

use carom_capi::*;

use super::super::world::{GLASS, LAWS, World};
use super::answers::told;

pub(super) fn limits(world: &mut World, which: usize) -> CaromStatus {
    let (of, error) = (world.pick(LAWS), world.error());
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
    let (law, mut time) = (world.laws[of], 0.0);
    let (law, to) = (world.point(law), world.point(&raw mut validity));
    // Of bytes, none is misaligned: there is room for a shift.
    let mut text = [0; 208];
    let (size, warning) = (world.pick(200), (world.bits() as u32) & (1 << world.pick(10)));
    let text = world.point(text.as_mut_ptr());
    let mut all: [CaromEncounter; 12] = std::array::from_fn(|_| {
        let [one, two] = world.meeting();
        let (law, wall) = (world.point(law), std::ptr::null());
        let load = CaromGrainLoad::default();
        CaromEncounter { law, touch: null_mut(), wall, one, two, load }
    });
    let (first, time_at) = (world.point(all.as_mut_ptr()), world.point(&raw mut time));
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            22 => carom_law_validity(law, radius_1, radius_2, zeta, to, error),
            23 => carom_law_impact_validity(
                law, radius_1, radius_2, mass_1, mass_2, velocity, step, to, error,
            ),
            24 => carom_encounters_validity(first, all.len(), to, error),
            25 => carom_law_impact_time(
                law, radius_1, radius_2, mass_1, mass_2, velocity, time_at, error,
            ),
            _ => carom_validity_text(to, warning, text, size, error),
        }
    };
    told(world, status, which, &[time])
}

/// Two materials, one of which may be rigid.
fn materials(world: &mut World) -> [CaromMaterial; 2] {
    let one = CaromMaterial {
        young_modulus: world.number(1e5, 1e11),
        poisson: world.number(-0.9, 0.5),
        yield_stress: 0.0,
    };
    let mut two = if world.chance(0.5) { one } else { GLASS };
    if world.chance(0.1) {
        two.young_modulus = f64::INFINITY;
    }
    [one, two]
}

pub(super) fn pairs(world: &mut World, which: usize) -> CaromStatus {
    let [mut one, mut two] = materials(world);
    let [a, b] = std::array::from_fn(|_| world.number(1e-3, 1.0));
    let (friction, tolerance) = (world.number(0.0, 1.0), world.number(0.0, 0.1));
    let (law, error) = ([0, 1, 2, u32::MAX][world.pick(40).min(3)], world.error());
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    // SAFETY: all zero are constants that nothing accepts.
    let mut pair = unsafe { zeroed() };
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        match which {
            18 => carom_pair_of_spheres(one, two, a, b, friction, law, tolerance, &mut pair, error),
            _ => {
                carom_pair_of_curvatures(one, two, a, b, friction, law, tolerance, &mut pair, error)
            }
        }
    }
}

pub(super) fn laws(world: &mut World, which: usize) -> CaromStatus {
    let ([mut one, mut two], error) = (materials(world), world.error());
    let mut options = CaromLawOptions {
        size: size_of::<CaromLawOptions>(),
        law: [0, 1, u32::MAX, 2][world.pick(60).min(3)] % 3,
        torsion: world.pick(20) as u32 / 9,
        tolerance: world.number(0.0, 0.1),
        ..Default::default()
    };
    match world.pick(6) {
        0 => options.static_friction = world.number(0.0, 1.0),
        1 => {
            (options.slip_friction_b, options.slip_friction_c) =
                (world.number(-0.3, 0.5), world.number(0.0, 4.0))
        }
        2 => options.relaxation = world.number(0.0, 1e-3),
        3 => options.restitution = world.number(0.01, 1.0),
        4 => {
            let [stiffness, damping, friction] =
                [1e4, 1.0, 0.1].map(|most| world.number(0.0, most));
            options.rolling = CaromRolling { stiffness, damping, friction };
        }
        _ => options.size = [0, 8, 40, 1000][world.pick(4)],
    }
    let friction = world.number(0.0, 1.0);
    let [radius, x, y] = [(1e-3, 1.0), (-1.0, 1.0), (-1.0, 1.0)].map(|(a, b)| world.number(a, b));
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let (flat, mut made) = (world.laws[world.pick(LAWS)], null_mut());
    let (flat, to) = (world.point(flat), world.point(&raw mut made));
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        let status = match which {
            20 => carom_law_make(one, two, friction, &options, to, error),
            _ => carom_law_on_curved_wall(flat, radius, x, y, to, error),
        };
        assert!(made.is_null() || status == CaromStatus::Ok);
        carom_law_free(made);
        status
    }
}

pub(super) fn creep(world: &mut World) -> CaromStatus {
    let (ratio, poisson) = (world.number(0.05, 20.0), world.number(0.0, 0.5));
    let (error, mut place) = (world.error(), MaybeUninit::<CaromCreep>::uninit());
    let to = world.point(place.as_mut_ptr());
    if world.chance(0.5) {
        // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
        return unsafe { carom_creep_coefficients(ratio, poisson, to, error) };
    }
    let axes = [ratio, world.number(0.5, 2.0)];
    let creepages = [(); 3].map(|()| world.number(-1e-3, 1e-3));
    let [modulus, friction, force] =
        [world.number(1e9, 1e11), world.number(0.1, 0.5), world.number(1.0, 1e5)];
    let mut place = MaybeUninit::<CaromCreepForce>::uninit();
    let to = world.point(place.as_mut_ptr());
    let axes = world.point(axes.as_ptr().cast_mut());
    let creepages = world.point(creepages.as_ptr().cast_mut());
    // SAFETY: each pointer is null, misaligned or that of something that may be read or written, and none twice.
    unsafe { carom_creep_force(axes, modulus, poisson, friction, force, creepages, to, error) }
}

pub(super) fn words(world: &mut World, which: usize) -> CaromStatus {
    let (mut law, error) = (0, world.error());
    if which == 33 {
        let name = [c"coulomb".as_ptr(), c"ring".as_ptr(), std::ptr::null()][world.pick(3)];
        let to = world.point(&raw mut law);
        // SAFETY: null or a text, and a place for a number, null or misaligned.
        return unsafe { carom_law_of_name(name, to, error) };
    }
    let text = match which {
        28 => carom_status_text(world.bits() as i32),
        29 => carom_version(),
        30 => carom_warning_text(world.bits() as u32),
        31 => carom_law_name(world.pick(5) as u32),
        _ => carom_status_text(carom_abi_version() as i32),
    };
    // SAFETY: ends with a zero.
    assert!(which == 31 || !unsafe { CStr::from_ptr(text) }.is_empty());
    CaromStatus::Ok
}
