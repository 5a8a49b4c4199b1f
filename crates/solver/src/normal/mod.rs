//! The normal problem: pressures without tension, gaps without overlap.

mod active_set;
mod begin;
mod iteration_state;
mod signs;
mod sparse;
mod task;

use std::sync::Arc;

use carom_halfspace::operator::{OperatorError, SurfaceOperator, Workspace};
use carom_halfspace::{Field, Grid};

use crate::convergence::{Convergence, Observer, Products, Stop};
use crate::drive::Driven;
use crate::nested;
use crate::state::{CellState, ContactState};
use active_set::ActiveSet;
use task::{LARGE, Limits, NormalTask};

/// The iteration on coarse grids stops when a correction changes the pressure by less than this
/// fraction, on the coarsest grid by less than a tenth of it.
const COARSE_CHANGE: f64 = 1e-2;

/// The grids of a normal problem, finest first, with their working memory.
#[derive(Clone)]
pub(crate) struct NormalGrids {
    levels: Vec<Level>,
}

/// Greatest number of cells along a side of the grid for the pilot solve.
const PILOT_CELLS: usize = 64;

/// A coarse grid, and the first and last column and row in contact there.
pub(crate) type PilotContact = (Grid, [[usize; 2]; 2]);

/// Stopping criteria on the finest grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Target {
    /// The greatest gap in the contact, or overlap outside, relative to the greatest displacement.
    pub(crate) tolerance: f64,
    pub(crate) iterations: usize,
}

#[derive(Clone)]
struct Level {
    grid: Grid,
    /// `None` on the finest grid, whose operator belongs to the problem, and on a grid that is to be made anew.
    operator: Option<Arc<dyn SurfaceOperator>>,
    /// `None` on a grid that is to be made anew.
    heights: Option<Arc<Field>>,
    /// Empty from the end of a solve on.
    pressure: Vec<f64>,
    set: ActiveSet,
}

impl NormalGrids {
    /// With coarser grids of the operator, finest first.
    pub(crate) fn new(
        operator: &dyn SurfaceOperator,
        heights: &Arc<Field>,
        coarser: impl FnOnce() -> Result<Vec<Arc<dyn SurfaceOperator>>, OperatorError>,
    ) -> Result<Self, OperatorError> {
        let mut levels = vec![Level::new(operator, Arc::clone(heights))];
        // A known outline needs no coarse grids, and they would not resolve the peaks at its edge.
        if heights.values().iter().all(|height| !height.is_infinite()) {
            for operator in coarser()? {
                let level = levels[levels.len() - 1].coarser(operator)?;
                levels.push(level);
            }
        }
        Ok(Self { levels })
    }

    /// The solution.
    pub(crate) fn pressure(&self) -> &[f64] {
        &self.levels[0].pressure
    }

    /// Moves the solution into a state without tractions and contact, where all cells in contact then slip.
    pub(crate) fn give(&mut self, to: &mut ContactState) -> Result<(), OperatorError> {
        let finest = &mut self.levels[0];
        to.pressure = Field::new(finest.grid, std::mem::take(&mut finest.pressure))?;
        if finest.grid.cells() >= LARGE {
            finest.set.release();
        }
        // Cells that are not written take no memory.
        let cells = to.cells.values_mut().iter_mut().zip(to.pressure.values());
        cells
            .filter(|(_, pressure)| **pressure > 0.0)
            .for_each(|(cell, _)| *cell = CellState::Slip);
        Ok(())
    }

    /// The gaps of the solution.
    pub(crate) fn gap(
        &mut self,
        operator: &dyn SurfaceOperator,
        approach: f64,
    ) -> Result<&[f64], OperatorError> {
        let Level { heights, pressure, set, .. } = &mut self.levels[0];
        let heights = heights.as_deref().map_or(&[][..], Field::values);
        set.gap_of((operator, heights), pressure, approach)
    }

    /// Sets the heights on the finest grid.
    pub(crate) fn set_heights(&mut self, heights: &Arc<Field>) {
        self.levels[0].heights = Some(Arc::clone(heights));
    }

    /// The heights on the finest grid, to be changed by the caller.
    pub(crate) fn heights_mut(&mut self) -> &mut [f64] {
        let heights = self.levels[0].heights.as_mut();
        heights.map_or(&mut [], |heights| Arc::make_mut(heights).values_mut())
    }

    /// The working memory for products on the finest grid.
    pub(crate) fn workspace(&mut self) -> &mut Workspace {
        &mut self.levels[0].set.workspace
    }

    /// Sets a known pressure as the start.
    pub(crate) fn start_from(&mut self, pressure: &[f64]) {
        let own = &mut self.levels[0].pressure;
        own.clear();
        own.extend_from_slice(pressure);
    }

