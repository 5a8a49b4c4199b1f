//! Integration of partial slip up to the event that ends it.

use carom_special::ode::{OdeError, Stepper, Tolerance};

use super::memory::Shape;
use super::recorder::Recorder;
use super::slip::{Clock, Pair, Slip, Unknowns};

const TOLERANCE: Tolerance = Tolerance { absolute: 5e-12, relative: 5e-12 };
/// First steps: of tau* along the memory, and of tau for slow slip.
pub(super) const FIRST_STEP: f64 = 0.05;
const FIRST_SLOW_STEP: f64 = 0.03;
/// Rates of the motion against the memory at which the independent variable changes. Above this
/// rate slip is slow, and tau is taken.
const MAX_PACE_ALONG_MEMORY: f64 = 1.6;
/// Below this rate tau* is taken again.
const MIN_PACE_OF_SLOW_SLIP: f64 = 1.25;
/// Largest number of changes of the independent variable, and of steps with one.
const MAX_CLOCKS: usize = 400;
const MAX_STEPS: usize = 2000;
/// Below this tau (release), the width of the slip annulus is the better unknown.
const TAU_OF_RELEASE: f64 = -0.3;
/// Smallest dip of the slip velocity below zero, in its unit, that counts as a stop; and smallest
/// excess over the limit that ends adhesion. The annulus that would open is proportional to the
/// power 3/2 of this. It is below round-off and does not affect R_x.
pub(super) const MIN_DIP: f64 = 1e-8;
/// Largest number of steps to reach an event that was detected.
const MAX_LANDING: usize = 60;

/// How an integration within one stretch ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SlipEvent {
    StretchEnd,
    SlipStop,
    RingClosed,
}

/// Where an integration ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipEnd {
    pub(super) event: SlipEvent,
    pub(super) pair: Pair,
}

/// How an integration with one independent variable ended.
enum ClockEnd {
    Event(SlipEnd),
    /// Slip has become slow.
    Slow(Pair),
    /// Slip is no longer slow.
    NoLongerSlow(Pair),
}

impl ClockEnd {
    fn at(event: SlipEvent, pair: Pair) -> Self {
        Self::Event(SlipEnd { event, pair })
    }
}

/// One integration of partial slip over one stretch of memory.
pub(super) struct SlipIntegration<'a, R> {
    pub(super) slip: Slip<'a>,
    pub(super) recorder: &'a mut R,
}

