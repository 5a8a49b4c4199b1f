//! Errors in evaluating a surface at a point.

use carom_special::RangeError;

/// Why a surface has no normal or no curvature at a point.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SurfaceError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The point does not lie on the surface.
    #[error(
        "the point ({}, {}, {}) lies {distance:e} off the surface, more than {allowed:e}",
        point[0], point[1], point[2]
    )]
    OffSurface {
        /// The point, in the axes of the body.
        point: [f64; 3],
        /// Signed distance, positive outside the body (to first order).
        distance: f64,
        /// The distance allowed.
        allowed: f64,
    },
    /// The point lies on an edge, where there is no tangent plane.
    #[error("the point lies on {part}: no tangent plane there, so no elliptical contact")]
    Edge {
        /// The part of the surface.
        part: &'static str,
    },
    /// The curvature jumps at the point.
    #[error("the curvature jumps at {part}: the contact there is not elliptical")]
    Seam {
        /// The part of the surface.
        part: &'static str,
    },
    /// The gradient of an implicit surface vanishes at the point.
    #[error("the gradient vanishes at ({}, {}, {}): no normal there", point[0], point[1], point[2])]
    Singular {
        /// The point, in the axes of the body.
        point: [f64; 3],
    },
    /// The interior of this kind of surface is not defined.
    #[error("the interior of this surface is not defined: give mass and moments of inertia")]
    NoInertia,
}
