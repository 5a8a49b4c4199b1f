//! The surface point closest to a given point, and the support point in a direction.

use nalgebra::{Matrix3, Vector3};

use super::least::Objective;
use super::{Kind, Surface};

/// Greatest number of iterations of a search.
const MAX_STEPS: usize = 100;

/// Distance of starts that may lead to different minima, relative to the size of the body.
const START_SPACING: f64 = 0.3;

/// A surface point, its outward normal, and the signed distance along it to the given point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Closest {
    pub(crate) point: Vector3<f64>,
    pub(crate) normal: Vector3<f64>,
    pub(crate) distance: f64,
}

/// The support point in a direction, and its derivative with respect to the direction, ds/dn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Support {
    pub(crate) point: Vector3<f64>,
    pub(crate) turning: Matrix3<f64>,
}

/// The support point of an ellipsoid in a unit direction.
pub(crate) fn support_of_ellipsoid(semi_axes: &Vector3<f64>, direction: &Vector3<f64>) -> Support {
    let squared = semi_axes.component_mul(semi_axes);
    let reach = semi_axes.component_mul(direction).norm();
    let point = squared.component_mul(direction) / reach;
    let turning = (Matrix3::from_diagonal(&squared) - point * point.transpose()) / reach;
    Support { point, turning }
}

impl Surface {
    /// The surface point closest to `from`; `None` if the search fails or the surface is known at
    /// one point only. `starts` are points of an implicit or explicit surface; other surfaces need
    /// none.
    pub(crate) fn closest(&self, from: &Vector3<f64>, starts: &[Vector3<f64>]) -> Option<Closest> {
        match self.kind() {
            Kind::Sphere { radius } => Some(around(&Vector3::zeros(), *radius, from)),
            Kind::Ellipsoid { semi_axes } => Some(closest_on_ellipsoid(semi_axes, from)),
            Kind::Plane => {
                let point = Vector3::new(from.x, from.y, 0.0);
                Some(Closest { point, normal: Vector3::z(), distance: from.z })
            }
            Kind::Cylinder { radius, half_length } => {
                Some(closest_on_cylinder(*radius, *half_length, from))
            }
            Kind::Capsule { radius, half_length } => {
                let along = from.z.clamp(-half_length, *half_length);
                Some(around(&Vector3::new(0.0, 0.0, along), *radius, from))
            }
            Kind::Torus { major, minor } => {
                let rim = libm::hypot(from.x, from.y);
                let outward = if rim > 0.0 {
                    Vector3::new(from.x / rim, from.y / rim, 0.0)
                } else {
                    Vector3::x()
                };
                Some(around(&(outward * *major), *minor, from))
            }
            Kind::Box { half } => Some(closest_on_box(half, from)),
            Kind::Implicit { .. } | Kind::Explicit { .. } => self.closest_of_some(from, starts),
            Kind::Given { .. } => None,
        }
    }

    // The closer of two minima of |p - from|: the one reached from the nearest start, and the one
    // from the nearest start on another part of the surface that may be as close.
    fn closest_of_some(&self, from: &Vector3<f64>, starts: &[Vector3<f64>]) -> Option<Closest> {
        let around = self.starts_around(from);
        let apart = START_SPACING * self.size();
        let nearest = |beyond: Option<&Vector3<f64>>| {
            let elsewhere =
                |start: &&Vector3<f64>| beyond.is_none_or(|first| (*start - first).norm() > apart);
            let distance = |start: &Vector3<f64>| (start - from).norm();
            let all = starts.iter().chain(&around).filter(elsewhere);
            all.min_by(|one, two| distance(one).total_cmp(&distance(two)))
        };
        let start = nearest(None)?;
        let first = self.closest_from(start, from);
        let reach = first.map_or(f64::INFINITY, |found| found.distance.abs() + apart);
        let second = nearest(Some(start))
            .filter(|start| (*start - from).norm() < reach)
            .and_then(|start| self.closest_from(start, from));
        let found = first.into_iter().chain(second);
        found.min_by(|one, two| one.distance.abs().total_cmp(&two.distance.abs()))
    }

    fn closest_from(&self, start: &Vector3<f64>, from: &Vector3<f64>) -> Option<Closest> {
        let scale = self.size() + from.norm();
        let half_square = |point: &Vector3<f64>| {
            let off = point - from;
            let (value, noise) = (0.5 * off.norm_squared(), 1e-15 * scale * scale);
            Some(Objective { value, gradient: off, hessian: Matrix3::identity(), noise })
        };
        let least = self.least(start, 1e-15 * scale, half_square)?;
        let (point, normal) = (least.local.point(), least.local.normal());
        let distance = (from - point).dot(&normal);
        (least.rest <= 1e-8 * scale).then_some(Closest { point, normal, distance })
    }
}

/// (M + shift I)^-1 in the plane perpendicular to the normal, zero along the normal.
pub(crate) fn invert_in_plane(
    matrix: &Matrix3<f64>,
    shift: f64,
    normal: &Vector3<f64>,
) -> Option<Matrix3<f64>> {
    let along = normal * normal.transpose();
    let plane = Matrix3::identity() - along;
    let scale = matrix.amax().max(shift.abs()).max(f64::MIN_POSITIVE);
    let full = plane * (matrix + Matrix3::identity() * shift) * plane + along * scale;
    let inverse = full.cholesky()?.inverse();
    Some(plane * inverse * plane)
}

fn around(core: &Vector3<f64>, radius: f64, from: &Vector3<f64>) -> Closest {
    let off = from - core;
    let length = off.norm();
    let normal = if length > 0.0 { off / length } else { Vector3::x() };
    Closest { point: core + normal * radius, normal, distance: length - radius }
}

