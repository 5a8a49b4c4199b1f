//! The sets of sticking and slipping cells: projection of tractions onto their discs.

use carom_halfspace::operator::OperatorError;

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::law::{REACHED, Violation};
use super::plane::{slices, slices_mut};
use super::task::TangentialTask;
use crate::parts::{each, fold};
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
            let parts = (slices_mut(&mut self.direction), slices(&self.preconditioned));
            each(self.threads, parts, &|(directions, steps)| {
                for (direction, step) in directions.into_iter().zip(steps) {
                    let both = direction.iter_mut().zip(step);
                    both.for_each(|(direction, step)| *direction += damping * step);
                }
            });
            self.restore_loads(task);
            if self.runs_away() {
                return Ok(Violation::LOST);
            }
            self.multiply_roughly(task.operator, &mut state.products)?;
            Ok(self.correct(task, 1.0, state))
        } else {
            self.gradient_step(task, power, state)
        }
    }

    /// Sets states, rims and curvature terms, and writes the correction that takes tractions to
    /// their discs to `direction` (to be subtracted). Returns whether it is not zero.
    fn project(&mut self, task: &mut TangentialTask<'_>) -> bool {
        let own = self.own;
        let tractions = [&*task.traction[0], &*task.traction[1]];
        let parts = (
            (task.limits, tractions, slices(&self.slip)),
            (&mut *task.cells, &mut self.bend[..]),
            (slices_mut(&mut self.rim), slices_mut(&mut self.direction)),
        );
        fold(
            self.threads,
            parts,
            &|((limits, tractions, slips), (cells, bends), (rims, directions))| {
                let mut any = false;
                for (i, limit) in limits.iter().enumerate() {
                    let at = |field: [&[f64]; 2]| [field[0][i], field[1][i]];
                    let (traction, slip) = (at(tractions), at(slips));
                    let (target, rim) =
                        projected((traction, *limit), slip, own, (&mut cells[i], &mut bends[i]));
                    if let Some(rim) = rim {
                        (rims[0][i], rims[1][i]) = (rim[0], rim[1]);
                    }
                    let step = [traction[0] - target[0], traction[1] - target[1]];
                    (directions[0][i], directions[1][i]) = (step[0], step[1]);
                    any |= step != [0.0; 2];
                }
                any
            },
            &|one, other| one | other,
        )
    }
}

/// The traction of a cell on its disc, and the direction in which it slips; sets its state and the
/// curvature term of its rim.
fn projected(
    ([x, y], limit): ([f64; 2], f64),
    slip: [f64; 2],
    own: f64,
    (cell, bend): (&mut CellState, &mut f64),
) -> ([f64; 2], Option<[f64; 2]>) {
    let norm = (x * x + y * y).sqrt();
    *bend = 0.0;
    let at_rim = norm >= limit * REACHED;
    let slipped = *cell == CellState::Slip;
    let along = if norm > 0.0 { (slip[0] * x + slip[1] * y) / norm } else { 0.0 };
    let pulled = [x - slip[0] / own, y - slip[1] / own];
    let pull = (pulled[0] * pulled[0] + pulled[1] * pulled[1]).sqrt();
    // Slip opposes the traction. A cell pushed out of its disc begins to slip, and so does one whose
    // bound is negligible compared with the traction that sticking would need.
    let tiny = limit < NEGLIGIBLE_BOUND * pull;
    let slips = (norm > limit && !slipped) || ((at_rim || slipped) && along < 0.0);
    if tiny || (slips && norm > 0.0) {
        *cell = CellState::Slip;
        let e = if tiny { pulled.map(|t| t / pull) } else { [x / norm, y / norm] };
        *bend = (-(slip[0] * e[0] + slip[1] * e[1])).max(0.0) / limit;
        ([limit * e[0], limit * e[1]], Some(e))
    } else {
        *cell = CellState::Stick;
        let part = if norm > limit { limit / norm } else { 1.0 };
        ([part * x, part * y], None)
    }
}
