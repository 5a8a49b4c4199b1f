//! The tangential problem at given pressures, by Newton's method on an active set.
//!
//! Coulomb's law in each cell is the condition of a minimum: with the slip s = A t + c, where c is
//! the displacement without tangential tractions, `t.A t/2 + t.c` is least over the discs |t| <= R.
//! A cell that sticks has two unknowns. A cell that slips has one, along the rim of its disc; the
//! curvature of the rim adds `D = -s.e/R` to the diagonal (12.20)-(12.24). Preconditioned conjugate
//! gradients solve for all cells together. The sets of sticking and slipping cells change when the
//! violation of the discs, or of the direction of slip, exceeds the last step. Projections onto the
//! discs and a damped step share one product.
//!
//! All fields are compressed to the cells of the contact; products use the box that contains them.

use std::ops::ControlFlow;

use carom_halfspace::Grid;
use carom_halfspace::operator::{OperatorError, SurfaceOperator};
use nalgebra::Vector3;

use super::compressed::Compressed;
use super::contact::ContactInfluence;
use super::descent::Descent;
use super::iteration_state::IterationState;
use super::law::{Violation, ViolationSums, force_scale, is_lost};
use super::rigid::{self, Deflation, Rigid};
use super::search::Search;
use crate::convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
use crate::state::CellState;

/// The problem and its solution. All fields are on the operator's grid or, once compressed, on the
/// cells of the contact.
pub(crate) struct TangentialTask<'a> {
    pub(crate) operator: &'a dyn SurfaceOperator,
    /// Traction bounds: zero outside the contact, infinite where the surfaces cannot slip.
    pub(crate) limits: &'a [f64],
    /// The displacement c without tangential tractions, minus the prescribed shifts.
    pub(crate) offset: [&'a [f64]; 2],
    /// Prescribed loads, and the shifts found for them.
    pub(crate) rigid: Rigid,
    /// The greatest pressure: a bound above it may never be reached.
    pub(crate) pressure: f64,
    /// Initial tractions and solution.
    pub(crate) traction: [&'a mut [f64]; 2],
    /// Initial states of the cells and those of the solution.
    pub(crate) cells: &'a mut [CellState],
}

/// Stopping criteria.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Greatest violation of the friction law relative to the greatest friction bound.
    pub(super) tolerance: f64,
    /// The iteration also stops when correction and violation, in norm, fall below this fraction of
    /// the tractions; zero: it stops at the tolerance only.
    pub(super) change: f64,
    pub(super) iterations: usize,
}

/// Curvature of the objective below this fraction of its diagonal part counts as zero.
const NEGLIGIBLE_CURVATURE: f64 = 1e-8;

/// Two components in each cell.
pub(super) type Plane = [Vec<f64>; 2];

/// One grid of the tangential problem with its working memory; fields are on the cells of the
/// contact.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) influence: ContactInfluence,
    compressed: Compressed,
    pub(super) centres: Plane,
    pub(super) deflation: Deflation,
    /// The influence of a cell's traction on itself, mean of both directions.
    pub(super) own: f64,
    /// The slip.
    pub(super) slip: Plane,
    /// Directions of the tractions in slipping cells.
    pub(super) rim: Plane,
    /// The curvature term D of the rim in slipping cells.
    pub(super) bend: Vec<f64>,
    /// Terms of the preconditioner in slipping cells: the square root of the weight of the inverse
    /// on a torus, and the diagonal term.
    pub(super) root: Vec<f64>,
    pub(super) alone: Vec<f64>,
    /// The residual of the linearised problem, then the preconditioned step.
    pub(super) rest: Plane,
    pub(super) preconditioned: Plane,
    pub(super) direction: Plane,
    pub(super) image: Plane,
    pub(super) search: Search,
}

