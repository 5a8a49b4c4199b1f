//! Solves a task on the cells of the contact.

use std::ops::ControlFlow;

use carom_halfspace::operator::OperatorError;

use super::active_set::ActiveSet;
use super::descent::Descent;
use super::iteration_state::IterationState;
use super::law::{force_scale, most_violation};
use super::newton::MOST_PHASES;
use super::task::{Limits, TangentialTask};
use crate::convergence::{Convergence, Observer, Progress, Residuals, Stop};

impl ActiveSet {
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

    /// Solves a task with prescribed loads whose influence is not reciprocal, with slow steps where
    /// Newton's method fails.
    ///
    /// # Errors
    /// The errors of the operator.
    pub(super) fn solve_slowly(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.on_the_contact(task, |set, own, cells| {
            set.iterate_by_newton(own, limits, (cells, MOST_PHASES), observer)
        })
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
        self.make_room(task.operator);
        let mut own = compressed.task(task);
        let convergence = solver(self, &mut own, task.limits.len());
        task.rigid = own.rigid;
        compressed.give(task, &self.influence.contact);
        self.compressed = compressed;
        convergence
    }

    /// Solves a compressed task.
    pub(super) fn iterate(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        if task.operator.is_reciprocal() {
            self.iterate_by_gradients(task, limits, cells, observer)
        } else {
            // Iterating on the shifts is better than slow steps to prescribed loads.
            let phases = if task.rigid.is_loaded() { 0 } else { MOST_PHASES };
            self.iterate_by_newton(task, limits, (cells, phases), observer)
        }
    }

    fn iterate_by_gradients(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut state = IterationState::default();
        let (scale, touching) = (force_scale(task), task.limits.len());
        let (most_violation, coupled) = (most_violation(task.limits), task.operator.is_coupled());
        self.begin(task, &mut state)?;
        let mut iteration = 0;
        let mut off = self.check_law(task);
        loop {
            iteration += 1;
            if state.slow_changes >= 4 || off.violation > most_violation {
                Descent::new(task.operator).run(self, task, &mut state.products)?;
                state = IterationState {
                    products: state.products,
                    slow_changes: 2,
                    ..IterationState::default()
                };
                off = self.check_law(task);
                off = self.change_sets(task, off.violation, &mut state)?;
            } else if iteration == 1 || state.asks_for_change(off.violation, coupled) {
                off = self.change_sets(task, off.violation, &mut state)?;
            } else {
                state.held = state.held.saturating_sub(1);
                let power = self.precondition(task, &mut state);
                off = self.gradient_step(task, power, &mut state)?;
            }
            let is_found = (off.distance + state.roughness) / scale <= limits.tolerance;
            if !is_found && state.is_rough(off.distance) {
                self.refine(task, &mut state)?;
                off = self.check_law(task);
            }
            let distance = off.distance + state.roughness;
            let tangential = distance.max(self.unbalance(task, touching)) / scale;
            let tangential = if distance.is_nan() { distance } else { tangential };
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
}

/// Whether violation or last step is small relative to the tractions.
fn is_converged(task: &TangentialTask<'_>, off: f64, change: f64) -> bool {
    if change == 0.0 {
        return false;
    }
    let square: f64 = task.traction.iter().flat_map(|values| values.iter()).map(|t| t * t).sum();
    off < change * square.sqrt()
}
