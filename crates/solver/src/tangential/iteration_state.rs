//! State of the iteration: when the sets change, and when changes are made cautiously.

use crate::convergence::Products;

/// The sets change when their violation exceeds this fraction of the last step. It is small, since few cells at a border
/// violate the law, while all cells take part in a step.
const EAGERNESS: f64 = 0.03;
/// The same between coupled bodies: at great friction their alternation is sensitive to it, and takes longer with less.
const COUPLED_EAGERNESS: f64 = 0.3;
/// The same after slow changes of the sets.
const SLOW_EAGERNESS: f64 = 3.0;
/// Changes of the sets are slow if the violation falls by less than this factor between two of
/// them.
const SLOW_DECREASE: f64 = 0.7;
/// Changes are no longer cautious once the violation has fallen to this fraction of its value at
/// the last change.
const LARGE_DECREASE: f64 = 0.03;

/// The slip is computed again where the errors of rough products may exceed this fraction of the distance from the
/// solution.
const ROUGH: f64 = 0.2;

/// State of the iteration on one grid.
#[derive(Default)]
pub(super) struct IterationState {
    pub(super) products: Products,
    /// `<K r, r>` of the last step on the present sets; `None` if conjugate gradients restart.
    pub(super) power: Option<f64>,
    /// The norm of the last correction.
    pub(super) step: f64,
    /// A bound on the error of the slip by rough products, divided by the influence of a cell on itself.
    pub(super) roughness: f64,
    /// The violation at the last change of the sets.
    pub(super) last_violation: Option<f64>,
    pub(super) started: bool,
    /// How often the violation hardly decreased from one change of the sets to the next.
    pub(super) slow_changes: u32,
    /// For how many steps the sets are kept.
    pub(super) held: u32,
}

impl IterationState {
    /// Whether set updates have stopped reducing the violation; false if it has fallen far since
    /// the last one.
    pub(super) fn careful(&self, violation: f64) -> bool {
        self.slow_changes >= 2
            && self.last_violation.is_none_or(|last| violation > LARGE_DECREASE * last)
    }

    pub(super) fn changes(&mut self, violation: f64) {
        let careful = self.careful(violation);
        if self.last_violation.is_some_and(|last| violation > SLOW_DECREASE * last) {
            self.slow_changes += 1;
        }
        // The violation of the start has no meaning: tractions of the last step all lie in their
        // discs.
        self.last_violation = self.started.then_some(violation);
        self.started = true;
        self.held = if careful { 2 } else { 1 };
    }

    /// Whether errors of rough products are no longer small beside the distance from the solution.
    pub(super) fn is_rough(&self, distance: f64) -> bool {
        self.roughness > ROUGH * distance
    }

    /// Whether the sets are to change before the next step.
    pub(super) fn asks_for_change(&self, violation: f64, coupled: bool) -> bool {
        let eagerness = match coupled {
            _ if self.careful(violation) => SLOW_EAGERNESS,
            true => COUPLED_EAGERNESS,
            false => EAGERNESS,
        };
        self.held == 0 && violation > eagerness * self.step
    }
}
