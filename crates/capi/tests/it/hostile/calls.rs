//! One random call of the C interface.

use std::ffi::CStr;
use std::mem::{MaybeUninit, size_of, zeroed};
use std::ptr::{null, null_mut};

use carom_capi::*;

use super::world::{GLASS, World};

/// All functions of the border.
pub(crate) const NAMES: [&str; 68] = [
    "carom_contact_advance",
    "carom_contact_load",
    "carom_contact_energy",
    "carom_contact_heat",
    "carom_contact_report",
    "carom_contact_turn_frame",
    "carom_contact_pack",
    "carom_contact_unpack",
    "carom_contact_advance_many",
    "carom_ring_touch_grains",
    "carom_ring_touch_wall",
    "carom_ring_touch_grains_load",
    "carom_ring_touch_wall_load",
    "carom_ring_touch_energy",
    "carom_ring_touch_report",
    "carom_ring_touch_pack",
    "carom_twist_advance",
    "carom_twist_torque",
    "carom_twist_energy",
    "carom_twist_heat",
    "carom_touch_grains",
    "carom_touch_wall",
    "carom_touch_grains_load",
    "carom_touch_wall_load",
    "carom_touch_energy",
    "carom_touch_report",
    "carom_touch_pack",
    "carom_touch_unpack",
    "carom_touch_many",
    "carom_touch_twist_grains",
    "carom_touch_twist_wall",
    "carom_touch_twist_energy",
    "carom_pair_of_spheres",
    "carom_pair_of_curvatures",
    "carom_pair_of_stiffness",
    "carom_grains_of",
    "carom_restitution",
    "carom_restitution_many",
    "carom_collide",
    "carom_ring_touch_unpack",
    "carom_status_text",
    "carom_version",
    "carom_abi_version",
    "carom_rings_of",
    "carom_restitution_dissimilar",
    "carom_warning_text",
    "carom_pair_validity",
    "carom_grains_impact_time",
    "carom_grains_validity",
    "carom_grains_impact_validity",
    "carom_encounters_validity",
    "carom_validity_text",
    "carom_touch_surface",
    "carom_touch_surface_load",
    "carom_touch_twist_surface",
    "carom_ring_touch_surface",
    "carom_ring_touch_surface_load",
    "carom_touch_roll_surface",
    "carom_touch_roll_grains",
    "carom_touch_roll_energy",
    "carom_grains_on_curved_wall",
    "carom_creep_coefficients",
    "carom_grains_restitution",
    "carom_pair_static_friction",
    "carom_grains_static_friction",
    "carom_grains_slip_friction",
    "carom_touch_friction",
    "carom_touch_unpack_with_friction",
];

/// Makes one call, now and then after bytes were garbled, and returns its name.
pub(crate) fn one(world: &mut World) -> &'static str {
    if world.chance(0.1) {
        world.garble();
    }
    // Those of microseconds and more are rarer.
    let which = match world.pick(400) {
        0 => 38 + world.pick(2),
        1 => 36 + world.pick(2),
        2..=4 => 40 + world.pick(12),
        5..=12 => 32 + world.pick(4),
        13..=40 => 16 + world.pick(4),
        41..=60 => 29 + world.pick(3),
        61..=90 => 52 + world.pick(16),
        k if k % 2 == 0 => world.pick(16),
        _ => 20 + world.pick(9),
    };
    let status = match which {
        0..=8 => contact(world, which),
        9..=15 | 39 => ring_touch(world, which),
        16..=19 => twist(world, which),
        20..=28 => touch(world, which),
        29..=31 => touch_twist(world, which),
        52..=56 => surface(world, which),
        57..=59 => roll(world, which),
        60 => curved(world),
        32..=35 => constants(world, which),
        36..=37 => restitution(world, which),
        44 => dissimilar(world),
        38 => collide(world),
        43 => rings(world),
        46 => validity(world),
        47 => impact_time(world),
        48..=51 => grains_validity(world, which),
        61 => creep(world),
        62 => rebound(world),
        63..=67 => friction(world, which),
        _ => words(world, which),
    };
    world.told[status as usize] += 1;
    world.called.insert(NAMES[which]);
    NAMES[which]
}

