//! The preconditioner: the inverse on a torus, weighted where cells slip.
//!
//! Along the rim of a slipping cell the matrix is A + D, with a bend D that grows from nothing at the
//! border of the stick area to no bound at that of the contact. Where D is far below the influence
//! a of a cell on itself, K = 1/A is the inverse, and the weight `1/(1 + D/a)` leaves it there; where
//! D is far above, 1/D is. Between them long waves still feel A: there `1/(D + 10 a)` is the better
//! second part.

use super::active_set::{ActiveSet, TangentialTask};
use super::course::Course;
use crate::state::CellState;

/// What stands for A beside D where slipping cells are taken one by one, over the influence of a cell
/// on itself. Measured: products to 1e-9 in Cattaneo's problem fall by a quarter from 0.4 to 10.
const ALONE: f64 = 10.0;

impl ActiveSet {
    /// What is left of the linearised problem, and the preconditioned step; the product of both.
    pub(super) fn precondition(
        &mut self,
        task: &mut TangentialTask<'_>,
        course: &mut Course,
    ) -> f64 {
        for i in 0..task.limits.len() {
            let bend = self.bend[i];
            let whole = [0, 1].map(|axis| self.slip[axis][i] + bend * task.traction[axis][i]);
            let [x, y] = self.admitted(task.cells[i], i, whole);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, course)
    }

    /// The same for tractions that have been taken to their rims: what they were around a rim of
    /// another direction is no part of the linearised problem.
    pub(super) fn precondition_projected(
        &mut self,
        task: &mut TangentialTask<'_>,
        course: &mut Course,
    ) -> f64 {
        for i in 0..task.limits.len() {
            let [x, y] = self.admitted(task.cells[i], i, [self.slip[0][i], self.slip[1][i]]);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, course)
    }

    /// The weights of the preconditioner beside the bends.
    pub(super) fn weigh(&mut self) {
        let takes_alone = self.within.has_inverse();
        for ((bend, root), alone) in self.bend.iter().zip(&mut self.root).zip(&mut self.alone) {
            (*root, *alone) = (1.0, 0.0);
            if *bend > 0.0 {
                let sigma = 1.0 / (1.0 + bend / self.own);
                *root = sigma.sqrt();
                if takes_alone {
                    *alone = (1.0 - sigma) / (bend + ALONE * self.own);
                }
            }
        }
    }

    /// The preconditioner on `rest`: `S K S` with the weight 1 where the surfaces stick and
    /// sqrt(sigma) along the rim where they slip, where the rest of the diagonal is added. The product
    /// with `rest`.
    pub(super) fn invert(&mut self, cells: &[CellState], course: &mut Course) -> f64 {
        for (step, rest) in self.preconditioned.iter_mut().zip(&self.rest) {
            for ((step, rest), root) in step.iter_mut().zip(rest).zip(&self.root) {
                *step = root * rest;
            }
        }
        self.within.invert(&mut self.preconditioned, &mut course.products);
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

    /// The part of a change that a cell admits: all, or along the rim.
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
