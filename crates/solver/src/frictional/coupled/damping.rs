//! Damped Newton steps, for starts that are far from the solution.
//!
//! At great friction a cell that slips at the edge closes its gap by the tractions around it, hardly by
//! its own, and the wrong set of such cells makes tractions of any size. A damped step adds to the gap of
//! each slipping cell a displacement in proportion to the change of its traction along the ray: it is a
//! step in time of a contact with viscous resistance. The damping falls and rises with the violation of the conditions.
//! If it has fallen too far, a step makes gaps many times as large, from which it takes many steps to recover:
//! such a step is taken again with a greater damping.

use crate::convergence::Residuals;

/// The first and greatest damping, relative to the influence of a cell on itself.
const GREATEST: f64 = 1.0;
/// A damping below this is none.
const LEAST: f64 = 1e-7;
/// The factors by which the damping falls and rises at most in a step.
const FACTORS: [f64; 2] = [0.3, 3.0];
/// A step fails if it multiplies the violation by more than the first factor and the greatest gap or overlap by
/// more than the second. A violation alone may also rise where one cell leaves the contact, which does no harm.
const FAILURE: [f64; 2] = [10.0, 4.0];
/// A failed step is taken again with the damping times this.
const RAISE: f64 = 5.0;
/// A step is taken again at most so many times.
const MOST_REPEATS: u32 = 3;

/// The damping of Newton's steps.
#[derive(Default)]
pub(super) struct Damping {
    last: Option<Last>,
}

/// What a step started from, and its damping.
struct Last {
    violation: f64,
    /// The normal residual.
    gap: f64,
    damping: f64,
    /// How many times the step was taken again.
    repeats: u32,
}

/// What follows a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Next {
    /// A step from here, with this damping.
    Onwards(f64),
    /// The last step once more, from where it started, with this damping.
    Again(f64),
}

impl Damping {
    /// The damping of the next step. It changes by the factor by which the violation has changed, within
    /// bounds.
    pub(super) fn next(&mut self, violation: f64, residuals: Residuals) -> Next {
        let gap = residuals.normal;
        if let Some(last) = self.last.as_mut().filter(|last| last.has_failed(violation, gap)) {
            last.damping = (RAISE * last.damping).min(GREATEST);
            last.repeats += 1;
            return Next::Again(last.damping);
        }
        let damping = self.last.as_ref().map_or(GREATEST, |last| {
            let factor = (violation / last.violation).clamp(FACTORS[0], FACTORS[1]);
            (factor * last.damping).min(GREATEST)
        });
        self.last = Some(Last { violation, gap, damping, repeats: 0 });
        Next::Onwards(if damping < LEAST { 0.0 } else { damping })
    }
}

impl Last {
    /// Whether the step has failed, to these values, and may succeed with a greater damping.
    fn has_failed(&self, violation: f64, gap: f64) -> bool {
        let may_repeat = self.repeats < MOST_REPEATS && self.damping < GREATEST;
        may_repeat && violation > FAILURE[0] * self.violation && gap > FAILURE[1] * self.gap
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn next(damping: &mut Damping, violation: f64, normal: f64) -> Next {
        damping.next(violation, Residuals { normal, tangential: 0.5 })
    }

    /// The greatest damping first, then in proportion to the violation.
    #[test]
    fn the_damping_follows_the_violation() {
        let mut damping = Damping::default();
        assert_eq!(next(&mut damping, 1e-3, 1e-3), Next::Onwards(1.0));
        // To take it again would change nothing.
        assert_eq!(next(&mut damping, 1.0, 1.0), Next::Onwards(1.0));
        assert_eq!(next(&mut damping, 0.5, 0.5), Next::Onwards(0.5));
        assert_eq!(next(&mut damping, 0.01, 0.01), Next::Onwards(0.3 * 0.5));
        assert_eq!(next(&mut damping, 0.09, 0.01), Next::Onwards(3.0 * 0.15));
    }

    /// A step that opens gaps is repeated with more damping, three times at most; one that turns the traction of
    /// a cell is not.
    #[test]
    fn a_step_that_fails_is_repeated_with_more_damping() {
        let mut damping = Damping::default();
        for size in [1.0, 0.1, 0.01, 1e-3, 1e-4] {
            next(&mut damping, size, size);
        }
        let low = 0.3_f64.powi(4);
        let Next::Again(once) = next(&mut damping, 1e-2, 1e-2) else { panic!("not repeated") };
        assert!((once - 5.0 * low).abs() < 1e-15, "{once}");
        let Next::Again(twice) = next(&mut damping, 1e-2, 1e-2) else { panic!("not repeated") };
        assert!((twice - 25.0 * low).abs() < 1e-15, "{twice}");
        assert_eq!(next(&mut damping, 1e-2, 1e-2), Next::Again(1.0));
        // At the greatest damping it goes on from where it is.
        assert_eq!(next(&mut damping, 1e-2, 1e-2), Next::Onwards(1.0));
        assert_eq!(next(&mut damping, 1e-3, 1e-3), Next::Onwards(0.3));
        assert_eq!(next(&mut damping, 1e-1, 1e-3), Next::Onwards(3.0 * 0.3));
    }
}
