//! Calls of touches by the law of rings.

use std::mem::MaybeUninit;
use std::ptr::null_mut;

use carom_capi::*;

use super::super::world::World;
use super::answers::{parts, reported, told};

pub(super) fn ring_touch(world: &mut World, which: usize) -> CaromStatus {
    let (at, error, kept) = (world.pick(6), world.error(), world.pick(3));
    let ([mut one, mut two], dt) = (world.meeting(), world.number(1e-9, 2e-8));
    let (place, velocity) = (world.vector(1e-9), world.vector(0.1));
    let mut wall = CaromWall { place, normal: [0.0, 0.0, 1.0], velocity };
    if which == 10 || which == 12 {
        one.place[2] -= 1e-3;
    }
    let (mut load, mut heats, mut number) = (CaromGrainLoad::default(), CaromHeats::default(), 0.0);
    let mut report = MaybeUninit::<CaromReport>::uninit();
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let (grains, touch) = (&raw mut world.ring_grains, &raw mut world.ring_touches[at]);
    let (grains, touch, rings) =
        (world.point(grains), world.point(touch), world.point(world.rings));
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let wall = world.point(&raw mut wall);
    let heats_at = if world.chance(0.7) { null_mut() } else { &raw mut heats };
    let numbers = &raw mut world.ring_packed[kept];
    let (load_at, numbers) = (world.point(&raw mut load), world.point(numbers).cast());
    let number_at = world.point(&raw mut number);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            9 => carom_ring_touch_grains(
                grains, rings, touch, one, two, dt, load_at, heats_at, error,
            ),
            10 => {
                carom_ring_touch_wall(grains, rings, touch, one, wall, dt, load_at, heats_at, error)
            }
            11 => carom_ring_touch_grains_load(grains, rings, touch, one, two, load_at, error),
            12 => carom_ring_touch_wall_load(grains, rings, touch, one, wall, load_at, error),
            13 => {
                carom_ring_touch_energy(grains, rings, touch, radius_1, radius_2, number_at, error)
            }
            14 => reported(&mut report, |to| carom_ring_touch_report(rings, touch, to, error)),
            15 => carom_ring_touch_pack(touch, numbers, error),
            _ => carom_ring_touch_unpack(grains, rings, radius_1, radius_2, numbers, touch, error),
        }
    };
    told(world, status, which, &[parts(&load, &heats).iter().sum(), number])
}

pub(super) fn rings(world: &mut World) -> CaromStatus {
    let (error, mut made) = (world.error(), null_mut());
    let pair = match world.chance(0.5) {
        true => &raw mut world.ring_grains.unit,
        false => &raw mut world.pairs[0],
    };
    let (pair, to) = (world.point(pair), world.point(&raw mut made));
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        let status = carom_rings_of(pair, to, error);
        carom_rings_free(made);
        status
    }
}
