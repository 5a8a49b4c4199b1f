//! The tangential problem at given pressures, started from coarser grids.

mod active_set;
mod compressed;
mod contact;
mod descent;
mod iteration_state;
mod law;
mod limit_surface;
mod loads;
mod newton;
mod plane;
mod precondition;
mod rigid;
mod search;
mod search_scratch;
mod sets;
mod solve;
mod task;
#[cfg(test)]
mod tests;

use std::ops::Range;
use std::sync::Arc;

use carom_halfspace::Grid;
use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, Threads, TractionField, Workspace,
};

use crate::convergence::{Convergence, Observer, Products, Stop};
use crate::nested;
use crate::parts;
use crate::state::CellState;
use active_set::ActiveSet;
use law::REACHED;
use plane::{Plane, slices};
use task::Limits;

pub(crate) use law::project_to_disc;
pub(crate) use limit_surface::LimitSurface;
pub(crate) use rigid::{Rigid, displacement, half_diagonal};
pub(crate) use task::TangentialTask;

/// The iteration on coarse grids stops when a correction changes the tractions by less than this
/// fraction, on the coarsest grid by less than a tenth of it.
const COARSE_CHANGE: f64 = 1e-2;
/// Iterations on a coarse grid after which a step starts from its tractions as they are: loads close
/// to the friction limit may be beyond it there.
const COARSE_ITERATIONS: usize = 100;
/// Number of rings of cells around the contact to which the ratio of traction to bound is extended.
const EXTENSION_RINGS: usize = 2;

/// Adds the displacements due to tractions to a field, by way of `image`.
fn add_displacement(
    operator: &dyn SurfaceOperator,
    traction: [&[f64]; 2],
    field: &mut Plane,
    (image, workspace): (&mut Plane, &mut Workspace),
) -> Result<(), OperatorError> {
    for values in &mut *image {
        values.resize(traction[0].len(), 0.0);
    }
    let [u, v] = image;
    let load = TractionField::tangential(traction[0], traction[1]);
    operator.apply(load, DisplacementField::tangential(u, v), workspace)?;
    for (values, image) in field.iter_mut().zip(image) {
        values.iter_mut().zip(image).for_each(|(value, image)| *value += *image);
    }
    Ok(())
}

/// Projects tractions onto their discs. Returns whether they were within them, to round-off, and whether some are left.
fn project(threads: Threads, limits: &[f64], traction: [&mut [f64]; 2]) -> (bool, bool) {
    let work = |(limits, [x, y]): (&[f64], [&mut [f64]; 2])| {
        let (mut is_kept, mut is_loaded) = (true, false);
        for ((x, y), limit) in x.iter_mut().zip(y).zip(limits) {
            is_kept &= (*x * *x + *y * *y).sqrt() * REACHED <= *limit;
            [*x, *y] = project_to_disc([*x, *y], *limit);
            is_loaded |= *x != 0.0 || *y != 0.0;
        }
        (is_kept, is_loaded)
    };
    parts::fold(threads, (limits, traction), &work, &|one, other| {
        (one.0 && other.0, one.1 || other.1)
    })
}

/// Whether nothing else is to be tried.
const fn has_ended(reached: &Convergence) -> bool {
    matches!(reached.stop, Stop::Converged | Stop::Observer)
}

/// Numbers of cells, their bounds, tractions and states.
type OnCells<'a> = (Range<usize>, &'a [f64], [&'a mut [f64]; 2], &'a mut [CellState]);

/// The coarser grids of the problem, finest first, and the working memory of all grids.
#[derive(Clone)]
pub(crate) struct TangentialScratch {
    set: ActiveSet,
    coarse: Vec<Level>,
    /// Whether prescribed loads are found by iterating on the shifts in this step.
    by_motions: bool,
    /// Initial tractions of a task with prescribed loads, or of a step.
    begun: Plane,
    cells: Vec<CellState>,
    /// The slip at the beginning of a step, and displacements due to tractions.
    slip: Plane,
    image: Plane,
    workspace: Workspace,
}

