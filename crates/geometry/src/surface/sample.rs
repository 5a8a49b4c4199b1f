//! Sample points of a surface, used as starts of a search.

use nalgebra::Vector3;
use std::f64::consts::PI;

use super::jet::Source;
use super::{Kind, Surface};

/// Number of rays from the origin of a body.
const RAYS: u32 = 162;

/// Steps along a ray; their lengths grow by a constant factor.
const RAY_STEPS: i32 = 60;
const RAY_GROWTH: f64 = 1.08;

/// First point of a ray relative to the size; the last one lies at four sizes.
const RAY_START: f64 = 0.043;

/// Range of a and b in which an explicit surface is sampled, relative to its size, and lines along
/// each.
const SAMPLED_RANGE: f64 = 2.0;
const LINES: i32 = 12;

impl Surface {
    /// Points of an ellipsoid or implicit surface on rays from the origin, and of an explicit
    /// surface on a square of four sizes; none for other surfaces.
    pub(crate) fn starts(&self) -> Vec<Vector3<f64>> {
        match self.kind() {
            Kind::Ellipsoid { semi_axes } => {
                directions().map(|ray| ray.component_mul(semi_axes)).collect()
            }
            Kind::Implicit { size, function } => {
                directions().flat_map(|ray| crossings(function, &ray, *size)).collect()
            }
            Kind::Explicit { size, .. } => {
                let step = SAMPLED_RANGE * size / f64::from(LINES);
                let at = |i: i32| f64::from(i) * step;
                let square = (-LINES..=LINES).flat_map(|i| (-LINES..=LINES).map(move |j| (i, j)));
                square.filter_map(|(i, j)| self.above(at(i), at(j))).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Points of an explicit surface that may be close: straight along c, and on two rings no wider
    /// than that distance.
    pub(super) fn starts_around(&self, from: &Vector3<f64>) -> Vec<Vector3<f64>> {
        let Some(foot) = self.above(from.x, from.y) else { return Vec::new() };
        let reach = (from.z - foot.z).abs();
        let ring = |share: f64| {
            (0..8).filter_map(move |i| {
                let (sin, cos) = libm::sincos(f64::from(i) * PI / 4.0);
                let radius = share * reach;
                self.above(from.x + radius * cos, from.y + radius * sin)
            })
        };
        std::iter::once(foot).chain(ring(0.4)).chain(ring(0.9)).collect()
    }

    fn above(&self, a: f64, b: f64) -> Option<Vector3<f64>> {
        let Kind::Explicit { function, .. } = self.kind() else { return None };
        let c = function.value(&Vector3::new(a, b, 0.0));
        c.is_finite().then(|| Vector3::new(a, b, c))
    }
}

// Where f changes sign along a ray.
fn crossings(function: &Source, ray: &Vector3<f64>, size: f64) -> Vec<Vector3<f64>> {
    let mut found = Vec::new();
    let mut last = (0.0, function.value(&Vector3::zeros()));
    for i in 0..RAY_STEPS {
        let t = RAY_START * size * libm::pow(RAY_GROWTH, f64::from(i));
        let now = (t, function.value(&(ray * t)));
        if last.1 * now.1 <= 0.0 && last.1 != now.1 {
            found.push(ray * (last.0 + (now.0 - last.0) * last.1 / (last.1 - now.1)));
        }
        last = now;
    }
    found
}

// Uniform on the sphere, by the golden angle; no direction lies exactly on a plane of symmetry.
fn directions() -> impl Iterator<Item = Vector3<f64>> {
    let golden = PI * (3.0 - libm::sqrt(5.0));
    (0..RAYS).map(move |i| {
        let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(RAYS);
        let (sin, cos) = libm::sincos(golden * f64::from(i));
        let rim = libm::sqrt(1.0 - z * z);
        Vector3::new(rim * cos, rim * sin, z)
    })
}
