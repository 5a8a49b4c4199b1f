//! Calls of touches with walls of any shape, and of rolling.

use std::mem::zeroed;
use std::ptr::null_mut;

use carom_capi::*;

use super::super::world::{GLASS, World};
use super::answers::{parts, told};

/// A wall of any shape below a grain, which is moved onto it.
pub(super) fn wall_below(world: &mut World, grain: &mut CaromGrain) -> CaromSurface {
    grain.place[2] -= 1e-3;
    let axis = [[0.0; 3], [1.0, 0.0, 0.0], world.vector(1.0)][world.pick(20).min(2)];
    let [velocity, spin] = [0.1, 10.0].map(|size| world.vector(size));
    CaromSurface { place: world.vector(1e-9), normal: [0.0, 0.0, 1.0], velocity, spin, axis }
}

pub(super) fn surface(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, error) = (world.pick(4), world.pick(3), world.error());
    let ([mut one, _], dt) = (world.meeting(), world.number(1e-9, 2e-8));
    let mut wall = wall_below(world, &mut one);
    let (mut load, mut heats) = (CaromGrainLoad::default(), CaromHeats::default());
    let grains = if which > 54 { &raw mut world.ring_grains } else { &raw mut world.grains[of] };
    let (touch, rings) = (&raw mut world.touches[at], world.point(world.rings));
    let (ring_touch, twist) = (&raw mut world.ring_touches[at], &raw mut world.twists[at]);
    let (grains, touch) = (world.point(grains), world.point(touch));
    let (ring_touch, twist) = (world.point(ring_touch), world.point(twist));
    let (one, wall) = (world.point(&raw mut one), world.point(&raw mut wall));
    let heats_at = if world.chance(0.7) { null_mut() } else { &raw mut heats };
    let load_at = world.point(&raw mut load);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            52 => carom_touch_surface(grains, touch, one, wall, dt, load_at, heats_at, error),
            53 => carom_touch_surface_load(grains, touch, one, wall, load_at, error),
            54 => carom_touch_twist_surface(grains, twist, one, wall, dt, load_at, heats_at, error),
            55 => carom_ring_touch_surface(
                grains, rings, ring_touch, one, wall, dt, load_at, heats_at, error,
            ),
            _ => {
                carom_ring_touch_surface_load(grains, rings, ring_touch, one, wall, load_at, error)
            }
        }
    };
    told(world, status, which, &[parts(&load, &heats).iter().sum()])
}

pub(super) fn roll(world: &mut World, which: usize) -> CaromStatus {
    let (of, error) = (world.pick(3), world.error());
    let ([mut one, mut two], dt) = (world.meeting(), world.number(1e-9, 2e-8));
    let mut wall = wall_below(world, &mut one.clone());
    let mut rolling = CaromRolling {
        stiffness: world.number(0.0, 1e4),
        damping: world.number(0.0, 1.0),
        friction: world.number(0.0, 0.1),
    };
    let normal = [[0.0; 3], [0.0, 0.0, 1.0], world.vector(1.0)][world.pick(20).min(2)];
    let mut roll = CaromRoll { shift: world.vector(1e-8), normal, force: world.vector(1.0) };
    let mut load = CaromGrainLoad { force: world.vector(1.0), ..CaromGrainLoad::default() };
    let (mut heat, mut energy) = (0.0, 0.0);
    let grains = &raw mut world.grains[of];
    let (grains, rolling) = (world.point(grains), world.point(&raw mut rolling));
    let (roll_at, load_at) = (world.point(&raw mut roll), world.point(&raw mut load));
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let (wall, heat_at) = (world.point(&raw mut wall), world.point(&raw mut heat));
    let given = load.force;
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            57 => carom_touch_roll_surface(
                grains, rolling, roll_at, one, wall, dt, load_at, heat_at, error,
            ),
            58 => carom_touch_roll_grains(
                grains, rolling, roll_at, one, two, dt, load_at, heat_at, error,
            ),
            _ => carom_touch_roll_energy(rolling, roll_at, &mut energy, error),
        }
    };
    // The force is the caller's.
    assert!(load.force.map(f64::to_bits) == given.map(f64::to_bits));
    let torques = load.torque_1.iter().chain(&load.torque_2);
    let state = roll.shift.iter().chain(&roll.force);
    let are_given =
        [roll.shift, roll.force, roll.normal].as_flattened().iter().all(|x| x.is_finite());
    match are_given {
        true => told(world, status, which, &[torques.chain(state).sum(), heat, energy]),
        false => status,
    }
}

pub(super) fn curved(world: &mut World) -> CaromStatus {
    let error = world.error();
    let (mut one, mut two) = (GLASS, GLASS);
    let [radius, x, y] = [(1e-3, 1.0), (-1.0, 1.0), (-1.0, 1.0)].map(|(a, b)| world.number(a, b));
    let (friction, law) = (world.number(0.0, 1.0), world.pick(4) as u32);
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    // SAFETY: all zero are constants that nothing accepts.
    let mut grains = unsafe { zeroed() };
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        carom_grains_on_curved_wall(
            one,
            two,
            radius,
            x,
            y,
            friction,
            law,
            0.0,
            1e-5,
            &mut grains,
            error,
        )
    }
}