#[derive(Clone)]
struct Level {
    grid: Grid,
    operator: Arc<dyn SurfaceOperator>,
    set: ActiveSet,
    limits: Vec<f64>,
    /// Tractions and slip at the beginning of the step, as means over the finer cells.
    begun: Plane,
    slip: Plane,
    /// What makes that slip of those tractions on these cells.
    offset: Plane,
    rigid: Rigid,
    pressure: f64,
    traction: Plane,
    cells: Vec<CellState>,
}

impl Level {
    fn new(operator: &Arc<dyn SurfaceOperator>) -> Self {
        let grid = operator.grid();
        let zero = || vec![0.0; grid.cells()];
        Self {
            grid,
            set: ActiveSet::new(&**operator),
            operator: Arc::clone(operator),
            limits: zero(),
            begun: Plane::default(),
            slip: Plane::default(),
            offset: [zero(), zero()],
            rigid: Rigid::default(),
            pressure: 0.0,
            traction: [zero(), zero()],
            cells: vec![CellState::Exterior; grid.cells()],
        }
    }

    /// Takes the problem of a finer grid, with its tractions and slip at the beginning of the step.
    fn take(
        &mut self,
        (fine, threads): (Grid, Threads),
        limits: &[f64],
        [begun, slip]: [[&[f64]; 2]; 2],
        rigid: &Rigid,
    ) {
        self.rigid = rigid.on_cells(self.grid.cell_area() / fine.cell_area());
        let coarser = |values: &[f64]| nested::coarser(fine, values, self.grid, threads);
        self.begun = begun.map(coarser);
        self.slip = slip.map(coarser);
        self.limits = nested::coarser(fine, limits, self.grid, threads);
        for (cell, limit) in self.cells.iter_mut().zip(&self.limits) {
            *cell = if *limit > 0.0 { CellState::Stick } else { CellState::Exterior };
        }
        for axis in 0..2 {
            self.offset[axis].clone_from(&self.slip[axis]);
            self.traction[axis].clone_from(&self.begun[axis]);
        }
    }

    /// Takes the displacements due to the tractions at the beginning out of the offset.
    fn compensate(
        &mut self,
        image: &mut Plane,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        let against = self.begun.each_ref().map(|values| values.iter().map(|t| -t).collect());
        let against: Plane = against;
        let space = (image, workspace);
        add_displacement(&*self.operator, slices(&against), &mut self.offset, space)
    }

    fn solve(&mut self, limits: Limits) -> Result<Convergence, OperatorError> {
        let [x, y] = &mut self.traction;
        let mut task = TangentialTask {
            operator: &*self.operator,
            limits: &self.limits,
            offset: [&self.offset[0], &self.offset[1]],
            rigid: self.rigid,
            pressure: self.pressure,
            traction: [x, y],
            cells: &mut self.cells,
        };
        let convergence = self.set.solve(&mut task, limits, &mut ())?;
        self.rigid = task.rigid;
        Ok(convergence)
    }

