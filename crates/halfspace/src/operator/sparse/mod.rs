//! The influence of pressures among a small part of the cells, in a time that grows with their number.
//!
//! Where a hundredth of a rough surface touches, a product with all cells by Fourier transforms is wasted on the
//! others. Here the influence between points far apart is that between the nodes of coarser and coarser grids (Brandt
//! and Lubrecht, J. Comput. Phys. 90, 1990), with nodes only about the chosen cells, and the coarsest grid uses
//! transforms. All is in single precision, in units of the influence of a cell on itself and of the greatest pressure.
//! The product is symmetric; its error is below [`SPARSENESS`].

mod level;
mod stencil;
mod sums;

use std::sync::Arc;

use super::length::Sizes;
use super::plan::Plan;
use super::precision::Real as _;
use super::product::{Term, Terms};
use super::spectrum::{Parity, Spectrum};
use super::torus::TorusInverse;
use super::{
    Axis, DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads,
    TractionField, Workspace,
};
use crate::{Coefficients, Grid, MaterialPair};
use level::{Frame, Level};
use stencil::Stencil;

/// Error of a product among some of the cells, over the greatest displacement plus what the influence of a cell on itself
/// makes of the root of the sum of all squared pressures, as for [`ROUGHNESS`](super::ROUGHNESS). Measured: 5e-4 at most,
/// under one loaded cell; 2e-4 under smooth pressures.
pub const SPARSENESS: f64 = 1e-3;

/// The coarsest grid has at most about so many cells.
const COARSEST: usize = 1 << 16;
/// No grid of fewer cells along an axis has a coarser one.
const LEAST: usize = 64;
/// The sides of a cell differ by this factor at most.
const SLENDEREST: f64 = 2.0;

/// The inverse counts neighbours up to this offset.
const INVERSE_REACH: usize = 4;
type InverseStencil = [[f32; 2 * INVERSE_REACH + 8]; 2 * INVERSE_REACH + 1];

/// What inverts the influence, as if the cells of all grids were those of the finest.
struct Inverse {
    /// Alone, on the finest grid.
    alone: InverseStencil,
    /// Beside coarser grids, the same for all kinds of places.
    stencils: [InverseStencil; 4],
    /// The pressure on a cell that alone is displaced, by its displacement.
    scale: f64,
    coarsest: TorusInverse<f32>,
}

/// The influence on all grids, of one operator.
pub(crate) struct Hierarchy {
    grid: Grid,
    threads: Threads,
    /// The finest grid and those below it.
    frames: Vec<Frame>,
    stencils: Vec<[Stencil; 4]>,
    plan: Plan<f32>,
    coarsest: Spectrum<f32>,
    /// The unit of the coarsest spectrum.
    unit: f64,
    inverse: Inverse,
    /// The influence of a cell on itself.
    own: f64,
}

impl Hierarchy {
    /// From the normal displacement of a cell due to the pressure on another one, by their offset, the
    /// materials and whether the surface repeats itself. `None` if grids cannot be made coarser.
    pub(crate) fn new(
        (grid, threads): (Grid, Threads),
        kernel: impl Fn(i32, i32) -> f64 + Sync,
        pair: &MaterialPair,
        periodic: bool,
    ) -> Option<Self> {
        let slender = grid.dx().max(grid.dy()) / grid.dx().min(grid.dy());
        let first = Frame { first: [0, 0], counts: [grid.nx(), grid.ny()], periodic };
        if slender > SLENDEREST || u32::try_from(first.stored()).is_err() {
            return None;
        }
        let own = kernel(0, 0);
        let kernel = |columns: i32, rows: i32| kernel(columns, rows) / own;
        let mut frames = vec![first];
        let mut stencils = Vec::new();
        loop {
            let last = frames[frames.len() - 1];
            let [nx, ny] = last.counts;
            let even = !periodic || (nx.is_multiple_of(2) && ny.is_multiple_of(2));
            let small = !stencils.is_empty() && nx * ny <= COARSEST * 5 / 4;
            if small || nx.min(ny) < LEAST || !even {
                break;
            }
            let spacing = 1 << stencils.len();
            stencils.push(stencil::stencils(&|x, y| kernel(spacing * x, spacing * y)));
            frames.push(last.coarser());
        }
        let (spacing, coarse) = (1 << stencils.len(), frames[frames.len() - 1]);
        if stencils.is_empty() {
            return None;
        }
        let [nx, ny] = coarse.counts;
        let cells = Grid::new(nx, ny, grid.dx(), grid.dy()).ok()?;
        let sizes = if periodic { Sizes::of_period(cells) } else { Sizes::of(cells) };
        let fill = |row: usize, values: &mut [f64]| {
            for (column, value) in values.iter_mut().enumerate() {
                *value = kernel(spacing * column as i32, spacing * row as i32);
            }
        };
        let coarsest = Spectrum::symmetric(&Plan::on(sizes, threads), fill, [Parity::Even; 2]);
        let (plan, unit) = (Plan::on(sizes, threads), coarsest.greatest());
        let (coarsest, inverse) = (coarsest.over(unit), Inverse::new(cells, threads, pair)?);
        Some(Self { grid, threads, frames, stencils, plan, coarsest, unit, inverse, own })
    }

