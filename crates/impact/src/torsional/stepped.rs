//! The torsional impact in steps, by the general history of a twisted contact: for spins that
//! reverse so fast that a second slip annulus opens.

use carom_laws::torsion::history::TwistHistory;
use carom_special::RangeError;

use super::groups::TorsionalGroups;
use crate::normal;

/// Steps of the coarse run; the result is that of a run with twice as many.
const COARSE_STEPS: usize = 2000;

/// The spin ratio, and its change by the last doubling of the steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Settled {
    pub(super) spin_ratio: f64,
    pub(super) change: f64,
}

/// Integrates the impact with two numbers of steps.
pub(super) fn settle(groups: TorsionalGroups) -> Result<Settled, RangeError> {
    let run = |steps: usize| -> Result<f64, RangeError> {
        let mut trajectory = SteppedTrajectory::new(groups, steps);
        Ok(trajectory.advance_to(-1.0)?.spin)
    };
    let (coarse, fine) = (run(COARSE_STEPS)?, run(2 * COARSE_STEPS)?);
    // No impact increases the spin.
    Ok(Settled { spin_ratio: fine.clamp(-1.0, 1.0), change: (fine - coarse).abs() })
}

/// One instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    pub(super) radius: f64,
    pub(super) stick: f64,
    pub(super) spin: f64,
    pub(super) twist: f64,
    pub(super) torque: f64,
}

/// The motion over decreasing normal velocity: half a step with the old torque, a step of the spin,
/// half a step with the new torque.
#[derive(Debug, Clone)]
pub(super) struct SteppedTrajectory {
    groups: TorsionalGroups,
    history: TwistHistory,
    longest: f64,
    /// Angle with cosine w.
    angle: f64,
    time: f64,
    spin: f64,
    twist: f64,
    torque: f64,
}

impl SteppedTrajectory {
    pub(super) fn new(groups: TorsionalGroups, steps: usize) -> Self {
        Self {
            groups,
            history: TwistHistory::new(),
            longest: std::f64::consts::PI / steps as f64,
            angle: 0.0,
            time: 0.0,
            spin: 1.0,
            twist: 0.0,
            torque: 0.0,
        }
    }

    /// Continues to the normal velocity `w` in [-1, 1], not above the last one.
    pub(super) fn advance_to(&mut self, w: f64) -> Result<Step, RangeError> {
        let (from, to) = (self.angle, libm::acos(w));
        let count = ((to - from) / self.longest - 1e-9).ceil().max(0.0) as usize;
        for i in 1..=count {
            let last = i == count;
            let angle = if last { to } else { from + (to - from) * (i as f64 / count as f64) };
            self.step(if last { w } else { libm::cos(angle) })?;
        }
        self.angle = to;
        let radius = self.history.radius();
        let stick = self.history.stick_radius();
        let Self { spin, twist, torque, .. } = *self;
        Ok(Step { radius, stick, spin, twist, torque })
    }

    fn step(&mut self, w: f64) -> Result<(), RangeError> {
        let (epsilon, omega) = (self.groups.epsilon(), self.groups.omega());
        let time = normal::time(w);
        let dt = time - self.time;
        let half = self.spin - 0.5 * epsilon * dt * self.torque;
        let twist = self.twist + dt * half;
        let torque = self.history.advance(normal::radius(w), omega * twist)? / omega;
        self.time = time;
        self.twist = twist;
        self.torque = torque;
        self.spin = half - 0.5 * epsilon * dt * torque;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::torsional::TorsionalImpact;

    #[test]
    fn steps_agree_with_the_law_of_one_ring_to_their_own_estimate() {
        for (epsilon, omega) in [(0.0625, 0.5), (0.5, 0.1), (0.8, 1.0), (3.0, 1.0), (5.0, 0.5)] {
            let groups = TorsionalGroups::new(epsilon, omega).unwrap();
            let exact = TorsionalImpact::new(groups).unwrap();
            assert_eq!(exact.error_estimate(), 1e-12);
            let steps = settle(groups).unwrap();
            let error = (steps.spin_ratio - exact.spin_ratio()).abs();
            assert!(error < 2.0 * steps.change && steps.change < 1e-4, "{steps:?} {error:e}");
        }
    }
}
