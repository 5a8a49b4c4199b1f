//! The steps of an impact that resembles a free one.

use super::Point;

/// Steps in time alone, t = T u^2 (3 - 2 u) with equal steps of u: fine at both ends, where the
/// force varies as the power 3/2 of time.
///
/// They do not depend on the state. The error of a run is therefore a smoother function of the step
/// than with steps chosen from the state. They require that the duration T is known well from
/// another run, and that nothing happens within a small part of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Schedule {
    duration: f64,
    fineness: f64,
    steps: usize,
}

impl Schedule {
    /// A schedule with this many steps within the duration.
    pub(super) fn new(duration: f64, steps: usize) -> Self {
        Self { duration, fineness: 1.0 / steps as f64, steps }
    }

    /// The step of this number from an instant; beyond the duration, up to the expected separation.
    pub(super) fn step(&self, number: usize, now: &Point) -> f64 {
        if number < self.steps {
            let (u, next) = (number as f64 * self.fineness, (number + 1) as f64 * self.fineness);
            return self.duration * (next * next * (3.0 - 2.0 * next) - u * u * (3.0 - 2.0 * u));
        }
        let (mean, outward) = (self.duration * self.fineness, -now.velocity.z);
        if outward > 0.0 { (now.shift.z / outward * (1.0 + 1e-9)).min(mean) } else { mean }
    }
}
