//! Cells of a box about a surface, each with the triangles that come near it.

use std::array::from_fn;

use nalgebra::Vector3;

use super::lists::Lists;
use super::parts::{Corner, Face};

/// Cells for each triangle, and about as many along an axis at most.
const CELLS: f64 = 2.0;
const MOST: f64 = 1000.0;
/// So many entries for each triangle are enough: large triangles among many small ones get wider cells.
const ENTRIES: usize = 64;

#[derive(Debug, Clone)]
pub(super) struct Cells {
    pub(super) low: Vector3<f64>,
    pub(super) high: Vector3<f64>,
    width: Vector3<f64>,
    counts: [usize; 3],
    faces: Lists<u32>,
}

impl Cells {
    pub(super) fn new(corners: &[Corner], faces: &[Face]) -> Self {
        let first = corners[0].at;
        let low = corners.iter().fold(first, |low, corner| low.inf(&corner.at));
        let high = corners.iter().fold(first, |high, corner| high.sup(&corner.at));
        let size = (high - low).max();
        // Cells are cubes, but that a surface in a plane has a single layer.
        let volume = (high - low).iter().fold(1.0, |volume, x| volume * (x / size).max(1e-2));
        let mut edge = size * libm::cbrt(volume / (CELLS * faces.len() as f64 + 8.0));
        loop {
            let counts = (high - low).map(|x| (x / edge).ceil().clamp(1.0, MOST));
            let width = (high - low).zip_map(&counts, |x, count| (x / count).max(1e-12 * size));
            let counts = from_fn(|k| counts[k] as usize);
            let mut cells = Self { low, high, width, counts, faces: Lists::new(0, &[]) };
            if let Some(pairs) = cells.pairs(corners, faces) {
                cells.faces = Lists::new(counts.iter().product(), &pairs);
                return cells;
            }
            edge *= 2.0;
        }
    }

    /// Cells and the triangles that come near them; nothing if they are too many.
    fn pairs(&self, corners: &[Corner], faces: &[Face]) -> Option<Vec<(u32, u32)>> {
        let most = (ENTRIES * faces.len()).max(1 << 20).min(u32::MAX as usize);
        let mut pairs = Vec::new();
        for (face, n) in faces.iter().zip(0..) {
            let [a, b, c] = face.corners.map(|corner| corners[corner as usize].at);
            let [x, y, z] = self.between(&a.inf(&b).inf(&c), &a.sup(&b).sup(&c));
            for (z, y) in (z[0]..=z[1]).flat_map(|z| (y[0]..=y[1]).map(move |y| (z, y))) {
                let near = (x[0]..=x[1]).filter(|x| self.comes_near(face, [*x, y, z]));
                pairs.extend(near.map(|x| (self.cell([x, y, z]) as u32, n)));
                if pairs.len() > most && self.counts != [1; 3] {
                    return None;
                }
            }
        }
        Some(pairs)
    }

    /// Whether the plane of a triangle comes near a cell.
    fn comes_near(&self, face: &Face, cell: [usize; 3]) -> bool {
        let middle = |k, _| self.low[k] + (cell[k] as f64 + 0.5) * self.width[k];
        let height = (Vector3::from_fn(middle) - face.point).dot(&face.normal);
        let reach = (0.5 * self.width).dot(&face.normal.abs());
        // A little more, for what lies on the border of two cells.
        height.abs() <= 1.01 * reach + 0.01 * self.width.max()
    }

    fn cell(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// The first and the last cell along each axis.
    fn between(&self, from: &Vector3<f64>, to: &Vector3<f64>) -> [[usize; 2]; 3] {
        from_fn(|k| {
            let cell = |x: f64| ((x - self.low[k]) / self.width[k]).floor() as usize;
            [from[k], to[k]].map(|x| cell(x).min(self.counts[k] - 1))
        })
    }

    /// Takes the triangles of all cells that a ball reaches, some of them several times.
    #[inline]
    pub(super) fn each_near(&self, center: &Vector3<f64>, reach: f64, mut take: impl FnMut(u32)) {
        let (from, to) = (center.add_scalar(-reach), center.add_scalar(reach));
        if (0..3).any(|k| to[k] < self.low[k] || from[k] > self.high[k]) {
            return;
        }
        let [x, y, z] = self.between(&from, &to);
        for z in z[0]..=z[1] {
            for y in y[0]..=y[1] {
                let faces = self.faces.run(self.cell([x[0], y, z]), self.cell([x[1], y, z]));
                faces.iter().for_each(|face| take(*face));
            }
        }
    }
}
