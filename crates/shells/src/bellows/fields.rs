//! Strains and resultants at the sample points, in the units E = t = 1.

use std::f64::consts::{PI, TAU};

use super::grid::Grid;

/// The unknowns: coefficients of beta (sin 1 to n), h (sin 1 to n), u (cos 0 to n), and the force.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unknowns(pub(super) Vec<f64>);

impl Unknowns {
    pub(super) fn zero(grid: &Grid) -> Self {
        Self(vec![0.0; grid.unknowns()])
    }

    const fn order(&self) -> usize {
        (self.0.len() - 2) / 3
    }

    pub(super) fn beta(&self) -> &[f64] {
        &self.0[..self.order()]
    }

    pub(super) fn h(&self) -> &[f64] {
        &self.0[self.order()..2 * self.order()]
    }

    pub(super) fn u(&self) -> &[f64] {
        &self.0[2 * self.order()..3 * self.order() + 1]
    }

    pub(super) fn force(&self) -> f64 {
        self.0[3 * self.order() + 1]
    }
}

/// What a sample point carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) r0: f64,
    pub(super) g: f64,
    pub(super) s: f64,
    pub(super) c: f64,
    /// sin phi - sin phi0 and cos phi - cos phi0.
    pub(super) ds: f64,
    pub(super) dc: f64,
    pub(super) beta: f64,
    pub(super) u: f64,
    pub(super) r: f64,
    /// r0 times the axial resultant V.
    pub(super) v: f64,
    /// h cos phi + r0 V sin phi = r0 N_s.
    pub(super) along: f64,
    /// h sin phi - r0 V cos phi.
    pub(super) across: f64,
    pub(super) strain: f64,
    pub(super) kappa_s: f64,
    pub(super) kappa_t: f64,
    pub(super) n_t: f64,
    pub(super) m_s: f64,
    pub(super) m_t: f64,
}

impl Point {
    pub(super) fn n_s(&self) -> f64 {
        self.along / self.r0
    }

    /// Axial growth per unit of the parameter: g((1 + eps) sin phi - sin phi0).
    pub(super) fn growth(&self) -> f64 {
        self.g * (self.strain * self.s + self.ds)
    }

    /// Twice the energy per area.
    fn density(&self) -> f64 {
        self.n_s() * self.strain
            + self.n_t * self.u / self.r0
            + self.m_s * self.kappa_s
            + self.m_t * self.kappa_t
    }
}

/// All sample points of a state.
pub(super) fn points(grid: &Grid, unknowns: &Unknowns, pressure: f64) -> Vec<Point> {
    let circle = &grid.circle;
    let slopes: Vec<f64> =
        unknowns.beta().iter().enumerate().map(|(i, b)| (i + 1) as f64 * b).collect();
    let beta = circle.sine_sum(unknowns.beta());
    let slope = circle.cosine_sum(&[&[0.0], slopes.as_slice()].concat());
    let h = circle.sine_sum(unknowns.h());
    let u = circle.cosine_sum(unknowns.u());
    let v0 = unknowns.force() / TAU;
    let at = |j: usize| {
        let (place, s0, c0) = (&grid.places[j], grid.sines[j], grid.cosines[j]);
        let (r0, g) = (place.radius, place.speed);
        let sine = libm::sin(beta[j]);
        let half = libm::sin(0.5 * beta[j]);
        let fall = 2.0 * half * half; // 1 - cos beta
        let (ds, dc) = (c0 * sine - s0 * fall, -s0 * sine - c0 * fall);
        let (s, c) = (s0 + ds, c0 + dc);
        let r = r0 + u[j];
        let v = 0.5 * pressure * r * r + v0;
        let along = h[j] * c + v * s;
        let (kappa_s, kappa_t) = (slope[j] / g, ds / r0);
        let nu = grid.poisson;
        Point {
            r0,
            g,
            s,
            c,
            ds,
            dc,
            beta: beta[j],
            u: u[j],
            r,
            v,
            along,
            across: h[j] * s - v * c,
            strain: along / (r0 * grid.stretching) - nu * u[j] / r0,
            kappa_s,
            kappa_t,
            n_t: (nu * along + u[j]) / r0,
            m_s: grid.bending * (kappa_s + nu * kappa_t),
            m_t: grid.bending * (kappa_t + nu * kappa_s),
        }
    };
    (0..circle.count()).map(at).collect()
}

/// Samples of a function of the points.
pub(super) fn samples(points: &[Point], of: impl Fn(&Point) -> f64) -> Vec<f64> {
    points.iter().map(of).collect()
}

/// Growth in length of the corrugation.
pub(super) fn dilatation(grid: &Grid, points: &[Point]) -> f64 {
    TAU * grid.circle.mean(&samples(points, Point::growth))
}

/// Stored energy of the corrugation.
pub(super) fn energy(grid: &Grid, points: &[Point]) -> f64 {
    0.5 * TAU * TAU * grid.circle.mean(&samples(points, |at| at.density() * at.r0 * at.g))
}

/// Enclosed volume of the corrugation.
pub(super) fn volume(grid: &Grid, points: &[Point]) -> f64 {
    let area = |at: &Point| at.r * at.r * (1.0 + at.strain) * at.s * at.g;
    PI * TAU * grid.circle.mean(&samples(points, area))
}