    /// The influence among these cells, in ascending order.
    pub(crate) fn among(self: &Arc<Self>, cells: &[usize]) -> Option<SparseOperator> {
        let (frame, nx) = (self.frames[0], self.grid.nx());
        let points = cells.iter().map(|cell| frame.at(cell % nx, cell / nx) as u32).collect();
        let grid = Grid::new(cells.len(), 1, self.grid.dx(), self.grid.dy()).ok()?;
        let mut levels = vec![Level { frame, points }];
        for _ in &self.stencils {
            levels.push(levels[levels.len() - 1].coarser());
        }
        Some(SparseOperator { hierarchy: Arc::clone(self), levels: levels.into(), grid })
    }
}

impl Inverse {
    /// With the numbers of cells of the coarsest grid.
    fn new(coarsest: Grid, threads: Threads, pair: &MaterialPair) -> Option<Self> {
        let torus = Grid::new(TORUS, TORUS, coarsest.dx(), coarsest.dy()).ok()?;
        let (mut unit, mut pressure) = (vec![0.0; torus.cells()], vec![0.0; torus.cells()]);
        unit[torus.index(TORUS / 2, TORUS / 2)] = 1.0;
        let inverse = TorusInverse::<f64>::new(pair, torus, Threads::One);
        inverse.pressure(&unit, &mut pressure, &mut Workspace::default());
        let scale = pressure[torus.index(TORUS / 2, TORUS / 2)];
        pressure.iter_mut().for_each(|pressure| *pressure /= scale);
        let (alone, mean) = inverse_stencil(torus, &pressure, 0.0);
        let stencils = [inverse_stencil(torus, &pressure, mean).0; 4];
        let coarsest = TorusInverse::new(pair, coarsest, threads);
        Some(Self { alone, stencils, scale, coarsest })
    }
}

/// Cells along the sides of a torus on which the stencil is made.
const TORUS: usize = 32;

/// The pressures about one cell that alone is displaced, `less` a number, and their mean. Factors that fall towards the end
/// of the stencil keep it positive definite. Less the mean it leaves out what does not change from cell to cell.
fn inverse_stencil(torus: Grid, pressure: &[f64], less: f64) -> (InverseStencil, f64) {
    let factor =
        |place: usize| 1.0 - place.abs_diff(INVERSE_REACH) as f64 / (INVERSE_REACH + 1) as f64;
    let (mut stencil, first) = (InverseStencil::default(), TORUS / 2 - INVERSE_REACH);
    let (mut sum, mut weight) = (0.0, 0.0);
    for (row, values) in stencil.iter_mut().enumerate() {
        for (column, value) in values[..=2 * INVERSE_REACH].iter_mut().enumerate() {
            let own = pressure[torus.index(first + column, first + row)] - less;
            let factor = factor(row) * factor(column);
            (sum, weight) = (sum + factor * own, weight + factor);
            *value = (factor * own) as f32;
        }
    }
    (stencil, sum / weight)
}

/// The influence of pressures among chosen cells. Fields hold the values of these cells, so that its grid is a row of
/// them.
pub(crate) struct SparseOperator {
    hierarchy: Arc<Hierarchy>,
    levels: Arc<[Level]>,
    grid: Grid,
}

/// The working memory of a product. All pressures are zero between products.
#[derive(Debug, Clone, Default)]
pub(crate) struct SparseSpace {
    pressures: Vec<Vec<f32>>,
    displacements: Vec<Vec<f32>>,
    /// The values of the points of one grid.
    values: Vec<f32>,
    /// Pressures and displacements on the coarsest grid.
    coarsest: [Vec<f64>; 2],
}

