//! Coulomb's law in each cell: what breaks it, how far, and the state that it gives.

use super::active_set::{ActiveSet, TangentialTask};
use crate::state::CellState;

/// A cell whose traction is within this part of its limit has reached it.
pub(super) const REACHED: f64 = 1.0 - 1e-9;

impl ActiveSet {
    /// The norm of what breaks the law: tractions beyond their discs, or in them where the cell is
    /// said to slip, and slip along the traction, as tractions.
    pub(super) fn violation(&self, task: &TangentialTask<'_>) -> f64 {
        let mut square = 0.0;
        for (i, limit) in task.limits.iter().enumerate() {
            if task.cells[i] == CellState::Exterior {
                continue;
            }
            let [x, y] = [task.traction[0][i], task.traction[1][i]];
            let norm = (x * x + y * y).sqrt();
            let beyond = match task.cells[i] {
                CellState::Slip => (norm - limit).abs(),
                _ => (norm - limit).max(0.0),
            };
            square += beyond * beyond;
            if task.cells[i] == CellState::Slip {
                let along = self.slip[0][i] * self.rim[0][i] + self.slip[1][i] * self.rim[1][i];
                let wrong = along.max(0.0) / self.own;
                square += wrong * wrong;
            }
        }
        square.sqrt()
    }

    /// The greatest distance of a traction from where the slip would take it and its disc hold it.
    pub(super) fn residual(&self, task: &TangentialTask<'_>) -> f64 {
        let mut greatest = 0.0_f64;
        for (i, &limit) in task.limits.iter().enumerate() {
            if task.cells[i] == CellState::Exterior {
                continue;
            }
            let at = [0, 1].map(|axis| task.traction[axis][i]);
            let pulled = [0, 1].map(|axis| at[axis] - self.slip[axis][i] / self.own);
            let [x, y] = within(pulled, limit);
            let distance = ((at[0] - x) * (at[0] - x) + (at[1] - y) * (at[1] - y)).sqrt();
            if distance.is_nan() {
                return distance;
            }
            greatest = greatest.max(distance);
        }
        greatest
    }

    /// Tractions in their discs, and what the cells do.
    pub(super) fn finish(&self, task: &mut TangentialTask<'_>) {
        for (i, &limit) in task.limits.iter().enumerate() {
            let slips = task.cells[i] == CellState::Slip;
            let at = [0, 1].map(|axis| task.traction[axis][i]);
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let [x, y] = if slips && norm > 0.0 {
                at.map(|t| limit * (t / norm))
            } else {
                within(at, limit)
            };
            (task.traction[0][i], task.traction[1][i]) = (x, y);
            let along = self.slip[0][i] * x + self.slip[1][i] * y;
            task.cells[i] = if limit == 0.0 {
                CellState::Exterior
            } else if x.hypot(y) >= limit * REACHED && along < 0.0 {
                CellState::Slip
            } else {
                CellState::Stick
            };
        }
    }
}

/// Whether tractions have left their discs for good.
pub(super) fn is_lost(task: &TangentialTask<'_>, violation: f64) -> bool {
    let size: f64 = task.limits.iter().filter(|r| r.is_finite()).map(|r| r * r).sum();
    size > 0.0 && violation > 10.0 * size.sqrt()
}

/// The nearest point of a disc.
pub(crate) fn within([x, y]: [f64; 2], limit: f64) -> [f64; 2] {
    let norm = (x * x + y * y).sqrt();
    if norm > limit { [limit * (x / norm), limit * (y / norm)] } else { [x, y] }
}

/// The greatest limit; where that is above all pressures and above what the offset asks for, the
/// greater of these.
pub(super) fn force_scale(task: &TangentialTask<'_>) -> f64 {
    let finite = task.limits.iter().copied().filter(|limit| limit.is_finite());
    let greatest = finite.fold(0.0, f64::max);
    if greatest > 0.0 && greatest <= task.pressure {
        return greatest;
    }
    let own = task.operator.coefficients(0, 0).rows[0][0];
    let offset = task.offset.iter().flat_map(|values| values.iter());
    let asked = offset.fold(0.0_f64, |most, value| most.max(value.abs())) / own;
    if greatest > 0.0 {
        greatest.min(asked.max(task.pressure))
    } else if asked > 0.0 {
        asked
    } else {
        1.0
    }
}
