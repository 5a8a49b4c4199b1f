//! Violations of the inequalities: tension, and overlap.

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::task::NormalTask;
use crate::parts::{fold, sum};

impl ActiveSet {
    /// The norm of the violations, tension inside the set and overlap outside, as pressures.
    pub(super) fn violation(&self, task: &NormalTask<'_>) -> f64 {
        let own = self.own;
        let parts = (&self.active[..], &*task.pressure, &self.gap[..]);
        let square = sum(self.threads, parts, &|(actives, pressures, gaps)| {
            let mut square = 0.0;
            for ((active, pressure), gap) in actives.iter().zip(pressures).zip(gaps) {
                let wrong = if *active { pressure.min(0.0) } else { gap.min(0.0) / own };
                square += wrong * wrong;
            }
            square
        });
        square.sqrt()
    }

    /// The greatest violation relative to the greatest displacement; NaN if any value is NaN.
    pub(super) fn residual(&self, task: &NormalTask<'_>) -> f64 {
        let (own, approach) = (self.own, task.approach);
        let parts = (&self.gap[..], &*task.pressure, &self.active[..], task.heights);
        let (greatest, scale) = fold(
            self.threads,
            parts,
            &|(gaps, pressures, actives, heights)| {
                let (mut greatest, mut scale) = (0.0_f64, 0.0_f64);
                for (i, gap) in gaps.iter().enumerate() {
                    let pressure = pressures[i];
                    let wrong = match (actives[i], pressure < 0.0) {
                        (true, true) => gap.abs().max(-pressure * own),
                        (true, false) => gap.abs(),
                        (false, _) => (-gap).max(0.0),
                    };
                    if wrong.is_nan() {
                        return (wrong, 0.0);
                    }
                    greatest = greatest.max(wrong);
                    if actives[i] {
                        scale = scale.max((gap + approach - heights[i]).abs());
                    }
                }
                (greatest, scale)
            },
            &|one, other| (greater(one.0, other.0), one.1.max(other.1)),
        );
        if scale > 0.0 { greatest / scale } else { greatest }
    }

    pub(super) fn is_converged(
        &self,
        task: &NormalTask<'_>,
        state: &IterationState,
        change: f64,
    ) -> bool {
        if change == 0.0 {
            return false;
        }
        let squares = |pressures: &[f64]| pressures.iter().map(|p| p * p).sum();
        let norm = change * sum(self.threads, &*task.pressure, &squares).sqrt();
        state.step < norm && self.violation(task) < norm
    }
}

/// The greater value; NaN if any is NaN.
pub(super) const fn greater(one: f64, other: f64) -> f64 {
    if one.is_nan() {
        one
    } else if other.is_nan() || other > one {
        other
    } else {
        one
    }
}
