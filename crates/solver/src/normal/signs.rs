//! Violations of the inequalities: tension, and overlap.

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::task::NormalTask;

impl ActiveSet {
    /// The norm of the violations, tension inside the set and overlap outside, as pressures.
    pub(super) fn violation(&self, task: &NormalTask<'_>) -> f64 {
        let mut square = 0.0;
        for ((active, pressure), gap) in self.active.iter().zip(task.pressure.iter()).zip(&self.gap)
        {
            let wrong = if *active { pressure.min(0.0) } else { gap.min(0.0) / self.own };
            square += wrong * wrong;
        }
        square.sqrt()
    }

    /// The greatest violation relative to the greatest displacement; NaN if any value is NaN.
    pub(super) fn residual(&self, task: &NormalTask<'_>) -> f64 {
        let (mut greatest, mut scale) = (0.0_f64, 0.0_f64);
        for (i, gap) in self.gap.iter().enumerate() {
            let pressure = task.pressure[i];
            let wrong = match (self.active[i], pressure < 0.0) {
                (true, true) => gap.abs().max(-pressure * self.own),
                (true, false) => gap.abs(),
                (false, _) => (-gap).max(0.0),
            };
            if wrong.is_nan() {
                return wrong;
            }
            greatest = greatest.max(wrong);
            if self.active[i] {
                scale = scale.max((gap + task.approach - task.heights[i]).abs());
            }
        }
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
        let norm = change * task.pressure.iter().map(|p| p * p).sum::<f64>().sqrt();
        state.step < norm && self.violation(task) < norm
    }
}
