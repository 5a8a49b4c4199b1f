//! Damped Newton steps, for starts that are far from the solution.
//!
//! At great friction a cell that slips at the edge closes its gap by the tractions around it, hardly by
//! its own, and the wrong set of such cells makes tractions of any size. A damped step adds to the gap of
//! each slipping cell a displacement in proportion to the change of its traction along the ray: it is a
//! step in time of a contact with viscous resistance. The damping falls and rises with the violation of the conditions.

/// The first and greatest damping, relative to the influence of a cell on itself.
const GREATEST: f64 = 1.0;
/// A damping below this is none.
const LEAST: f64 = 1e-7;
/// The factors by which the damping falls and rises at most in a step.
const FACTORS: [f64; 2] = [0.3, 3.0];

/// The damping of Newton's steps.
#[derive(Default)]
pub(super) struct Damping {
    /// The violation before the last step, and its damping.
    last: Option<(f64, f64)>,
}

impl Damping {
    /// The damping of the next step. It changes by the factor by which the violation has changed, within
    /// bounds.
    pub(super) fn next(&mut self, violation: f64) -> f64 {
        let damping = match self.last {
            None => GREATEST,
            Some((before, damping)) => {
                let factor = (violation / before).clamp(FACTORS[0], FACTORS[1]);
                (factor * damping).min(GREATEST)
            }
        };
        self.last = Some((violation, damping));
        if damping < LEAST { 0.0 } else { damping }
    }
}
