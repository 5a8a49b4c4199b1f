//! The values that a damped step started from, to take the step again.

use super::cells::Cells;
use super::system::System;
use super::task::CoupledTask;
use crate::state::CellState;
use crate::tangential::Rigid;

/// Tractions, motions and states of the cells before a step, with the gaps and slips that they make.
#[derive(Clone)]
pub(super) struct Origin {
    pressure: Vec<f64>,
    traction: [Vec<f64>; 2],
    cells: Vec<CellState>,
    approach: f64,
    rigid: Rigid,
    gap: Vec<f64>,
    slip: [Vec<f64>; 2],
    /// Directions of the tangential tractions of slipping cells.
    rim: [Vec<f64>; 2],
}

impl Origin {
    pub(super) fn new(cells: usize) -> Self {
        let zero = || vec![0.0; cells];
        let plane = || [zero(), zero()];
        Self {
            pressure: zero(),
            traction: plane(),
            cells: vec![CellState::Exterior; cells],
            approach: 0.0,
            rigid: Rigid::default(),
            gap: zero(),
            slip: plane(),
            rim: plane(),
        }
    }

    pub(super) fn keep(&mut self, task: &CoupledTask<'_>, system: &System, cells: &Cells) {
        self.pressure.copy_from_slice(task.pressure);
        self.cells.copy_from_slice(task.cells);
        self.gap.copy_from_slice(&system.gap);
        for axis in 0..2 {
            self.traction[axis].copy_from_slice(task.traction[axis]);
            self.slip[axis].copy_from_slice(&system.slip[axis]);
            self.rim[axis].copy_from_slice(&cells.rim[axis]);
        }
        (self.approach, self.rigid) = (task.approach, task.rigid);
    }

    pub(super) fn restore(
        &self,
        task: &mut CoupledTask<'_>,
        system: &mut System,
        cells: &mut Cells,
    ) {
        task.pressure.copy_from_slice(&self.pressure);
        task.cells.copy_from_slice(&self.cells);
        system.gap.copy_from_slice(&self.gap);
        for axis in 0..2 {
            task.traction[axis].copy_from_slice(&self.traction[axis]);
            system.slip[axis].copy_from_slice(&self.slip[axis]);
            cells.rim[axis].copy_from_slice(&self.rim[axis]);
        }
        (task.approach, task.rigid) = (self.approach, self.rigid);
    }
}
