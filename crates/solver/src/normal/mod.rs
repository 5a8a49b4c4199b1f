//! The normal problem: pressures without friction (11.5).

mod active_set;
mod level;

use std::sync::Arc;

use carom_halfspace::Grid;
use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, TractionField, Workspace,
};
use carom_special::RangeError;

use crate::convergence::{Convergence, Observer, Products, Stop};
use crate::drive::{Drive, Driven};
use crate::method::Method;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use active_set::{ActiveSet, Limits, NormalTask};

/// Grids with fewer cells along a side than this are not made coarser.
const COARSEST: usize = 32;
/// Coarse grids stop when a correction changes the pressure by less than this, the coarsest by
/// less than a tenth of it.
const COARSE_CHANGE: f64 = 1e-2;

/// Contact without friction: preconditioned conjugate gradients on an active set, started from
/// coarser grids where operator and gap allow that.
///
/// The approach or the normal force is given; tangential shifts have no effect.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction};
/// use carom_solver::{ContactProblem, ContactState, Drive, Driven, Frictionless, Gap, Method};
/// let grid = Grid::new(48, 48, 0.05, 0.05)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.5)?;
/// let pair = MaterialPair::new(body, Material::RIGID)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::NONE)?;
/// let method = Frictionless::default();
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// let drive = Drive { normal: Driven::Shift(1.0), ..Drive::default() };
/// method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// // Hertz: a sphere of radius 1, a = 1, F_z = (4/3) (2 G) a^3/R.
/// assert!((state.load().f_z / (16.0 / 3.0) - 1.0).abs() < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frictionless {
    tolerance: f64,
    iterations: usize,
}

/// Why a frictionless step failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NormalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// The problem has friction, of which this method knows nothing.
    #[error("the surfaces have friction: this method takes frictionless ones only")]
    Friction,
    /// Iterations ended before the tolerance was reached.
    #[error(
        "the pressure is not found within {:.1e}: {:.1e} after {} iterations ({:?})",
        .tolerance, .reached.residuals.normal, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// The tolerance.
        tolerance: f64,
        /// How far it got.
        reached: Convergence,
    },
}

impl Default for Frictionless {
    /// To 1e-10 of the greatest displacement.
    fn default() -> Self {
        Self { tolerance: 1e-10, iterations: 1000 }
    }
}

impl Frictionless {
    /// To another tolerance: the greatest gap in the contact, or overlap outside, over the greatest
    /// displacement.
    ///
    /// # Errors
    /// [`RangeError`] unless it lies in 1e-14 to 0.1.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-14..=0.1).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-14 to 0.1")?;
        Ok(Self { tolerance, ..self })
    }

    /// With at most as many iterations on each grid.
    #[must_use]
    pub const fn at_most(self, iterations: usize) -> Self {
        Self { iterations, ..self }
    }
}

/// The grids of a problem, finest first, with their working memory.
#[derive(Clone)]
pub struct NormalScratch {
    levels: Vec<Level>,
    workspace: Workspace,
}

#[derive(Clone)]
struct Level {
    grid: Grid,
    /// None on the finest grid: that of the problem.
    operator: Option<Arc<dyn SurfaceOperator>>,
    heights: Vec<f64>,
    pressure: Vec<f64>,
    set: ActiveSet,
}

impl Level {
    fn new(operator: &dyn SurfaceOperator, heights: Vec<f64>) -> Self {
        let (grid, pressure) = (operator.grid(), vec![0.0; heights.len()]);
        Self { grid, operator: None, heights, pressure, set: ActiveSet::new(operator) }
    }

    fn coarser(&self, own: &dyn SurfaceOperator) -> Result<Option<Self>, OperatorError> {
        let small = self.grid.nx().min(self.grid.ny()) < COARSEST;
        // A known outline needs no coarse grids, and the peaks at its edge are lost on them.
        if small || self.heights.iter().any(|height| height.is_infinite()) {
            return Ok(None);
        }
        let Some(operator) = self.operator.as_deref().unwrap_or(own).coarser() else {
            return Ok(None);
        };
        let operator: Arc<dyn SurfaceOperator> = operator?.into();
        let heights = level::coarser_heights(self.grid, &self.heights, operator.grid());
        let level = Self::new(&*operator, heights);
        Ok(Some(Self { operator: Some(operator), ..level }))
    }

    /// A first guess where nothing better is known: round pressures where the bodies come closest.
    fn guess(&mut self, driven: Driven) {
        let mut heights: Vec<f64> =
            self.heights.iter().copied().filter(|height| height.is_finite()).collect();
        heights.sort_by(f64::total_cmp);
        let lowest = heights.first().copied().unwrap_or(0.0);
        let top = match driven {
            Driven::Shift(approach) => approach,
            Driven::Load(_) => heights.get(heights.len() / 4).copied().unwrap_or(lowest),
        };
        let span = top - lowest;
        for (pressure, height) in self.pressure.iter_mut().zip(&self.heights) {
            *pressure = if *height > top {
                0.0
            } else if span > 0.0 {
                ((top - height) / span).sqrt()
            } else {
                1.0
            };
        }
    }
}

