//! Small loads: spring rate, effective area, stresses per unit.

use std::f64::consts::{PI, TAU};

use super::axial::Axial;
use super::equations::jacobian;
use super::fields::{Point, Unknowns, points, samples};
use super::grid::Grid;
use super::profile::{WallPoint, profile};
use crate::Wall;
use crate::dense::{Factors, Singular};

/// The response of one corrugation to small loads.
///
/// ```
/// use carom_shells::{Wall, bellows::{Bellows, Meridian}};
/// let bellows = Bellows::new(Meridian::u_shaped(10.0, 0.5, 1.0)?, Wall::new(1.0, 0.3, 0.05)?, 32)?;
/// let response = bellows.linear_response()?;
/// // The effective area is nearly that of the mean circle, and by reciprocity dV/dDelta.
/// assert!((response.effective_area / (100.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
/// assert!((response.volume_per_dilatation / response.effective_area - 1.0).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LinearResponse {
    /// F/Delta of one corrugation without pressure; N corrugations in a row have a N-th of it.
    pub spring_rate: f64,
    /// A_e = -F/p at fixed ends: the thrust is p A_e.
    pub effective_area: f64,
    /// Growth of the enclosed volume per dilatation without pressure; equal to A_e by reciprocity.
    pub volume_per_dilatation: f64,
    /// Displacements and stresses per unit of dilatation, at the undeformed places, from crest to
    /// root.
    pub per_dilatation: Vec<WallPoint>,
    /// The same per unit of pressure at fixed ends.
    pub per_pressure: Vec<WallPoint>,
}

impl LinearResponse {
    pub(super) fn new(grid: &Grid, wall: &Wall) -> Result<Self, Singular> {
        let rest = points(grid, &Unknowns::zero(grid), 0.0);
        let jacobian = jacobian(grid, &rest, 0.0, Axial::Dilatation(0.0));
        let factors = Factors::new(&jacobian.matrix);
        let mut unit = vec![0.0; grid.unknowns()];
        unit[grid.unknowns() - 1] = 1.0;
        let stretched = Unknowns(factors.solve(&unit)?);
        let right: Vec<f64> = jacobian.by_pressure.iter().map(|value| -value).collect();
        let pressed = Unknowns(factors.solve(&right)?);
        let (t, e) = (wall.thickness(), wall.young_modulus());
        let strained = small(grid, &rest, &stretched, 0.0);
        let rate = |place: WallPoint, unit: f64| -> WallPoint {
            WallPoint {
                radial_displacement: unit * place.radial_displacement,
                rotation: unit * place.rotation,
                meridional_membrane: unit * place.meridional_membrane,
                meridional_bending: unit * place.meridional_bending,
                hoop_membrane: unit * place.hoop_membrane,
                hoop_bending: unit * place.hoop_bending,
                ..place
            }
        };
        let profile = |points: &[Point], unit: f64| -> Vec<WallPoint> {
            let places = profile(grid, wall, &rest).into_iter();
            let strained = profile(grid, wall, points).into_iter();
            let pair = places.zip(strained).map(|(place, strained)| WallPoint {
                radius: place.radius,
                height: place.height,
                ..rate(strained, unit)
            });
            pair.collect()
        };
        Ok(Self {
            spring_rate: e * t * stretched.force(),
            effective_area: -t * t * pressed.force(),
            volume_per_dilatation: t * t * volume_rate(grid, &strained),
            per_dilatation: profile(&strained, 1.0 / t),
            per_pressure: profile(&small(grid, &rest, &pressed, 1.0), 1.0 / e),
        })
    }
}

/// Strains and resultants to the first order in the unknowns and the pressure.
fn small(grid: &Grid, rest: &[Point], unknowns: &Unknowns, pressure: f64) -> Vec<Point> {
    // A point is linear in (h, u, F, p) at fixed angle; the rotation adds its own linear terms.
    let slopes: Vec<f64> =
        unknowns.beta().iter().enumerate().map(|(i, b)| (i + 1) as f64 * b).collect();
    let slope = grid.circle.cosine_sum(&[&[0.0], slopes.as_slice()].concat());
    let beta = grid.circle.sine_sum(unknowns.beta());
    let h = grid.circle.sine_sum(unknowns.h());
    let u = grid.circle.cosine_sum(unknowns.u());
    let nu = grid.poisson;
    let at = |(j, rest): (usize, &Point)| {
        let v = 0.5 * pressure * rest.r0 * rest.r0 + unknowns.force() / TAU;
        let along = h[j] * rest.c + v * rest.s;
        let (kappa_s, kappa_t) = (slope[j] / rest.g, beta[j] * rest.c / rest.r0);
        Point {
            beta: beta[j],
            ds: beta[j] * rest.c,
            dc: -beta[j] * rest.s,
            u: u[j],
            v,
            along,
            across: h[j] * rest.s - v * rest.c,
            strain: along / (rest.r0 * grid.stretching) - nu * u[j] / rest.r0,
            kappa_s,
            kappa_t,
            n_t: (nu * along + u[j]) / rest.r0,
            m_s: grid.bending * (kappa_s + nu * kappa_t),
            m_t: grid.bending * (kappa_t + nu * kappa_s),
            ..*rest
        }
    };
    rest.iter().enumerate().map(at).collect()
}

/// First order of the volume, pi times the integral of r^2 dz.
fn volume_rate(grid: &Grid, points: &[Point]) -> f64 {
    let rate = |at: &Point| at.r0 * (2.0 * at.u * at.s + at.r0 * (at.strain * at.s + at.ds)) * at.g;
    PI * TAU * grid.circle.mean(&samples(points, rate))
}
