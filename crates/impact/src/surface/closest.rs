//! The point of a surface closest to a given one, and the one farthest in a direction.

use nalgebra::{Matrix3, Vector3};

use super::evaluate::ellipsoid;
use super::{Kind, Surface};

/// Iterations after which a search gives up.
const MAX_STEPS: usize = 100;

/// A surface point, the outward normal and the signed distance along it to the point asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Closest {
    pub(crate) point: Vector3<f64>,
    pub(crate) normal: Vector3<f64>,
    pub(crate) distance: f64,
}

/// The farthest point in a direction and how it moves when the direction turns: ds/dn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Support {
    pub(crate) point: Vector3<f64>,
    pub(crate) turning: Matrix3<f64>,
}

impl Surface {
    /// The surface point closest to `from`; none if the search fails or the surface is known at
    /// one point only.
    pub(crate) fn closest(&self, from: &Vector3<f64>) -> Option<Closest> {
        match self.kind() {
            Kind::Sphere { radius } => Some(around(&Vector3::zeros(), *radius, from)),
            Kind::Ellipsoid { semi_axes } => closest_on_ellipsoid(semi_axes, from),
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
            Kind::Implicit { .. } | Kind::Explicit { .. } => self.closest_by_newton(from),
            Kind::Given { .. } => None,
        }
    }

    /// The farthest point in the unit direction, of smooth convex surfaces and the torus.
    pub(crate) fn support(&self, direction: &Vector3<f64>) -> Option<Support> {
        match self.kind() {
            Kind::Sphere { radius } => {
                Some(Support { point: direction * *radius, turning: Matrix3::identity() * *radius })
            }
            Kind::Ellipsoid { semi_axes } => {
                let squared = semi_axes.component_mul(semi_axes);
                let reach = semi_axes.component_mul(direction).norm();
                let point = squared.component_mul(direction) / reach;
                let turning =
                    (Matrix3::from_diagonal(&squared) - point * point.transpose()) / reach;
                Some(Support { point, turning })
            }
            Kind::Torus { major, minor } => {
                let flat = Vector3::new(direction.x, direction.y, 0.0);
                let outward = flat.try_normalize(0.0).unwrap_or(Vector3::x());
                let point = outward * *major + direction * *minor;
                Some(Support { point, turning: Matrix3::identity() * *minor })
            }
            Kind::Implicit { size, .. } => self.support_by_newton(direction, *size),
            _ => None,
        }
    }

    /// The straight core segment's half-length and the radius around it, along axis c.
    pub(crate) fn core(&self) -> Option<(f64, f64)> {
        match self.kind() {
            Kind::Sphere { radius } => Some((0.0, *radius)),
            Kind::Capsule { radius, half_length } | Kind::Cylinder { radius, half_length } => {
                Some((*half_length, *radius))
            }
            _ => None,
        }
    }

    // Alternates a step to the tangent plane with one along it, until the normal points at `from`.
    fn closest_by_newton(&self, from: &Vector3<f64>) -> Option<Closest> {
        let mut point = self.descend(from)?;
        let tight = 1e-14 * (self.size() + from.norm());
        for _ in 0..MAX_STEPS {
            let local = self.local(&point).ok()?;
            let normal = local.normal();
            let off = from - point;
            let distance = off.dot(&normal);
            let tangent = off - normal * distance;
            if tangent.norm() <= tight {
                return Some(Closest { point, normal, distance });
            }
            // d(tangent)/d(point) = -(I + distance * S) in the tangent plane.
            let step = tangent_solve(&local.shape_operator(), distance, &normal, &tangent)?;
            let limited = step * (0.3 * self.size() / step.norm()).min(1.0);
            point = self.descend(&(point + limited))?;
        }
        None
    }

    // Newton's iteration for f = 0 along the gradient.
    fn descend(&self, from: &Vector3<f64>) -> Option<Vector3<f64>> {
        let mut point = *from;
        for _ in 0..MAX_STEPS {
            let (value, gradient) = self.value_and_gradient(&point)?;
            let step = gradient * (value / gradient.norm_squared());
            if !step.norm().is_finite() {
                return None;
            }
            point -= step * (0.5 * self.size() / step.norm().max(f64::MIN_POSITIVE)).min(1.0);
            if step.norm() <= 1e-14 * self.size() {
                return Some(point);
            }
        }
        // Rounding may keep the last digits moving.
        self.local(&point).is_ok().then_some(point)
    }

    fn value_and_gradient(&self, point: &Vector3<f64>) -> Option<(f64, Vector3<f64>)> {
        match self.kind() {
            Kind::Implicit { function, .. } => {
                let jet = function.at(point);
                Some((jet.value, jet.gradient))
            }
            Kind::Explicit { function, side, .. } => {
                let height = function.at(&[point.x, point.y]);
                let sign = if *side == super::Side::Above { 1.0 } else { -1.0 };
                let gradient = Vector3::new(height.c_a, height.c_b, -1.0);
                Some((sign * (height.c - point.z), gradient * sign))
            }
            Kind::Ellipsoid { semi_axes } => {
                let jet = ellipsoid(semi_axes, point);
                Some((jet.value, jet.gradient))
            }
            _ => None,
        }
    }

    fn support_by_newton(&self, direction: &Vector3<f64>, size: f64) -> Option<Support> {
        let mut point = self.descend(&(direction * size))?;
        for _ in 0..MAX_STEPS {
            let local = self.local(&point).ok()?;
            let normal = local.normal();
            let shape = local.shape_operator();
            let lack = direction - normal * normal.dot(direction);
            if lack.norm() <= 1e-13 && normal.dot(direction) > 0.0 {
                let turning = invert_in_plane(&shape, 0.0, &normal)?;
                return Some(Support { point, turning });
            }
            let step = tangent_solve_curved(&shape, &normal, &lack)?;
            let limited = step * (0.3 * size / step.norm()).min(1.0);
            point = self.descend(&(point + limited))?;
        }
        None
    }
}

// (I + distance S)^-1 tangent in the tangent plane.
fn tangent_solve(
    shape: &Matrix3<f64>,
    distance: f64,
    normal: &Vector3<f64>,
    tangent: &Vector3<f64>,
) -> Option<Vector3<f64>> {
    let matrix = Matrix3::identity() + shape * distance.max(0.0) + normal * normal.transpose();
    matrix.cholesky().map(|factor| factor.solve(tangent))
}

fn tangent_solve_curved(
    shape: &Matrix3<f64>,
    normal: &Vector3<f64>,
    lack: &Vector3<f64>,
) -> Option<Vector3<f64>> {
    Some(invert_in_plane(shape, 0.0, normal)? * lack)
}

/// (M + shift I)^-1 in the plane at right angles to the normal, zero along it.
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

// p = M^2 (M^2 + t)^-1 q with sum (A_i q_i/(A_i^2 + t))^2 = 1: convex and falling in t, so that
// Newton's iteration from below the root rises to it.
fn closest_on_ellipsoid(semi_axes: &Vector3<f64>, from: &Vector3<f64>) -> Option<Closest> {
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
    if from.norm() == 0.0 {
        return None;
    }
    let floor = -squared.min() * (1.0 - 1e-12);
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
    let point = from.zip_map(&squared, |q, s| q * s / (s + t));
    let normal = point.component_div(&squared).normalize();
    Some(Closest { point, normal, distance: (from - point).dot(&normal) })
}
