//! Newton's method on the sets, for influences without reciprocity: steady rolling.
//!
//! The change of displacement between two steps of rolling, B t, is no gradient: the tractions of a
//! cell act on the particles behind it, hardly on those ahead. Conjugate gradients do not apply,
//! but B is positive definite, so that the solution is unique. Each pass takes tractions beyond
//! their discs to the rim, decides which cells stick and which slip, and solves the linear system
//! of these sets, with the shifts whose loads are prescribed, by GMRES.

use std::ops::ControlFlow;

use carom_halfspace::operator::{OperatorError, SurfaceOperator};
use nalgebra::{Matrix3, Vector3};

use super::active_set::ActiveSet;
use super::descent::Descent;
use super::iteration_state::IterationState;
use super::law::{Violation, force_scale};
use super::rigid;
use super::task::{Limits, TangentialTask};
use crate::convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
use crate::krylov::{self, LinearMap};
use crate::state::CellState;

/// Relative residual to which each linear system is solved.
const LINEAR_RESIDUAL: f64 = 1e-2;
/// Relative residual to which the response to a shift is solved.
const RESPONSE_RESIDUAL: f64 = 1e-6;
/// Diagonal term that stands for B in slipping cells, relative to the influence of a cell on itself.
/// Measured: on 200 x 200 elements 1, 2, 4 take 178, 170, 200 products.
const ISOLATED_CELL_COMPLIANCE: f64 = 2.0;
/// Greatest number of products for one linear system.
const MOST_PRODUCTS: usize = 200;
/// Newton steps in which the violation is not halved, before slow but sure steps are made.
const PATIENCE: usize = 10;
/// Number of slow steps at first; each time they are needed again it doubles, at most so often.
const DESCENT_STEPS: usize = 16;
pub(super) const MOST_PHASES: usize = 7;
/// Steps are not made whose motions exceed so many times what all cells at their limits could displace one of them.
const FARTHEST: f64 = 1e3;
/// A cell slips in the direction that its slip asks for if its bound is below this fraction of the
/// traction that sticking would need.
const NEGLIGIBLE_BOUND: f64 = 0.003;

