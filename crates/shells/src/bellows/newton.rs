//! Newton's method at given pressure and force or dilatation.

use super::axial::Axial;
use super::equations::{jacobian, residual};
use super::fields::{Unknowns, points};
use super::grid::Grid;
use crate::dense::{Factors, Singular};

/// Newton's method did not reach a solution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "no convergence beyond {fraction:.4} of the load: last step {last_step:e}, residual {residual:e}"
)]
pub struct NotConverged {
    /// The part of the load that was reached.
    pub fraction: f64,
    /// Greatest change of an unknown in the last step; rotations are pure numbers, displacements in
    /// thicknesses t, forces in E t^2.
    pub last_step: f64,
    /// Greatest residual of the equations, in the same units.
    pub residual: f64,
}

/// A solution.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solved {
    pub(super) unknowns: Unknowns,
    pub(super) iterations: usize,
    pub(super) last_step: f64,
    pub(super) residual: f64,
    /// Whether the determinant of the equations at given dilatation is negative.
    pub(super) is_negative: bool,
    /// dF/dDelta at fixed pressure.
    pub(super) stiffness: f64,
    /// Change of the unknowns per unit of dilatation at fixed pressure.
    pub(super) tangent: Vec<f64>,
}

/// The most steps.
const MOST_STEPS: usize = 25;
/// A step below this, relative, ends the iteration.
const CONVERGED: f64 = 1e-13;
/// Rounding may keep steps above that; one below this that does not halve any more ends it too.
const STALLED: f64 = 1e-8;
/// A greater rotation in one step leads nowhere.
const GREATEST_TURN: f64 = 1.5;

/// Solves from a start.
pub(super) fn solve(
    grid: &Grid,
    start: &Unknowns,
    pressure: f64,
    axial: Axial,
) -> Result<Solved, NotConverged> {
    let mut unknowns = start.clone();
    let mut last_step = f64::INFINITY;
    let failed =
        |last_step: f64, residual: f64| NotConverged { fraction: 0.0, last_step, residual };
    for iterations in 1..=MOST_STEPS {
        let state = points(grid, &unknowns, pressure);
        let right = residual(grid, &state, &unknowns, pressure, axial);
        let factors = Factors::new(&jacobian(grid, &state, pressure, axial).matrix);
        let Ok(step) = factors.solve(&right) else {
            return Err(failed(last_step, greatest(&right)));
        };
        let turn = greatest(&step[..grid.harmonics]);
        let size = greatest(&step);
        if turn.is_nan() || turn > GREATEST_TURN {
            return Err(failed(size, greatest(&right)));
        }
        for (value, change) in unknowns.0.iter_mut().zip(&step) {
            *value -= change;
        }
        let relative = size / (1.0 + greatest(&unknowns.0));
        let is_stalled = relative < STALLED && size > 0.5 * last_step;
        last_step = size;
        if relative < CONVERGED || is_stalled {
            return finish(grid, unknowns, pressure, axial, iterations, last_step);
        }
    }
    let state = points(grid, &unknowns, pressure);
    Err(failed(last_step, greatest(&residual(grid, &state, &unknowns, pressure, axial))))
}

/// One step from a start: the linear solution if that is rest.
pub(super) fn solve_once(
    grid: &Grid,
    start: &Unknowns,
    pressure: f64,
    axial: Axial,
) -> Result<Unknowns, Singular> {
    let state = points(grid, start, pressure);
    let right = residual(grid, &state, start, pressure, axial);
    let step = Factors::new(&jacobian(grid, &state, pressure, axial).matrix).solve(&right)?;
    Ok(Unknowns(start.0.iter().zip(&step).map(|(value, change)| value - change).collect()))
}

fn finish(
    grid: &Grid,
    unknowns: Unknowns,
    pressure: f64,
    axial: Axial,
    iterations: usize,
    last_step: f64,
) -> Result<Solved, NotConverged> {
    let state = points(grid, &unknowns, pressure);
    let residual = greatest(&residual(grid, &state, &unknowns, pressure, axial));
    let matrix = jacobian(grid, &state, pressure, Axial::Dilatation(0.0)).matrix;
    let mut unit = vec![0.0; grid.unknowns()];
    unit[grid.unknowns() - 1] = 1.0;
    let failed = NotConverged { fraction: 0.0, last_step, residual };
    let factors = Factors::new(&matrix);
    let tangent = factors.solve(&unit).map_err(|_| failed)?;
    let stiffness = tangent[grid.unknowns() - 1];
    let is_negative = factors.is_negative();
    Ok(Solved { unknowns, iterations, last_step, residual, is_negative, stiffness, tangent })
}

pub(super) fn greatest(values: &[f64]) -> f64 {
    values
        .iter()
        .fold(0.0, |most: f64, value| if value.is_nan() { *value } else { most.max(value.abs()) })
}