    /// Solves from the present pressure; returns the approach.
    pub(crate) fn solve(
        &mut self,
        operator: &dyn SurfaceOperator,
        driven: Driven,
        target: Target,
        observer: &mut dyn Observer,
    ) -> Result<(f64, Convergence), OperatorError> {
        let Target { tolerance, iterations } = target;
        let finest = &mut self.levels[0];
        if !finest.pressure.iter().any(|pressure| *pressure > 0.0) {
            finest.guess(driven);
        }
        finest.solve(operator, driven, Limits { tolerance, change: 0.0, iterations }, observer)
    }

    /// Computes a start by solving on the coarser grids, coarsest first; returns the cost.
    pub(crate) fn start(
        &mut self,
        operator: &dyn SurfaceOperator,
        driven: Driven,
        target: Target,
    ) -> Result<Products, OperatorError> {
        self.climb(0, operator, driven, target)
    }

    /// Computes the start on one grid from the coarser ones.
    fn climb(
        &mut self,
        to: usize,
        operator: &dyn SurfaceOperator,
        driven: Driven,
        target: Target,
    ) -> Result<Products, OperatorError> {
        let Target { tolerance, iterations } = target;
        let levels = &mut self.levels;
        make_anew(levels, operator)?;
        let (coarsest, cells) = (levels.len() - 1, levels[0].grid.cells());
        levels[coarsest].guess(driven);
        let mut spent = Products::default();
        for i in (to + 1..=coarsest).rev() {
            let change = if i == coarsest { 0.1 * COARSE_CHANGE } else { COARSE_CHANGE };
            let limits = Limits { tolerance, change, iterations };
            // Zeroed memory is allocated where it is written; ahead of what is given back, so that it leaves no hole.
            let mut start = vec![0.0; levels[i - 1].grid.cells()];
            let (_, coarse) = levels[i].solve(operator, driven, limits, &mut ())?;
            spent = spent.plus(coarse.products.times(levels[i].grid.cells() as f64 / cells as f64));
            let (finer, coarser) = levels.split_at_mut(i);
            let (fine, coarse) = (&mut finer[i - 1], &coarser[0]);
            nested::refine_pressure(coarse.grid, &coarse.pressure, fine.grid, &mut start);
            fine.pressure = start;
            coarser[0].release();
            if !fine.pressure.iter().any(|pressure| *pressure > 0.0) {
                fine.guess(driven);
            }
        }
        Ok(spent)
    }

    /// The region in contact on a coarse grid, by a pilot solve; `None` if no grid is coarse enough
    /// or the pilot solve does not converge.
    pub(crate) fn find_contact_by_pilot(
        &mut self,
        operator: &dyn SurfaceOperator,
        driven: Driven,
        target: Target,
    ) -> Result<Option<PilotContact>, OperatorError> {
        let few = |level: &Level| level.grid.cells() <= PILOT_CELLS * PILOT_CELLS;
        let Some(at) = (1..self.levels.len()).find(|i| few(&self.levels[*i])) else {
            return Ok(None);
        };
        let Some(lowest) = self.levels[at].lowest() else { return Ok(None) };
        let grid = self.levels[at].grid;
        let alone = [lowest % grid.nx(), lowest / grid.nx()].map(|place| [place; 2]);
        if matches!(driven, Driven::Shift(approach) if self.levels[at].heights()[lowest] >= approach)
        {
            return Ok(Some((grid, alone)));
        }
        self.climb(at, operator, driven, target)?;
        let Target { tolerance, iterations } = target;
        let limits = Limits { tolerance, change: COARSE_CHANGE, iterations };
        let level = &mut self.levels[at];
        let (_, convergence) = level.solve(operator, driven, limits, &mut ())?;
        if convergence.stop != Stop::Converged {
            return Ok(None);
        }
        let touching = level.pressure.iter().enumerate().filter(|(_, pressure)| **pressure > 0.0);
        let extent = touching.fold(alone, |[columns, rows], (i, _)| {
            let wider = |[low, high]: [usize; 2], at: usize| [low.min(at), high.max(at)];
            [wider(columns, i % grid.nx()), wider(rows, i / grid.nx())]
        });
        Ok(Some((grid, extent)))
    }
}

impl Level {
    fn new(operator: &dyn SurfaceOperator, heights: Arc<Field>) -> Self {
        let (grid, heights, pressure) = (operator.grid(), Some(heights), Vec::new());
        Self { grid, operator: None, heights, pressure, set: ActiveSet::new(operator) }
    }

