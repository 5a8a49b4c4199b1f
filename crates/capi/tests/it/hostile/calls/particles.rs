//! Calls of touches of particles.

use std::mem::MaybeUninit;
use std::ptr::null_mut;

use carom_capi::*;

use super::super::world::World;
use super::answers::{parts, reported, told};

pub(super) fn touch(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, error, kept) = (world.pick(12), world.pick(3), world.error(), world.pick(4));
    let ([mut one, mut two], dt) = (world.meeting(), world.number(1e-9, 2e-8));
    let mut wall = CaromWall {
        place: world.vector(1e-9),
        normal: [0.0, 0.0, 1.0],
        velocity: world.vector(0.1),
    };
    if which == 21 || which == 23 {
        one.place[2] -= 1e-3;
    }
    if world.chance(0.05) {
        wall.normal = world.vector(1.0);
    }
    let (mut load, mut heats, mut number) = (CaromGrainLoad::default(), CaromHeats::default(), 0.0);
    let mut report = MaybeUninit::<CaromReport>::uninit();
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let (grains, touch) = (&raw mut world.grains[of], &raw mut world.touches[at]);
    let (grains, touch) = (world.point(grains), world.point(touch));
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let wall = world.point(&raw mut wall);
    let heats_at = if world.chance(0.7) { null_mut() } else { &raw mut heats };
    let numbers = &raw mut world.packed[kept];
    let (load_at, numbers) = (world.point(&raw mut load), world.point(numbers).cast());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            20 => carom_touch_grains(grains, touch, one, two, dt, load_at, heats_at, error),
            21 => carom_touch_wall(grains, touch, one, wall, dt, load_at, heats_at, error),
            22 => carom_touch_grains_load(grains, touch, one, two, load_at, error),
            23 => carom_touch_wall_load(grains, touch, one, wall, load_at, error),
            24 => carom_touch_energy(touch, world.point(&raw mut number), error),
            25 => reported(&mut report, |report| carom_touch_report(touch, report, error)),
            26 => carom_touch_pack(touch, numbers, error),
            27 => carom_touch_unpack(grains, radius_1, radius_2, numbers, touch, error),
            _ => many(world, grains, dt, heats_at, error),
        }
    };
    told(world, status, which, &[parts(&load, &heats).iter().sum(), number])
}

/// # Safety
/// As `carom_touch_many`.
pub(super) unsafe fn many(
    world: &mut World,
    grains: *mut CaromGrains,
    dt: f64,
    heats: *mut CaromHeats,
    error: *mut CaromError,
) -> CaromStatus {
    let touches: [*mut CaromTouch; 12] = world.touches.each_mut().map(|touch| &raw mut *touch);
    let mut all = touches.map(|touch| {
        let [one, two] = world.meeting();
        let (grains, touch) = (world.point(grains), world.point(touch));
        CaromEncounter { grains, touch, one, two, load: CaromGrainLoad::default() }
    });
    let first = world.point(all.as_mut_ptr());
    // SAFETY: the caller's promise.
    let status = unsafe { carom_touch_many(first, all.len(), dt, heats, error) };
    let loads = all.each_ref().map(|at| parts(&at.load, &CaromHeats::default()).iter().sum());
    told(world, status, 28, &loads)
}

pub(super) fn touch_twist(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, error) = (world.pick(4), world.pick(3), world.error());
    let ([mut one, mut two], dt) = (world.meeting(), world.number(1e-9, 2e-8));
    let mut wall =
        CaromWall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: world.vector(0.1) };
    if which == 30 {
        one.place[2] -= 1e-3;
    }
    let (mut load, mut heats, mut number) = (CaromGrainLoad::default(), CaromHeats::default(), 0.0);
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let (grains, twist) = (&raw mut world.grains[of], &raw mut world.twists[at]);
    let (grains, twist) = (world.point(grains), world.point(twist));
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let heats_at = if world.chance(0.7) { null_mut() } else { &raw mut heats };
    let load_at = world.point(&raw mut load);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            29 => carom_touch_twist_grains(grains, twist, one, two, dt, load_at, heats_at, error),
            30 => carom_touch_twist_wall(
                grains,
                twist,
                one,
                world.point(&raw mut wall),
                dt,
                load_at,
                heats_at,
                error,
            ),
            _ => carom_touch_twist_energy(grains, twist, radius_1, radius_2, &mut number, error),
        }
    };
    told(world, status, which, &[parts(&load, &heats).iter().sum(), number])
}
