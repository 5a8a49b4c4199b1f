//! The sets of sticking and slipping cells: projection of tractions onto their discs.

use carom_halfspace::operator::OperatorError;

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::law::{REACHED, Violation};
use super::task::TangentialTask;
use crate::state::CellState;

/// Fraction of a preconditioned step that is made together with a projection.
const DAMPING: f64 = 0.4;
/// A cell slips if its bound is below this fraction of the traction that sticking would need.
const NEGLIGIBLE_BOUND: f64 = 0.003;

impl ActiveSet {
    /// Projects tractions onto their discs and decides which cells stick and which slip.
    pub(super) fn change_sets(
        &mut self,
        task: &mut TangentialTask<'_>,
        violation: f64,
        state: &mut IterationState,
    ) -> Result<Violation, OperatorError> {
        let damping = if state.careful(violation) { 0.0 } else { DAMPING };
        state.changes(violation);
        let projected = self.project(task);
        self.weigh();
        self.prepare_deflation(task, state);
        let power = self.precondition_projected(task, state);
        state.power = None;
        if projected || self.excess(task).norm() > 0.0 {
            for axis in 0..2 {
                let steps = self.direction[axis].iter_mut().zip(&self.preconditioned[axis]);
                steps.for_each(|(direction, step)| *direction += damping * step);
            }
            self.restore_loads(task);
            if self.runs_away() {
                return Ok(Violation::LOST);
            }
            self.multiply(task.operator, &mut state.products)?;
            Ok(self.correct(task, 1.0, state))
        } else {
            self.gradient_step(task, power, state)
        }
    }

    /// Sets states, rims and curvature terms, and writes the correction that takes tractions to
    /// their discs to `direction` (to be subtracted). Returns whether it is not zero.
    fn project(&mut self, task: &mut TangentialTask<'_>) -> bool {
        let mut any = false;
        for i in 0..task.limits.len() {
            let limit = task.limits[i];
            let [x, y] = [task.traction[0][i], task.traction[1][i]];
            let norm = (x * x + y * y).sqrt();
            self.bend[i] = 0.0;
            let at_rim = norm >= limit * REACHED;
            let slipped = task.cells[i] == CellState::Slip;
            let along =
                if norm > 0.0 { (self.slip[0][i] * x + self.slip[1][i] * y) / norm } else { 0.0 };
            let pulled = [x - self.slip[0][i] / self.own, y - self.slip[1][i] / self.own];
            let pull = (pulled[0] * pulled[0] + pulled[1] * pulled[1]).sqrt();
            // Slip opposes the traction. A cell pushed out of its disc begins to slip, and so does
            // one whose bound is negligible compared with the traction that sticking would need.
            let tiny = limit < NEGLIGIBLE_BOUND * pull;
            let slips = (norm > limit && !slipped) || ((at_rim || slipped) && along < 0.0);
            let target = if tiny || (slips && norm > 0.0) {
                task.cells[i] = CellState::Slip;
                let e = if tiny { pulled.map(|t| t / pull) } else { [x / norm, y / norm] };
                (self.rim[0][i], self.rim[1][i]) = (e[0], e[1]);
                let along = self.slip[0][i] * e[0] + self.slip[1][i] * e[1];
                self.bend[i] = (-along).max(0.0) / limit;
                [limit * e[0], limit * e[1]]
            } else {
                task.cells[i] = CellState::Stick;
                let part = if norm > limit { limit / norm } else { 1.0 };
                [part * x, part * y]
            };
            (self.direction[0][i], self.direction[1][i]) = (x - target[0], y - target[1]);
            any |= self.direction[0][i] != 0.0 || self.direction[1][i] != 0.0;
        }
        any
    }
}
