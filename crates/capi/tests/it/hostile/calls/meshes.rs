//! Surfaces of triangles.

use std::mem::zeroed;
use std::ptr::{null, null_mut};

use carom_capi::*;

use super::super::world::World;

/// More than most balls touch.
const ROOM: usize = 4;

/// Two sides of a tent that repeats itself.
pub(crate) fn tent() -> *mut CaromMesh {
    let ridge = [[0.0, 0.0, 1e-3], [0.0, 2e-3, 1e-3]];
    let side =
        |x: f64| [[ridge[0], ridge[1], [x, 0.0, 0.0]], [[x, 2e-3, 0.0], ridge[1], [x, 0.0, 0.0]]];
    let (triangles, period, mut made) = ([side(-1e-3), side(1e-3)], [2e-3, 0.0, 0.0], null_mut());
    let first = triangles.as_ptr().cast();
    // SAFETY: all pointers are references or null.
    let status = unsafe { carom_mesh_make(first, 4, 0.2, &period[0], &raw mut made, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    made
}

pub(super) fn mesh(world: &mut World, which: usize) -> CaromStatus {
    let error = world.error();
    if which == 34 {
        let mut numbers = [[0.0; 9]; 6].map(|own| own.map(|_: f64| world.number(-1.0, 1.0)));
        let mut period = [(); 3].map(|()| world.number(0.0, 4.0));
        let (count, smooth, mut made) = (world.pick(7), world.number(0.01, 0.8), null_mut());
        let first = world.point(numbers.as_mut_ptr()).cast::<f64>();
        let period =
            if world.chance(0.5) { null() } else { world.point(period.as_mut_ptr()).cast() };
        let to = world.point(&raw mut made);
        // SAFETY: each pointer is null, misaligned or that of something that may be read or written, and none twice.
        let status = unsafe { carom_mesh_make(first, count, smooth, period, to, error) };
        assert!(made.is_null() || status == CaromStatus::Ok);
        // SAFETY: null or made by the library.
        unsafe { carom_mesh_free(made) };
        return status;
    }
    // SAFETY: plain numbers.
    let mut places: [CaromPlace; ROOM] = unsafe { zeroed() };
    let (mut center, reach) = (world.vector(3e-3), world.number(1e-4, 2e-3));
    let (room, mut count, mesh) = (world.pick(ROOM + 1), 0, world.mesh);
    let (mesh, center) = (world.point(mesh), world.point(center.as_mut_ptr()));
    let (to, number) = (world.point(places.as_mut_ptr()), world.point(&raw mut count));
    // SAFETY: each pointer is null, misaligned or that of something that may be read or written, and none twice.
    let status = unsafe { carom_mesh_places(mesh, center, reach, to, room, number, error) };
    for place in places.iter().take(count.min(room)) {
        let length = place.normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length - 1.0).abs() < 1e-9 && place.distance <= reach);
    }
    status
}