fn closest_on_cylinder(radius: f64, half_length: f64, from: &Vector3<f64>) -> Closest {
    let rim = libm::hypot(from.x, from.y);
    let outward =
        if rim > 0.0 { Vector3::new(from.x / rim, from.y / rim, 0.0) } else { Vector3::x() };
    let (side, end) = (rim - radius, from.z.abs() - half_length);
    let up = Vector3::new(0.0, 0.0, from.z.signum());
    if end <= 0.0 || (side > end && side <= 0.0) {
        if side >= end {
            let point = outward * radius + Vector3::new(0.0, 0.0, from.z);
            return Closest { point, normal: outward, distance: side };
        }
        return Closest { point: from - up * end, normal: up, distance: end };
    }
    if side <= 0.0 {
        return Closest { point: from - up * end, normal: up, distance: end };
    }
    let point = outward * radius + up * half_length;
    let off = from - point;
    Closest { point, normal: off.normalize(), distance: off.norm() }
}

fn closest_on_box(half: &Vector3<f64>, from: &Vector3<f64>) -> Closest {
    let inner = from.zip_map(half, |x, h| x.clamp(-h, h));
    let off = from - inner;
    let distance = off.norm();
    if distance > 0.0 {
        return Closest { point: inner, normal: off / distance, distance };
    }
    let depth = from.abs() - half;
    let axis = depth.imax();
    let normal = Vector3::ith(axis, from[axis].signum());
    Closest { point: from - normal * depth[axis], normal, distance: depth[axis] }
}

// p = M^2 (M^2 + t)^-1 q with sum (A_i q_i/(A_i^2 + t))^2 = 1, which is convex and decreasing in t:
// Newton's iteration from below rises to the root. If no root lies above -min(A_i)^2, the point
// lies so deep on a plane of symmetry that two surface points are equally close.
fn closest_on_ellipsoid(semi_axes: &Vector3<f64>, from: &Vector3<f64>) -> Closest {
    let squared = semi_axes.component_mul(semi_axes);
    let sums = |t: f64| {
        let (mut f, mut slope) = (-1.0, 0.0);
        for i in 0..3 {
            let d = squared[i] + t;
            let part = squared[i] * from[i] * from[i] / (d * d);
            f += part;
            slope -= 2.0 * part / d;
        }
        (f, slope)
    };
    let shortest = squared.imin();
    let floor = -squared[shortest] * (1.0 - 1e-12);
    let point = if sums(floor).0 <= 0.0 {
        deep_in_ellipsoid(&squared, shortest, from)
    } else {
        let mut t = 0.0_f64;
        for _ in 0..MAX_STEPS {
            let (f, slope) = sums(t);
            let next = (t - f / slope).max(0.5 * (t + floor));
            let step = next - t;
            t = next;
            if step.abs() <= 1e-16 * (squared.min() + t.abs()) {
                break;
            }
        }
        from.zip_map(&squared, |q, s| q * s / (s + t))
    };
    let normal = point.component_div(&squared).normalize();
    Closest { point, normal, distance: (from - point).dot(&normal) }
}

// t = -min(A_i)^2: the other components as above, the shortest from the equation of the ellipsoid.
fn deep_in_ellipsoid(squared: &Vector3<f64>, shortest: usize, from: &Vector3<f64>) -> Vector3<f64> {
    let mut point = Vector3::zeros();
    let mut rest = 1.0;
    for i in (0..3).filter(|i| *i != shortest) {
        let excess = squared[i] - squared[shortest];
        if excess > 0.0 && from[i] != 0.0 {
            point[i] = from[i] * squared[i] / excess;
        }
        rest -= point[i] * point[i] / squared[i];
    }
    point[shortest] = libm::sqrt(squared[shortest] * rest.max(0.0)).copysign(from[shortest]);
    point
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The surface point at spherical angles, which need not be those of its direction.
    fn at(semi_axes: &Vector3<f64>, polar: f64, around: f64) -> Vector3<f64> {
        let ((s, c), (sin, cos)) = (libm::sincos(polar), libm::sincos(around));
        semi_axes.component_mul(&Vector3::new(s * cos, s * sin, c))
    }

    #[test]
    fn no_point_of_an_ellipsoid_is_closer_than_the_closest() {
        let inside = [[0.2, 0.1, 0.0], [0.0, 0.0, 0.0], [1.4, -0.1, 0.0], [0.3, -0.2, 0.1]];
        let outside = [[4.0, 0.0, 0.0], [1.0, -3.0, 0.5]];
        for axes in [[3.0, 2.0, 1.0], [1.0, 3.0, 2.0], [2.0, 1.0, 3.0], [2.0, 2.0, 1.0]] {
            let axes = Vector3::from(axes);
            for from in inside.into_iter().chain(outside).map(Vector3::from) {
                let found = closest_on_ellipsoid(&axes, &from);
                let on = found.point.component_div(&axes).norm_squared();
                assert!((on - 1.0).abs() < 1e-11, "{found:?} from {from:?}");
                let foot = found.point + found.normal * found.distance;
                assert!((foot - from).norm() < 1e-10, "{found:?} from {from:?}");
                let steps = (0..=200).flat_map(|i| (0..400).map(move |j| (i, j)));
                let least = steps
                    .map(|(i, j)| {
                        let [polar, around] =
                            [i, j].map(|k| f64::from(k) * 0.005 * std::f64::consts::PI);
                        (at(&axes, polar, around) - from).norm()
                    })
                    .fold(f64::INFINITY, f64::min);
                let own = found.distance.abs();
                assert!(
                    own <= least * (1.0 + 1e-12) && own > least - 2e-3,
                    "{own} {least} {from:?}"
                );
            }
        }
    }
}
