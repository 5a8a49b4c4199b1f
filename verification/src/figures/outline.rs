//! Closed curves.

use std::f64::consts::TAU;

use crate::linspace;

/// An ellipse of so many pieces about a centre.
pub(super) fn ellipse(centre: [f64; 2], semi_axes: [f64; 2], pieces: usize) -> Vec<(f64, f64)> {
    let at = |angle: f64| {
        let (sin, cos) = libm::sincos(angle);
        (centre[0] + semi_axes[0] * cos, centre[1] + semi_axes[1] * sin)
    };
    linspace(0.0, TAU, pieces + 1).into_iter().map(at).collect()
}

/// A circle of 180 pieces.
pub(super) fn circle(centre: [f64; 2], radius: f64) -> Vec<(f64, f64)> {
    ellipse(centre, [radius; 2], 180)
}