/// Makes calls until the bytes of the world are used up. No call may panic inside.
pub(crate) fn all_of_bytes(world: &mut World) {
    while !world.random.has_ended() {
        let name = one(world);
        assert_eq!(world.told[CaromStatus::Internal as usize], 0, "{name}");
    }
}

/// What a call has told with success are numbers, unless the bytes of a memory were changed.
fn told(world: &World, status: CaromStatus, which: usize, numbers: &[f64]) -> CaromStatus {
    let are_numbers = numbers.iter().all(|number| number.is_finite());
    let holds = status != CaromStatus::Ok || are_numbers || world.are_damaged;
    assert!(holds, "{}: {numbers:?}", NAMES[which]);
    status
}

/// The numbers of a load, and of what became heat.
fn parts(load: &CaromGrainLoad, heats: &CaromHeats) -> [f64; 11] {
    let CaromGrainLoad { force: [a, b, c], torque_1: [d, e, f], torque_2: [g, h, i] } = *load;
    [a, b, c, d, e, f, g, h, i, heats.friction, heats.damping]
}

fn contact(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, shift, error) = (world.pick(6), world.pick(5), world.shift(), world.error());
    let state = world.pick(6);
    let (mut load, mut number) = (CaromLoad::default(), 0.0);
    let mut report = MaybeUninit::<CaromReport>::uninit();
    let (pair, contact) = (&raw mut world.pairs[of], &raw mut world.contacts[at]);
    let (pair, contact) = (world.point(pair), world.point(contact));
    let (load_at, number_at) = (world.point(&raw mut load), world.point(&raw mut number));
    let mut all = [CaromLoad::default(); 6];
    let state = &raw mut world.states[state];
    let (state, size) = (world.point(state), size_of::<CaromContact>());
    let angle = world.number(-4.0, 4.0);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            0 => carom_contact_advance(pair, contact, shift, load_at, error),
            1 => carom_contact_load(pair, contact, load_at, error),
            2 => carom_contact_energy(pair, contact, number_at, error),
            3 => carom_contact_heat(pair, contact, shift, number_at, error),
            4 => reported(&mut report, |report| carom_contact_report(pair, contact, report, error)),
            5 => carom_contact_turn_frame(pair, contact, angle, error),
            6 => carom_contact_pack(pair, contact, state, error),
            7 => carom_contact_unpack(pair, state, contact, error),
            _ => {
                let shifts = [shift; 6];
                let first = world.contacts.as_mut_ptr();
                carom_contact_advance_many(
                    pair,
                    6,
                    first,
                    size,
                    shifts.as_ptr(),
                    24,
                    all.as_mut_ptr(),
                    24,
                    error,
                )
            }
        }
    };
    let [x, y, z] = all
        .iter()
        .chain([&load])
        .fold([0.0; 3], |[x, y, z], load| [x + load.f_x, y + load.f_y, z + load.f_z]);
    told(world, status, which, &[number, x, y, z])
}

/// A report that was told has a regime that is one.
fn reported(
    report: &mut MaybeUninit<CaromReport>,
    ask: impl FnOnce(*mut CaromReport) -> CaromStatus,
) -> CaromStatus {
    let status = ask(report.as_mut_ptr());
    if status == CaromStatus::Ok {
        // SAFETY: written, in the layout of C: a double and the number of the regime.
        let regime = unsafe { report.as_ptr().cast::<u32>().add(2).read() };
        assert!(regime <= 6, "{regime}");
    }
    status
}

