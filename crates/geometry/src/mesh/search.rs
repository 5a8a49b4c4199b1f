//! The places where a ball touches a mesh.

use std::mem::replace;

use carom_special::RangeError;
use nalgebra::Vector3;

use super::{FAR, TriangleMesh};

/// How far beyond its rim a face still counts, over the reach of a search, so that no ball falls between two triangles.
const SLACK: f64 = 1e-9;
/// The reach of a search in periods, at most.
const PERIODS: f64 = 10.0;
/// A centre further away has lost its digits, in periods.
const AWAY: f64 = 1e9;

/// What of a mesh a ball touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The inside of a face.
    Face,
    /// An edge between its ends.
    Edge,
    /// A corner.
    Corner,
}

/// A place where a ball touches a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The point of the surface.
    pub point: Vector3<f64>,
    /// The unit normal from there to the centre of the ball.
    pub normal: Vector3<f64>,
    /// Of the centre from the point.
    pub distance: f64,
    /// What is touched.
    pub part: Part,
    /// Which one, from 0; of a face the triangle.
    pub number: u32,
    /// Whether it is an edge or a corner where triangles meet at more than the smooth angle, or end.
    pub is_sharp: bool,
    /// How far the touched copy of a surface that repeats itself is from the given triangles; else zero.
    pub shift: Vector3<f64>,
}

impl Place {
    /// The nearer one is before, at the same height faces before edges, these before corners.
    fn is_before(&self, other: &Self, slack: f64) -> bool {
        if (self.distance - other.distance).abs() > slack {
            return self.distance < other.distance;
        }
        self.part < other.part
    }
}

/// The work memory of searches, of one thread, in any meshes.
#[derive(Debug, Clone, Default)]
pub struct Search {
    /// What was seen in a search has its number.
    number: u32,
    faces: Vec<u32>,
    edges: Vec<u32>,
    corners: Vec<u32>,
    close: Vec<u32>,
    found: Vec<Place>,
    places: Vec<Place>,
}

/// A ball, carried to the given triangles.
struct Ball {
    center: Vector3<f64>,
    reach: f64,
    shift: Vector3<f64>,
}

impl TriangleMesh {
    /// The places where a ball with this centre touches the surface whose distance is at most `reach`: faces in the order
    /// of the triangles, then edges, then corners.
    ///
    /// # Errors
    /// [`RangeError`] unless the centre is finite and `reach` is above 0 and below 1e50; where the surface repeats itself
    /// the centre may be 1e9 periods away and `reach` ten periods.
    #[inline]
    pub fn places<'a>(
        &self,
        center: Vector3<f64>,
        reach: f64,
        search: &'a mut Search,
    ) -> Result<&'a [Place], RangeError> {
        for x in center.iter() {
            RangeError::finite("center", *x)?;
        }
        RangeError::check("reach", reach, reach > 0.0 && reach < FAR, "> 0 and below 1e50")?;
        search.found.clear();
        search.places.clear();
        if self.repeats() {
            self.find_in_all_periods(center, reach, search)?;
        } else {
            self.find(&Ball { center, reach, shift: Vector3::zeros() }, search);
        }
        search.select(self.cosine, SLACK * reach);
        Ok(&search.places)
    }

    /// Where the surface is the same as a period further, the ball is carried there and the places back.
    fn find_in_all_periods(
        &self,
        center: Vector3<f64>,
        reach: f64,
        search: &mut Search,
    ) -> Result<(), RangeError> {
        let (mut first, mut last) = (Vector3::zeros(), Vector3::zeros());
        for k in (0..3).filter(|k| self.periods[*k] > 0.0) {
            let period = self.periods[k];
            RangeError::check("reach", reach, reach <= PERIODS * period, "at most ten periods")?;
            let is_close = center[k].abs() <= AWAY * period;
            RangeError::check("center", center[k], is_close, "at most 1e9 periods away")?;
            first[k] = ((center[k] - reach - self.cells.high[k]) / period).ceil();
            last[k] = ((center[k] + reach - self.cells.low[k]) / period).floor();
        }
        for z in steps(first[2], last[2]) {
            for y in steps(first[1], last[1]) {
                for x in steps(first[0], last[0]) {
                    let [a, b, c] = self.periods;
                    let shift = Vector3::new(x * a, y * b, z * c);
                    self.find(&Ball { center: center - shift, reach, shift }, search);
                }
            }
        }
        Ok(())
    }

    fn find(&self, ball: &Ball, search: &mut Search) {
        search.begin(self);
        let Search { number, faces, close, .. } = search;
        self.cells.each_near(&ball.center, ball.reach, |face| {
            if replace(&mut faces[face as usize], *number) != *number {
                close.push(face);
            }
        });
        close.sort_unstable();
        for n in 0..search.close.len() {
            self.try_face(search.close[n], ball, search);
        }
    }

    fn try_face(&self, number: u32, ball: &Ball, search: &mut Search) {
        let face = &self.faces[number as usize];
        let height = (ball.center - face.point).dot(&face.normal);
        if height.abs() > ball.reach {
            return;
        }
        let mut is_within = true;
        for k in 0..3 {
            let (edge, corner) = (face.edges[k], face.corners[k]);
            let arm = ball.center - self.corners[corner as usize].at;
            is_within &= arm.dot(&face.inward[k]) >= -SLACK * ball.reach;
            if search.is_new_edge(edge) && !self.edges[edge as usize].is_flat {
                self.try_edge(edge, ball, search);
            }
            if search.is_new_corner(corner) {
                self.try_corner(corner, ball, search);
            }
        }
        if is_within {
            let sign = if height < 0.0 { -1.0 } else { 1.0 };
            let point = ball.center - height * face.normal;
            search.take(
                (Part::Face, number, false),
                ball,
                (point, sign * face.normal, sign * height),
            );
        }
    }

    fn try_edge(&self, number: u32, ball: &Ball, search: &mut Search) {
        let edge = &self.edges[number as usize];
        let arm = ball.center - self.corners[edge.ends[0] as usize].at;
        let (foot, slack) = (arm.dot(&edge.along), SLACK * ball.reach);
        if foot < -slack || foot > edge.length + slack {
            return;
        }
        let arm = arm - foot * edge.along;
        if self.inward.of(number).iter().any(|inward| arm.dot(inward) > 0.0) {
            return;
        }
        let height = arm.dot(&arm).sqrt();
        if height > 0.0 && height <= ball.reach {
            let part = (Part::Edge, number, edge.is_sharp);
            search.take(part, ball, (ball.center - arm, arm / height, height));
        }
    }

    fn try_corner(&self, number: u32, ball: &Ball, search: &mut Search) {
        let corner = &self.corners[number as usize];
        let arm = ball.center - corner.at;
        let height = arm.dot(&arm).sqrt();
        if height > 0.0
            && height <= ball.reach
            && self.along.of(number).iter().all(|along| arm.dot(along) <= 0.0)
        {
            let part = (Part::Corner, number, corner.is_sharp);
            search.take(part, ball, (corner.at, arm / height, height));
        }
    }
}

