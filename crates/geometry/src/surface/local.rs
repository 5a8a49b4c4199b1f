//! Normal, principal curvatures and principal directions of a surface at a point (8.6)-(8.24).

use nalgebra::{Matrix3, Vector3};

use crate::attitude::Attitude;
use crate::direction::perpendicular;

/// The point is an umbilic if the principal curvatures differ by less than this, relative to their
/// size.
const UMBILIC: f64 = 1e-13;

/// The second-order shape of a surface at one of its points: `z = (k_1 x^2 + k_2 y^2)/2` along the
/// inward normal (8.6), in the principal axes (8.11).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalSurface {
    point: Vector3<f64>,
    normal: Vector3<f64>,
    curvatures: [f64; 2],
    direction: Vector3<f64>,
}

impl LocalSurface {
    /// From the curvature tensor, positive where the surface is convex: the tangential part of
    /// hessian/|gradient| of a function that increases outwards. The normal part is ignored.
    pub(crate) fn from_tensor(
        point: Vector3<f64>,
        normal: Vector3<f64>,
        tensor: &Matrix3<f64>,
    ) -> Self {
        let one = perpendicular(&normal);
        let two = normal.cross(&one);
        let (image_1, image_2) = (tensor * one, tensor * two);
        let (p, q) = (one.dot(&image_1), two.dot(&image_2));
        let r = 0.5 * (one.dot(&image_2) + two.dot(&image_1));
        // gamma = atan2(2 k_xy, k_x - k_y)/2, the robust form of (8.19), (8.24).
        let half = 0.5 * libm::hypot(p - q, 2.0 * r);
        let angle = 0.5 * libm::atan2(2.0 * r, p - q);
        let mean = 0.5 * (p + q);
        let (sin, cos) = libm::sincos(angle);
        // First the curvature that is computed without cancellation, the other from the
        // determinant.
        let determinant = p * q - r * r;
        let large = mean + half.copysign(mean);
        let other = if large == 0.0 { 0.0 } else { determinant / large };
        let curvatures = if mean >= 0.0 { [large, other] } else { [other, large] };
        Self::new(point, normal, curvatures, one * cos + two * sin)
    }

    /// From the principal curvatures and the principal direction of the first.
    pub(crate) fn new(
        point: Vector3<f64>,
        normal: Vector3<f64>,
        curvatures: [f64; 2],
        direction: Vector3<f64>,
    ) -> Self {
        if curvatures[0] >= curvatures[1] {
            return Self { point, normal, curvatures, direction };
        }
        let [small, large] = curvatures;
        Self { point, normal, curvatures: [large, small], direction: normal.cross(&direction) }
    }

    /// At a point of a sphere or plane.
    pub(crate) fn umbilic(point: Vector3<f64>, normal: Vector3<f64>, curvature: f64) -> Self {
        Self { point, normal, curvatures: [curvature; 2], direction: perpendicular(&normal) }
    }

    /// The point.
    #[must_use]
    pub const fn point(&self) -> Vector3<f64> {
        self.point
    }

    /// The outward unit normal.
    #[must_use]
    pub const fn normal(&self) -> Vector3<f64> {
        self.normal
    }

    /// The principal curvatures, the larger first; positive where the surface is convex.
    #[must_use]
    pub const fn curvatures(&self) -> [f64; 2] {
        self.curvatures
    }

    /// Unit vector along the direction of the larger curvature; any tangent at an umbilic.
    #[must_use]
    pub const fn direction(&self) -> Vector3<f64> {
        self.direction
    }

    /// Unit vector along the direction of the smaller curvature, `normal x direction`.
    #[must_use]
    pub fn direction_across(&self) -> Vector3<f64> {
        self.normal.cross(&self.direction)
    }

    /// Whether both curvatures are equal (to 1e-13), so that every direction is principal.
    #[must_use]
    pub fn is_umbilic(&self) -> bool {
        let [k_1, k_2] = self.curvatures;
        k_1 - k_2 <= UMBILIC * k_1.abs().max(k_2.abs())
    }

    /// The shape operator in space: maps a tangent vector to the derivative of the outward normal
    /// along it.
    #[must_use]
    pub fn shape_operator(&self) -> Matrix3<f64> {
        let (one, two) = (self.direction, self.direction_across());
        let [k_1, k_2] = self.curvatures;
        one * one.transpose() * k_1 + two * two.transpose() * k_2
    }

    /// The same in the axes of space, for a body with this centre and attitude.
    #[must_use]
    pub fn placed(&self, centre: &Vector3<f64>, attitude: &Attitude) -> Self {
        Self {
            point: centre + attitude.to_space(&self.point),
            normal: attitude.to_space(&self.normal),
            curvatures: self.curvatures,
            direction: attitude.to_space(&self.direction),
        }
    }
}
