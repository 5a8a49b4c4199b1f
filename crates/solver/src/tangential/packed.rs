//! A task on the cells of its contact, one after the other.

use super::active_set::{Plane, TangentialTask};
use super::contact::Contact;
use crate::state::CellState;

/// The fields of a task without what lies outside the contact.
#[derive(Clone, Default)]
pub(super) struct Packed {
    limits: Vec<f64>,
    offset: Plane,
    traction: Plane,
    cells: Vec<CellState>,
}

impl Packed {
    pub(super) fn take(&mut self, task: &TangentialTask<'_>, contact: &Contact) {
        contact.gather(task.limits, &mut self.limits);
        contact.gather(task.cells, &mut self.cells);
        for axis in 0..2 {
            contact.gather(task.offset[axis], &mut self.offset[axis]);
            contact.gather(task.traction[axis], &mut self.traction[axis]);
        }
    }

    /// The same task on these fields.
    pub(super) fn task<'a>(&'a mut self, whole: &TangentialTask<'a>) -> TangentialTask<'a> {
        let [x, y] = &mut self.traction;
        TangentialTask {
            operator: whole.operator,
            limits: &self.limits,
            offset: [&self.offset[0], &self.offset[1]],
            rigid: whole.rigid,
            pressure: whole.pressure,
            traction: [x, y],
            cells: &mut self.cells,
        }
    }

    /// The solution to the whole grid, where all else carries nothing.
    pub(super) fn give(&self, task: &mut TangentialTask<'_>, contact: &Contact) {
        for (field, own) in task.traction.iter_mut().zip(&self.traction) {
            field.fill(0.0);
            contact.scatter(own, field);
        }
        task.cells.fill(CellState::Exterior);
        contact.scatter(&self.cells, task.cells);
    }
}
