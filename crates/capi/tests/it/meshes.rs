//! Surfaces of triangles: places are those of the library, and errors tell the triangle.

use std::mem::zeroed;
use std::ptr::{null, null_mut};

use carom_capi::*;

use crate::particles::{Told, told};

/// The sides of a unit cube whose corners lie at 0 and 1.
fn cube() -> Vec<[f64; 9]> {
    let side = |axis: usize, at: f64| {
        let corner = |u, v| {
            let mut corner = [at; 3];
            (corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (u, v);
            corner
        };
        let [a, b, c, d] = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        [[a, b, c], [a, c, d]].map(|corners| corners.as_flattened().try_into().unwrap())
    };
    (0..3).flat_map(|axis| [side(axis, 0.0), side(axis, 1.0)]).flatten().collect()
}

fn made(triangles: &[[f64; 9]], smooth: f64, period: *const f64) -> Result<*mut CaromMesh, Told> {
    let first = triangles.as_ptr().cast();
    // SAFETY: all pointers are references, or null.
    told(null_mut(), |mesh, error| unsafe {
        carom_mesh_make(first, triangles.len(), smooth, period, mesh, error)
    })
}

fn places(mesh: *mut CaromMesh, center: [f64; 3], reach: f64) -> Result<Vec<CaromPlace>, Told> {
    // SAFETY: plain numbers.
    let none: (usize, [CaromPlace; 2]) = unsafe { zeroed() };
    // SAFETY: all pointers are references.
    let (count, places) = told(none, |(count, places), error| unsafe {
        carom_mesh_places(mesh, &center[0], reach, &mut places[0], 2, count, error)
    })?;
    Ok(places[..count].to_vec())
}

#[test]
fn a_ball_touches_a_cube_at_a_face_an_edge_and_a_corner() {
    let mesh = made(&cube(), 0.2, null()).unwrap();
    let [face, edge, corner] = [[0.4, 0.5, 1.25], [1.3, 0.5, 1.4], [1.2, 1.2, 1.1]].map(|center| {
        let found = places(mesh, center, 0.6).unwrap();
        assert_eq!(found.len(), 1);
        found[0]
    });
    assert_eq!((face.part, face.distance, face.is_sharp), (CAROM_PART_FACE, 0.25, 0));
    assert_eq!((face.point, face.normal), ([0.4, 0.5, 1.0], [0.0, 0.0, 1.0]));
    assert_eq!((edge.part, edge.is_sharp, edge.point), (CAROM_PART_EDGE, 1, [1.0, 0.5, 1.0]));
    assert_eq!(edge.ends, [[1.0, 0.0, 1.0], [1.0, 1.0, 1.0]]);
    assert!((edge.distance - 0.5).abs() < 1e-15 && (edge.normal[0] - 0.6).abs() < 1e-15);
    assert_eq!((corner.part, corner.ends), (CAROM_PART_CORNER, [[1.0; 3]; 2]));
    assert!((corner.distance - 0.3).abs() < 1e-15 && corner.shift == [0.0; 3]);
    // SAFETY: made above; null is where nothing is wanted.
    unsafe { (carom_mesh_free(mesh), carom_mesh_free(null_mut())) };
}

#[test]
fn a_surface_repeats_itself_and_tells_all_places() {
    let mesh = made(&cube(), 0.2, [4.0, 0.0, 0.0].as_ptr()).unwrap();
    let between = places(mesh, [-1.5, 0.5, 0.5], 1.5).unwrap();
    let normals: Vec<_> = between.iter().map(|place| (place.normal[0], place.shift[0])).collect();
    assert_eq!(normals, [(-1.0, 0.0), (1.0, -4.0)]);
    let (mut count, center) = (0, [-1.5, 0.5, 0.5]);
    // SAFETY: all pointers are references; no place is asked for.
    let status =
        unsafe { carom_mesh_places(mesh, &center[0], 1.5, null_mut(), 0, &mut count, null_mut()) };
    assert_eq!((status, count), (CaromStatus::Ok, 2));
    // SAFETY: made above.
    unsafe { carom_mesh_free(mesh) };
}

#[test]
fn what_is_wrong_is_named() {
    let (mut flat, mut endless) = (cube(), cube());
    flat[3][3..6].copy_from_slice(&[0.0; 3]);
    flat[3][..3].copy_from_slice(&[0.0; 3]);
    endless[4][2] = f64::NAN;
    let short = [0.9, 0.0, 0.0];
    for (triangles, smooth, period, field, index, text) in [
        (&flat, 0.2, null(), "triangles", 3, "triangle 4 is not valid: its corners lie on a line"),
        (&endless, 0.2, null(), "triangles", 4, "triangle 5 is not valid: a coordinate"),
        (&vec![], 0.2, null(), "triangles", -1, "triangles = 0 is out of range"),
        (&cube(), 0.9, null(), "smooth", -1, "smooth = 0.9 is out of range"),
        (&cube(), 0.2, short.as_ptr(), "period", -1, "length of the surface along x = 1 is out"),
    ] {
        let Told { status, field: name, text: said, index: at } =
            made(triangles, smooth, period).unwrap_err();
        assert_eq!((status, name.as_str(), at), (CaromStatus::OutOfRange, field, index), "{said}");
        assert!(said.starts_with(text), "{said}");
    }
    let mesh = made(&cube(), 0.2, null()).unwrap();
    assert_eq!(places(mesh, [f64::NAN, 0.0, 0.0], 1.0).unwrap_err().field, "center");
    assert_eq!(places(mesh, [0.0; 3], -1.0).unwrap_err().field, "reach");
    // SAFETY: made above.
    unsafe { carom_mesh_free(mesh) };
}
