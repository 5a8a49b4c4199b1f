//! Calls of single contacts: shifts and twists.

use std::mem::{MaybeUninit, size_of};

use carom_capi::*;

use super::super::world::World;
use super::answers::{reported, told};

pub(super) fn contact(world: &mut World, which: usize) -> CaromStatus {
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

pub(super) fn twist(world: &mut World, which: usize) -> CaromStatus {
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
