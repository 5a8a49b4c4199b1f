//! One random call of the C interface.

mod answers;
mod constants;
mod contacts;
mod impacts;
mod particles;
mod ring_particles;
mod walls;

use carom_capi::*;

use super::world::World;

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
        0..=8 => contacts::contact(world, which),
        9..=15 | 39 => ring_particles::ring_touch(world, which),
        16..=19 => contacts::twist(world, which),
        20..=28 => particles::touch(world, which),
        29..=31 => particles::touch_twist(world, which),
        52..=56 => walls::surface(world, which),
        57..=59 => walls::roll(world, which),
        60 => walls::curved(world),
        32..=35 => constants::constants(world, which),
        36..=37 => impacts::restitution(world, which),
        44 => impacts::dissimilar(world),
        38 => impacts::collide(world),
        43 => ring_particles::rings(world),
        46 => constants::validity(world),
        47 => impacts::impact_time(world),
        48..=51 => constants::grains_validity(world, which),
        61 => constants::creep(world),
        62 => impacts::rebound(world),
        63..=67 => constants::friction(world, which),
        _ => constants::words(world, which),
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