fn ring_touch(world: &mut World, which: usize) -> CaromStatus {
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

fn validity(world: &mut World) -> CaromStatus {
    let (of, error) = (world.pick(5), world.error());
    let (zeta, radius) = (world.number(0.0, 1e-3), world.number(1e-3, 1.0));
    let mut validity = CaromValidity::default();
    let pair = &raw mut world.pairs[of];
    let (pair, to) = (world.point(pair), world.point(&raw mut validity));
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe { carom_pair_validity(pair, zeta, radius, to, error) }
}

fn grains_validity(world: &mut World, which: usize) -> CaromStatus {
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

fn impact_time(world: &mut World) -> CaromStatus {
    let (of, error) = (world.pick(3), world.error());
    let [radius_1, radius_2] = [world.number(1e-3, 2e-3), world.number(1e-3, 2e-3)];
    let [mass_1, mass_2] = [world.number(1e-6, 1e-3), world.number(1e-6, 1e-3)];
    let (velocity, mut time) = (world.number(0.0, 10.0), 0.0);
    let grains = &raw mut world.grains[of];
    let (grains, to) = (world.point(grains), world.point(&raw mut time));
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        carom_grains_impact_time(grains, radius_1, radius_2, mass_1, mass_2, velocity, to, error)
    };
    told(world, status, 47, &[time])
}

fn rings(world: &mut World) -> CaromStatus {
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

fn twist(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, error) = (world.pick(4), world.pick(5), world.error());
    let (zeta, omega) = (world.number(-0.2e-7, 3e-7), world.number(-1e-2, 1e-2));
    let mut number = 0.0;
    let (pair, twist) = (&raw mut world.pairs[of], &raw mut world.twists[at]);
    let (pair, twist, to) = (world.point(pair), world.point(twist), &raw mut number);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            16 => carom_twist_advance(pair, twist, zeta, omega, to, error),
            17 => carom_twist_torque(pair, twist, to, error),
            18 => carom_twist_energy(pair, twist, to, error),
            _ => carom_twist_heat(pair, twist, zeta, omega, to, error),
        }
    };
    told(world, status, which, &[number])
}

