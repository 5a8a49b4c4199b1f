//! Contacts that cover a small part of a large grid: corrections among the cells that may touch.
//!
//! The gap on all cells is computed exactly, g = A p + z - zeta, row by row. The problem of pressures and gaps is then
//! solved among the cells that touch or nearly do, with an influence B among them that is cheap and slightly wrong, and
//! with heights for which B p has the exact gap: the error of the new pressure is that of B on the correction alone. The
//! next exact gap tells whether a further correction is needed.

use carom_halfspace::Grid;
use carom_halfspace::operator::{
    DisplacementField, NormalRows, OperatorError, SurfaceOperator, TractionField, Workspace,
};

use super::active_set::ActiveSet;
use super::signs::greater;
use super::task::{LARGE, Limits, NormalTask, finish};
use crate::convergence::{Convergence, Observer, Products, Residuals, Stop};
use crate::drive::Driven;
use crate::lanes;
use crate::parts::{each, sum};
use crate::rows::{Row, of_rows};

/// A contact is solved on all cells if its own, with those about it, are more than one in so many.
const FEW: usize = 6;
/// Corrections are given up after this many.
const CORRECTIONS: usize = 8;
/// A correction is found to this part of the violation before it.
const GAIN: f64 = 1e-4;
/// A correction that leaves more than this part of the violation is the last.
const LEAST_GAIN: f64 = 0.5;

impl ActiveSet {
    /// Solves a task as [`ActiveSet::solve`] does; if few of many cells touch, by corrections among these as far as they
    /// lead.
    pub(super) fn solve_any(
        &mut self,
        task: &mut NormalTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let (all, mut spent, mut iterations) = (task.heights.len(), Products::default(), 0);
        let is_sparse = all >= LARGE && self.touching(task) * FEW <= all;
        if is_sparse && task.operator.among(&[0]).is_some() {
            self.knows_gap = false;
            let mut before = f64::INFINITY;
            for _ in 0..CORRECTIONS {
                let Exact { violation, near } = self.exact(task, limits.tolerance)?;
                spent.normal += 1.0;
                // A correction needs the memory of its own.
                self.workspace = Workspace::default();
                if violation <= limits.tolerance {
                    finish(task);
                    let residuals = Residuals { normal: violation, tangential: 0.0 };
                    let stop = Stop::Converged;
                    return Ok(Convergence { iterations, products: spent, residuals, stop });
                }
                if violation.is_nan() || violation >= LEAST_GAIN * before {
                    break;
                }
                before = violation;
                let Some(reached) = correct_once(task, near, (violation, limits), observer)? else {
                    break;
                };
                spent = spent.plus(reached.products);
                iterations += reached.iterations;
                // A coarse grid needs no more than a good start for the next one.
                let is_start = reached.stop == Stop::Converged && limits.change > 0.0;
                if is_start || reached.stop == Stop::Observer {
                    finish(task);
                    return Ok(Convergence { iterations, products: spent, ..reached });
                }
                if reached.stop != Stop::Converged {
                    break;
                }
            }
        }
        let rest = self.solve(task, limits, observer)?;
        let products = spent.plus(rest.products);
        Ok(Convergence { iterations: iterations + rest.iterations, products, ..rest })
    }

    /// The violation of the conditions on all cells and, if it is above the tolerance, the cells that may touch. A
    /// prescribed force has its pressures: they are scaled to it, and the gap is zero in the mean of the cells that touch.
    fn exact(&mut self, task: &mut NormalTask<'_>, tolerance: f64) -> Result<Exact, OperatorError> {
        if let Driven::Load(force) = task.driven {
            let sum = sum(self.threads, &*task.pressure, &lanes::total);
            let factor = force / (task.operator.grid().cell_area() * sum);
            each(self.threads, &mut *task.pressure, &|pressures: &mut [f64]| {
                let loaded = pressures.iter_mut().filter(|pressure| **pressure != 0.0);
                loaded.for_each(|pressure| *pressure *= factor);
            });
        }
        let mut rows = task.operator.pressed(task.pressure, &mut self.workspace)?;
        if matches!(task.driven, Driven::Load(_)) {
            task.approach += mean_gap(&mut *rows, task);
        }
        let rows = &mut *rows;
        let seen = of_rows(rows, fields(task), &|_| true, &|row| seen(row, task.approach));
        let (greatest, scale) = seen.iter().fold((0.0_f64, 0.0_f64), |(greatest, scale), row| {
            (greater(greatest, row.greatest), scale.max(row.scale))
        });
        let violation = if scale > 0.0 { greatest / scale } else { greatest };
        let near = if violation > tolerance { near(rows, task, &seen) } else { Vec::new() };
        Ok(Exact { violation, near })
    }
}

/// What the exact gap of a pressure tells.
struct Exact {
    /// The greatest violation relative to the greatest displacement; NaN if any value is NaN.
    violation: f64,
    /// The cells that touch or overlap and all next to them, with their gaps.
    near: Vec<(usize, f64)>,
}

/// Pressures and heights.
fn fields<'a>(task: &'a NormalTask<'_>) -> (Grid, [&'a [f64]; 2]) {
    (task.operator.grid(), [task.pressure, task.heights])
}

