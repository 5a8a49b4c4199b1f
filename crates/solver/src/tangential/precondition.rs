//! The preconditioner: the inverse on a torus, weighted in slipping cells.
//!
//! Along the rim of a slipping cell the matrix is A + D. The curvature term D grows from zero at
//! the border of the stick area to infinity at the border of the contact. Let a be the influence of
//! a cell on itself. Where D is far below a, the inverse K = 1/A applies, and the weight `1/(1 +
//! D/a)` keeps it; where D is far above a, 1/D applies. In between, long waves are still governed
//! by A; there `1/(D + 10 a)` is the better diagonal term.

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::task::TangentialTask;
use crate::state::CellState;

/// Diagonal term that stands for A in slipping cells, relative to the influence of a cell on
/// itself. Measured: the number of products to 1e-9 in Cattaneo's problem falls by a quarter from
/// 0.4 to 10.
const ISOLATED_CELL_COMPLIANCE: f64 = 10.0;

impl ActiveSet {
    /// Computes the residual of the linearised problem and the preconditioned step. Returns the
    /// product of both.
    pub(super) fn precondition(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> f64 {
        for i in 0..task.limits.len() {
            let bend = self.bend[i];
            let whole = [0, 1].map(|axis| self.slip[axis][i] + bend * task.traction[axis][i]);
            let [x, y] = self.admitted(task.cells[i], i, whole);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, state)
    }

    /// The same after tractions have been projected onto their rims: their former component along
    /// another rim direction is not part of the linearised problem.
    pub(super) fn precondition_projected(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> f64 {
        for i in 0..task.limits.len() {
            let [x, y] = self.admitted(task.cells[i], i, [self.slip[0][i], self.slip[1][i]]);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, state)
    }

    /// The weights of the preconditioner, from the curvature terms.
    pub(super) fn weigh(&mut self) {
        let takes_alone = self.influence.has_inverse();
        for ((bend, root), alone) in self.bend.iter().zip(&mut self.root).zip(&mut self.alone) {
            (*root, *alone) = (1.0, 0.0);
            if *bend > 0.0 {
                let sigma = 1.0 / (1.0 + bend / self.own);
                *root = sigma.sqrt();
                if takes_alone {
                    *alone = (1.0 - sigma) / (bend + ISOLATED_CELL_COMPLIANCE * self.own);
                }
            }
        }
    }

    /// Applies the preconditioner to `rest`: `S K S`, with the weight 1 in sticking cells and
    /// sqrt(sigma) along the rim in slipping cells, plus the diagonal term. Returns the product
    /// with `rest`.
    pub(super) fn invert(&mut self, cells: &[CellState], state: &mut IterationState) -> f64 {
        for (step, rest) in self.preconditioned.iter_mut().zip(&self.rest) {
            for ((step, rest), root) in step.iter_mut().zip(rest).zip(&self.root) {
                *step = root * rest;
            }
        }
        self.influence.invert(&mut self.preconditioned, &mut state.products);
        let mut power = 0.0;
        for (i, state) in cells.iter().enumerate() {
            let step = [self.preconditioned[0][i], self.preconditioned[1][i]];
            let (root, alone) = (self.root[i], self.alone[i]);
            let rest = [self.rest[0][i], self.rest[1][i]];
            let [x, y] = self.admitted(*state, i, step);
            let [x, y] = [root * x + alone * rest[0], root * y + alone * rest[1]];
            (self.preconditioned[0][i], self.preconditioned[1][i]) = (x, y);
            power += x * rest[0] + y * rest[1];
        }
        power
    }

    /// The component of a change that a cell admits: all of it, or that along the rim.
    #[inline]
    pub(super) fn admitted(&self, state: CellState, i: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        if state == CellState::Slip {
            let (e_x, e_y) = (self.rim[0][i], self.rim[1][i]);
            let across = e_x * y - e_y * x;
            [-e_y * across, e_x * across]
        } else {
            [x, y]
        }
    }
}