impl<R: Recorder> SlipIntegration<'_, R> {
    /// Integrates from `start` with the remainder E = `rest` of the first integral.
    pub(super) fn run(&mut self, start: Pair, rest: f64, trial: f64) -> Result<SlipEnd, OdeError> {
        let mut end = self.by_memory(start, rest, trial);
        for _ in 0..MAX_CLOCKS {
            end = match end {
                ClockEnd::Event(met) => return Ok(met),
                ClockEnd::Slow(pair) => self.by_motion(pair)?,
                ClockEnd::NoLongerSlow(pair) => {
                    self.by_memory(pair, self.slip.rest(&pair), FIRST_STEP)
                }
            }
        }
        Err(OdeError::StepTooSmall { x: start.stick.tau, step: 0.0 })
    }

    // Independent variable tau*. Where it fails, tau is taken instead.
    fn by_memory(&mut self, start: Pair, rest: f64, trial: f64) -> ClockEnd {
        let rest = rest * self.slip.square;
        self.slip = self.slip.measured_by(&start);
        let slip = self.slip;
        let rest = rest / slip.square;
        let end = slip.stretch.inner;
        let releases = start.now.tau < TAU_OF_RELEASE;
        let (clock, width) = if releases {
            (Clock::Release, slip.load(&start).ring * slip.psi / slip.unit)
        } else {
            (Clock::Memory, start.gap)
        };
        let slope = |x: f64, y: &Unknowns| slip.slope(clock, x, y);
        let stepper = Stepper::new(start.stick.tau, [width, rest], trial, TOLERANCE, slope);
        let mut pace = -slip.pace(&start);
        let suits = pace < MAX_PACE_ALONG_MEMORY && !self.is_early(&start);
        let (Ok(mut stepper), true) = (stepper, suits) else {
            return ClockEnd::Slow(start);
        };
        for _ in 0..MAX_STEPS {
            let (x, y) = (stepper.x(), *stepper.y());
            let here = |slip: &Slip<'_>| slip.at(clock, x, &y);
            if stepper.step(end).is_err() {
                return ClockEnd::Slow(here(&slip));
            }
            if stepper.y()[0] < 0.0 {
                let before = here(&slip);
                return match self.land(Clock::Gap, &before, y[1]) {
                    Some(pair) => ClockEnd::at(SlipEvent::RingClosed, pair),
                    None => ClockEnd::Slow(before),
                };
            }
            let [tau, next] = slip.progress(clock, stepper.x(), stepper.y(), stepper.slope());
            let hasty = pace.max(-next) > MIN_PACE_OF_SLOW_SLIP;
            if hasty && self.turns(&here(&slip), &slip.at(clock, stepper.x(), stepper.y())) {
                return ClockEnd::Slow(here(&slip));
            }
            self.recorder.slip(&slip, clock, &mut stepper);
            pace = -next;
            let there = |slip: &Slip<'_>| slip.at(clock, stepper.x(), stepper.y());
            if stepper.x() == end {
                return ClockEnd::at(SlipEvent::StretchEnd, there(&slip));
            }
            if pace > MAX_PACE_ALONG_MEMORY {
                return ClockEnd::Slow(there(&slip));
            }
            if !releases && tau < TAU_OF_RELEASE {
                return self.by_memory(there(&slip), stepper.y()[1], stepper.trial_step());
            }
        }
        ClockEnd::Slow(slip.at(clock, stepper.x(), stepper.y()))
    }

    // Over frozen stresses tau* is a poor variable at first.
    fn is_early(&self, pair: &Pair) -> bool {
        const MAX_EARLY_TAU: f64 = 0.5;
        matches!(self.slip.stretch.shape, Shape::Slip(_)) && pair.stick.tau < MAX_EARLY_TAU
    }

    // Whether the slip velocity had a minimum in between.
    fn turns(&self, before: &Pair, after: &Pair) -> bool {
        self.slip.load(before).slip_rate < 0.0 && self.slip.load(after).slip_rate > 0.0
    }

    fn by_motion(&mut self, start: Pair) -> Result<ClockEnd, OdeError> {
        let slip = self.slip;
        let mut pair = start;
        let slope = |x: f64, y: &Unknowns| slip.slope(Clock::Motion, x, y);
        let y = [slip.mark(&start.stick), start.slip_velocity / slip.unit];
        let mut stepper = Stepper::new(start.now.tau, y, -FIRST_SLOW_STEP, TOLERANCE, slope)?;
        let mut limit = -1.0;
        for _ in 0..MAX_STEPS {
            // d(s q)/d tau: positive while the slip slows down, as tau falls.
            let slowing = slip.sign * stepper.slope()[1] > 0.0;
            let checkpoint = stepper.clone();
            if let Err(error) = stepper.step(limit) {
                // No progress at the event itself: it is reached.
                let event = self.nearly_passed(&pair).ok_or(error)?;
                return Ok(ClockEnd::at(event, pair));
            }
            let next = slip.at(Clock::Motion, stepper.x(), stepper.y());
            let mut middle = 0.5 * (pair.now.tau + next.now.tau);
            let mut event = self.passed(&next);
            let turns = slowing && slip.sign * stepper.slope()[1] < 0.0;
            if event.is_none()
                && turns
                && let Some(x) = self.dip(&mut stepper)
            {
                (event, middle) = (Some(SlipEvent::SlipStop), x);
            } else if let Some(event) = event
                && let Some(pair) = self.meet(event, &pair)
            {
                return Ok(ClockEnd::at(event, pair));
            }
            if let Some(event) = event {
                // Approaches the event by shorter steps.
                if (next.now.tau - pair.now.tau).abs() < 1e-13 {
                    return Ok(ClockEnd::at(event, pair));
                }
                limit = middle;
                stepper = checkpoint;
                continue;
            }
            self.recorder.slip(&slip, Clock::Motion, &mut stepper);
            pair = next;
            if -slip.pace(&pair) < MIN_PACE_OF_SLOW_SLIP && !self.is_early(&pair) {
                return Ok(ClockEnd::NoLongerSlow(pair));
            }
            if stepper.x() == limit {
                limit = -1.0;
            }
        }
        Err(OdeError::StepTooSmall { x: stepper.x(), step: 0.0 })
    }

    // Where, within the last step, the slip velocity falls to zero and recovers.
    fn dip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &self,
        stepper: &mut Stepper<2, F>,
    ) -> Option<f64> {
        let slip = &self.slip;
        let dense = stepper.dense();
        let (mut early, mut late) = (dense.start(), dense.end());
        for _ in 0..40 {
            let middle = 0.5 * (early + late);
            let now = slip.at(Clock::Motion, middle, &dense.at(middle));
            if slip.sign * now.slip_velocity < -MIN_DIP * slip.unit {
                return Some(middle);
            }
            if slip.load(&now).slip_rate < 0.0 { early = middle } else { late = middle }
        }
        None
    }

    // False at the bottom of a dip that only grazes zero.
    fn stops(&self, pair: &Pair) -> bool {
        let velocity = self.slip.sign * pair.slip_velocity / self.slip.unit;
        let falls = || self.slip.load(pair).slip_rate < -MIN_DIP.sqrt() * self.slip.unit;
        velocity < -MIN_DIP || (velocity <= 0.0 && falls())
    }

    fn passed(&self, pair: &Pair) -> Option<SlipEvent> {
        if self.stops(pair) {
            Some(SlipEvent::SlipStop)
        } else if pair.gap < 0.0 {
            Some(SlipEvent::RingClosed)
        } else if pair.stick.tau >= self.slip.stretch.inner {
            Some(SlipEvent::StretchEnd)
        } else {
            None
        }
    }

    // The event whose quantity has vanished to within the tolerance.
    fn nearly_passed(&self, pair: &Pair) -> Option<SlipEvent> {
        const EVENT_TOLERANCE: f64 = 1e-9;
        if self.slip.sign * pair.slip_velocity < EVENT_TOLERANCE {
            Some(SlipEvent::SlipStop)
        } else if pair.gap * self.slip.unit < EVENT_TOLERANCE && pair.now.tau < 0.0 {
            Some(SlipEvent::RingClosed)
        } else if self.slip.stretch.inner - pair.stick.tau < EVENT_TOLERANCE {
            Some(SlipEvent::StretchEnd)
        } else {
            None
        }
    }

    fn meet(&mut self, event: SlipEvent, from: &Pair) -> Option<Pair> {
        let clock = match event {
            SlipEvent::SlipStop => Clock::SlipVelocity,
            SlipEvent::RingClosed => Clock::Gap,
            SlipEvent::StretchEnd => Clock::Memory,
        };
        self.land(clock, from, self.slip.rest(from))
    }

    // Reaches an event exactly, with the vanishing quantity as independent variable (Henon's
    // method).
    fn land(&mut self, clock: Clock, from: &Pair, rest: f64) -> Option<Pair> {
        let slip = self.slip;
        let inner = slip.stretch.inner;
        let (start, target, y) = match clock {
            Clock::Memory => (from.stick.tau, inner, [from.gap, rest]),
            Clock::Gap => (from.gap, 0.0, [from.stick.tau, rest]),
            _ => (from.slip_velocity / slip.unit, 0.0, [from.now.tau, slip.mark(&from.stick)]),
        };
        if start == target {
            return None; // the phase has only just begun
        }
        let slope = |x: f64, y: &Unknowns| slip.slope(clock, x, y);
        let mut stepper = Stepper::new(start, y, target - start, TOLERANCE, slope).ok()?;
        for _ in 0..MAX_LANDING {
            stepper.step(target).ok()?;
            let pair = slip.at(clock, stepper.x(), stepper.y());
            let sound = pair.now.tau <= from.now.tau
                && pair.stick.tau >= from.stick.tau
                && pair.stick.tau <= inner
                && pair.gap >= 0.0;
            if !sound {
                return None;
            }
            self.recorder.slip(&slip, clock, &mut stepper);
            if stepper.x() == target {
                return Some(pair);
            }
        }
        None
    }
}
