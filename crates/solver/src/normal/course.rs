//! The course of an iteration: when the set changes, and when that calls for care.

use crate::convergence::Products;

/// The set changes when the violation of signs exceeds this part of the last step.
const EAGERNESS: f64 = 0.3;
/// Part of a preconditioned step beside dropped pressures: it overshoots where the edge moves.
const DAMPING: f64 = 0.4;
/// The same with care.
const CAREFUL_DAMPING: f64 = 0.2;
/// A violation that falls by less than this between two changes of the set, twice, calls for care.
const FALL: f64 = 0.6;
/// After so many changes of that kind pressures are dropped and nothing else is done.
const MANY: u32 = 8;

/// The course of an iteration on one grid.
#[derive(Default)]
pub(super) struct Course {
    pub(super) products: Products,
    /// `<K g, g>` of the last step within the set; none if the next one begins afresh.
    pub(super) power: Option<f64>,
    /// The norm of the last correction.
    pub(super) step: f64,
    /// The violation at the last change of the set, and how often it hardly fell.
    pub(super) last_violation: Option<f64>,
    pub(super) slow_changes: u32,
    /// The set stands for one step.
    pub(super) held: bool,
    /// Whether the contact was lost once already.
    pub(super) rescued: bool,
}

impl Course {
    /// Once the contact was lost: pressures are dropped and nothing else is done.
    pub(super) fn rescue(products: Products) -> Self {
        Self { products, rescued: true, slow_changes: MANY, ..Self::default() }
    }

    const fn careful(&self) -> bool {
        self.slow_changes >= 2
    }

    /// Part of a preconditioned step beside dropped pressures.
    pub(super) const fn damping(&self) -> f64 {
        match self.slow_changes {
            0 | 1 => DAMPING,
            2..MANY => CAREFUL_DAMPING,
            _ => 0.0,
        }
    }

    pub(super) fn changes(&mut self, violation: f64) {
        if self.last_violation.is_some_and(|last| violation > FALL * last) {
            self.slow_changes += 1;
        }
        self.last_violation = Some(violation);
        self.held = self.careful();
    }

    /// Whether the set is to change before the next step.
    pub(super) fn asks_for_change(&self, violation: f64) -> bool {
        let eagerness = if self.careful() { 1.0 } else { EAGERNESS };
        !self.held && violation > eagerness * self.step
    }
}
