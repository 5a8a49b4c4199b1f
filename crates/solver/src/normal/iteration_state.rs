//! State of the iteration: when the active set changes, and when changes are made cautiously.

use crate::convergence::Products;

/// The active set changes when the violation of the inequalities exceeds this fraction of the last
/// step.
const EAGERNESS: f64 = 0.3;
/// The same where changes wait for the solution on the present set.
const PATIENCE: f64 = 100.0;
/// Fraction of a preconditioned step made when pressures are dropped: a full step overshoots where
/// the edge moves.
const DAMPING: f64 = 0.4;
/// The same while changes are made cautiously.
const CAREFUL_DAMPING: f64 = 0.2;
/// Changes of the set become cautious if the violation twice falls by less than this factor between
/// two changes.
const SLOW_DECREASE: f64 = 0.6;
/// After this many such changes, or one that the violation outgrows, only pressures are dropped, without a step of the
/// other cells.
const CHANGES_BEFORE_DROPPING_ONLY: u32 = 8;
/// After this many such changes each waits for the solution on the present set.
const CHANGES_BEFORE_WAITING: u32 = 100;

/// State of the iteration on one grid.
#[derive(Default)]
pub(super) struct IterationState {
    pub(super) products: Products,
    /// `<K g, g>` of the last step on the present set; `None` if conjugate gradients restart.
    pub(super) power: Option<f64>,
    /// The norm of the last correction.
    pub(super) step: f64,
    /// A bound on the error of the gap by rough products.
    pub(super) roughness: f64,
    /// The violation at the last change of the set, and how often it hardly decreased.
    pub(super) last_violation: Option<f64>,
    pub(super) slow_changes: u32,
    /// The set is kept for one step.
    pub(super) held: bool,
    /// Whether the iteration was restarted after losing the contact.
    pub(super) rescued: bool,
    /// Whether slow changes of the set wait for the solution on the present set, as in Kalker's
    /// NORM. On a plate one cell moves all others, and an early change of the set may be undone by
    /// the next one for ever.
    pub(super) patient: bool,
}

impl IterationState {
    /// After losing the contact: only pressures are dropped, without a step of the other cells.
    pub(super) fn rescue(products: Products, patient: bool) -> Self {
        Self {
            products,
            patient,
            rescued: true,
            slow_changes: CHANGES_BEFORE_DROPPING_ONLY,
            ..Self::default()
        }
    }

    const fn careful(&self) -> bool {
        self.slow_changes >= 2
    }

    /// Fraction of a preconditioned step made when pressures are dropped.
    pub(super) const fn damping(&self) -> f64 {
        if self.waits() {
            return 0.0;
        }
        match self.slow_changes {
            0 | 1 => DAMPING,
            2..CHANGES_BEFORE_DROPPING_ONLY => CAREFUL_DAMPING,
            _ => 0.0,
        }
    }

    const fn waits(&self) -> bool {
        self.patient && self.careful() || self.slow_changes >= CHANGES_BEFORE_WAITING
    }

    pub(super) fn changes(&mut self, violation: f64) {
        match self.last_violation {
            // Damped steps overshoot: among a million spots far from each other a field of gaps that hardly varies asks
            // for a small part of what K gives, and each change would leave a greater violation than the one before.
            Some(last) if violation > last && !self.patient => {
                self.slow_changes = CHANGES_BEFORE_DROPPING_ONLY.max(self.slow_changes + 1);
            }
            Some(last) if violation > SLOW_DECREASE * last => self.slow_changes += 1,
            _ => {}
        }
        self.last_violation = Some(violation);
        self.held = self.careful();
    }

    /// Whether the set is to change before the next step.
    pub(super) fn asks_for_change(&self, violation: f64) -> bool {
        let eagerness = match (self.waits(), self.careful()) {
            (true, _) => PATIENCE,
            (false, true) => 1.0,
            (false, false) => EAGERNESS,
        };
        !self.held && violation > eagerness * self.step
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn after_a_change_that_the_violation_outgrows_the_other_cells_keep_still() {
        let damping = |patient, violations: &[f64]| {
            let mut state = IterationState { patient, ..IterationState::default() };
            violations.iter().for_each(|violation| state.changes(*violation));
            state.damping()
        };
        assert_eq!(damping(false, &[1.0, 0.5, 0.2]), DAMPING);
        assert_eq!(damping(false, &[1.0, 0.7, 0.5]), CAREFUL_DAMPING);
        assert_eq!(damping(false, &[1.0, 0.5, 0.6, 0.1]), 0.0);
        // One cell of a plate moves all others: a violation that grows once is usual there.
        assert_eq!(damping(true, &[1.0, 0.5, 0.6, 0.1]), DAMPING);
    }

    #[test]
    fn many_slow_changes_wait_for_the_solution_on_the_present_set() {
        let mut state = IterationState { step: 1.0, ..IterationState::default() };
        let asks = |state: &IterationState, violation| {
            IterationState { held: false, ..*state }.asks_for_change(violation)
        };
        (0..50).for_each(|_| state.changes(1.0));
        assert!(asks(&state, 2.0));
        (0..60).for_each(|_| state.changes(1.0));
        assert!(!asks(&state, 2.0) && asks(&state, 200.0));
    }
}