impl SparseSpace {
    fn prepare(&mut self, levels: &[Level]) {
        let fits = |fields: &[Vec<f32>]| {
            fields.len() == levels.len()
                && fields
                    .iter()
                    .zip(levels)
                    .all(|(field, level)| field.len() == level.frame.stored())
        };
        if !fits(&self.pressures) {
            let zero = || levels.iter().map(|level| vec![0.0; level.frame.stored()]).collect();
            (self.pressures, self.displacements) = (zero(), zero());
            let cells = levels.last().map_or(0, |level| level.frame.counts.iter().product());
            self.coarsest = [vec![0.0; cells], vec![0.0; cells]];
        }
        self.values.resize(levels.iter().map(|level| level.points.len()).max().unwrap_or(0), 0.0);
    }
}

impl SurfaceOperator for SparseOperator {
    fn grid(&self) -> Grid {
        self.grid
    }

    fn threads(&self) -> Threads {
        self.hierarchy.threads
    }

    fn is_coupled(&self) -> bool {
        false
    }

    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        let mut coefficients = Coefficients::default();
        if (columns, rows) == (0, 0) {
            coefficients.rows[2][2] = self.hierarchy.own;
        }
        coefficients
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        let (levels, hierarchy) = (Arc::clone(&self.levels), Arc::clone(&self.hierarchy));
        Some(Arc::new(SparseInverse { hierarchy, levels }))
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        tractions.check(self.grid.cells())?;
        displacements.check(self.grid.cells())?;
        let [None, None, Some(pressure)] = tractions.by_axis() else {
            let (of, by) = (Axis::Normal.displacement_name(), Axis::X.traction_name());
            return Err(OperatorError::Missing { of, by });
        };
        let [None, None, Some(found)] = displacements.by_axis() else {
            let (of, by) = (Axis::X.displacement_name(), Axis::Normal.traction_name());
            return Err(OperatorError::Missing { of, by });
        };
        self.product(pressure, found, workspace);
        Ok(())
    }
}

impl SparseSpace {
    /// The values on the coarsest grid.
    fn give_coarsest(&mut self, frame: &Frame) {
        let (Some(pressures), nx) = (self.pressures.last(), frame.counts[0]) else { return };
        for (row, values) in self.coarsest[0].chunks_exact_mut(nx).enumerate() {
            let from = &pressures[frame.at(0, row)..][..nx];
            values.iter_mut().zip(from).for_each(|(value, from)| *value = f64::from(*from));
        }
    }

    /// A part of what was found there.
    fn take_coarsest(&mut self, frame: &Frame, part: f32) {
        let (Some(displacements), nx) = (self.displacements.last_mut(), frame.counts[0]) else {
            return;
        };
        for (row, values) in self.coarsest[1].chunks_exact(nx).enumerate() {
            let to = &mut displacements[frame.at(0, row)..][..nx];
            values.iter().zip(to).for_each(|(value, to)| *to = part * *value as f32);
        }
        frame.repeat(displacements);
    }

    /// Puts the values of cells into the finest grid; returns their unit.
    fn take(&mut self, level: &Level, values: &[f64]) -> f64 {
        let unit = f32::unit(&[values], Threads::One);
        let per_unit = 1.0 / unit;
        for (own, value) in self.values.iter_mut().zip(values) {
            *own = (value * per_unit) as f32;
        }
        level.scatter(&self.values, &mut self.pressures[0]);
        unit
    }

    /// Gives the values found for the cells, in a unit.
    fn give(&self, unit: f64, found: &mut [f64]) {
        for (found, value) in found.iter_mut().zip(&self.values) {
            *found = unit * f64::from(*value);
        }
    }
}

impl SparseOperator {
    fn product(&self, pressure: &[f64], found: &mut [f64], workspace: &mut Workspace) {
        let hierarchy = &*self.hierarchy;
        let cascade = Cascade { levels: &self.levels, threads: hierarchy.threads, part: 1.0 };
        let on_coarsest = |[given, found]: &mut [Vec<f64>; 2], workspace: &mut Workspace| {
            let mut blocks = [[None; 3]; 3];
            blocks[0][0] = Some(Term { spectrum: &hierarchy.coarsest, sign: 1.0 });
            let terms = Terms { blocks: &blocks, unit: hierarchy.unit };
            hierarchy.plan.product(&[given], &terms, &mut [found], workspace);
        };
        let stencils = |level: usize| &hierarchy.stencils[level];
        cascade.run(stencils, on_coarsest, (pressure, hierarchy.own, found), workspace);
    }
}

