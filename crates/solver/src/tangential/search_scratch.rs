//! The working memory of a search for the shifts.

use super::limit_surface::LimitSurface;
use super::plane::Plane;
use super::task::TangentialTask;
use crate::state::CellState;

/// The working memory of a search.
#[derive(Clone, Default)]
pub(super) struct Search {
    pub(super) surface: LimitSurface,
    /// Tractions at the beginning of the last step.
    traction: Plane,
    cells: Vec<CellState>,
}

impl Search {
    pub(super) fn keep(&mut self, task: &TangentialTask<'_>) {
        for (kept, traction) in self.traction.iter_mut().zip(&task.traction) {
            kept.clear();
            kept.extend_from_slice(traction);
        }
        self.cells.clear();
        self.cells.extend_from_slice(task.cells);
    }

    pub(super) fn give_back(&self, task: &mut TangentialTask<'_>) {
        for (kept, traction) in self.traction.iter().zip(&mut task.traction) {
            traction.copy_from_slice(kept);
        }
        task.cells.copy_from_slice(&self.cells);
    }
}
