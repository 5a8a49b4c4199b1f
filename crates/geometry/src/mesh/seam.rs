//! Which corners and edges of a surface are one where it repeats itself.

use std::array::from_fn;
use std::collections::{BTreeMap, HashMap};

use nalgebra::Vector3;

use super::parts::{Corner, Edge};

/// Along each axis a number of periods.
type Steps = [i32; 3];

/// Corners and edges that coincide modulo the periods, as those at two opposite sides of a surface that is as long as
/// its period.
#[derive(Default)]
pub(super) struct Seam {
    /// Those that are one, without those that are alone.
    pub(super) corners: Vec<Vec<u32>>,
    pub(super) edges: Vec<Vec<u32>>,
    periods: [f64; 3],
    /// Of a corner: the first of its group, or itself, and how far from there.
    firsts: Vec<u32>,
    steps: Vec<Steps>,
    is_shared: Vec<bool>,
    /// Of an edge: in periods, from those with which it is one.
    away: Vec<Steps>,
}

impl Seam {
    /// Closes the corners: those that are one within the tolerance are moved by less than that, so that they are one
    /// exactly. Those on a high side are carried to the low one, where those that meet are one.
    pub(super) fn new(corners: &mut [Corner], periods: [f64; 3], tolerance: f64) -> Self {
        let (steps, mut rim) = rim(corners, periods, tolerance);
        // Those on no high side first, so that they stay where they are.
        rim.sort_by_key(|n| steps[*n as usize].iter().sum::<i32>());
        let firsts = (0..corners.len() as u32).collect();
        let is_shared = vec![false; corners.len()];
        let mut seam = Self { periods, firsts, steps, is_shared, ..Self::default() };
        let (mut places, mut groups) = (Places::new(tolerance), Vec::<Vec<u32>>::new());
        for n in rim {
            let steps = seam.steps[n as usize];
            let carried = seam.moved(corners[n as usize].at, steps.map(|step| -step));
            let place = places.place_of(carried, 1 << (steps[0] + 2 * steps[1] + 4 * steps[2]));
            groups.resize(places.points.len(), Vec::new());
            groups[place].push(n);
        }
        for group in groups {
            seam.close(&group, corners);
            if group.len() > 1 {
                seam.corners.push(group);
            }
        }
        seam
    }

    fn close(&mut self, group: &[u32], corners: &mut [Corner]) {
        let base = self.steps[group[0] as usize];
        for n in group.iter().map(|n| *n as usize) {
            self.firsts[n] = group[0];
            self.steps[n] = from_fn(|k| self.steps[n][k] - base[k]);
            self.is_shared[n] = group.len() > 1;
            corners[n].at = self.moved(corners[group[0] as usize].at, self.steps[n]);
        }
    }

    fn moved(&self, point: Vector3<f64>, steps: Steps) -> Vector3<f64> {
        Vector3::from_fn(|k, _| point[k] + f64::from(steps[k]) * self.periods[k])
    }

    /// Finds edges whose ends are one.
    pub(super) fn close_edges(&mut self, edges: &[Edge]) {
        let mut known = BTreeMap::<_, Vec<u32>>::new();
        self.away = vec![[0; 3]; edges.len()];
        for (edge, n) in edges.iter().zip(0..) {
            let ends = edge.ends.map(|end| end as usize);
            if ends.iter().all(|end| self.is_shared[*end]) {
                let (key, away) = self.key_of(ends);
                self.away[n as usize] = away;
                known.entry(key).or_default().push(n);
            }
        }
        self.edges = known.into_values().filter(|group| group.len() > 1).collect();
    }

    /// Corners and steps between, equal for edges that are one, and how many periods away from others it is.
    fn key_of(&self, [one, two]: [usize; 2]) -> ((u32, u32, Steps), Steps) {
        let across: Steps = from_fn(|k| self.steps[two][k] - self.steps[one][k]);
        let (back, [first, last]) = (across.map(|step| -step), [one, two].map(|n| self.firsts[n]));
        match (first, back) <= (last, across) {
            true => ((first, last, across), self.steps[one]),
            false => ((last, first, back), self.steps[two]),
        }
    }

    /// A point as it is seen from another of the edges that are one.
    pub(super) fn beyond(&self, point: Vector3<f64>, from: u32, to: u32) -> Vector3<f64> {
        if from == to {
            return point;
        }
        let [from, to] = [from, to].map(|edge| self.away[edge as usize]);
        self.moved(point, from_fn(|k| to[k] - from[k]))
    }
}

/// On which high sides each corner is, and the corners on any side.
fn rim(corners: &[Corner], periods: [f64; 3], tolerance: f64) -> (Vec<Steps>, Vec<u32>) {
    let low = corners.iter().fold(corners[0].at, |low, corner| low.inf(&corner.at));
    let (mut all, mut rim) = (Vec::with_capacity(corners.len()), Vec::new());
    for (corner, n) in corners.iter().zip(0..) {
        let off = corner.at - low;
        let repeats = |k: usize| periods[k] > 0.0;
        let steps = from_fn(|k| i32::from(repeats(k) && off[k] >= periods[k] - tolerance));
        if steps != [0; 3] || (0..3).any(|k| repeats(k) && off[k] <= 2.0 * tolerance) {
            rim.push(n);
        }
        all.push(steps);
    }
    (all, rim)
}

/// Places on the low sides, in cells that are wider than the tolerance.
struct Places {
    tolerance: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
    points: Vec<Vector3<f64>>,
    /// Of the corners there, as bits.
    sides: Vec<u8>,
}

impl Places {
    fn new(tolerance: f64) -> Self {
        Self { tolerance, cells: HashMap::new(), points: Vec::new(), sides: Vec::new() }
    }

    /// The nearest place within the tolerance that has no corner of this side yet, or else a new one.
    fn place_of(&mut self, point: Vector3<f64>, side: u8) -> usize {
        let middle: [i64; 3] = from_fn(|k| (point[k] / (4.0 * self.tolerance)).floor() as i64);
        let (mut best, mut least) = (None, self.tolerance);
        for n in 0..27 {
            let cell = [middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1];
            for place in self.cells.get(&cell).into_iter().flatten() {
                let off = (self.points[*place] - point).amax();
                if self.sides[*place] & side == 0 && off <= least {
                    (best, least) = (Some(*place), off);
                }
            }
        }
        let place = best.unwrap_or_else(|| {
            self.cells.entry(middle).or_default().push(self.points.len());
            self.points.push(point);
            self.sides.push(0);
            self.points.len() - 1
        });
        self.sides[place] |= side;
        place
    }
}
