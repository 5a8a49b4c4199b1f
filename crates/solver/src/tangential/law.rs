//! Coulomb's law in each cell: its violation, and the state of the cell.

use super::task::TangentialTask;
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

/// Sums over the cells.
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

    /// The sums over both sets of cells.
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            violations: self.violations + other.violations,
            farthest: self.farthest.max(other.farthest),
            all: self.all + other.all,
        }
    }

    pub(super) fn all(&self) -> Violation {
        let distance = if self.all.is_nan() { self.all } else { self.farthest.sqrt() };
        Violation { violation: self.violations.sqrt(), distance }
    }
}

/// The greatest violation from which tractions return to their discs.
pub(super) fn most_violation(limits: &[f64]) -> f64 {
    let size: f64 = limits.iter().filter(|r| r.is_finite()).map(|r| r * r).sum();
    if size > 0.0 { 10.0 * size.sqrt() } else { f64::INFINITY }
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
