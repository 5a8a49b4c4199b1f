//! Corners, edges and faces of a mesh.

use std::array::from_fn;
use std::cmp::Ordering;
use std::collections::HashMap;

use nalgebra::Vector3;

#[derive(Debug, Clone)]
pub(super) struct Corner {
    pub(super) at: Vector3<f64>,
    pub(super) is_sharp: bool,
}

#[derive(Debug, Clone)]
pub(super) struct Edge {
    pub(super) ends: [u32; 2],
    pub(super) along: Vector3<f64>,
    pub(super) length: f64,
    /// Triangles meet here at more than the smooth angle, or end.
    pub(super) is_sharp: bool,
    /// Between two triangles of one plane.
    pub(super) is_flat: bool,
}

/// A triangle.
#[derive(Debug, Clone, Default)]
pub(super) struct Face {
    pub(super) corners: [u32; 3],
    /// Edge k runs from corner k to the next.
    pub(super) edges: [u32; 3],
    /// From edge k, in the plane of the face.
    pub(super) inward: [Vector3<f64>; 3],
    /// Shared by all triangles of a plane.
    pub(super) normal: Vector3<f64>,
    pub(super) point: Vector3<f64>,
}

/// Corners with the same coordinates are one; they are ordered by them.
pub(super) fn corners_of(triangles: &[[[f64; 3]; 3]]) -> (Vec<Corner>, Vec<[u32; 3]>) {
    let points = triangles.as_flattened();
    // The sum with zero makes -0 and 0 the same.
    let point = |n: &u32| points[*n as usize].map(|x| x + 0.0);
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(|a, b| point(a).partial_cmp(&point(b)).unwrap_or(Ordering::Equal));
    let (mut corners, mut of) = (Vec::<Corner>::new(), vec![[0; 3]; triangles.len()]);
    for n in order {
        let at = Vector3::from(point(&n));
        if corners.last().is_none_or(|last| last.at != at) {
            corners.push(Corner { at, is_sharp: false });
        }
        of[n as usize / 3][n as usize % 3] = corners.len() as u32 - 1;
    }
    (corners, of)
}

/// The edges in the order of the triangles with these corners, and those of each triangle.
pub(super) fn edges_of(corners: &[Corner], of: &[[u32; 3]]) -> (Vec<Edge>, Vec<[u32; 3]>) {
    let (mut edges, mut known) = (Vec::new(), HashMap::new());
    let mut edge = |one: u32, two: u32| {
        let ends = [one.min(two), one.max(two)];
        *known.entry(ends).or_insert_with(|| {
            let [from, to] = ends.map(|end| corners[end as usize].at);
            let (along, length) = unit(to - from);
            edges.push(Edge { ends, along, length, is_sharp: true, is_flat: false });
            edges.len() as u32 - 1
        })
    };
    let its = of.iter().map(|at| from_fn(|k| edge(at[k], at[(k + 1) % 3]))).collect();
    (edges, its)
}

/// A vector over its length, and the length.
pub(super) fn unit(vector: Vector3<f64>) -> (Vector3<f64>, f64) {
    let length = vector.dot(&vector).sqrt();
    (vector / length, length)
}