    /// Passes the change of the tractions in this step to the finer grid, as a ratio to the bound. A
    /// fine cell slips, with its full traction, if half of the coarse cells around it slip.
    fn pass_on(
        &self,
        (fine, threads): (Grid, Threads),
        limits: &[f64],
        traction: [&mut [f64]; 2],
        cells: &mut [CellState],
    ) {
        let unit = |limit: f64| if limit.is_finite() { limit } else { 1.0 };
        let known: Vec<bool> = self.limits.iter().map(|limit| *limit > 0.0).collect();
        let spread = |value: &dyn Fn(usize) -> f64| {
            let value = |i: usize| if known[i] { value(i) } else { 0.0 };
            let mut values: Vec<f64> = (0..known.len()).map(value).collect();
            nested::extended(self.grid, &mut values, &known, EXTENSION_RINGS);
            values
        };
        let ratio = |axis: usize| {
            spread(&|i| (self.traction[axis][i] - self.begun[axis][i]) / unit(self.limits[i]))
        };
        let slipping = spread(&|i| f64::from(u8::from(self.cells[i] == CellState::Slip)));
        let (along, across) = (ratio(0), ratio(1));
        let passage = nested::Passage::new(self.grid, fine);
        let one = |i: usize, limit: f64, [x, y]: [f64; 2]| {
            if limit <= 0.0 {
                return ([0.0, 0.0], CellState::Exterior);
            }
            let along = x / unit(limit) + passage.at(&along, i);
            let across = y / unit(limit) + passage.at(&across, i);
            let norm = along.hypot(across);
            let slips = norm > 0.0 && passage.at(&slipping, i) >= 0.5;
            let part = if slips || norm > 1.0 { unit(limit) / norm } else { unit(limit) };
            let cell = if slips { CellState::Slip } else { CellState::Stick };
            ([part * along, part * across], cell)
        };
        parts::each(threads, (0..limits.len(), limits, traction, cells), &|all: OnCells<'_>| {
            let (numbers, limits, [x, y], cells) = all;
            let tractions = x.iter_mut().zip(y).zip(cells);
            for ((i, limit), ((x, y), cell)) in numbers.zip(limits).zip(tractions) {
                ([*x, *y], *cell) = one(i, *limit, [*x, *y]);
            }
        });
    }
}

impl TangentialScratch {
    /// With coarser grids of the operator, finest first.
    pub(crate) fn new(
        operator: &dyn SurfaceOperator,
        coarser: &[Arc<dyn SurfaceOperator>],
    ) -> Self {
        let coarse = coarser.iter().map(Level::new).collect();
        Self {
            set: ActiveSet::new(operator),
            coarse,
            by_motions: false,
            begun: Plane::default(),
            cells: Vec::new(),
            slip: Plane::default(),
            image: Plane::default(),
            workspace: Workspace::default(),
        }
    }

    /// Forgets how prescribed loads were found in the last step.
    pub(crate) fn begin_step(&mut self) {
        self.by_motions = false;
    }

    /// From now on finds prescribed loads by iterating on the shifts: the loads are close to the
    /// limit.
    pub(crate) fn find_by_motions(&mut self) {
        self.by_motions = true;
    }

    /// Solves a task to the tolerance, from its own start.
    pub(crate) fn solve(
        &mut self,
        task: &mut TangentialTask<'_>,
        tolerance: f64,
        iterations: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let limits = Limits { tolerance, change: 0.0, iterations };
        let given = task.rigid;
        if given.loads == [None; 3] {
            return self.set.solve(task, limits, observer);
        }
        for (begun, traction) in self.begun.iter_mut().zip(&task.traction) {
            begun.clear();
            begun.extend_from_slice(traction);
        }
        self.cells.clear();
        self.cells.extend_from_slice(task.cells);
        let mut products = Products::default();
        if !self.by_motions {
            let reached = self.set.solve(task, limits, observer)?;
            if has_ended(&reached) {
                return Ok(reached);
            }
            // Deflated corrections do not reach these loads.
            self.by_motions = true;
            products = reached.products;
            self.go_back(task, given);
        }
        let reached = self.set.solve_by_motions(task, limits, observer)?;
        products = products.plus(reached.products);
        if has_ended(&reached) || task.operator.is_reciprocal() {
            return Ok(Convergence { products, ..reached });
        }
        self.go_back(task, given);
        let reached = self.set.solve_slowly(task, limits, observer)?;
        Ok(Convergence { products: products.plus(reached.products), ..reached })
    }

    /// Returns to the initial tractions.
    fn go_back(&self, task: &mut TangentialTask<'_>, given: Rigid) {
        for (begun, traction) in self.begun.iter().zip(&mut task.traction) {
            traction.copy_from_slice(begun);
        }
        task.cells.copy_from_slice(&self.cells);
        task.rigid = given;
    }

