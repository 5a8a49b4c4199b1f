//! A surface of triangles: where it touches a ball.
//!
//! A ball touches the surface where its centre is nearer to it than anywhere close by: within a face, on an edge or at a
//! corner. Triangles in one plane are one face. Both sides of a triangle count. Places whose normals differ by less than
//! an angle are one place, the nearest of them, so that a ball rolls over the edges of a finely triangulated surface with
//! one contact. A surface may repeat itself along axes; where it leaves one period and enters the next its corners and
//! edges are shared as elsewhere.

mod cells;
mod draft;
mod error;
mod lists;
mod parts;
mod planes;
mod seam;
mod search;

use carom_special::RangeError;
use nalgebra::Vector3;

use cells::Cells;
use draft::Draft;
use lists::Lists;
use parts::{Corner, Edge, Face};

pub use error::MeshError;
pub use search::{Part, Place, Search};

/// Triangles, corners, edges and lists of these are counted in 32 bits.
const MOST: usize = 500_000_000;
/// Coordinates below this have finite products.
const FAR: f64 = 1e50;

/// A surface of triangles.
///
/// ```
/// use carom_geometry::mesh::{Part, Search, TriangleMesh};
/// use carom_geometry::nalgebra::Vector3;
/// let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let (mesh, mut search) = (TriangleMesh::new(&[triangle], 0.2, [0.0; 3])?, Search::default());
/// let places = mesh.places(Vector3::new(0.2, 0.3, -0.1), 0.15, &mut search)?;
/// assert_eq!((places.len(), places[0].part, places[0].normal), (1, Part::Face, -Vector3::z()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct TriangleMesh {
    corners: Vec<Corner>,
    edges: Vec<Edge>,
    faces: Vec<Face>,
    /// By edge: into each of its triangles.
    inward: Lists<Vector3<f64>>,
    /// By corner: its edges, away from it.
    along: Lists<Vector3<f64>>,
    cells: Cells,
    cosine: f64,
    periods: [f64; 3],
}

impl TriangleMesh {
    /// From the three corners of each triangle, in any order, the smooth angle, rad, and for each axis the period, 0 if
    /// there is none. Corners with the same coordinates are one.
    ///
    /// # Errors
    /// [`MeshError`] for a triangle that has no area or is not finite, an angle below .01 or above .8 rad, a period that
    /// is negative or shorter than the surface, and if there are no triangles or more than 500 millions.
    pub fn new(
        triangles: &[[[f64; 3]; 3]],
        smooth: f64,
        periods: [f64; 3],
    ) -> Result<Self, MeshError> {
        let count = triangles.len();
        let is_angle = (0.01..=0.8).contains(&smooth);
        RangeError::check("smooth", smooth, is_angle, "from 0.01 to 0.8 rad")?;
        RangeError::check("triangles", count as f64, (1..=MOST).contains(&count), "from 1 to 5e8")?;
        for period in periods {
            RangeError::non_negative("period", period)?;
        }
        check(triangles)?;
        let mut draft = Draft::new(triangles, periods);
        draft.make_planes()?;
        let (inward, cosine) = (draft.make_inward(), libm::cos(smooth));
        draft.tell_sharp(&inward, cosine);
        let (along, cells) = (draft.along(), Cells::new(&draft.corners, &draft.faces));
        let Draft { corners, edges, faces, tolerance, .. } = draft;
        for (axis, period) in periods.into_iter().enumerate() {
            let length = cells.high[axis] - cells.low[axis];
            if period > 0.0 && length > period + tolerance {
                return Err(MeshError::TooLong { axis, length, period });
            }
        }
        Ok(Self { corners, edges, faces, inward, along, cells, cosine, periods })
    }

    fn repeats(&self) -> bool {
        self.periods != [0.0; 3]
    }

    /// The ends of an edge in the given triangles, which its shift moves to the place; of a corner twice itself, of a face
    /// twice a point of its plane that is the same for all places on it.
    #[must_use]
    pub fn ends(&self, place: &Place) -> [Vector3<f64>; 2] {
        let (n, corner) = (place.number as usize, |n: u32| self.corners[n as usize].at);
        match place.part {
            Part::Face => [self.faces[n].point; 2],
            Part::Edge => self.edges[n].ends.map(corner),
            Part::Corner => [corner(place.number); 2],
        }
    }
}

fn check(triangles: &[[[f64; 3]; 3]]) -> Result<(), MeshError> {
    for (triangle, number) in triangles.iter().zip(1..) {
        if !triangle.as_flattened().iter().all(|x| x.abs() < FAR) {
            return Err(MeshError::NotFinite { number });
        }
        draft::check_area(triangle.map(Vector3::from), number)?;
    }
    Ok(())
}
