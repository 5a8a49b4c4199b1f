//! Contacts that cover a small part of a large grid: corrections among the cells that may touch.
//!
//! The gap on all cells is computed exactly, g = A p + z - zeta. The problem of pressures and gaps is then solved among
//! the cells that touch or nearly do, with an influence B among them that is cheap and slightly wrong, and with heights
//! for which B p has the exact gap: the error of the new pressure is that of B on the correction alone. The next exact
//! gap tells whether a further correction is needed.

use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, TractionField, Workspace,
};

use super::active_set::ActiveSet;
use super::task::{Limits, NormalTask, finish};
use crate::convergence::{Convergence, Observer, Products, Residuals, Stop};
use crate::drive::Driven;
use crate::lanes;
use crate::parts::{each, fold, sum};

/// Grids with fewer cells are solved on all cells.
const LARGE: usize = 1 << 16;
/// So is a contact whose cells, with those about it, are more than one in so many.
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
            let mut before = f64::INFINITY;
            for _ in 0..CORRECTIONS {
                spent = spent.plus(self.exact_gap(task)?);
                let normal = self.residual(task);
                if normal <= limits.tolerance {
                    finish(task);
                    let residuals = Residuals { normal, tangential: 0.0 };
                    let stop = Stop::Converged;
                    return Ok(Convergence { iterations, products: spent, residuals, stop });
                }
                if normal.is_nan() || normal >= LEAST_GAIN * before {
                    break;
                }
                before = normal;
                // A correction needs the memory of its own.
                self.workspace = Workspace::default();
                let Some(reached) = self.correct_once(task, (normal, limits), observer)? else {
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

    /// One correction of a pressure that violates the conditions by so much; `None` if too many cells may touch, or the
    /// operator has no influence among some cells.
    fn correct_once(
        &self,
        task: &mut NormalTask<'_>,
        (violation, limits): (f64, Limits),
        observer: &mut dyn Observer,
    ) -> Result<Option<Convergence>, OperatorError> {
        let (cells, all) = (self.that_may_touch(task), self.gap.len());
        if cells.len() * FEW > all {
            return Ok(None);
        }
        let Some(operator) = task.operator.among(&cells) else { return Ok(None) };
        let tolerance = (0.3 * limits.tolerance).max(GAIN * violation);
        let limits = Limits { tolerance, ..limits };
        let reached = self.correct_among(task, (&*operator, &cells), limits, observer)?;
        let products = reached.products.times(cells.len() as f64 / all as f64);
        Ok(Some(Convergence { products, ..reached }))
    }

    /// The gap on all cells. A prescribed force has it: pressures are scaled to it, and the gap is zero in the mean of the
    /// cells that touch.
    fn exact_gap(&mut self, task: &mut NormalTask<'_>) -> Result<Products, OperatorError> {
        self.make_room(task.heights.len());
        if let Driven::Load(force) = task.driven {
            let sum = sum(self.threads, &*task.pressure, &lanes::total);
            let factor = force / (task.operator.grid().cell_area() * sum);
            each(self.threads, &mut *task.pressure, &|pressures: &mut [f64]| {
                pressures.iter_mut().for_each(|pressure| *pressure *= factor);
            });
        }
        let tractions = TractionField::normal(task.pressure);
        let displacements = DisplacementField::normal(&mut self.gap);
        task.operator.apply(tractions, displacements, &mut self.workspace)?;
        let approach = task.approach;
        let parts = ((&mut self.gap[..], &mut self.active[..]), (&*task.pressure, task.heights));
        let (mean, count) = fold(
            self.threads,
            parts,
            &|((gaps, actives), (pressures, heights))| {
                let (mut sum, mut count) = (0.0, 0.0);
                for (i, gap) in gaps.iter_mut().enumerate() {
                    *gap += heights[i] - approach;
                    actives[i] = pressures[i] > 0.0;
                    if actives[i] {
                        (sum, count) = (sum + *gap, count + 1.0);
                    }
                }
                (sum, count)
            },
            &|one: (f64, f64), other| (one.0 + other.0, one.1 + other.1),
        );
        if matches!(task.driven, Driven::Load(_)) && count > 0.0 {
            let mean = mean / count;
            task.approach += mean;
            each(self.threads, &mut self.gap[..], &|gaps: &mut [f64]| {
                gaps.iter_mut().for_each(|gap| *gap -= mean);
            });
        }
        Ok(Products { normal: 1.0, ..Products::default() })
    }

    /// The cells that touch or overlap, and all next to them.
    fn that_may_touch(&self, task: &NormalTask<'_>) -> Vec<usize> {
        let grid = task.operator.grid();
        let mut near = vec![false; self.gap.len()];
        for (row, gaps) in self.gap.chunks_exact(grid.nx()).enumerate() {
            for (column, gap) in gaps.iter().enumerate() {
                if !(self.active[row * grid.nx() + column] || *gap < 0.0) {
                    continue;
                }
                for row in row.saturating_sub(1)..(row + 2).min(grid.ny()) {
                    let range = column.saturating_sub(1)..(column + 2).min(grid.nx());
                    near[row * grid.nx()..][range].fill(true);
                }
            }
        }
        let finite = |cell: &usize| near[*cell] && self.gap[*cell].is_finite();
        (0..near.len()).filter(finite).collect()
    }

    /// Solves for the pressures of these cells, by an influence among them.
    fn correct_among(
        &self,
        task: &mut NormalTask<'_>,
        (operator, cells): (&dyn SurfaceOperator, &[usize]),
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut pressure: Vec<f64> = cells.iter().map(|cell| task.pressure[*cell]).collect();
        let mut set = Self::new(operator);
        let mut heights = vec![0.0; cells.len()];
        let displacements = DisplacementField::normal(&mut heights);
        operator.apply(TractionField::normal(&pressure), displacements, &mut set.workspace)?;
        for (height, cell) in heights.iter_mut().zip(cells) {
            *height = self.gap[*cell] + task.approach - *height;
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
}
