//! Coplanar neighbours are one face: each triangle gets the plane of the largest that it grows from.

use carom_special::interrupt;
use nalgebra::Vector3;

use super::draft::{Draft, check_area};
use super::error::MeshError;
use super::parts::unit;

impl Draft {
    /// Gives each triangle its plane.
    pub(super) fn make_planes(&mut self) -> Result<(), MeshError> {
        let mut areas = Vec::with_capacity(self.faces.len());
        for (face, number) in self.faces.iter_mut().zip(1..) {
            let [a, b, c] = face.corners.map(|corner| self.corners[corner as usize].at);
            check_area([a, b, c], number)?;
            let (normal, area) = unit((b - a).cross(&(c - a)));
            (face.normal, face.point) = (normal, a);
            areas.push(area);
        }
        let mut order: Vec<u32> = (0..areas.len() as u32).collect();
        order.sort_by(|a, b| areas[*b as usize].total_cmp(&areas[*a as usize]));
        let mut done = vec![false; areas.len()];
        for (n, seed) in order.into_iter().enumerate() {
            if n % 4096 == 0 && interrupt::is_wanted() {
                return Err(MeshError::Interrupted);
            }
            if !done[seed as usize] {
                self.grow_plane(seed, &mut done);
            }
        }
        Ok(())
    }

    fn grow_plane(&mut self, seed: u32, done: &mut [bool]) {
        let normal = self.faces[seed as usize].normal;
        let mut left = vec![seed];
        done[seed as usize] = true;
        while let Some(last) = left.pop() {
            let face = &mut self.faces[last as usize];
            face.normal = normal;
            let (point, edges) = (face.point, face.edges);
            for (edge, side) in edges
                .iter()
                .flat_map(|edge| self.sides.of(*edge).iter().map(move |side| (edge, side)))
            {
                let point = self.seam.beyond(point, *edge, side.edge);
                if !done[side.face as usize] && self.lies_in(side.face, &point, &normal) {
                    self.faces[side.face as usize].point = point;
                    done[side.face as usize] = true;
                    left.push(side.face);
                }
            }
        }
    }

    fn lies_in(&self, face: u32, point: &Vector3<f64>, normal: &Vector3<f64>) -> bool {
        let off = |corner: u32| (self.corners[corner as usize].at - point).dot(normal).abs();
        self.faces[face as usize].corners.iter().all(|corner| off(*corner) <= self.tolerance)
    }
}