/// The mean gap of the cells that touch.
fn mean_gap(rows: &mut dyn NormalRows, task: &NormalTask<'_>) -> f64 {
    let nx = task.operator.grid().nx();
    let touches =
        |row: usize| task.pressure[row * nx..][..nx].iter().any(|pressure| *pressure > 0.0);
    let sums = of_rows(rows, fields(task), &touches, &|row| {
        let touching = row.gaps(task.approach).filter(|(pressure, _)| *pressure > 0.0);
        touching.fold((0.0, 0.0), |(sum, count), (_, gap)| (sum + gap, count + 1.0))
    });
    let add = |one: (f64, f64), row: &(f64, f64)| (one.0 + row.0, one.1 + row.1);
    let (sum, count) = sums.iter().fold((0.0, 0.0), add);
    if count > 0.0 { sum / count } else { 0.0 }
}

/// What is seen of a row.
#[derive(Default)]
struct Seen {
    /// The greatest violation, as a gap; NaN if any value is NaN.
    greatest: f64,
    /// The greatest displacement of cells that touch.
    scale: f64,
    /// The columns of cells that touch or overlap.
    columns: Vec<u32>,
}

fn seen(row: &Row<'_>, approach: f64) -> Seen {
    let mut seen = Seen::default();
    for (column, (pressure, gap)) in row.gaps(approach).enumerate() {
        let touches = pressure > 0.0;
        let wrong = if touches { gap.abs() } else { (-gap).max(0.0) };
        seen.greatest = greater(seen.greatest, if gap.is_nan() { gap } else { wrong });
        if touches {
            seen.scale = seen.scale.max(row.displacements[column].abs());
        }
        if touches || gap < 0.0 {
            seen.columns.push(column as u32);
        }
    }
    seen
}

/// The cells that touch or overlap and all next to them, with their gaps; those whose gap is infinite never touch.
fn near(rows: &mut dyn NormalRows, task: &NormalTask<'_>, seen: &[Seen]) -> Vec<(usize, f64)> {
    let (nx, ny) = (task.operator.grid().nx(), seen.len());
    let about = |row: usize| &seen[row.saturating_sub(1)..(row + 2).min(ny)];
    let wanted = |row: usize| about(row).iter().any(|row| !row.columns.is_empty());
    let found = of_rows(rows, fields(task), &wanted, &|row| {
        let mut is_near = vec![false; nx];
        for column in about(row.number).iter().flat_map(|row| &row.columns) {
            let column = *column as usize;
            is_near[column.saturating_sub(1)..(column + 2).min(nx)].fill(true);
        }
        let cells = row.gaps(task.approach).enumerate();
        let near = cells.filter(|(column, (_, gap))| is_near[*column] && gap.is_finite());
        near.map(|(column, (_, gap))| (row.number * nx + column, gap)).collect::<Vec<_>>()
    });
    found.into_iter().flatten().collect()
}

/// One correction of a pressure that violates the conditions by so much; `None` if too many cells may touch, or the
/// operator has no influence among some cells.
fn correct_once(
    task: &mut NormalTask<'_>,
    near: Vec<(usize, f64)>,
    (violation, limits): (f64, Limits),
    observer: &mut dyn Observer,
) -> Result<Option<Convergence>, OperatorError> {
    let all = task.heights.len();
    if near.len() * FEW > all {
        return Ok(None);
    }
    let (cells, gaps): (Vec<usize>, Vec<f64>) = near.into_iter().unzip();
    let Some(operator) = task.operator.among(&cells) else { return Ok(None) };
    let tolerance = (0.3 * limits.tolerance).max(GAIN * violation);
    let limits = Limits { tolerance, ..limits };
    let reached = correct_among(task, &*operator, (&cells, gaps), limits, observer)?;
    let products = reached.products.times(cells.len() as f64 / all as f64);
    Ok(Some(Convergence { products, ..reached }))
}

/// Solves for the pressures of these cells, whose gaps are known, by an influence among them.
fn correct_among(
    task: &mut NormalTask<'_>,
    operator: &dyn SurfaceOperator,
    (cells, gaps): (&[usize], Vec<f64>),
    limits: Limits,
    observer: &mut dyn Observer,
) -> Result<Convergence, OperatorError> {
    let mut pressure: Vec<f64> = cells.iter().map(|cell| task.pressure[*cell]).collect();
    let mut set = ActiveSet::new(operator);
    let mut heights = vec![0.0; cells.len()];
    let displacements = DisplacementField::normal(&mut heights);
    operator.apply(TractionField::normal(&pressure), displacements, &mut set.workspace)?;
    for (height, gap) in heights.iter_mut().zip(gaps) {
        *height = gap + task.approach - *height;
    }
    let (driven, approach) = (task.driven, task.approach);
    let mut among =
        NormalTask { operator, heights: &heights, driven, pressure: &mut pressure, approach };
    let reached = set.solve(&mut among, limits, observer)?;
    task.approach = among.approach;
    for (cell, pressure) in cells.iter().zip(pressure) {
        task.pressure[*cell] = pressure;
    }
    Ok(reached)
}
