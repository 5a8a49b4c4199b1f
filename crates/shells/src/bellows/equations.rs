//! Residuals of the equations as coefficients, and their derivatives as product matrices.

use std::f64::consts::{PI, TAU};

use carom_dense::Mat;

use super::axial::Axial;
use super::fields::{Point, Unknowns, dilatation, samples};
use super::grid::Grid;
use crate::fourier::{EvenSeries, OddSeries};

/// Residuals of moments (sin 1 to n), fit (sin 1 to n), radial forces (cos 0 to n) and of what is
/// prescribed along the axis.
pub(super) fn residual(
    grid: &Grid,
    points: &[Point],
    unknowns: &Unknowns,
    pressure: f64,
    axial: Axial,
) -> Vec<f64> {
    let n = grid.harmonics;
    let circle = &grid.circle;
    let even = |of: &dyn Fn(&Point) -> f64| circle.even(&samples(points, of), n);
    let odd = |of: &dyn Fn(&Point) -> f64| circle.odd(&samples(points, of), n);
    let moment = even(&|at| at.r0 * at.m_s);
    let turning = odd(&|at| at.g * (at.m_t * at.c + (1.0 + at.strain) * at.across));
    let fit = odd(&|at| at.g * (at.strain * at.c + at.dc));
    let radial = even(&|at| at.g * (at.n_t - pressure * at.r * (1.0 + at.strain) * at.s));
    let mut residual = Vec::with_capacity(grid.unknowns());
    residual.extend((1..=n).map(|k| -(k as f64) * moment.coefficient(k) - turning.coefficient(k)));
    residual.extend((1..=n).map(|k| -(k as f64) * unknowns.u()[k] - fit.coefficient(k)));
    let slope = |k: usize| if k == 0 { 0.0 } else { k as f64 * unknowns.h()[k - 1] };
    residual.extend((0..=n).map(|k| slope(k) - radial.coefficient(k)));
    residual.push(match axial {
        Axial::Force(force) => unknowns.force() - force,
        Axial::Dilatation(growth) => dilatation(grid, points) - growth,
    });
    residual
}

/// Derivatives of r0 N_s/r0 and eps_s of a point with respect to beta, h, u, F and p.
struct Rates {
    force: [f64; 5],
    strain: [f64; 5],
}

/// Places in [`Rates`].
const BETA: usize = 0;
const H: usize = 1;
const U: usize = 2;
const F: usize = 3;
const P: usize = 4;

impl Rates {
    fn new(grid: &Grid, at: &Point, pressure: f64) -> Self {
        let force = [
            -at.across / at.r0,
            at.c / at.r0,
            at.s * pressure * at.r / at.r0,
            at.s / (TAU * at.r0),
            0.5 * at.s * at.r * at.r / at.r0,
        ];
        let mut strain = force.map(|rate| rate / grid.stretching);
        strain[U] -= grid.poisson / at.r0;
        Self { force, strain }
    }
}

/// Derivatives of the residual: a matrix for the unknowns and a column for the pressure.
pub(super) struct Jacobian {
    pub(super) matrix: Mat<f64>,
    pub(super) by_pressure: Vec<f64>,
}

/// Functions of the points whose product matrices make the derivative of one equation.
struct Row<'a> {
    grid: &'a Grid,
    points: &'a [Point],
    rates: &'a [Rates],
}

impl Row<'_> {
    fn samples(&self, of: impl Fn(&Point, &Rates) -> f64) -> Vec<f64> {
        self.points.iter().zip(self.rates).map(|(at, rates)| of(at, rates)).collect()
    }

    fn even(&self, of: impl Fn(&Point, &Rates) -> f64) -> EvenSeries {
        self.grid.circle.even(&self.samples(of), 2 * self.grid.harmonics)
    }

    fn odd(&self, of: impl Fn(&Point, &Rates) -> f64) -> OddSeries {
        self.grid.circle.odd(&self.samples(of), 2 * self.grid.harmonics)
    }
}

/// The derivatives at a state; `by_force` tells whether F or the dilatation is prescribed.
pub(super) fn jacobian(grid: &Grid, points: &[Point], pressure: f64, axial: Axial) -> Jacobian {
    let rates: Vec<Rates> = points.iter().map(|at| Rates::new(grid, at, pressure)).collect();
    let row = Row { grid, points, rates: &rates };
    let size = grid.unknowns();
    let mut jacobian = Jacobian { matrix: Mat::zeros(size, size), by_pressure: vec![0.0; size] };
    moments(&row, pressure, &mut jacobian);
    fit(&row, &mut jacobian);
    radial(&row, pressure, &mut jacobian);
    match axial {
        Axial::Force(_) => jacobian.matrix[(size - 1, size - 1)] = 1.0,
        Axial::Dilatation(_) => growth(&row, &mut jacobian),
    }
    jacobian
}