    /// The next coarser grid, whose operator this is.
    fn coarser(&self, operator: Arc<dyn SurfaceOperator>) -> Result<Self, OperatorError> {
        let (grid, threads) = (operator.grid(), operator.threads());
        let heights = Field::new(grid, nested::coarser(self.grid, self.heights(), grid, threads))?;
        Ok(Self {
            operator: Some(Arc::clone(&operator)),
            ..Self::new(&*operator, Arc::new(heights))
        })
    }

    /// The distances of the surfaces at zero approach.
    fn heights(&self) -> &[f64] {
        self.heights.as_deref().map_or(&[], Field::values)
    }

    /// Gives back the memory of a large coarse grid whose solution is no longer needed.
    fn release(&mut self) {
        if self.grid.cells() < LARGE {
            return;
        }
        self.set.release();
        self.pressure = Vec::new();
        let is_alone = self.operator.as_ref().is_some_and(|own| Arc::strong_count(own) == 1);
        if is_alone {
            self.forget();
        }
    }

    /// Gives back what is made anew for the next start.
    fn forget(&mut self) {
        (self.operator, self.heights, self.set.inverse) = (None, None, None);
    }

    /// The cell with the smallest gap, if any gap is finite.
    fn lowest(&self) -> Option<usize> {
        let finite = self.heights().iter().enumerate().filter(|(_, height)| height.is_finite());
        finite.min_by(|one, other| one.1.total_cmp(other.1)).map(|(cell, _)| cell)
    }

    /// A first guess without better knowledge: semi-ellipsoidal pressures at the smallest gap.
    fn guess(&mut self, driven: Driven) {
        let all = self.heights.as_deref().map_or(&[][..], Field::values);
        let mut heights: Vec<f64> =
            all.iter().copied().filter(|height| height.is_finite()).collect();
        heights.sort_by(f64::total_cmp);
        let lowest = heights.first().copied().unwrap_or(0.0);
        let top = match driven {
            Driven::Shift(approach) => approach,
            Driven::Load(_) => heights.get(heights.len() / 4).copied().unwrap_or(lowest),
        };
        let span = top - lowest;
        let at = |height: &f64| {
            if *height > top {
                0.0
            } else if span > 0.0 {
                ((top - height) / span).sqrt()
            } else {
                1.0
            }
        };
        self.pressure.clear();
        self.pressure.extend(all.iter().map(at));
    }
}

/// Makes the coarse grids anew that were given back.
fn make_anew(levels: &mut [Level], own: &dyn SurfaceOperator) -> Result<(), OperatorError> {
    for at in 1..levels.len() {
        let (finer, coarser) = levels.split_at_mut(at);
        if coarser[0].heights.is_some() {
            return Ok(());
        }
        let above = &finer[at - 1];
        if let Some(operator) = above.operator.as_deref().unwrap_or(own).coarser() {
            coarser[0] = above.coarser(operator?.into())?;
        }
    }
    Ok(())
}

impl Level {
    fn solve(
        &mut self,
        own: &dyn SurfaceOperator,
        driven: Driven,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<(f64, Convergence), OperatorError> {
        let approach = match driven {
            Driven::Shift(approach) => approach,
            Driven::Load(_) => 0.0,
        };
        let mut task = NormalTask {
            operator: self.operator.as_deref().unwrap_or(own),
            heights: self.heights.as_deref().map_or(&[], Field::values),
            driven,
            pressure: &mut self.pressure,
            approach,
        };
        let convergence = self.set.solve_any(&mut task, limits, observer)?;
        Ok((task.approach, convergence))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_halfspace::operator::{PeriodicOperator, Threads};
    use carom_halfspace::{Material, MaterialPair};

    #[test]
    fn grids_that_were_given_back_are_made_anew() {
        let grid = Grid::new(128, 128, 0.1, 0.1).unwrap();
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let operator = PeriodicOperator::new(pair, grid, Threads::One).unwrap();
        let waves = Field::from_function(grid, |x, y| 0.1 * ((2.0 * x).cos() + y.sin()));
        let heights = Arc::new(waves);
        let coarser = || nested::coarser_operators(&operator);
        let mut grids = NormalGrids::new(&operator, &heights, coarser).unwrap();
        let target = Target { tolerance: 1e-8, iterations: 1000 };
        let solved = |grids: &mut NormalGrids| {
            grids.start(&operator, Driven::Load(0.5), target).unwrap();
            let start = grids.pressure().to_vec();
            (start, grids.solve(&operator, Driven::Load(0.5), target, &mut ()).unwrap())
        };
        let first = solved(&mut grids);
        assert!(grids.levels.len() > 2);
        grids.levels[1..].iter_mut().for_each(Level::forget);
        assert_eq!(solved(&mut grids), first);
    }
}
