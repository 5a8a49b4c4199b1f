//! Refines an impact with a spin about the normal.
//!
//! The error by too few rings falls with the square of their number and is taken off (Richardson); that of an impact
//! without spin is another one. The error by too few angles shows in how far two runs differ whose axes are half the
//! distance of two angles apart; of both the mean is taken. So the axes do not matter.

use super::levels::{Level, SPINNING};
use super::motion::{Passage, Rates};
use super::problem::Problem;
use super::refine::Found;
use super::{RingImpact, RingImpactError};

/// What may be left of the part that is taken off.
const LEFT_OF_RINGS: f64 = 0.35;
/// What may be left of half the difference of two directions.
const LEFT_OF_ANGLES: f64 = 0.6;
/// What may be left of the change by more angles and steps alone.
const LEFT_OF_STEPS: f64 = 0.2;

/// A run, and what is known of its errors.
struct Spun {
    rings: f64,
    passage: Passage,
    /// What more rings would change.
    beyond: Rates,
    /// The size of the change by more angles and steps alone.
    by_steps: f64,
}

impl Problem {
    /// As [`Problem::found`], with spin.
    pub(super) fn found_spinning(
        &self,
        [allowed, normal]: [f64; 2],
    ) -> Result<Found, RingImpactError> {
        let (alike, exact, left_out) = (self.alike(), self.exact()?, self.left_out());
        let mut last: Option<Spun> = None;
        let mut best = None;
        // The finest level takes a tenth of a second.
        let finest =
            if allowed < RingImpact::TOLERANCE { SPINNING.len() } else { SPINNING.len() - 1 };
        for (level, rings) in SPINNING.into_iter().take(finest) {
            let mut samples = Vec::new();
            let mut passage = level.observed(self, &mut |sample| samples.push(sample))?;
            let alike = level.passage(&alike)?;
            passage.after[0] += exact[0] - alike.after[0];
            let by_law = self.taken_from_viscous_law(&alike, &exact)
                / (self.scale() * self.motion.before[0]);
            let now = Spun::after(last.as_ref(), passage, rings);
            if last.is_some() {
                let found = self.judged_spinning(&level, &now);
                let estimate = found.estimate + left_out + by_law;
                let found = Found { samples, estimate, ..found };
                let enough = found.estimate <= allowed.max(2.0 * left_out) + by_law
                    && found.normal <= normal;
                best = Some(found);
                if enough {
                    break;
                }
            }
            last = Some(now);
        }
        best.ok_or(RingImpactError::NoSeparation)
    }

    fn judged_spinning(&self, level: &Level, run: &Spun) -> Found {
        let size = |rates: &Rates| libm::hypot(rates[1], rates[2]);
        let mut passage = run.passage;
        passage.after = self.possible(&passage.after, &run.beyond);
        let left = LEFT_OF_RINGS * size(&run.beyond)
            + LEFT_OF_ANGLES * passage.by_direction
            + LEFT_OF_STEPS * run.by_steps;
        let [speed, _, _, omega] = self.motion.before;
        let estimate = left / (self.scale() * speed) + self.floor(level);
        let normal = level.left * run.beyond[0].abs() / speed;
        let spin = LEFT_OF_RINGS * run.beyond[3].abs() / omega.abs() + level.floor.of_spin;
        Found { passage, estimate, normal, spin, level: *level, samples: Vec::new() }
    }
}

impl Problem {
    /// Rates after the impact with what more rings would change, as far as friction and energy allow.
    fn possible(&self, after: &Rates, beyond: &Rates) -> Rates {
        let before = self.motion.before;
        let mut rates: Rates = std::array::from_fn(|i| after[i] + beyond[i]);
        let [along, across, _] = self.motion.mobility;
        let [x, y] = [rates[1] - before[1], rates[2] - before[2]];
        let limit = self.friction.get() * (before[0] - rates[0]) / along;
        let part = across * limit / libm::hypot(x, y);
        if part < 1.0 {
            (rates[1], rates[2]) = (before[1] + part * x, before[2] + part * y);
        }
        if self.energy(&rates) <= self.energy(&before) { rates } else { *after }
    }

    /// Twice the energy that an impact can change.
    fn energy(&self, rates: &Rates) -> f64 {
        let [along, across, about] = self.motion.mobility;
        let part =
            |rate: f64, mobility: f64| if mobility > 0.0 { rate * rate / mobility } else { 0.0 };
        let [speed, x, y, omega] = *rates;
        part(speed, along) + part(x, across) + part(y, across) + part(omega, about)
    }
}

impl Spun {
    fn after(last: Option<&Self>, passage: Passage, rings: f64) -> Self {
        let Some(last) = last else {
            return Self { rings, passage, beyond: [0.0; 4], by_steps: 0.0 };
        };
        let change: Rates = std::array::from_fn(|i| passage.after[i] - last.passage.after[i]);
        if rings == last.rings {
            let by_steps = libm::hypot(change[1], change[2]);
            return Self { rings, passage, beyond: last.beyond, by_steps };
        }
        let ratio = rings / last.rings;
        let beyond = change.map(|change| change / (ratio * ratio - 1.0));
        Self { rings, passage, beyond, by_steps: 0.0 }
    }
}