/// (r0 M_s)' - g (M_t cos phi + (1 + eps) Q), Q = h sin phi - r0 V cos phi.
fn moments(row: &Row<'_>, pressure: f64, jacobian: &mut Jacobian) {
    let (n, nu, d) = (row.grid.harmonics, row.grid.poisson, row.grid.bending);
    let bend = row.even(|at, _| at.r0 * d / at.g);
    let mixed = row.odd(|at, _| d * nu * at.c);
    let turn = row.even(|at, rates| {
        -at.g
            * (d * at.c * at.c / at.r0 - at.s * at.m_t
                + at.across * rates.strain[BETA]
                + (1.0 + at.strain) * at.along)
    });
    let by_h =
        row.even(|at, rates| -at.g * (at.across * rates.strain[H] + (1.0 + at.strain) * at.s));
    let by_axial = |at: &Point, strain: f64, v: f64| {
        -at.g * (at.across * strain - (1.0 + at.strain) * at.c * v)
    };
    let by_u = row.odd(|at, rates| by_axial(at, rates.strain[U], pressure * at.r));
    let by_f = row.odd(|at, rates| by_axial(at, rates.strain[F], 1.0 / TAU));
    let by_p = row.odd(|at, rates| by_axial(at, rates.strain[P], 0.5 * at.r * at.r));
    let matrix = &mut jacobian.matrix;
    for k in 1..=n {
        let (i, kf) = (k - 1, k as f64);
        for j in 1..=n {
            let jf = j as f64;
            matrix[(i, j - 1)] = -kf * (bend.cos_to_cos(k, j) * jf + mixed.sin_to_cos(k, j))
                - mixed.cos_to_sin(k, j) * jf
                + turn.sin_to_sin(k, j);
            matrix[(i, n + j - 1)] = by_h.sin_to_sin(k, j);
        }
        for j in 0..=n {
            matrix[(i, 2 * n + j)] = by_u.cos_to_sin(k, j);
        }
        matrix[(i, 3 * n + 1)] = by_f.coefficient(k);
        jacobian.by_pressure[i] = by_p.coefficient(k);
    }
}

/// u' - g ((1 + eps) cos phi - cos phi0).
fn fit(row: &Row<'_>, jacobian: &mut Jacobian) {
    let n = row.grid.harmonics;
    let by_beta =
        row.even(|at, rates| -at.g * (at.c * rates.strain[BETA] - (1.0 + at.strain) * at.s));
    let by_h = row.even(|at, rates| -at.g * at.c * rates.strain[H]);
    let [by_u, by_f, by_p] =
        [U, F, P].map(|which| row.odd(|at, rates| -at.g * at.c * rates.strain[which]));
    let matrix = &mut jacobian.matrix;
    for k in 1..=n {
        let i = n + k - 1;
        for j in 1..=n {
            matrix[(i, j - 1)] = by_beta.sin_to_sin(k, j);
            matrix[(i, n + j - 1)] = by_h.sin_to_sin(k, j);
        }
        for j in 0..=n {
            let slope = if j == k { k as f64 } else { 0.0 };
            matrix[(i, 2 * n + j)] = by_u.cos_to_sin(k, j) - slope;
        }
        matrix[(i, 3 * n + 1)] = by_f.coefficient(k);
        jacobian.by_pressure[i] = by_p.coefficient(k);
    }
}

/// h' - g (N_t - p r (1 + eps) sin phi).
fn radial(row: &Row<'_>, pressure: f64, jacobian: &mut Jacobian) {
    let (n, nu) = (row.grid.harmonics, row.grid.poisson);
    let part = |at: &Point, rates: &Rates, which: usize| {
        nu * rates.force[which] - pressure * at.r * at.s * rates.strain[which]
    };
    let by_beta = row.odd(|at, rates| {
        -at.g * (part(at, rates, BETA) - pressure * at.r * (1.0 + at.strain) * at.c)
    });
    let by_h = row.odd(|at, rates| -at.g * part(at, rates, H));
    let by_u = row.even(|at, rates| {
        -at.g * (part(at, rates, U) + 1.0 / at.r0 - pressure * (1.0 + at.strain) * at.s)
    });
    let by_f = row.even(|at, rates| -at.g * part(at, rates, F));
    let by_p = row.even(|at, rates| -at.g * (part(at, rates, P) - at.r * (1.0 + at.strain) * at.s));
    let matrix = &mut jacobian.matrix;
    for k in 0..=n {
        let i = 2 * n + k;
        for j in 1..=n {
            let slope = if j == k { k as f64 } else { 0.0 };
            matrix[(i, j - 1)] = by_beta.sin_to_cos(k, j);
            matrix[(i, n + j - 1)] = by_h.sin_to_cos(k, j) + slope;
        }
        for j in 0..=n {
            matrix[(i, 2 * n + j)] = by_u.cos_to_cos(k, j);
        }
        matrix[(i, 3 * n + 1)] = by_f.coefficient(k);
        jacobian.by_pressure[i] = by_p.coefficient(k);
    }
}

/// The integral of g((1 + eps) sin phi - sin phi0) around.
fn growth(row: &Row<'_>, jacobian: &mut Jacobian) {
    let n = row.grid.harmonics;
    let last = 3 * n + 1;
    let by_beta =
        row.odd(|at, rates| at.g * (at.s * rates.strain[BETA] + (1.0 + at.strain) * at.c));
    let by_h = row.odd(|at, rates| at.g * at.s * rates.strain[H]);
    let by_u = row.even(|at, rates| at.g * at.s * rates.strain[U]);
    let mean = |which: usize| {
        let samples = row.samples(|at, rates| at.g * at.s * rates.strain[which]);
        TAU * row.grid.circle.mean(&samples)
    };
    let (by_f, by_p) = (mean(F), mean(P));
    // beta and h are odd: their products with odd functions count, by the rule of sines.
    let matrix = &mut jacobian.matrix;
    for j in 1..=n {
        matrix[(last, j - 1)] = PI * by_beta.coefficient(j);
        matrix[(last, n + j - 1)] = PI * by_h.coefficient(j);
        matrix[(last, 2 * n + j)] = PI * by_u.coefficient(j);
    }
    matrix[(last, 2 * n)] = TAU * by_u.coefficient(0);
    matrix[(last, last)] = by_f;
    jacobian.by_pressure[last] = by_p;
}
