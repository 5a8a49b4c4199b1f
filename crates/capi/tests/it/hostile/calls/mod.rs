//! One random call of the C interface.

mod answers;
mod constants;
mod contacts;
mod impacts;
pub(super) mod meshes;
mod particles;

use carom_capi::*;

use super::world::World;

/// All functions of the border but `carom_law_free` and `carom_mesh_free`.
pub(crate) const NAMES: [&str; 36] = [
    "carom_contact_advance",
    "carom_contact_load",
    "carom_contact_energy",
    "carom_contact_pack",
    "carom_contact_unpack",
    "carom_restitution",
    "carom_restitution_many",
    "carom_restitution_dissimilar",
    "carom_collide",
    "carom_contact_advance_many",
    "carom_touch_step",
    "carom_touch_load",
    "carom_touch_energy",
    "carom_touch_report",
    "carom_touch_pack",
    "carom_touch_unpack",
    "carom_touch_step_many",
    "carom_touch_size, carom_touch_pack_size",
    "carom_pair_of_spheres",
    "carom_pair_of_curvatures",
    "carom_law_make",
    "carom_law_on_curved_wall",
    "carom_law_validity",
    "carom_law_impact_validity",
    "carom_encounters_validity",
    "carom_law_impact_time",
    "carom_validity_text",
    "carom_creep_coefficients, carom_creep_force",
    "carom_status_text",
    "carom_version",
    "carom_warning_text",
    "carom_law_name",
    "carom_abi_version",
    "carom_law_of_name",
    "carom_mesh_make",
    "carom_mesh_places",
];

/// Makes one call, now and then after bytes were garbled, and returns its name.
pub(crate) fn one(world: &mut World) -> &'static str {
    if world.chance(0.1) {
        world.garble();
    }
    // Those of microseconds and more are rarer.
    let which = match world.pick(400) {
        0 => 7 + world.pick(2),
        1 => 5 + world.pick(2),
        2..=14 => 18 + world.pick(4),
        15..=40 => 22 + world.pick(14),
        41..=140 => [0, 1, 2, 3, 4, 9][world.pick(6)],
        _ => 10 + world.pick(8),
    };
    let status = match which {
        0..=4 | 9 => contacts::contact(world, which),
        5 | 6 => impacts::restitution(world, which),
        7 => impacts::dissimilar(world),
        8 => impacts::collide(world),
        10..=17 => particles::touch(world, which),
        18 | 19 => constants::pairs(world, which),
        20 | 21 => constants::laws(world, which),
        22..=26 => constants::limits(world, which),
        27 => constants::creep(world),
        34 | 35 => meshes::mesh(world, which),
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
