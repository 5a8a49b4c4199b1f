//! The preconditioner: the inverse on a torus, weighted in slipping cells.
//!
//! Along the rim of a slipping cell the matrix is A + D. The curvature term D grows from zero at
//! the border of the stick area to infinity at the border of the contact. Let a be the influence of
//! a cell on itself. Where D is far below a, the inverse K = 1/A applies, and the weight `1/(1 +
//! D/a)` keeps it; where D is far above a, 1/D applies. In between, long waves are still governed
//! by A; there `1/(D + 10 a)` is the better diagonal term.

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::plane::{slices, slices_mut};
use super::task::TangentialTask;
use crate::parts::{each, sum};
use crate::state::CellState;

/// Diagonal term that stands for A in slipping cells, relative to the influence of a cell on
/// itself. Measured: the number of products to 1e-9 in Cattaneo's problem falls by a quarter from
/// 0.4 to 10.
const ISOLATED_CELL_COMPLIANCE: f64 = 10.0;

/// The component of a change that a cell admits: all of it, or that along the rim.
#[inline]
pub(super) fn admitted(state: CellState, [e_x, e_y]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    if state == CellState::Slip {
        let across = e_x * y - e_y * x;
        [-e_y * across, e_x * across]
    } else {
        [x, y]
    }
}

impl ActiveSet {
    /// Computes the residual of the linearised problem and the preconditioned step. Returns the
    /// product of both.
    pub(super) fn precondition(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> f64 {
        let tractions = [&*task.traction[0], &*task.traction[1]];
        let parts = (
            (slices_mut(&mut self.rest), &*task.cells),
            (slices(&self.slip), &self.bend[..]),
            (tractions, slices(&self.rim)),
        );
        each(self.threads, parts, &|((rest, cells), (slip, bends), (tractions, rims))| {
            for (i, (cell, bend)) in cells.iter().zip(bends).enumerate() {
                let whole = [0, 1].map(|axis| slip[axis][i] + bend * tractions[axis][i]);
                let [x, y] = admitted(*cell, [rims[0][i], rims[1][i]], whole);
                (rest[0][i], rest[1][i]) = (x, y);
            }
        });
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
        let fields = (slices(&self.slip), slices(&self.rim));
        let parts = (slices_mut(&mut self.rest), &*task.cells, fields);
        each(self.threads, parts, &|(rest, cells, (slip, rims))| {
            for (i, cell) in cells.iter().enumerate() {
                let [x, y] = admitted(*cell, [rims[0][i], rims[1][i]], [slip[0][i], slip[1][i]]);
                (rest[0][i], rest[1][i]) = (x, y);
            }
        });
        self.deflate(task);
        self.invert(task.cells, state)
    }

    /// The weights of the preconditioner, from the curvature terms.
    pub(super) fn weigh(&mut self) {
        let (takes_alone, own) = (self.influence.has_inverse(), self.own);
        let parts = (&self.bend[..], [&mut self.root[..], &mut self.alone[..]]);
        each(self.threads, parts, &|(bends, [roots, alone])| {
            for ((bend, root), alone) in bends.iter().zip(roots).zip(alone) {
                (*root, *alone) = (1.0, 0.0);
                if *bend > 0.0 {
                    let sigma = 1.0 / (1.0 + bend / own);
                    *root = sigma.sqrt();
                    if takes_alone {
                        *alone = (1.0 - sigma) / (bend + ISOLATED_CELL_COMPLIANCE * own);
                    }
                }
            }
        });
    }

    /// Applies the preconditioner to `rest`: `S K S`, with the weight 1 in sticking cells and
    /// sqrt(sigma) along the rim in slipping cells, plus the diagonal term. Returns the product
    /// with `rest`.
    pub(super) fn invert(&mut self, cells: &[CellState], state: &mut IterationState) -> f64 {
        let parts = (slices_mut(&mut self.preconditioned), slices(&self.rest), &self.root[..]);
        each(self.threads, parts, &|(steps, rests, roots)| {
            for (steps, rests) in steps.into_iter().zip(rests) {
                for ((step, rest), root) in steps.iter_mut().zip(rests).zip(roots) {
                    *step = root * rest;
                }
            }
        });
        self.influence.invert(&mut self.preconditioned, &mut state.products);
        let weights = [&self.root[..], &self.alone[..]];
        let parts = (
            (slices_mut(&mut self.preconditioned), slices(&self.rest)),
            (cells, weights, slices(&self.rim)),
        );
        sum(self.threads, parts, &|((steps, rests), (cells, [roots, alone], rims))| {
            let mut power = 0.0;
            for (i, cell) in cells.iter().enumerate() {
                let (root, alone) = (roots[i], alone[i]);
                let rest = [rests[0][i], rests[1][i]];
                let step = [steps[0][i], steps[1][i]];
                let [x, y] = admitted(*cell, [rims[0][i], rims[1][i]], step);
                let [x, y] = [root * x + alone * rest[0], root * y + alone * rest[1]];
                (steps[0][i], steps[1][i]) = (x, y);
                power += x * rest[0] + y * rest[1];
            }
            power
        })
    }

    /// The component of a change that cell `i` admits.
    #[inline]
    pub(super) fn admitted(&self, state: CellState, i: usize, change: [f64; 2]) -> [f64; 2] {
        admitted(state, [self.rim[0][i], self.rim[1][i]], change)
    }
}