fn touch(world: &mut World, which: usize) -> CaromStatus {
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
unsafe fn many(
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

fn touch_twist(world: &mut World, which: usize) -> CaromStatus {
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

/// A wall of any shape below a grain, which is moved onto it.
fn wall_below(world: &mut World, grain: &mut CaromGrain) -> CaromSurface {
    grain.place[2] -= 1e-3;
    let axis = [[0.0; 3], [1.0, 0.0, 0.0], world.vector(1.0)][world.pick(20).min(2)];
    let [velocity, spin] = [0.1, 10.0].map(|size| world.vector(size));
    CaromSurface { place: world.vector(1e-9), normal: [0.0, 0.0, 1.0], velocity, spin, axis }
}

fn surface(world: &mut World, which: usize) -> CaromStatus {
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

fn roll(world: &mut World, which: usize) -> CaromStatus {
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

fn curved(world: &mut World) -> CaromStatus {
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

fn constants(world: &mut World, which: usize) -> CaromStatus {
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

fn restitution(world: &mut World, which: usize) -> CaromStatus {
    let kappa = [world.number(0.75, 1.5), world.number(0.75, 1.5)];
    let (lambda, method, error) = (world.number(0.0, 9.0), world.pick(3) as u32, world.error());
    let (mut answer, stride) = ([0.0; 2], world.pick(17));
    let to = world.point(answer.as_mut_ptr());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            36 => carom_restitution(kappa[0], lambda, method, to, error),
            _ => {
                let stride = if stride > 8 { 8 } else { stride };
                carom_restitution_many(2, kappa.as_ptr(), 8, &lambda, 0, method, to, stride, error)
            }
        }
    };
    told(world, status, which, &answer)
}

fn dissimilar(world: &mut World) -> CaromStatus {
    let (kappa, gamma) = (world.number(0.75, 1.5), world.number(-0.2, 0.2));
    let (friction, lambda) = (world.number(0.05, 1.0), world.number(0.0, 7.0));
    let (ratio, error) = (world.number(1.0, 6.0), world.error());
    let (mut answer, mut estimate, mut method) = (0.0, 0.0, 0);
    let (to, method) = (world.point(&raw mut answer), world.point(&raw mut method));
    let estimate = world.point(&raw mut estimate);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        carom_restitution_dissimilar(
            kappa, gamma, friction, lambda, ratio, to, estimate, method, error,
        )
    }
}

fn rebound(world: &mut World) -> CaromStatus {
    let (at, restitution, error) = (world.pick(3), world.number(0.01, 1.0), world.error());
    let grains = &raw mut world.grains[at];
    let grains = world.point(grains);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe { carom_grains_restitution(grains, restitution, error) }
}

fn friction(world: &mut World, which: usize) -> CaromStatus {
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

fn creep(world: &mut World) -> CaromStatus {
    let (ratio, poisson) = (world.number(0.05, 20.0), world.number(0.0, 0.5));
    let (error, mut place) = (world.error(), MaybeUninit::<CaromCreep>::uninit());
    let to = world.point(place.as_mut_ptr());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe { carom_creep_coefficients(ratio, poisson, to, error) }
}

fn body(world: &mut World) -> CaromBody {
    // SAFETY: zeros are a solid sphere at rest.
    let mut body: CaromBody = unsafe { zeroed() };
    (body.shape, body.hollow) = (world.pick(8) as u32, (world.pick(9) / 8) as u32);
    body.sizes = std::array::from_fn(|_| world.number(0.01, 0.03));
    (body.mass, body.material) = (world.number(0.1, 1.0), GLASS);
    (body.velocity, body.spin, body.centre) =
        (world.vector(2.0), world.vector(20.0), world.vector(0.02));
    if world.chance(0.3) {
        body.attitude = std::array::from_fn(|_| world.number(-1.0, 1.0));
    }
    body
}

fn collide(world: &mut World) -> CaromStatus {
    let ([mut one, mut two], friction) = ([body(world), body(world)], world.number(0.0, 1.0));
    // Spheres and planes, but for a few: others take their time.
    if world.chance(0.9) {
        (one.shape, two.shape) = (CAROM_SHAPE_SPHERE, world.pick(2) as u32);
    }
    let normal = world.vector(1.0);
    let by = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let normal = if world.chance(0.1) { normal } else { normal.map(|x| x / by) };
    let normal = if world.chance(0.1) { null() } else { normal.as_ptr() };
    let (mut rebound, error) = (CaromRebound::default(), world.error());
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let size = [0, 8, 40, size_of::<CaromCollideOptions>()][world.pick(12).min(3)];
    let options = CaromCollideOptions {
        size,
        law: [0, 0, 0, 1, 2, 4][world.pick(6)],
        loss: world.pick(5) as u32,
        normal_restitution: world.number(0.0, 1.0),
        tolerance: if world.chance(0.8) { 0.0 } else { world.number(1e-4, 1e-2) },
        torsion: [0, 0, 1, 2, 3][world.pick(5)],
        relaxation: world.number(0.0, 1e-5),
        static_friction: if world.chance(0.8) { 0.0 } else { world.number(0.0, 1.0) },
        slip_friction_b: if world.chance(0.8) { 0.0 } else { world.number(-0.3, 1.0) },
        slip_friction_c: world.number(0.0, 2.0),
    };
    let options = if world.chance(0.5) { null() } else { &raw const options };
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe { carom_collide(one, two, friction, normal, options, &mut rebound, error) };
    let vectors = [
        rebound.body_1_velocity,
        rebound.body_1_spin,
        rebound.body_2_velocity,
        rebound.body_2_spin,
        rebound.impulse,
    ];
    let vectors = vectors.as_flattened().iter().sum();
    let energies = rebound.energy_after + rebound.energy_dissipated + rebound.energy_lost;
    told(world, status, 38, &[vectors, energies, rebound.duration, rebound.R_x])
}

fn words(world: &mut World, which: usize) -> CaromStatus {
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