impl ActiveSet {
    /// Solves a compressed task whose influence is not reciprocal, with slow but sure steps at most
    /// so many times.
    pub(super) fn iterate_by_newton(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        (cells, most_phases): (usize, usize),
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut state = IterationState::default();
        let (scale, touching) = (force_scale(task), task.limits.len());
        self.begin(task, &mut state)?;
        let (mut iteration, mut phases) = (0, 0);
        let (mut least, mut since) = (f64::INFINITY, 0);
        let mut best = Best::default();
        loop {
            iteration += 1;
            let off = self.take_to_discs(task, &mut state)?;
            self.choose_states(task);
            let tangential = off.distance.max(self.unbalance(task, touching)) / scale;
            let tangential = if off.distance.is_nan() { off.distance } else { tangential };
            best.see(tangential, task);
            if tangential < 0.5 * least {
                (least, since) = (tangential, 0);
            } else {
                since += 1;
            }
            let residuals = Residuals { normal: 0.0, tangential };
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let is_lost = tangential.is_nan() || since > PATIENCE;
            let stop = if is_lost && phases >= most_phases {
                Some(Stop::Stalled)
            } else if tangential <= limits.tolerance || tangential < 0.1 * limits.change {
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
            if is_lost {
                best.restore(task);
                best = Best::default();
                let steps = DESCENT_STEPS << phases;
                Descent::new(task.operator).run_twice(self, task, steps, &mut state.products)?;
                (phases, least, since) = (phases + 1, f64::INFINITY, 0);
            } else if !self.newton_step(task, &mut state)? {
                since = PATIENCE + 1;
            }
        }
    }

    /// The loads of the tractions due to a unit of one motion, at fixed states of the cells.
    pub(super) fn answer_by_newton(
        &mut self,
        task: &TangentialTask<'_>,
        k: usize,
        products: &mut Products,
    ) -> Result<Vector3<f64>, OperatorError> {
        let n = task.limits.len();
        let mut state = IterationState::default();
        let mut right = vec![0.0; 2 * n + 3];
        let motion = Vector3::from_fn(|l, _| f64::from(u8::from(l == k)));
        for i in 0..n {
            let whole = rigid::displacement(&motion, self.centres[0][i], self.centres[1][i]);
            let [x, y] = self.admitted(task.cells[i], i, whole);
            (right[i], right[n + i]) = (x, y);
        }
        let mut step = vec![0.0; 2 * n + 3];
        let least = RESPONSE_RESIDUAL * krylov::norm(&right);
        let mut map = Newton::new(self, task, &mut state);
        map.given = [false; 3];
        krylov::solve(&mut map, &right, &mut step, least, MOST_PRODUCTS)?;
        *products = products.plus(state.products);
        for axis in 0..2 {
            self.direction[axis].copy_from_slice(&step[axis * n..][..n]);
        }
        Ok(rigid::sums(self.threads, &self.centres, [&self.direction[0], &self.direction[1]]))
    }

    /// Takes tractions beyond their discs, and those of slipping cells, to the rim. Returns the
    /// violation of the law with the slip that results.
    fn take_to_discs(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> Result<Violation, OperatorError> {
        for i in 0..task.limits.len() {
            let (limit, at) = (task.limits[i], [task.traction[0][i], task.traction[1][i]]);
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let slips = task.cells[i] == CellState::Slip;
            let pulled = [0, 1].map(|axis| at[axis] - self.slip[axis][i] / self.own);
            let pull = (pulled[0] * pulled[0] + pulled[1] * pulled[1]).sqrt();
            // Slip along the traction: it turns back, unless the cell comes to stick.
            let along = self.slip[0][i] * at[0] + self.slip[1][i] * at[1] > 0.0;
            let to = if limit < NEGLIGIBLE_BOUND * pull || (along && slips && pull > limit) {
                pulled.map(|t| limit * (t / pull))
            } else if norm > limit || (slips && norm > 0.0) {
                at.map(|t| limit * (t / norm))
            } else {
                at
            };
            for axis in 0..2 {
                self.direction[axis][i] = at[axis] - to[axis];
            }
        }
        self.multiply(task.operator, &mut state.products)?;
        Ok(self.correct(task, 1.0, state))
    }

    /// Decides from tractions and slip which cells stick and which slip.
    fn choose_states(&mut self, task: &mut TangentialTask<'_>) {
        for (i, &limit) in task.limits.iter().enumerate() {
            let at = [task.traction[0][i], task.traction[1][i]];
            let slip = [self.slip[0][i] / self.own, self.slip[1][i] / self.own];
            let pulled = (at[0] - slip[0]).hypot(at[1] - slip[1]);
            let norm = at[0].hypot(at[1]);
            let cell =
                if pulled > limit && norm > 0.0 { CellState::Slip } else { CellState::Stick };
            task.cells[i] = cell;
            (self.bend[i], self.rim[0][i], self.rim[1][i]) = (0.0, 0.0, 0.0);
            if cell == CellState::Slip {
                (self.rim[0][i], self.rim[1][i]) = (at[0] / norm, at[1] / norm);
                let along = self.slip[0][i] * self.rim[0][i] + self.slip[1][i] * self.rim[1][i];
                self.bend[i] = (-along).max(0.0) / limit;
            }
        }
        self.weigh_for_rolling();
    }

    /// The weights of the preconditioner. B is of order zero, so that slipping cells need no more
    /// than the diagonal; the inverse on the torus would exaggerate waves across the way, which B
    /// hardly resists but the curvature of the rim does.
    fn weigh_for_rolling(&mut self) {
        if !self.influence.has_inverse() {
            self.weigh();
            return;
        }
        for (i, bend) in self.bend.iter().enumerate() {
            let slips = self.rim[0][i] != 0.0 || self.rim[1][i] != 0.0;
            (self.root[i], self.alone[i]) = if slips {
                (0.0, 1.0 / (bend + ISOLATED_CELL_COMPLIANCE * self.own))
            } else {
                (1.0, 0.0)
            };
        }
    }

    /// Makes a step; returns false if there is none, as where no cell can take up a load, or if it leads too far.
    fn newton_step(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> Result<bool, OperatorError> {
        let n = task.limits.len();
        let excess = self.excess(task);
        let mut right = vec![0.0; 2 * n + 3];
        for i in 0..n {
            let [x, y] = self.admitted(task.cells[i], i, [self.slip[0][i], self.slip[1][i]]);
            (right[i], right[n + i]) = (-x, -y);
        }
        let mut map = Newton::new(self, task, state);
        for k in 0..3 {
            right[2 * n + k] = -map.weights[k] * excess[k];
        }
        let mut step = vec![0.0; 2 * n + 3];
        let least = LINEAR_RESIDUAL * krylov::norm(&right);
        krylov::solve(&mut map, &right, &mut step, least, MOST_PRODUCTS)?;
        let farthest = FARTHEST * self.own * task.limits.iter().sum::<f64>();
        let arm = rigid::half_diagonal(task.operator.grid());
        let [x, y, turn] = [0, 1, 2].map(|k| step[2 * n + k].abs());
        let moves_far = x.max(y).max(arm * turn) > farthest;
        if moves_far || !step.iter().all(|value| value.is_finite()) {
            return Ok(false);
        }
        for axis in 0..2 {
            let steps = &step[axis * n..][..n];
            task.traction[axis].iter_mut().zip(steps).for_each(|(t, step)| *t += step);
            self.direction[axis].copy_from_slice(steps);
        }
        for k in 0..3 {
            task.rigid.moved[k] += step[2 * n + k];
        }
        self.multiply(task.operator, &mut state.products)?;
        let moved = Vector3::new(step[2 * n], step[2 * n + 1], step[2 * n + 2]);
        for i in 0..n {
            let [x, y] = rigid::displacement(&moved, self.centres[0][i], self.centres[1][i]);
            self.slip[0][i] += self.image[0][i] - x;
            self.slip[1][i] += self.image[1][i] - y;
        }
        Ok(true)
    }
}

/// The tractions and motions with the least violation since the last slow steps. Newton's steps may lead away from any
/// solution: near the friction limit the loads hardly depend on the motions, and steps grow without bound.
struct Best {
    violation: f64,
    traction: [Vec<f64>; 2],
    moved: [f64; 3],
}

impl Default for Best {
    fn default() -> Self {
        Self { violation: f64::INFINITY, traction: Default::default(), moved: [0.0; 3] }
    }
}

impl Best {
    fn see(&mut self, violation: f64, task: &TangentialTask<'_>) {
        if violation < self.violation {
            (self.violation, self.moved) = (violation, task.rigid.moved);
            for (own, traction) in self.traction.iter_mut().zip(&task.traction) {
                own.clear();
                own.extend_from_slice(traction);
            }
        }
    }

    fn restore(&self, task: &mut TangentialTask<'_>) {
        if self.violation < f64::INFINITY {
            task.rigid.moved = self.moved;
            for (traction, own) in task.traction.iter_mut().zip(&self.traction) {
                traction.copy_from_slice(own);
            }
        }
    }
}

/// The linear system of the present sets. Unknowns are both tractions of all cells, of those that
/// slip along the rim only, then the shifts whose loads are prescribed.
struct Newton<'a> {
    set: &'a mut ActiveSet,
    operator: &'a dyn SurfaceOperator,
    cells: &'a [CellState],
    given: [bool; 3],
    /// Factors that turn the equations of the loads into displacements.
    weights: [f64; 3],
    /// The inverse of the loads that the preconditioner gives for each unit motion.
    answers: Matrix3<f64>,
    state: &'a mut IterationState,
}

impl<'a> Newton<'a> {
    fn new(
        set: &'a mut ActiveSet,
        task: &'a TangentialTask<'_>,
        state: &'a mut IterationState,
    ) -> Self {
        let arm = rigid::half_diagonal(task.operator.grid());
        let weight = set.own / (task.limits.len().max(1) as f64).sqrt();
        let given = task.rigid.loads.map(|load| load.is_some());
        let (weights, answers) = ([weight, weight, weight / arm], Matrix3::identity());
        let (operator, cells) = (task.operator, &*task.cells);
        let mut own = Self { set, operator, cells, given, weights, answers, state };
        own.prepare();
        own
    }

    fn prepare(&mut self) {
        let given = self.given;
        for k in (0..3).filter(|&k| given[k]) {
            let motion = Vector3::from_fn(|l, _| f64::from(u8::from(l == k)));
            self.pull(&motion);
            self.set.invert(self.cells, self.state);
            for axis in 0..2 {
                let correction = &self.set.preconditioned[axis];
                self.set.deflation.corrections[k][axis].clone_from(correction);
            }
            let loads = self.loads();
            for l in (0..3).filter(|&l| given[l]) {
                self.answers[(l, k)] = loads[l];
            }
        }
        self.answers = self.answers.try_inverse().unwrap_or_default();
    }

    /// Sets `rest` to the displacements of a motion that the cells admit.
    fn pull(&mut self, motion: &Vector3<f64>) {
        for i in 0..self.cells.len() {
            let (x, y) = (self.set.centres[0][i], self.set.centres[1][i]);
            let whole = rigid::displacement(motion, x, y);
            let [x, y] = self.set.admitted(self.cells[i], i, whole);
            (self.set.rest[0][i], self.set.rest[1][i]) = (x, y);
        }
    }

    /// The loads of `preconditioned`.
    fn loads(&self) -> Vector3<f64> {
        let [x, y] = &self.set.preconditioned;
        rigid::sums(self.set.threads, &self.set.centres, [x, y])
    }
}

impl LinearMap for Newton<'_> {
    type Error = OperatorError;

    fn apply(&mut self, x: &[f64], y: &mut [f64]) -> Result<(), OperatorError> {
        let n = self.cells.len();
        for axis in 0..2 {
            self.set.direction[axis].copy_from_slice(&x[axis * n..][..n]);
        }
        self.set.multiply(self.operator, &mut self.state.products)?;
        let motion = Vector3::from_fn(|k, _| if self.given[k] { x[2 * n + k] } else { 0.0 });
        let set = &*self.set;
        for i in 0..n {
            let moved = rigid::displacement(&motion, set.centres[0][i], set.centres[1][i]);
            let whole = [0, 1].map(|axis| {
                set.image[axis][i] + set.bend[i] * set.direction[axis][i] - moved[axis]
            });
            let [along, across] = set.admitted(self.cells[i], i, whole);
            (y[i], y[n + i]) = (along, across);
        }
        let loads = rigid::sums(set.threads, &set.centres, [&set.direction[0], &set.direction[1]]);
        for k in 0..3 {
            let own = 2 * n + k;
            y[own] = if self.given[k] { self.weights[k] * loads[k] } else { x[own] };
        }
        Ok(())
    }

    fn precondition(&mut self, y: &[f64], x: &mut [f64]) {
        let n = self.cells.len();
        for axis in 0..2 {
            self.set.rest[axis].copy_from_slice(&y[axis * n..][..n]);
        }
        self.set.invert(self.cells, self.state);
        let loads = self.loads();
        for axis in 0..2 {
            x[axis * n..][..n].copy_from_slice(&self.set.preconditioned[axis]);
        }
        let wrong = Vector3::from_fn(|k, _| {
            if self.given[k] { y[2 * n + k] / self.weights[k] - loads[k] } else { 0.0 }
        });
        let motion = self.answers * wrong;
        for k in 0..3 {
            x[2 * n + k] = if self.given[k] { motion[k] } else { 0.0 };
        }
        for k in (0..3).filter(|&k| self.given[k]) {
            for axis in 0..2 {
                let correction = &self.set.deflation.corrections[k][axis];
                let steps = x[axis * n..][..n].iter_mut().zip(correction);
                steps.for_each(|(x, own)| *x += motion[k] * own);
            }
        }
    }
}