    /// Replaces the start of a task by the solution on coarser grids. Returns the cost, in products
    /// on the finest grid. Does nothing if there are no coarser grids.
    ///
    /// The coarse grids solve for the change of the tractions in this step: the slip at its beginning
    /// is that of the finest grid (full approximation scheme). `moved` is the rigid motion of the step
    /// if it alone makes the slip of the tractions of the task; `None` if that slip is not known.
    pub(crate) fn start(
        &mut self,
        task: &mut TangentialTask<'_>,
        moved: Option<[f64; 3]>,
        (tolerance, iterations): (f64, usize),
    ) -> Result<Products, OperatorError> {
        let mut spent = Products::default();
        // Coarse cells hold slightly different loads.
        if self.by_motions || self.coarse.is_empty() {
            return Ok(spent);
        }
        let is_loaded = self.begin_coarse(task, moved, &mut spent)?;
        let iterations = if is_loaded { iterations.min(COARSE_ITERATIONS) } else { iterations };
        let (fine, threads) = (task.operator.grid(), task.operator.threads());
        let coarsest = self.coarse.len();
        for i in (0..coarsest).rev() {
            let change = if i + 1 == coarsest { 0.1 * COARSE_CHANGE } else { COARSE_CHANGE };
            let limits = Limits { tolerance, change, iterations };
            let convergence = self.coarse[i].solve(limits)?;
            let part = self.coarse[i].grid.cells() as f64 / fine.cells() as f64;
            spent = spent.plus(convergence.products.times(part));
            if is_loaded && convergence.stop != Stop::Converged {
                return Ok(spent);
            }
            let (finer, coarser) = self.coarse.split_at_mut(i);
            match finer.last_mut() {
                None => {
                    task.rigid.moved = coarser[0].rigid.moved;
                    let [x, y] = &mut task.traction;
                    coarser[0].pass_on((fine, threads), task.limits, [x, y], task.cells);
                }
                Some(level) => {
                    level.rigid.moved = coarser[0].rigid.moved;
                    let [x, y] = &mut level.traction;
                    let (own, limits) = ((level.grid, threads), &level.limits);
                    coarser[0].pass_on(own, limits, [x, y], &mut level.cells);
                }
            }
        }
        Ok(spent)
    }

    /// Gives the task to the coarse grids. Returns whether there are tractions at the beginning.
    fn begin_coarse(
        &mut self,
        task: &mut TangentialTask<'_>,
        moved: Option<[f64; 3]>,
        spent: &mut Products,
    ) -> Result<bool, OperatorError> {
        let Self { coarse, slip, image, workspace, .. } = self;
        let (fine, threads) = (task.operator.grid(), task.operator.threads());
        let [x, y] = &mut task.traction;
        let (is_kept, is_loaded) = project(threads, task.limits, [x, y]);
        match moved.filter(|_| is_kept && is_loaded) {
            Some([dx, dy, turn]) => {
                let [u, v] = &mut *slip;
                u.clear();
                v.clear();
                for row in 0..fine.ny() {
                    u.resize(u.len() + fine.nx(), -(dx + fine.centred_y(row) * turn)); // (12.2)
                    v.extend((0..fine.nx()).map(|column| -(dy - fine.centred_x(column) * turn)));
                }
            }
            None => {
                for (slip, offset) in slip.iter_mut().zip(task.offset) {
                    slip.clear();
                    slip.extend_from_slice(offset);
                }
                if is_loaded {
                    add_displacement(task.operator, [x, y], slip, (image, workspace))?;
                    spent.tangential += 1.0;
                }
            }
        }
        for i in 0..coarse.len() {
            coarse[i].pressure = task.pressure;
            let (above, below) = coarse.split_at_mut(i);
            match above.last() {
                None => {
                    let started = [[&**x, &**y], slices(slip)];
                    below[0].take((fine, threads), task.limits, started, &task.rigid);
                }
                Some(level) => {
                    let started = [slices(&level.begun), slices(&level.slip)];
                    below[0].take((level.grid, threads), &level.limits, started, &level.rigid);
                }
            }
            if is_loaded {
                below[0].compensate(image, workspace)?;
                spent.tangential += below[0].grid.cells() as f64 / fine.cells() as f64;
            }
        }
        Ok(is_loaded)
    }
}