impl Method for Frictionless {
    type Error = NormalError;
    type Scratch = NormalScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<NormalScratch, NormalError> {
        if !problem.friction().is_none() {
            return Err(NormalError::Friction);
        }
        let own = problem.operator();
        let mut levels = vec![Level::new(own, problem.gap().heights().values().to_vec())];
        while let Some(level) = levels[levels.len() - 1].coarser(own)? {
            levels.push(level);
        }
        Ok(NormalScratch { levels, workspace: own.workspace() })
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut NormalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, NormalError> {
        drive.check()?;
        from.check_grid(problem.grid())?;
        let loads = [("F_x", drive.x), ("F_y", drive.y), ("M_z", drive.twist)];
        for (name, driven) in loads {
            if let Driven::Load(load) = driven {
                RangeError::check(name, load, load == 0.0, "0 without friction")?;
            }
        }
        let convergence = self.pressures(problem, drive.normal, scratch, observer, to)?;
        let kept = |driven, before| match driven {
            Driven::Shift(shift) => shift,
            Driven::Load(_) => before,
        };
        to.shift.xi = kept(drive.x, from.shift.xi);
        to.shift.eta = kept(drive.y, from.shift.eta);
        to.shift.omega = kept(drive.twist, from.shift.omega);
        Ok(convergence)
    }
}

impl Frictionless {
    fn pressures(
        &self,
        problem: &ContactProblem,
        driven: Driven,
        scratch: &mut NormalScratch,
        observer: &mut dyn Observer,
        to: &mut ContactState,
    ) -> Result<Convergence, NormalError> {
        let heights = problem.gap().heights().values();
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let grid = problem.grid();
        *to = ContactState::apart(grid);
        let apart = match driven {
            Driven::Shift(approach) => (approach <= lowest).then_some(approach),
            Driven::Load(force) => (force == 0.0).then_some(lowest),
        };
        if let Some(approach) = apart {
            to.shift.zeta = approach;
            let (products, residuals) = Default::default();
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        let (approach, convergence) = self.nested(problem, driven, scratch, observer)?;
        if convergence.stop != Stop::Converged {
            let tolerance = self.tolerance;
            return Err(NormalError::NotConverged { tolerance, reached: convergence });
        }
        let pressure = &scratch.levels[0].pressure;
        to.shift.zeta = approach;
        to.pressure.values_mut().copy_from_slice(pressure);
        for (cell, pressure) in to.cells.values_mut().iter_mut().zip(pressure) {
            *cell = if *pressure > 0.0 { CellState::Slip } else { CellState::Exterior };
        }
        let mut products = convergence.products;
        if problem.operator().is_coupled() {
            let displacements = DisplacementField::tangential(
                to.displacement_x.values_mut(),
                to.displacement_y.values_mut(),
            );
            let load = TractionField::normal(pressure);
            problem.operator().apply(load, displacements, &mut scratch.workspace)?;
            products.coupling += 1.0;
        }
        Ok(Convergence { products, ..convergence })
    }

    /// From the coarsest grid to the finest; the approach there.
    fn nested(
        &self,
        problem: &ContactProblem,
        driven: Driven,
        scratch: &mut NormalScratch,
        observer: &mut dyn Observer,
    ) -> Result<(f64, Convergence), NormalError> {
        let levels = &mut scratch.levels;
        let coarsest = levels.len() - 1;
        levels[coarsest].guess(driven);
        let mut spent = Products::default();
        for i in (1..=coarsest).rev() {
            let change = if i == coarsest { 0.1 * COARSE_CHANGE } else { COARSE_CHANGE };
            let limits = Limits { tolerance: self.tolerance, change, iterations: self.iterations };
            let (_, coarse) = levels[i].solve(problem, driven, limits, &mut ())?;
            let part = levels[i].grid.cells() as f64 / problem.grid().cells() as f64;
            spent = spent.plus(coarse.products.times(part));
            let (finer, coarser) = levels.split_at_mut(i);
            let (fine, coarse) = (&mut finer[i - 1], &coarser[0]);
            fine.pressure = level::finer_pressure(coarse.grid, &coarse.pressure, fine.grid);
            if !fine.pressure.iter().any(|pressure| *pressure > 0.0) {
                fine.guess(driven);
            }
        }
        let limits = Limits { tolerance: self.tolerance, change: 0.0, iterations: self.iterations };
        let (approach, finest) = levels[0].solve(problem, driven, limits, observer)?;
        Ok((approach, Convergence { products: spent.plus(finest.products), ..finest }))
    }
}

impl Level {
    fn solve(
        &mut self,
        problem: &ContactProblem,
        driven: Driven,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<(f64, Convergence), OperatorError> {
        let approach = match driven {
            Driven::Shift(approach) => approach,
            Driven::Load(_) => 0.0,
        };
        let mut task = NormalTask {
            operator: self.operator.as_deref().unwrap_or(problem.operator()),
            heights: &self.heights,
            driven,
            pressure: &mut self.pressure,
            approach,
        };
        let convergence = self.set.solve(&mut task, limits, observer)?;
        Ok((task.approach, convergence))
    }
}
