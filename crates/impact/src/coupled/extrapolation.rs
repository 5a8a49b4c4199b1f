//! Richardson extrapolation of runs with doubled numbers of steps and annuli.

use std::ops::Range;

use super::run::Run;

/// Runs with twice as many steps and annuli each, and their limit.
///
/// The error of a run is proportional to the square of the step. The error of Richardson's
/// extrapolation is proportional to its cube while the stages of the contact change smoothly. If
/// the last three limits confirm this, a second extrapolation is used. Two limits may agree by
/// chance: therefore no change counts for less than a small part of the one before.
#[derive(Debug)]
pub(super) struct Extrapolation {
    plain: Run,
    once: Column,
    twice: Column,
    smooth: bool,
}

/// Limits of successive runs and their changes.
#[derive(Debug, Clone, Copy)]
struct Column {
    limit: Option<Run>,
    /// The last change.
    change: f64,
    /// The greatest of the changes, each divided by `LEAST_DECREASE` for every later one.
    error: f64,
}

/// Ratio of successive changes accepted as 2^3.
const CUBIC: Range<f64> = 5.0..11.0;
/// Ratio of successive changes accepted as 2^4.
const QUARTIC: Range<f64> = 11.0..32.0;

/// Twice the least ratio of successive changes of the first and of the second extrapolation if the
/// errors are smooth.
const LEAST_DECREASE: [f64; 2] = [16.0, 32.0];

impl Extrapolation {
    pub(super) const fn new(plain: Run) -> Self {
        Self { plain, once: Column::EMPTY, twice: Column::EMPTY, smooth: false }
    }

    /// Adds a run with twice as many steps and annuli as the last.
    pub(super) fn refine(&mut self, run: Run) {
        let before = self.once;
        let once = run.extrapolated(&self.plain, 3.0);
        self.once = before.then(once, LEAST_DECREASE[0]);
        let ratio = before.change / self.once.change;
        let order = [CUBIC, QUARTIC].iter().position(|range| range.contains(&ratio));
        if let Some(limit) = before.limit {
            let gain = [7.0, 15.0][order.unwrap_or(0)];
            self.twice = self.twice.then(once.extrapolated(&limit, gain), LEAST_DECREASE[1]);
        }
        self.smooth = order.is_some();
        self.plain = run;
    }

    /// The finest run.
    pub(super) const fn finest(&self) -> &Run {
        &self.plain
    }

    /// The limit.
    pub(super) fn best(&self) -> Run {
        self.column().limit.unwrap_or(self.plain)
    }

    /// Estimated error of the velocity of the limit; infinite after fewer than three runs.
    pub(super) const fn error(&self) -> f64 {
        self.column().error
    }

    const fn column(&self) -> &Column {
        if self.smooth && self.twice.error < self.once.error { &self.twice } else { &self.once }
    }
}

impl Column {
    const EMPTY: Self = Self { limit: None, change: f64::INFINITY, error: f64::INFINITY };

    fn then(&self, limit: Run, fading: f64) -> Self {
        let Some(before) = &self.limit else { return Self { limit: Some(limit), ..Self::EMPTY } };
        let change = (limit.velocity - before.velocity).norm();
        let memory = if self.change.is_finite() { self.change / fading } else { 0.0 };
        Self { limit: Some(limit), change, error: change.max(memory) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn run(error: f64) -> Run {
        let velocity = Vector3::new(1.0 + error, -error, -1.0 - 2.0 * error);
        Run {
            velocity,
            impulse: -velocity,
            duration: 3.0 + error,
            strongest: 0.0,
            peak: 1.0 - error,
            compressions: 1,
            steps: 1,
            rings: None,
            work: 1,
        }
    }

    fn after(rounds: i32, error: impl Fn(f64) -> f64) -> Extrapolation {
        let mut table = Extrapolation::new(run(error(0.1)));
        for round in 1..=rounds {
            table.refine(run(error(0.1 * 0.5_f64.powi(round))));
        }
        table
    }

    #[test]
    fn square_and_cube_of_the_step_cancel() {
        let table = after(3, |h| 0.3 * h * h - 0.2 * h * h * h);
        assert!(table.smooth && table.error() < 1e-15);
        let best = table.best();
        assert!((best.velocity - Vector3::new(1.0, 0.0, -1.0)).norm() < 1e-15);
        assert!((best.duration - 3.0).abs() < 1e-15 && (best.peak - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_second_extrapolation_waits_for_smooth_errors() {
        // A remainder that jumps between runs, as if an event falls between two steps.
        let table = after(4, |h| 0.3 * h * h * (1.0 + 0.5 * (1.0 / h).sin()));
        assert!(!table.smooth);
        let best = (table.best().velocity.x - 1.0).abs();
        assert!(best <= table.error(), "{best:e} {:e}", table.error());
        // Too few runs give no estimate.
        assert!(!after(1, |h| h * h).smooth && after(0, |h| h * h).error().is_infinite());
    }

    /// The last two limits agree by chance, at .03 from the true one: the change before still counts.
    #[test]
    fn limits_that_agree_by_chance_are_no_proof() {
        let mut table = Extrapolation::new(run(0.4));
        for error in [0.1, 0.0475, 0.034_375] {
            table.refine(run(error));
        }
        let velocity = table.best().velocity;
        assert!((velocity - run(0.03).velocity).norm() < 1e-12, "{velocity}");
        let changed = (run(0.03).velocity - run(0.0).velocity).norm();
        assert!((table.error() / (changed / 16.0) - 1.0).abs() < 1e-9, "{:e}", table.error());
    }
}