impl Search {
    fn begin(&mut self, mesh: &TriangleMesh) {
        self.close.clear();
        self.number = self.number.wrapping_add(1);
        let counts = [mesh.faces.len(), mesh.edges.len(), mesh.corners.len()];
        for (seen, count) in
            [&mut self.faces, &mut self.edges, &mut self.corners].into_iter().zip(counts)
        {
            if self.number == 0 {
                seen.fill(0);
            }
            if seen.len() < count {
                seen.resize(count, 0);
            }
        }
        self.number = self.number.max(1);
    }

    fn is_new_edge(&mut self, edge: u32) -> bool {
        replace(&mut self.edges[edge as usize], self.number) != self.number
    }

    fn is_new_corner(&mut self, corner: u32) -> bool {
        replace(&mut self.corners[corner as usize], self.number) != self.number
    }

    fn take(
        &mut self,
        (part, number, is_sharp): (Part, u32, bool),
        ball: &Ball,
        (point, normal, distance): (Vector3<f64>, Vector3<f64>, f64),
    ) {
        let (shift, point) = (ball.shift, point + ball.shift);
        self.found.push(Place { point, normal, distance, part, number, is_sharp, shift });
    }

    /// Of places whose normals nearly agree the first.
    fn select(&mut self, cosine: f64, slack: f64) {
        while !self.found.is_empty() {
            let mut best = 0;
            for (n, place) in self.found.iter().enumerate() {
                if place.is_before(&self.found[best], slack) {
                    best = n;
                }
            }
            let chosen = self.found.remove(best);
            self.found.retain(|place| place.normal.dot(&chosen.normal) < cosine);
            self.places.push(chosen);
        }
        // A stable sort that allocates nothing.
        let key = |place: &Place| (place.part, place.number);
        for i in 1..self.places.len() {
            let own = key(&self.places[i]);
            let to = self.places[..i].partition_point(|place| key(place) <= own);
            self.places[to..=i].rotate_right(1);
        }
    }
}

/// Whole numbers from one to another.
fn steps(first: f64, last: f64) -> impl Iterator<Item = f64> {
    let count = if first <= last { (last - first) as u32 + 1 } else { 0 };
    (0..count).map(move |n| first + f64::from(n))
}
