//! The parts of a mesh while it is made.

use nalgebra::Vector3;

use super::error::MeshError;
use super::lists::Lists;
use super::parts::{Corner, Edge, Face, corners_of, edges_of, unit};
use super::seam::Seam;

/// Corners of triangles this far from a plane, over the size of the surface, lie in it: the round-off of the single
/// precision of binary STL files.
const FLATNESS: f64 = 2e-7;
/// A triangle whose height is below this part of its longest side has no normal.
const FLATTEST: f64 = 1e-7;
/// The square of the longest side of the smallest triangle.
const LEAST: f64 = 1e-100;

pub(super) struct Draft {
    pub(super) corners: Vec<Corner>,
    pub(super) edges: Vec<Edge>,
    pub(super) faces: Vec<Face>,
    pub(super) seam: Seam,
    /// By edge: the triangles there.
    pub(super) sides: Lists<Side>,
    pub(super) tolerance: f64,
}

/// A triangle, and which of its edges is meant.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Side {
    pub(super) face: u32,
    pub(super) edge: u32,
}

/// Checks that a triangle has a normal.
pub(super) fn check_area([a, b, c]: [Vector3<f64>; 3], number: usize) -> Result<(), MeshError> {
    let sides = [b - a, c - b, a - c];
    let longest = sides.iter().map(|side| side.dot(side)).fold(0.0, f64::max);
    let area = sides[0].cross(&sides[1]);
    match area.dot(&area).sqrt() > FLATTEST * longest && longest > LEAST {
        true => Ok(()),
        false => Err(MeshError::NoArea { number }),
    }
}

/// The greatest coordinate or length that the first corners and sides show.
fn size(triangles: &[[[f64; 3]; 3]]) -> f64 {
    let its = triangles.iter().flat_map(|[a, b, _]| a.iter().zip(b));
    its.map(|(a, b)| (b - a).abs().max(a.abs())).fold(0.0, f64::max)
}

impl Draft {
    pub(super) fn new(triangles: &[[[f64; 3]; 3]], periods: [f64; 3]) -> Self {
        let (mut corners, of) = corners_of(triangles);
        let tolerance = FLATNESS * size(triangles);
        let mut seam = Seam::new(&mut corners, periods, tolerance);
        let (edges, its) = edges_of(&corners, &of);
        seam.close_edges(&edges);
        let at =
            its.iter().zip(0..).flat_map(|(its, face)| its.map(|edge| (edge, Side { face, edge })));
        let mut sides = Lists::new(edges.len(), &at.collect::<Vec<_>>());
        sides.share(&seam.edges);
        let face = |(corners, edges)| Face { corners, edges, ..Face::default() };
        let faces = of.into_iter().zip(its).map(face).collect();
        Self { corners, edges, faces, seam, sides, tolerance }
    }

    /// Gives each triangle its directions from the edges inward, and lists them by edge.
    pub(super) fn make_inward(&mut self) -> Lists<Vector3<f64>> {
        let mut pairs = Vec::with_capacity(3 * self.faces.len());
        let corner = |n: u32| self.corners[n as usize].at;
        for face in &mut self.faces {
            for (k, edge) in face.edges.into_iter().enumerate() {
                let inward = unit(face.normal.cross(&self.edges[edge as usize].along)).0;
                let arm = corner(face.corners[(k + 2) % 3]) - corner(face.corners[k]);
                face.inward[k] = if arm.dot(&inward) < 0.0 { -inward } else { inward };
                pairs.push((edge, face.inward[k]));
            }
        }
        let mut inward = Lists::new(self.edges.len(), &pairs);
        inward.share(&self.seam.edges);
        inward
    }

    /// Tells which edges and corners are sharp: where triangles meet at more than the angle, or end.
    pub(super) fn tell_sharp(&mut self, inward: &Lists<Vector3<f64>>, cosine: f64) {
        let normal = |side: &Side| self.faces[side.face as usize].normal;
        for (edge, n) in self.edges.iter_mut().zip(0..) {
            let turn = match inward.of(n) {
                [one, two] => -one.dot(two),
                _ => -1.0,
            };
            edge.is_sharp = turn < cosine;
            let sides = self.sides.of(n);
            edge.is_flat = turn > 0.0 && sides.first().map(normal) == sides.last().map(normal);
            for end in edge.ends {
                self.corners[end as usize].is_sharp |= edge.is_sharp;
            }
        }
        for group in &self.seam.corners {
            let is_sharp = group.iter().any(|corner| self.corners[*corner as usize].is_sharp);
            group.iter().for_each(|corner| self.corners[*corner as usize].is_sharp = is_sharp);
        }
    }

    /// By corner: its edges, away from it.
    pub(super) fn along(&self) -> Lists<Vector3<f64>> {
        let two = |edge: &Edge| [(edge.ends[0], edge.along), (edge.ends[1], -edge.along)];
        let pairs: Vec<_> = self.edges.iter().flat_map(two).collect();
        let mut along = Lists::new(self.corners.len(), &pairs);
        along.share(&self.seam.corners);
        along
    }
}
