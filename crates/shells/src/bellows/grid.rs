//! The undeformed meridian at sample points, in units of the thickness.

use super::meridian::{Meridian, MeridianPoint};
use crate::Wall;
use crate::fourier::HalfCircle;

/// Samples per harmonic around a smooth meridian, and where curvature jumps.
const SMOOTH: usize = 4;
const JUMPING: usize = 32;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    pub(super) circle: HalfCircle,
    pub(super) harmonics: usize,
    pub(super) places: Vec<MeridianPoint>,
    /// Sine and cosine of phi0.
    pub(super) sines: Vec<f64>,
    pub(super) cosines: Vec<f64>,
    pub(super) is_closed: bool,
    pub(super) poisson: f64,
    /// C/(E t) and D/(E t^3).
    pub(super) stretching: f64,
    pub(super) bending: f64,
}

impl Grid {
    pub(super) fn new(meridian: &Meridian, wall: &Wall, harmonics: usize) -> Self {
        let per_harmonic = if meridian.is_smooth() { SMOOTH } else { JUMPING };
        let circle = HalfCircle::new((per_harmonic * harmonics).max(32)); // a multiple of 4
        let unit = 1.0 / wall.thickness();
        let count = circle.count();
        let place = |j: usize| {
            let place =
                meridian.at(if j + 1 == count { std::f64::consts::PI } else { circle.angle(j) });
            MeridianPoint {
                radius: unit * place.radius,
                height: unit * place.height,
                speed: unit * place.speed,
                ..place
            }
        };
        let places: Vec<_> = (0..count).map(place).collect();
        let stretching = 1.0 / (1.0 - wall.poisson() * wall.poisson());
        Self {
            sines: places.iter().map(|place| libm::sin(place.angle)).collect(),
            cosines: places.iter().map(|place| libm::cos(place.angle)).collect(),
            circle,
            harmonics,
            places,
            is_closed: meridian.is_closed(),
            poisson: wall.poisson(),
            stretching,
            bending: stretching / 12.0,
        }
    }

    /// Number of coefficients of beta, h and u, and the force.
    pub(super) const fn unknowns(&self) -> usize {
        3 * self.harmonics + 2
    }
}