/// A symmetric product that is a sum over all grids: of the values on each one with a stencil, and on the coarsest grid
/// with transforms.
struct Cascade<'a> {
    levels: &'a [Level],
    threads: Threads,
    /// What a grid has of the values on the next coarser one.
    part: f32,
}

impl Cascade<'_> {
    fn run<'s, const R: usize, const W: usize>(
        &self,
        stencils: impl Fn(usize) -> &'s [[[f32; W]; R]; 4],
        on_coarsest: impl FnOnce(&mut [Vec<f64>; 2], &mut Workspace),
        (given, scale, found): (&[f64], f64, &mut [f64]),
        workspace: &mut Workspace,
    ) {
        let levels = self.levels;
        let mut space = std::mem::take(&mut workspace.sparse);
        space.prepare(levels);
        let unit = space.take(&levels[0], given);
        for at in 1..levels.len() {
            let (fine, coarse) = space.pressures.split_at_mut(at);
            levels[at].gather(&levels[at - 1].frame, &fine[at - 1], &mut space.values);
            levels[at].scatter(&space.values, &mut coarse[0]);
        }
        let last = levels.len() - 1;
        space.give_coarsest(&levels[last].frame);
        on_coarsest(&mut space.coarsest, workspace);
        space.take_coarsest(&levels[last].frame, self.part);
        for at in (0..last).rev() {
            let (level, count) = (&levels[at], levels[at].points.len());
            let (fine, coarse) = space.displacements.split_at_mut(at + 1);
            let nodes = (&levels[at + 1].frame, &coarse[0][..]);
            let own = (stencils(at), &space.pressures[at][..]);
            level.values(own, nodes, self.threads, &mut space.values[..count]);
            if at > 0 {
                space.values[..count].iter_mut().for_each(|value| *value *= self.part);
                level.scatter(&space.values, &mut fine[at]);
            }
        }
        space.give(unit * scale, found);
        for (level, pressures) in levels.iter().zip(&mut space.pressures) {
            level.clear(pressures);
        }
        workspace.sparse = space;
    }
}

/// The inverse among chosen cells. Of few cells it is made of their neighbours alone. Of many it is a sum over all grids,
/// where a stencil inverts waves of a few cells (Bramble, Pasciak and Xu, Math. Comput. 55, 1990), so that the number of
/// iterations does not grow with the patches of contact.
struct SparseInverse {
    hierarchy: Arc<Hierarchy>,
    levels: Arc<[Level]>,
}

/// So many cells are many.
const MANY: usize = 1 << 15;

/// An influence falls with the distance, and each node stands for four cells: the inverse on the next coarser grid,
/// interpolated at both points, is this part of that on the finer one.
const COARSER_INVERSE: f32 = 0.125;

impl Preconditioner for SparseInverse {
    fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        if displacement.len() < MANY {
            self.by_neighbours(displacement, pressure, workspace);
        } else {
            self.by_all_grids(displacement, pressure, workspace);
        }
    }
}

impl SparseInverse {
    fn by_neighbours(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        let (level, hierarchy) = (&self.levels[0], &*self.hierarchy);
        let space = &mut workspace.sparse;
        space.prepare(&self.levels);
        let unit = space.take(level, displacement);
        let SparseSpace { pressures, values, .. } = space;
        let found = &mut values[..level.points.len()];
        level.product(&hierarchy.inverse.alone, &pressures[0], hierarchy.threads, found);
        space.give(unit / hierarchy.own, pressure);
        level.clear(&mut space.pressures[0]);
    }

    fn by_all_grids(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        let (levels, hierarchy) = (&*self.levels, &*self.hierarchy);
        let cascade = Cascade { levels, threads: hierarchy.threads, part: COARSER_INVERSE };
        let Inverse { stencils, scale, coarsest, .. } = &hierarchy.inverse;
        let on_coarsest = |[given, found]: &mut [Vec<f64>; 2], workspace: &mut Workspace| {
            coarsest.pressure(given, found, workspace);
            found.iter_mut().for_each(|value| *value /= scale);
        };
        let given = (displacement, 1.0 / hierarchy.own, pressure);
        cascade.run(|_| stencils, on_coarsest, given, workspace);
    }
}
