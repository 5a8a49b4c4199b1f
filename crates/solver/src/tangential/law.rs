//! Coulomb's law in each cell: its violation, and the state of the cell.

use super::active_set::{ActiveSet, TangentialTask};
use crate::state::CellState;

/// A traction above this fraction of its bound has reached it.
pub(super) const REACHED: f64 = 1.0 - 1e-9;

/// The violation of Coulomb's law.
#[derive(Clone, Copy)]
pub(super) struct Violation {
    /// The norm of the violations, as tractions: tractions outside their discs, tractions inside
    /// their discs in cells marked as slipping, and slip in the direction of the traction.
    pub(super) violation: f64,
    /// The greatest distance of a traction from its image under slip and projection onto its disc;
    /// NaN if any value is NaN.
    pub(super) distance: f64,
}

impl Violation {
    /// Tractions have left their discs and will not return.
    pub(super) const LOST: Self = Self { violation: f64::INFINITY, distance: f64::INFINITY };
}

/// ViolationSums over the cells.
#[derive(Default)]
pub(super) struct ViolationSums {
    violations: f64,
    farthest: f64,
    all: f64,
}

impl ViolationSums {
    /// Adds a cell with its traction, its slip divided by its own influence, and its rim direction.
    #[inline]
    pub(super) fn add(
        &mut self,
        state: CellState,
        limit: f64,
        [x, y]: [f64; 2],
        [u, v]: [f64; 2],
        [e_x, e_y]: [f64; 2],
    ) {
        let (norm, most) = (x * x + y * y, limit * limit);
        if state == CellState::Slip {
            let (beyond, along) = (norm.sqrt() - limit, (u * e_x + v * e_y).max(0.0));
            self.violations += beyond * beyond + along * along;
        } else if norm > most {
            let beyond = norm.sqrt() - limit;
            self.violations += beyond * beyond;
        }
        let (x_pulled, y_pulled) = (x - u, y - v);
        let pulled = x_pulled * x_pulled + y_pulled * y_pulled;
        let part = if pulled > most { limit / pulled.sqrt() } else { 1.0 };
        let (dx, dy) = (x - part * x_pulled, y - part * y_pulled);
        let distance = dx * dx + dy * dy;
        self.farthest = self.farthest.max(distance);
        // The maximum would skip NaN.
        self.all += distance;
    }

    pub(super) fn all(&self) -> Violation {
        let distance = if self.all.is_nan() { self.all } else { self.farthest.sqrt() };
        Violation { violation: self.violations.sqrt(), distance }
    }
}

impl ActiveSet {
    /// The violation of the law.
    pub(super) fn check_law(&self, task: &TangentialTask<'_>) -> Violation {
        let (mut off, per_own) = (ViolationSums::default(), 1.0 / self.own);
        for (i, limit) in task.limits.iter().enumerate() {
            let traction = [task.traction[0][i], task.traction[1][i]];
            let slip = [self.slip[0][i] * per_own, self.slip[1][i] * per_own];
            off.add(task.cells[i], *limit, traction, slip, [self.rim[0][i], self.rim[1][i]]);
        }
        off.all()
    }

    /// Projects tractions onto their discs and sets the states of the cells.
    pub(super) fn finish(&self, task: &mut TangentialTask<'_>) {
        for (i, &limit) in task.limits.iter().enumerate() {
            let slips = task.cells[i] == CellState::Slip;
            let at = [0, 1].map(|axis| task.traction[axis][i]);
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let [x, y] = if slips && norm > 0.0 {
                at.map(|t| limit * (t / norm))
            } else {
                project_to_disc(at, limit)
            };
            (task.traction[0][i], task.traction[1][i]) = (x, y);
            let along = self.slip[0][i] * x + self.slip[1][i] * y;
            let slips = (x * x + y * y).sqrt() >= limit * REACHED && along < 0.0;
            task.cells[i] = if slips { CellState::Slip } else { CellState::Stick };
        }
    }
}

/// Whether tractions have left their discs and will not return.
pub(super) fn is_lost(task: &TangentialTask<'_>, violation: f64) -> bool {
    let size: f64 = task.limits.iter().filter(|r| r.is_finite()).map(|r| r * r).sum();
    size > 0.0 && violation > 10.0 * size.sqrt()
}

/// The nearest point of a disc.
pub(crate) fn project_to_disc([x, y]: [f64; 2], limit: f64) -> [f64; 2] {
    let norm = (x * x + y * y).sqrt();
    if norm > limit { [limit * (x / norm), limit * (y / norm)] } else { [x, y] }
}

/// The greatest bound; if it exceeds all pressures and the tractions that the offset needs, the
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
