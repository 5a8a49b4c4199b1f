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
    /// What is left of the linearised problem, and the preconditioned step.
    pub(super) fn precondition(&mut self, task: &mut TangentialTask<'_>, course: &mut Course) {
        for i in 0..task.limits.len() {
            let [x, y] = self.rest_at(task, i);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, course);
    }

    /// The same for tractions that have been taken to their rims: what they were around a rim of
    /// another direction is no part of the linearised problem.
    pub(super) fn precondition_projected(
        &mut self,
        task: &mut TangentialTask<'_>,
        course: &mut Course,
    ) {
        for i in 0..task.limits.len() {
            let [x, y] = self.admitted(task.cells[i], i, [self.slip[0][i], self.slip[1][i]]);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, course);
    }

    /// The preconditioner on `rest`: `S K S` with the weight 1 where the surfaces stick and
    /// sqrt(sigma) along the rim where they slip, where the rest of the diagonal is added.
    pub(super) fn invert(&mut self, cells: &[CellState], course: &mut Course) {
        for (i, state) in cells.iter().enumerate() {
            let rest = [self.rest[0][i], self.rest[1][i]];
            let [x, y] = match state {
                CellState::Exterior => [0.0; 2],
                CellState::Stick => rest,
                CellState::Slip => {
                    let weight = (1.0 + self.bend[i] / self.own).sqrt();
                    rest.map(|rest| rest / weight)
                }
            };
            (self.image[0][i], self.image[1][i]) = (x, y);
        }
        if let Some(inverse) = &self.inverse {
            let [x, y] = &mut self.preconditioned;
            let image = [&self.image[0][..], &self.image[1][..]];
            inverse.traction(image, [x, y], &mut self.workspace);
            course.products.preconditioner += 1.0;
        } else {
            for axis in 0..2 {
                self.preconditioned[axis].copy_from_slice(&self.image[axis]);
            }
        }
        for (i, state) in cells.iter().enumerate() {
            if *state == CellState::Exterior {
                (self.preconditioned[0][i], self.preconditioned[1][i]) = (0.0, 0.0);
                continue;
            }
            let sigma = 1.0 / (1.0 + self.bend[i] / self.own);
            let step = [self.preconditioned[0][i], self.preconditioned[1][i]];
            let step = self.admitted(*state, i, step).map(|step| sigma.sqrt() * step);
            let own = if self.inverse.is_some() && self.bend[i] > 0.0 {
                (1.0 - sigma) / (self.bend[i] + ALONE * self.own)
            } else {
                0.0
            };
            self.preconditioned[0][i] = step[0] + own * self.rest[0][i];
            self.preconditioned[1][i] = step[1] + own * self.rest[1][i];
        }
    }

    /// The gradient of the linearised problem in the cell.
    fn rest_at(&self, task: &TangentialTask<'_>, i: usize) -> [f64; 2] {
        let bend = self.bend[i];
        let whole = [0, 1].map(|axis| self.slip[axis][i] + bend * task.traction[axis][i]);
        self.admitted(task.cells[i], i, whole)
    }

    /// The part of a change that a cell admits: all, along the rim, none.
    pub(super) fn admitted(&self, state: CellState, i: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        match state {
            CellState::Exterior => [0.0; 2],
            CellState::Stick => [x, y],
            CellState::Slip => {
                let (e_x, e_y) = (self.rim[0][i], self.rim[1][i]);
                let across = e_x * y - e_y * x;
                [-e_y * across, e_x * across]
            }
        }
    }
}
