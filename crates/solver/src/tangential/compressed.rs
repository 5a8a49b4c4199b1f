//! A task compressed to the cells of the contact.

use super::contact::Contact;
use super::plane::Plane;
use super::task::TangentialTask;
use crate::state::CellState;

/// The fields of a task on the cells of the contact.
#[derive(Clone, Default)]
pub(super) struct Compressed {
    limits: Vec<f64>,
    offset: Plane,
    traction: Plane,
    cells: Vec<CellState>,
}

impl Compressed {
    pub(super) fn take(&mut self, task: &TangentialTask<'_>, contact: &Contact) {
        contact.gather(task.limits, &mut self.limits);
        contact.gather(task.cells, &mut self.cells);
        for axis in 0..2 {
            contact.gather(task.offset[axis], &mut self.offset[axis]);
            contact.gather(task.traction[axis], &mut self.traction[axis]);
        }
    }

    /// The same task on the compressed fields.
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

    /// Writes the solution to the whole grid; tractions outside the contact are zero.
    pub(super) fn give(&self, task: &mut TangentialTask<'_>, contact: &Contact) {
        for (field, own) in task.traction.iter_mut().zip(&self.traction) {
            field.fill(0.0);
            contact.scatter(own, field);
        }
        task.cells.fill(CellState::Exterior);
        contact.scatter(&self.cells, task.cells);
    }
}
