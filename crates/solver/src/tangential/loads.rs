//! Prescribed loads: rigid motions are deflated, so that corrections do not change the loads.

use nalgebra::Vector3;

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::plane::{dot, slices, slices_mut};
use super::precondition::admitted;
use super::rigid;
use super::task::TangentialTask;
use crate::parts::each;

impl ActiveSet {
    pub(super) fn excess(&self, task: &TangentialTask<'_>) -> Vector3<f64> {
        let tractions = [&*task.traction[0], &*task.traction[1]];
        task.rigid.excess(self.threads, &self.centres, tractions)
    }

    /// The preconditioner applied to the rigid displacements whose loads are prescribed.
    pub(super) fn prepare_deflation(
        &mut self,
        task: &TangentialTask<'_>,
        state: &mut IterationState,
    ) {
        if !task.rigid.is_loaded() {
            return;
        }
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_some()) {
            let mut motion = Vector3::zeros();
            motion[k] = 1.0;
            let parts = (
                (slices_mut(&mut self.rest), &*task.cells),
                (slices(&self.centres), slices(&self.rim)),
            );
            each(self.threads, parts, &|((rest, cells), (centres, rims))| {
                for (i, cell) in cells.iter().enumerate() {
                    let whole = rigid::displacement(&motion, centres[0][i], centres[1][i]);
                    let [x, y] = admitted(*cell, [rims[0][i], rims[1][i]], whole);
                    (rest[0][i], rest[1][i]) = (x, y);
                }
            });
            self.invert(task.cells, state);
            for axis in 0..2 {
                self.deflation.corrections[k][axis].clone_from(&self.preconditioned[axis]);
            }
        }
        let mut deflation = std::mem::take(&mut self.deflation);
        deflation.prepare(&task.rigid, |i| {
            let (x, y) = (self.centres[0][i], self.centres[1][i]);
            // A correction satisfies the constraints of its cell, so that the whole displacement
            // can be used.
            [Vector3::new(1.0, 0.0, y), Vector3::new(0.0, 1.0, -x)]
        });
        self.deflation = deflation;
    }

    /// Changes `direction`, which will be subtracted, so that the tractions have the prescribed
    /// loads.
    pub(super) fn restore_loads(&mut self, task: &TangentialTask<'_>) {
        if !task.rigid.is_loaded() {
            return;
        }
        let mut wrong =
            rigid::sums(self.threads, &self.centres, slices(&self.direction)) - self.excess(task);
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_none()) {
            wrong[k] = 0.0;
        }
        let parts = self.deflation.parts(&wrong);
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_some()) {
            let fields = (slices_mut(&mut self.direction), slices(&self.deflation.corrections[k]));
            each(self.threads, fields, &|(directions, corrections)| {
                for (direction, correction) in directions.into_iter().zip(corrections) {
                    let both = direction.iter_mut().zip(correction);
                    both.for_each(|(step, own)| *step -= parts[k] * own);
                }
            });
        }
    }

    /// Adjusts the shifts whose loads are prescribed, so that corrections do not change the loads.
    pub(super) fn deflate(&mut self, task: &mut TangentialTask<'_>) {
        if !task.rigid.is_loaded() {
            return;
        }
        let mut loads = Vector3::zeros();
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_some()) {
            loads[k] = dot(self.threads, &self.deflation.corrections[k], &self.rest);
        }
        let moved = self.deflation.parts(&loads);
        let fields = (
            (slices_mut(&mut self.rest), slices_mut(&mut self.slip)),
            (&*task.cells, slices(&self.centres), slices(&self.rim)),
        );
        each(self.threads, fields, &|((rest, slips), (cells, centres, rims))| {
            for (i, cell) in cells.iter().enumerate() {
                let whole = rigid::displacement(&moved, centres[0][i], centres[1][i]);
                let own = admitted(*cell, [rims[0][i], rims[1][i]], whole);
                for axis in 0..2 {
                    rest[axis][i] -= own[axis];
                    slips[axis][i] -= whole[axis];
                }
            }
        });
        for k in 0..3 {
            task.rigid.moved[k] += moved[k];
        }
    }

    /// The error of the loads, as a mean traction.
    pub(super) fn unbalance(&self, task: &TangentialTask<'_>, touching: usize) -> f64 {
        if !task.rigid.is_loaded() {
            return 0.0;
        }
        let (excess, touching) = (self.excess(task), touching as f64);
        let arm = rigid::half_diagonal(task.operator.grid());
        (excess[0].abs().max(excess[1].abs()).max(excess[2].abs() / arm)) / touching
    }
}
