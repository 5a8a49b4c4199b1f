//! The surface of a body near the contact point as a paraboloid (5.1), in any frame.

use std::f64::consts::TAU;

use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};

use crate::linspace;

/// `z = c p^2/2 + c' q^2/2` with p along the principal direction at `angle` from the x-axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Paraboloid {
    curvatures: [f64; 2],
    angle: f64,
}

impl Paraboloid {
    pub(super) fn new(radii: PrincipalRadii, angle: f64) -> Self {
        Self { curvatures: radii.curvatures(), angle }
    }

    /// The gap of two bodies, its larger curvature at `angle`.
    pub(super) fn gap(gap: RelativeCurvature, angle: f64) -> Self {
        Self { curvatures: [2.0 * gap.a(), 2.0 * gap.b()], angle }
    }

    pub(super) fn height(&self, x: f64, y: f64) -> f64 {
        let (s, c) = libm::sincos(self.angle);
        let (p, q) = (c * x + s * y, c * y - s * x);
        0.5 * (self.curvatures[0] * p * p + self.curvatures[1] * q * q)
    }

    /// The line of the given height, closed.
    pub(super) fn contour(&self, height: f64) -> Vec<(f64, f64)> {
        let (s, c) = libm::sincos(self.angle);
        let [p, q] = self.curvatures.map(|curvature| (2.0 * height / curvature).sqrt());
        let point = |t: f64| {
            let (p, q) = (p * libm::cos(t), q * libm::sin(t));
            (c * p - s * q, s * p + c * q)
        };
        linspace(0.0, TAU, 181).into_iter().map(point).collect()
    }
}
