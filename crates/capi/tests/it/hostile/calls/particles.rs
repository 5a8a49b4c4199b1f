//! Calls of touches: grains with grains and walls, by laws of all kinds.

use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

use carom_capi::*;

use super::super::world::{LAWS, TOUCHES, World};
use super::answers::{parts, reported, told};

/// A wall of any shape below a grain, which is moved onto it.
fn wall_below(world: &mut World, grain: &mut CaromGrain) -> CaromSurface {
    grain.place[2] -= 1e-3;
    let axis = [[0.0; 3], [1.0, 0.0, 0.0], world.vector(1.0)][world.pick(20).min(2)];
    let normal = if world.chance(0.05) { world.vector(1.0) } else { [0.0, 0.0, 1.0] };
    let [velocity, spin] = [0.1, 10.0].map(|size| world.vector(size));
    CaromSurface { place: world.vector(1e-9), normal, velocity, spin, axis }
}

/// A law, now and then another one than that of the touch.
fn law_of(world: &mut World, at: usize) -> *mut CaromLaw {
    let law = world.laws[if world.chance(0.97) { at % LAWS } else { world.pick(LAWS) }];
    world.point(law)
}

pub(super) fn touch(world: &mut World, which: usize) -> CaromStatus {
    let (at, error) = (world.pick(TOUCHES), world.error());
    let law = law_of(world, at);
    let ([mut one, mut two], dt) = (world.meeting(), world.number(1e-9, 2e-8));
    let (mut no_grain, mut no_wall) = (null_mut(), null_mut());
    let mut wall = wall_below(world, &mut one.clone());
    let (two_at, wall_at) = (world.point(&raw mut two), world.point(&raw mut wall));
    match world.pick(20) {
        0 => (no_grain, no_wall) = (two_at, wall_at),
        1..=7 => {
            one.place[2] -= 1e-3;
            no_wall = wall_at;
        }
        _ => no_grain = two_at,
    }
    let (two, wall) = (no_grain, no_wall);
    let (mut load, mut heats, mut number) = (CaromGrainLoad::default(), CaromHeats::default(), 0.0);
    let mut report = MaybeUninit::<CaromReport>::uninit();
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let touch = (&raw mut world.touches[at]).cast::<CaromTouch>();
    let (touch, one) = (world.point(touch), world.point(&raw mut one));
    let heats_at = if world.chance(0.7) { null_mut() } else { &raw mut heats };
    let numbers = (&raw mut world.packed[at % LAWS]).cast::<f64>();
    let (load_at, numbers) = (world.point(&raw mut load), world.point(numbers));
    let number_at = world.point(&raw mut number);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            10 => carom_touch_step(law, touch, one, two, wall, dt, load_at, heats_at, error),
            11 => carom_touch_load(law, touch, one, two, wall, load_at, error),
            12 => carom_touch_energy(law, touch, radius_1, radius_2, number_at, error),
            13 => reported(&mut report, |report| carom_touch_report(law, touch, report, error)),
            14 => carom_touch_pack(law, touch, numbers, error),
            15 => carom_touch_unpack(law, radius_1, radius_2, numbers, touch, error),
            16 => many(world, dt, heats_at, error),
            _ => sizes(law),
        }
    };
    told(world, status, which, &[parts(&load, &heats).iter().sum(), number])
}

/// Sizes are those of a law, or zero.
fn sizes(law: *const CaromLaw) -> CaromStatus {
    // SAFETY: null, misaligned or a law.
    let sizes = unsafe { [carom_touch_size(law), carom_touch_pack_size(law)] };
    assert!(sizes == [0; 2] || (sizes[0] >= 1272 && sizes[1] >= 82));
    CaromStatus::Ok
}

/// # Safety
/// As `carom_touch_step_many`.
unsafe fn many(
    world: &mut World,
    dt: f64,
    heats: *mut CaromHeats,
    error: *mut CaromError,
) -> CaromStatus {
    // All of a law, as hosts have them, then some of others.
    let of = world.pick(LAWS);
    let mut all: [CaromEncounter; 6] = std::array::from_fn(|i| {
        let [one, two] = world.meeting();
        let at = if i < 4 { of + LAWS * i } else { (of + i) % LAWS };
        let touch = (&raw mut world.touches[at]).cast::<CaromTouch>();
        let (law, touch) = (law_of(world, at), world.point(touch));
        CaromEncounter { law, touch, wall: null(), one, two, load: CaromGrainLoad::default() }
    });
    let first = world.point(all.as_mut_ptr());
    // SAFETY: the caller's promise.
    let status = unsafe { carom_touch_step_many(first, all.len(), dt, heats, error) };
    let loads = all.each_ref().map(|at| parts(&at.load, &CaromHeats::default()).iter().sum());
    told(world, status, 16, &loads)
}
