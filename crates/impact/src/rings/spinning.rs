//! Refines an impact with a spin about the normal.
//!
//! The error by too few rings falls with the square of their number and is taken off (Richardson); that of an impact
//! without spin is another one. The error by too few angles shows in how far two runs differ whose axes are half the
//! distance of two angles apart; of both the mean is taken. So the axes do not matter.

use super::RingImpactError;
use super::levels::Level;
use super::motion::{Passage, Rates};
use super::problem::{Exact, Problem};
use super::refine::{Corrected, Correction};

/// What may be left of the part that is taken off.
const LEFT_OF_RINGS: f64 = 0.35;
/// What may be left of half the difference of two directions.
const LEFT_OF_ANGLES: f64 = 0.6;
/// What may be left of the change by more angles and steps alone.
const LEFT_OF_STEPS: f64 = 0.2;

/// With spin: by what more rings would change, and by what steps change the normal velocity.
#[derive(Default)]
pub(super) struct Extrapolated {
    last: Option<Spun>,
}

/// A run, and what is known of its errors.
#[derive(Clone, Copy)]
struct Spun {
    rings: usize,
    after: Rates,
    /// What more rings would change.
    beyond: Rates,
    /// The size of the change by more angles and steps alone.
    by_steps: f64,
}

impl Correction for Extrapolated {
    fn of(
        &mut self,
        problem: &Problem,
        level: &Level,
        mut passage: Passage,
        exact: &Exact,
    ) -> Result<Option<Corrected>, RingImpactError> {
        passage.after[0] += exact.rates[0] - level.normal(problem)?;
        let by_law = match problem.loss {
            None => 0.0,
            Some(_) => {
                let alike = level.passage(&problem.alike())?;
                problem.without_viscous_law(level, &mut passage, (&alike, exact))?
            }
        };
        let first = self.last.is_none();
        let run = Spun::after(self.last.as_ref(), passage.after, level.rings);
        self.last = Some(run);
        if first {
            return Ok(None);
        }
        passage.after = problem.possible(&run.after, &run.beyond);
        let left = LEFT_OF_RINGS * libm::hypot(run.beyond[1], run.beyond[2])
            + LEFT_OF_ANGLES * passage.by_direction
            + LEFT_OF_STEPS * run.by_steps;
        let [speed, _, _, omega] = problem.motion.before;
        let tangential = left / (problem.scale() * speed);
        let normal = level.left * run.beyond[0].abs() / speed;
        let spin = LEFT_OF_RINGS * run.beyond[3].abs() / omega.abs();
        Ok(Some(Corrected { passage, left: [tangential, normal, spin], by_law }))
    }
}

impl Problem {
    /// Takes off what the step law of a viscous material errs in the like impact, apart from rings and steps, which err as
    /// much in an elastic one; less where spin uses up the friction. Returns its size over f v_z: as much may be left.
    fn without_viscous_law(
        &self,
        level: &Level,
        passage: &mut Passage,
        (alike, exact): (&Passage, &Exact),
    ) -> Result<f64, RingImpactError> {
        let elastic = Self { loss: None, ..*self };
        let (stepped, known) = (level.passage(&elastic.alike())?, elastic.exact()?);
        let [speed, _, _, omega] = self.motion.before;
        let over = self.scale() * speed;
        let rim = self.constants.radius * passage.maximal_approach.sqrt() * omega / over;
        let part = 1.0 / (1.0 + rim * rim);
        let off =
            |i: usize| (exact.rates[i] - alike.after[i]) - (known.rates[i] - stepped.after[i]);
        for i in [1, 2] {
            passage.after[i] += part * off(i);
        }
        Ok(libm::hypot(off(1), off(2)) / over)
    }

    /// Rates after the impact with what more rings would change, as far as friction and energy allow.
    pub(super) fn possible(&self, after: &Rates, beyond: &Rates) -> Rates {
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
    pub(super) fn energy(&self, rates: &Rates) -> f64 {
        let [along, across, about] = self.motion.mobility;
        let part =
            |rate: f64, mobility: f64| if mobility > 0.0 { rate * rate / mobility } else { 0.0 };
        let [speed, x, y, omega] = *rates;
        part(speed, along) + part(x, across) + part(y, across) + part(omega, about)
    }
}

impl Spun {
    fn after(last: Option<&Self>, after: Rates, rings: usize) -> Self {
        let Some(last) = last else {
            return Self { rings, after, beyond: [0.0; 4], by_steps: 0.0 };
        };
        let change: Rates = std::array::from_fn(|i| after[i] - last.after[i]);
        if rings == last.rings {
            let by_steps = libm::hypot(change[1], change[2]);
            return Self { rings, after, beyond: last.beyond, by_steps };
        }
        let ratio = rings as f64 / last.rings as f64;
        let beyond = change.map(|change| change / (ratio * ratio - 1.0));
        Self { rings, after, beyond, by_steps: 0.0 }
    }
}
