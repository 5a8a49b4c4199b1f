//! The flat faces, straight sides and edges of cylinders, boxes and planes.

use nalgebra::Vector3;
use std::f64::consts::PI;

use super::scan::{Curve, Rail};
use super::touch::{Nearest, Touch};
use crate::direction::perpendicular;
use crate::placed::Placed;
use crate::surface::Kind;

/// Faces at a smaller angle than this touch over an area, radians.
const PARALLEL: f64 = 1e-7;

/// Greatest number of alternating projections between two overlapping faces.
const MOST_PROJECTIONS: usize = 40;

/// The extent of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Outline {
    Endless,
    Disc(f64),
    Rectangle { axes: [Vector3<f64>; 2], half: [f64; 2] },
}

/// A flat part of a surface, in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Face {
    pub(super) centre: Vector3<f64>,
    pub(super) normal: Vector3<f64>,
    outline: Outline,
    /// Thickness of the body behind it.
    depth: f64,
}

impl Face {
    /// The point of the face closest to a point.
    fn clamp(&self, point: &Vector3<f64>) -> Vector3<f64> {
        let off = point - self.centre;
        let flat = off - self.normal * self.normal.dot(&off);
        let within = match self.outline {
            Outline::Endless => flat,
            Outline::Disc(radius) => flat * (radius / flat.norm().max(radius)),
            Outline::Rectangle { axes, half } => {
                let part = |i: usize| axes[i] * axes[i].dot(&flat).clamp(-half[i], half[i]);
                part(0) + part(1)
            }
        };
        self.centre + within
    }

    /// Distance of a point from the face, parallel to it.
    pub(super) fn beside(&self, point: &Vector3<f64>) -> f64 {
        let foot = point - self.normal * self.normal.dot(&(point - self.centre));
        (self.clamp(&foot) - foot).norm()
    }

    /// Sample points of a bounded face.
    pub(super) fn spots(&self) -> Vec<Vector3<f64>> {
        match self.outline {
            Outline::Endless => Vec::new(),
            Outline::Disc(radius) => {
                let one = perpendicular(&self.normal);
                let two = self.normal.cross(&one);
                let ring = (0..6).map(|i| {
                    let (sin, cos) = libm::sincos(f64::from(i) * PI / 3.0);
                    self.centre + (one * cos + two * sin) * (0.7 * radius)
                });
                ring.chain([self.centre]).collect()
            }
            Outline::Rectangle { axes, half } => {
                let thirds = [-2.0 / 3.0, 0.0, 2.0 / 3.0];
                let at = |u: f64, v: f64| axes[0] * (u * half[0]) + axes[1] * (v * half[1]);
                thirds.iter().flat_map(|u| thirds.map(|v| self.centre + at(*u, v))).collect()
            }
        }
    }

    /// The nearest point of another body relative to this face, above or below it.
    pub(super) fn under(&self, point: &Vector3<f64>) -> Touch {
        let gap = self.normal.dot(&(point - self.centre));
        let foot = point - self.normal * gap;
        let slack = 1e-12 * (self.centre.norm() + point.norm());
        let within = gap > -self.depth && self.beside(point) <= slack;
        Touch { near: Nearest { points: [foot, *point], gap }, within }
    }

    /// Two parallel faces that overlap.
    pub(super) fn onto(&self, other: &Self) -> Option<Touch> {
        if (self.normal + other.normal).norm() > PARALLEL {
            return None;
        }
        let mut point = other.clamp(&self.centre);
        for _ in 0..MOST_PROJECTIONS {
            point = other.clamp(&self.clamp(&point));
        }
        Some(self.under(&point))
    }
}

/// The faces of a body.
pub(super) fn faces(body: &Placed) -> Vec<Face> {
    let at = |centre: Vector3<f64>, normal: Vector3<f64>, outline: Outline, depth: f64| Face {
        centre: body.space_point(&centre),
        normal: body.attitude().to_space(&normal),
        outline,
        depth,
    };
    match body.surface().kind() {
        Kind::Plane => {
            vec![at(Vector3::zeros(), Vector3::z(), Outline::Endless, f64::INFINITY)]
        }
        Kind::Cylinder { radius, half_length } => [1.0, -1.0]
            .map(|sign| {
                let normal = Vector3::z() * sign;
                at(normal * *half_length, normal, Outline::Disc(*radius), 2.0 * half_length)
            })
            .to_vec(),
        Kind::Box { half } => sides()
            .map(|(axis, sign)| {
                let normal = Vector3::ith(axis, sign);
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let axes = [i, j].map(|i| body.attitude().to_space(&Vector3::ith(i, 1.0)));
                let outline = Outline::Rectangle { axes, half: [half[i], half[j]] };
                at(normal * half[axis], normal, outline, 2.0 * half[axis])
            })
            .collect(),
        _ => Vec::new(),
    }
}

/// The curved side of a cylinder, as a curve swept by a ball.
pub(super) fn side<'a>(body: &'a Placed) -> Option<Rail<'a>> {
    match body.surface().kind() {
        Kind::Cylinder { radius, half_length } => {
            Some(Rail { body, curve: Curve::axis(*half_length), radius: *radius })
        }
        _ => None,
    }
}

/// A body that is swept by a ball: sphere, capsule, torus.
pub(super) fn swept<'a>(body: &'a Placed) -> Option<Rail<'a>> {
    let (curve, radius) = match body.surface().kind() {
        Kind::Sphere { radius } => (Curve::axis(0.0), *radius),
        Kind::Capsule { radius, half_length } => (Curve::axis(*half_length), *radius),
        Kind::Torus { major, minor } => (Curve::Round { height: 0.0, radius: *major }, *minor),
        _ => return None,
    };
    Some(Rail { body, curve, radius })
}

/// The edges of a body, with the corners as their ends.
pub(super) fn edges<'a>(body: &'a Placed) -> Vec<Rail<'a>> {
    let curves = match body.surface().kind() {
        Kind::Cylinder { radius, half_length } => [1.0, -1.0]
            .map(|sign| Curve::Round { height: sign * half_length, radius: *radius })
            .to_vec(),
        Kind::Box { half } => (0..3)
            .flat_map(|axis| {
                [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|s| (axis, s))
            })
            .map(|(axis, signs)| {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let middle =
                    Vector3::ith(i, signs[0] * half[i]) + Vector3::ith(j, signs[1] * half[j]);
                let along = Vector3::ith(axis, 1.0);
                Curve::Straight { middle, along, half_length: half[axis] }
            })
            .collect(),
        _ => Vec::new(),
    };
    curves.into_iter().map(|curve| Rail { body, curve, radius: 0.0 }).collect()
}

fn sides() -> impl Iterator<Item = (usize, f64)> {
    (0..3).flat_map(|axis| [(axis, 1.0), (axis, -1.0)])
}
