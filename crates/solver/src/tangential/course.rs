//! The course of an iteration: when the sets change, and when that calls for care.

use crate::convergence::Products;

/// The sets change when their violation exceeds this part of the last step.
const EAGERNESS: f64 = 0.3;
/// The same once that does not converge.
const PATIENCE: f64 = 3.0;
/// A violation that falls by less than this between changes of the sets calls for care.
const FALL: f64 = 0.7;
/// A violation that has fallen to this part since the last change of the sets has fallen far.
const FAR: f64 = 0.03;

/// The course of an iteration on one grid.
#[derive(Default)]
pub(super) struct Course {
    pub(super) products: Products,
    /// `<K r, r>` of the last step within the sets; none if the next one begins afresh.
    pub(super) power: Option<f64>,
    /// The norm of the last correction.
    pub(super) step: f64,
    /// The violation at the last change of the sets.
    pub(super) last_violation: Option<f64>,
    pub(super) started: bool,
    /// How often the violation hardly fell from one change of the sets to the next.
    pub(super) slow_changes: u32,
    /// For how many steps the sets stand.
    pub(super) held: u32,
}

impl Course {
    /// Whether changes of the sets lead nowhere; not if the violation has fallen far since.
    pub(super) fn careful(&self, violation: f64) -> bool {
        self.slow_changes >= 2 && self.last_violation.is_none_or(|last| violation > FAR * last)
    }

    pub(super) fn changes(&mut self, violation: f64) {
        let careful = self.careful(violation);
        if self.last_violation.is_some_and(|last| violation > FALL * last) {
            self.slow_changes += 1;
        }
        // That of the start says nothing: tractions of the last step are all in their discs.
        self.last_violation = self.started.then_some(violation);
        self.started = true;
        self.held = if careful { 2 } else { 1 };
    }

    /// Whether the sets are to change before the next step.
    pub(super) fn asks_for_change(&self, violation: f64) -> bool {
        let eagerness = if self.careful(violation) { PATIENCE } else { EAGERNESS };
        self.held == 0 && violation > eagerness * self.step
    }
}
