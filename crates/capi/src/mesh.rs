//! Surfaces of triangles.

use carom_geometry::mesh::{MeshError, Part, Search, TriangleMesh};

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pointers::{Strided, read, write};

/// `carom_place.part`: the inside of a face.
pub const CAROM_PART_FACE: u32 = 0;
/// `carom_place.part`: an edge between its ends.
pub const CAROM_PART_EDGE: u32 = 1;
/// `carom_place.part`: a corner.
pub const CAROM_PART_CORNER: u32 = 2;

/// A surface of triangles, with the memory of a search: it may be used by one thread at a time. It takes about 450 bytes
/// a triangle.
#[derive(Debug)]
pub struct CaromMesh {
    mesh: TriangleMesh,
    search: Search,
}

/// A place where a ball touches a surface.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromPlace {
    /// The point of the surface.
    pub point: [f64; 3],
    /// The unit normal from there to the centre of the ball.
    pub normal: [f64; 3],
    /// The distance of the centre from the point.
    pub distance: f64,
    /// The ends of an edge in the given triangles; of a corner twice itself, of a face twice a point of its plane that is
    /// the same for all places on it.
    pub ends: [[f64; 3]; 2],
    /// Where the surface repeats itself: how far the copy that is touched is from the given triangles; else zero.
    pub shift: [f64; 3],
    /// A `CAROM_PART_...`.
    pub part: u32,
    /// Which one, from 0; of a face the triangle.
    pub number: u32,
    /// 1 if it is an edge or a corner where triangles meet at more than the smooth angle, or end; else 0.
    pub is_sharp: u32,
}

impl From<MeshError> for Failure {
    #[cold]
    fn from(error: MeshError) -> Self {
        let told = |field| Self::new(CaromStatus::OutOfRange, field, error);
        match error {
            MeshError::Range(error) => error.into(),
            MeshError::NotFinite { number } | MeshError::NoArea { number } => {
                told("triangles").at(number - 1)
            }
            MeshError::TooLong { length, .. } => told("period").with_value(length),
            MeshError::Interrupted => Self::internal(),
        }
    }
}

/// Makes a surface of `count` triangles, nine numbers for each: three corners in any order. Corners with the same
/// coordinates are one, triangles in one plane are one face, and both sides count. Places whose normals differ by less
/// than `smooth`, from .01 to .8 rad, are one place. `period`, if not null, has three numbers: the lengths after which
/// the surface repeats itself along the axes, 0 for none; shorter than the surface they are refused. `carom_mesh_free`
/// releases the surface.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `triangles` must have 9 `count` entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_mesh_make(
    triangles: *const f64,
    count: usize,
    smooth: f64,
    period: *const f64,
    mesh: *mut *mut CaromMesh,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        read(triangles, "triangles")?;
        let triangles = std::slice::from_raw_parts(triangles.cast(), count);
        let periods = if period.is_null() { [0.0; 3] } else { *read(period.cast(), "period")? };
        let (place, search) = (write(mesh, "mesh")?, Search::default());
        let mesh = TriangleMesh::new(triangles, smooth, periods)?;
        *place = Box::into_raw(Box::new(CaromMesh { mesh, search }));
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The places where a ball with this centre touches the surface whose distance from the centre is at most `reach`:
/// where the surface is nearer than anywhere close by, within a face, on an edge or at a corner. The first `room` of them
/// are written to `places`, faces first, as their triangles were given; `count` is their number, which may be greater.
/// It allocates nothing once it has found as much before.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `center` must have 3 entries, `places` `room`; `mesh` must be made by this library and not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_mesh_places(
    mesh: *mut CaromMesh,
    center: *const f64,
    reach: f64,
    places: *mut CaromPlace,
    room: usize,
    count: *mut usize,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let CaromMesh { mesh, search } = write(mesh, "mesh")?;
        let center: &[f64; 3] = read(center.cast(), "center")?;
        let to = Strided::new(places, size_of::<CaromPlace>(), room, "places")?;
        let (count, found) =
            (write(count, "count")?, mesh.places((*center).into(), reach, search)?);
        for (i, place) in found.iter().take(room).enumerate() {
            let (point, normal, shift) = (place.point, place.normal, place.shift);
            to.at(i).write(CaromPlace {
                point: point.into(),
                normal: normal.into(),
                distance: place.distance,
                ends: mesh.ends(place).map(Into::into),
                shift: shift.into(),
                part: match place.part {
                    Part::Face => CAROM_PART_FACE,
                    Part::Edge => CAROM_PART_EDGE,
                    Part::Corner => CAROM_PART_CORNER,
                },
                number: place.number,
                is_sharp: place.is_sharp.into(),
            });
        }
        *count = found.len();
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Releases a surface; null is allowed.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `mesh` must be null or made by this library, and is not to be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_mesh_free(mesh: *mut CaromMesh) {
    if !mesh.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(mesh) });
    }
}
