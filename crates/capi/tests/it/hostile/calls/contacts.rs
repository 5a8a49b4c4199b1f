//! Calls of single contacts.

use std::mem::size_of;

use carom_capi::*;

use super::super::world::World;
use super::answers::told;

pub(super) fn contact(world: &mut World, which: usize) -> CaromStatus {
    let (at, of, shift, error) = (world.pick(6), world.pick(5), world.shift(), world.error());
    let state = world.pick(6);
    let (mut load, mut number) = (CaromLoad::default(), 0.0);
    let (pair, contact) = (&raw mut world.pairs[of], &raw mut world.contacts[at]);
    let (pair, contact) = (world.point(pair), world.point(contact));
    let (load_at, number_at) = (world.point(&raw mut load), world.point(&raw mut number));
    let mut all = [CaromLoad::default(); 6];
    let state = &raw mut world.states[state];
    let (state, size) = (world.point(state), size_of::<CaromContact>());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            0 => carom_contact_advance(pair, contact, shift, load_at, error),
            1 => carom_contact_load(pair, contact, load_at, error),
            2 => carom_contact_energy(pair, contact, number_at, error),
            3 => carom_contact_pack(pair, contact, state, error),
            4 => carom_contact_unpack(pair, state, contact, error),
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