impl ActiveSet {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let own = operator.coefficients(0, 0).rows;
        Self {
            influence: ContactInfluence::new(),
            compressed: Compressed::default(),
            centres: Plane::default(),
            deflation: Deflation::default(),
            own: 0.5 * (own[0][0] + own[1][1]),
            slip: Plane::default(),
            rim: Plane::default(),
            bend: Vec::new(),
            root: Vec::new(),
            alone: Vec::new(),
            rest: Plane::default(),
            preconditioned: Plane::default(),
            direction: Plane::default(),
            image: Plane::default(),
            search: Search::default(),
        }
    }

    /// Solves a task.
    ///
    /// # Errors
    /// The errors of the operator.
    pub(super) fn solve(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.on_the_contact(task, |set, own, cells| set.iterate(own, limits, cells, observer))
    }

    /// Solves a task with prescribed loads by iterating on the shifts.
    ///
    /// # Errors
    /// The errors of the operator.
    pub(super) fn solve_by_motions(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.on_the_contact(task, |set, own, cells| set.search(own, limits, cells, observer))
    }

    /// Compresses a task to the contact and calls a solver, with the number of cells of the grid.
    fn on_the_contact(
        &mut self,
        task: &mut TangentialTask<'_>,
        solver: impl FnOnce(
            &mut Self,
            &mut TangentialTask<'_>,
            usize,
        ) -> Result<Convergence, OperatorError>,
    ) -> Result<Convergence, OperatorError> {
        self.influence.enter(task.operator, task.limits);
        let mut compressed = std::mem::take(&mut self.compressed);
        compressed.take(task, &self.influence.contact);
        self.make_room(task.operator.grid());
        let mut own = compressed.task(task);
        let convergence = solver(self, &mut own, task.limits.len());
        task.rigid = own.rigid;
        compressed.give(task, &self.influence.contact);
        self.compressed = compressed;
        convergence
    }

    fn make_room(&mut self, grid: Grid) {
        self.influence.contact.centres(grid, &mut self.centres);
        let cells = self.influence.contact.cells();
        let planes = [
            &mut self.slip,
            &mut self.rim,
            &mut self.rest,
            &mut self.preconditioned,
            &mut self.direction,
            &mut self.image,
        ];
        let all = [&mut self.bend, &mut self.root, &mut self.alone];
        for values in planes.into_iter().flatten().chain(all) {
            values.resize(cells, 0.0);
        }
    }

    pub(super) fn iterate(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut state = IterationState::default();
        let (scale, touching) = (force_scale(task), task.limits.len());
        self.begin(task, &mut state)?;
        let mut iteration = 0;
        let mut off = self.check_law(task);
        loop {
            iteration += 1;
            if state.slow_changes >= 4 || is_lost(task, off.violation) {
                Descent::new(task.operator).run(self, task, &mut state.products)?;
                state = IterationState {
                    products: state.products,
                    slow_changes: 2,
                    ..IterationState::default()
                };
                off = self.check_law(task);
                off = self.change_sets(task, off.violation, &mut state)?;
            } else if iteration == 1 || state.asks_for_change(off.violation) {
                off = self.change_sets(task, off.violation, &mut state)?;
            } else {
                state.held = state.held.saturating_sub(1);
                let power = self.precondition(task, &mut state);
                off = self.gradient_step(task, power, &mut state)?;
            }
            let tangential = off.distance.max(self.unbalance(task, touching)) / scale;
            let tangential = if off.distance.is_nan() { off.distance } else { tangential };
            let residuals = Residuals { normal: 0.0, tangential };
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let stop = if tangential.is_nan() {
                Some(Stop::Stalled)
            } else if tangential <= limits.tolerance
                || is_converged(task, state.step.max(off.violation), limits.change)
            {
                Some(Stop::Converged)
            } else if matches!(seen, ControlFlow::Break(())) {
                Some(Stop::Observer)
            } else {
                (iteration >= limits.iterations).then_some(Stop::Exhausted)
            };
            if let Some(stop) = stop {
                self.finish(task);
                let products = state.products;
                return Ok(Convergence { iterations: iteration, products, residuals, stop });
            }
        }
    }

    /// The initial slip and the initial rim directions.
    fn begin(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        for axis in 0..2 {
            self.direction[axis].copy_from_slice(task.traction[axis]);
        }
        self.multiply(task.operator, &mut state.products)?;
        self.slip_of_image(task);
        // Results of the previous solve must not enter.
        for i in 0..task.limits.len() {
            let at = [task.traction[0][i], task.traction[1][i]];
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let rim = if norm > 0.0 { at.map(|t| t / norm) } else { [0.0; 2] };
            (self.rim[0][i], self.rim[1][i]) = (rim[0], rim[1]);
        }
        Ok(())
    }

    /// The slip for tractions whose displacement is `image`.
    pub(super) fn slip_of_image(&mut self, task: &TangentialTask<'_>) {
        let moved = Vector3::from(task.rigid.moved);
        for i in 0..task.limits.len() {
            let [x, y] = rigid::displacement(&moved, self.centres[0][i], self.centres[1][i]);
            self.slip[0][i] = self.image[0][i] + task.offset[0][i] - x;
            self.slip[1][i] = self.image[1][i] + task.offset[1][i] - y;
        }
    }

    /// A step of conjugate gradients along `preconditioned`, whose product with `rest` is `power`.
    pub(super) fn gradient_step(
        &mut self,
        task: &mut TangentialTask<'_>,
        power: f64,
        state: &mut IterationState,
    ) -> Result<Violation, OperatorError> {
        let share = state.power.map_or(0.0, |last| power / last);
        for axis in 0..2 {
            let steps = self.direction[axis].iter_mut().zip(&self.preconditioned[axis]);
            steps.for_each(|(direction, step)| *direction = step + share * *direction);
        }
        state.power = Some(power);
        if self.runs_away() {
            return Ok(Violation::LOST);
        }
        self.multiply(task.operator, &mut state.products)?;
        let (mut down, mut bend, mut alone) = (0.0, 0.0, 0.0);
        let [along, across] = &self.direction;
        let rest = self.rest[0].iter().zip(&self.rest[1]);
        let image = self.image[0].iter().zip(&self.image[1]);
        for (((x, y), own), ((r_x, r_y), (u, v))) in
            along.iter().zip(across).zip(&self.bend).zip(rest.zip(image))
        {
            down += x * r_x + y * r_y;
            bend += x * u + y * v + own * (x * x + y * y);
            alone += x * x + y * y;
        }
        // Uniform tractions on a whole period cause no displacement: they grow until some reach
        // their bounds.
        let bend = bend.max(NEGLIGIBLE_CURVATURE * self.own * alone);
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        Ok(self.correct(task, length, state))
    }

    /// Whether `direction` is infinite or NaN: no correction gives the prescribed loads.
    pub(super) fn runs_away(&self) -> bool {
        !self.direction.iter().flatten().all(|value| value.is_finite())
    }

    /// Subtracts `length` times `direction` from the tractions. Returns the violation of the law.
    pub(super) fn correct(
        &mut self,
        task: &mut TangentialTask<'_>,
        length: f64,
        state: &mut IterationState,
    ) -> Violation {
        let (mut square, mut off) = (0.0, ViolationSums::default());
        let [tractions_x, tractions_y] = &mut task.traction;
        let [slips_x, slips_y] = &mut self.slip;
        let steps = self.direction[0].iter().zip(&self.direction[1]);
        let images = self.image[0].iter().zip(&self.image[1]);
        let rims = self.rim[0].iter().zip(&self.rim[1]);
        let tractions = tractions_x.iter_mut().zip(tractions_y.iter_mut());
        let slips = slips_x.iter_mut().zip(slips_y);
        let given = task.limits.iter().zip(task.cells.iter());
        let per_own = 1.0 / self.own;
        for ((((x, y), (u, v)), ((d_x, d_y), (a_x, a_y))), ((limit, cell), (e_x, e_y))) in
            tractions.zip(slips).zip(steps.zip(images)).zip(given.zip(rims))
        {
            *x -= length * d_x;
            *y -= length * d_y;
            square += d_x * d_x + d_y * d_y;
            *u -= length * a_x;
            *v -= length * a_y;
            off.add(*cell, *limit, [*x, *y], [*u * per_own, *v * per_own], [*e_x, *e_y]);
        }
        state.step = length.abs() * f64::sqrt(square);
        off.all()
    }

    /// Sets `image` to A times `direction`.
    pub(super) fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        self.influence.displace(operator, &self.direction, &mut self.image, products)
    }
}

/// Whether violation or last step is small relative to the tractions.
fn is_converged(task: &TangentialTask<'_>, off: f64, change: f64) -> bool {
    if change == 0.0 {
        return false;
    }
    let square: f64 = task.traction.iter().flat_map(|values| values.iter()).map(|t| t * t).sum();
    off < change * square.sqrt()
}

pub(super) fn dot(a: &Plane, b: &Plane) -> f64 {
    let along = |axis: usize| a[axis].iter().zip(&b[axis]).map(|(a, b)| a * b).sum::<f64>();
    along(0) + along(1)
}
