//! Partial slip followed by integration up to the event that ends it.

use carom_special::ode::{OdeError, Stepper, Tolerance};

use super::slip::{Chart, Clock, Instant, Slip, Unknowns, Weight};
use super::trace::Recorder;

const TOLERANCE: Tolerance = Tolerance { absolute: 2e-12, relative: 2e-12 };
/// Step of the stick radius in terms of the contact radius: its distance to the singular point
/// zeta = 0, which lies at an imaginary stick radius and which no error estimate sees beforehand.
const REACH: f64 = 0.5;
/// Slip velocity above which the stick radius may be the clock, and below which it is given up
/// again when the slip slows down.
const BRISK: f64 = 0.03;
const SLOW: f64 = 0.25;
/// Steps of one slip phase after which the integration gives up.
const MAX_STEPS: usize = 20_000;

/// How an integration within one stretch and one chart ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Crossing {
    StretchEnd,
    ChartEnd,
    SlipStop,
    RingClosed,
}

/// Where an integration ended.
pub(super) struct Arrival {
    pub(super) crossing: Crossing,
    pub(super) y: Unknowns,
    pub(super) now: Instant,
}

/// How an integration with one clock ended.
enum Leg {
    Arrived(Arrival),
    /// The slip slows down at these unknowns in this chart.
    Slowed {
        chart: Chart,
        y: Unknowns,
    },
}

/// One integration of partial slip over one stretch of memory in one chart.
pub(super) struct Journey<'a, R> {
    pub(super) slip: Slip<'a>,
    pub(super) recorder: &'a mut R,
}

impl<R: Recorder> Journey<'_, R> {
    pub(super) fn run(&mut self, start: Unknowns) -> Result<Arrival, OdeError> {
        let mut leg = self.by_coordinate(start, BRISK)?;
        loop {
            match leg {
                Leg::Arrived(arrival) => return Ok(arrival),
                // The stick radius slows down with the slip: back to the coordinate.
                Leg::Slowed { chart, y } => {
                    self.slip = Slip { weight: Weight::One, chart, ..self.slip };
                    leg = self.by_coordinate(y, f64::INFINITY)?;
                }
            }
        }
    }

    // `brisk`: the slip velocity from which the stick radius may take over as clock.
    fn by_coordinate(&mut self, start: Unknowns, brisk: f64) -> Result<Leg, OdeError> {
        let slip = self.slip;
        let end = slip.chart.end();
        let mut now = slip.instant(&start);
        let room = (end - start[0]).abs().min(4.0 * now.slip_velocity.abs());
        let first = (0.1 * room).max(1e-9) * (end - start[0]).signum();
        let slope = |x: f64, y: &Unknowns| slip.slope(Clock::Coordinate, x, y);
        let mut walk = Stepper::new(start[0], start, first, TOLERANCE, slope)?;
        let mut limit = end;
        let mut brisk = brisk;
        for _ in 0..MAX_STEPS {
            let from = with_coordinate(walk.x(), walk.y());
            if now.slip_velocity > brisk && self.suits_stick_radius(&now) {
                match self.by_stick_radius(&from) {
                    Ok(leg) => return Ok(leg),
                    Err(_) => brisk = f64::INFINITY,
                }
            }
            let checkpoint = walk.clone();
            if let Err(error) = walk.step(limit) {
                // Stuck at the very event: it is reached.
                let reached = self.nearly_passed(&now).ok_or(error)?;
                return Ok(Leg::Arrived(self.arrive(reached, from)));
            }
            let y = with_coordinate(walk.x(), walk.y());
            let next = slip.instant(&y);
            let mut crossing = self.passed(&next);
            let mut middle = 0.5 * (from[0] + y[0]);
            if crossing.is_none()
                && let Some(x) = self.dip(&now, &next, &mut walk)
            {
                (crossing, middle) = (Some(Crossing::SlipStop), x);
            }
            if let Some(crossing) = crossing {
                let seen = next.slip_velocity <= 0.0 || crossing != Crossing::SlipStop;
                if seen && let Some(leg) = self.land(crossing, &from) {
                    return Ok(leg);
                }
                // Close in on the event by shorter steps.
                if (y[0] - from[0]).abs() < 1e-13 {
                    return Ok(Leg::Arrived(self.arrive(crossing, from)));
                }
                limit = middle;
                walk = checkpoint;
                continue;
            }
            now = next;
            self.recorder.slip(&slip, Clock::Coordinate, &mut walk);
            if walk.x() == end {
                return Ok(Leg::Arrived(self.arrive(Crossing::ChartEnd, y)));
            }
            if walk.x() == limit {
                limit = end;
            }
        }
        Err(OdeError::StepTooSmall { x: walk.x(), step: 0.0 })
    }

    // Where within the last step the slip velocity falls to zero and recovers, unseen at its ends.
    fn dip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &self,
        before: &Instant,
        after: &Instant,
        walk: &mut Stepper<4, F>,
    ) -> Option<f64> {
        const DEEP: f64 = 0.5;
        let slip = &self.slip;
        let turns = slip.slip_rate(before) < 0.0 && slip.slip_rate(after) > 0.0;
        if !turns || before.slip_velocity.min(after.slip_velocity) > DEEP {
            return None;
        }
        let dense = walk.dense();
        let (mut early, mut late) = (dense.start(), dense.end());
        for _ in 0..40 {
            let middle = 0.5 * (early + late);
            let now = slip.at_clock(Clock::Coordinate, middle, &dense.at(middle));
            if now.slip_velocity <= 0.0 {
                return Some(middle);
            }
            if slip.slip_rate(&now) < 0.0 { early = middle } else { late = middle }
        }
        None
    }

    fn arrive(&self, crossing: Crossing, y: Unknowns) -> Arrival {
        Arrival { crossing, y, now: self.slip.instant(&y) }
    }

    // The event whose quantity has vanished but for the tolerance.
    fn nearly_passed(&self, now: &Instant) -> Option<Crossing> {
        const NEAR: f64 = 1e-9;
        if now.slip_velocity < NEAR {
            Some(Crossing::SlipStop)
        } else if now.ring < NEAR && now.w < 0.0 {
            Some(Crossing::RingClosed)
        } else if now.stick - self.slip.stretch.low < NEAR {
            Some(Crossing::StretchEnd)
        } else {
            None
        }
    }

    fn passed(&self, now: &Instant) -> Option<Crossing> {
        if now.slip_velocity <= 0.0 {
            Some(Crossing::SlipStop)
        } else if now.ring <= 0.0 && now.w < 0.0 {
            Some(Crossing::RingClosed)
        } else if now.stick <= self.slip.stretch.low {
            Some(Crossing::StretchEnd)
        } else {
            None
        }
    }

    // Land exactly on an event with the vanishing quantity as clock (Henon's device).
    fn land(&mut self, crossing: Crossing, from: &Unknowns) -> Option<Leg> {
        match crossing {
            Crossing::StretchEnd => match self.by_stick_radius(from) {
                Ok(leg @ Leg::Arrived(_)) => Some(leg),
                _ => None,
            },
            Crossing::SlipStop | Crossing::RingClosed => {
                self.until_zero(self.slip, crossing, from).map(Leg::Arrived)
            }
            Crossing::ChartEnd => None,
        }
    }

    fn until_zero(
        &mut self,
        slip: Slip<'_>,
        crossing: Crossing,
        from: &Unknowns,
    ) -> Option<Arrival> {
        let (clock, now) = match crossing {
            Crossing::SlipStop => (Clock::SlipVelocity, slip.instant(from).slip_velocity),
            _ => (Clock::RingWidth, from[2]),
        };
        if now <= 0.0 {
            return None;
        }
        let slope = |x: f64, y: &Unknowns| slip.slope(clock, x, y);
        let mut walk = Stepper::new(now, *from, -now, TOLERANCE, slope).ok()?;
        for _ in 0..60 {
            walk.step(0.0).ok()?;
            let mut y = *walk.y();
            let forward = (y[0] - from[0]) * (slip.chart.end() - from[0]) >= 0.0;
            if !forward || slip.instant(&y).stick <= slip.stretch.low {
                return None;
            }
            self.recorder.slip(&slip, clock, &mut walk);
            if walk.x() == 0.0 {
                if clock == Clock::RingWidth {
                    y[2] = 0.0;
                }
                return Some(Arrival { crossing, y, now: slip.instant(&y) });
            }
        }
        None
    }

    // The stick radius is the better clock where it moves briskly and either nears the end of
    // its stretch or would soon feel the singular point z* = 0.
    fn suits_stick_radius(&self, now: &Instant) -> bool {
        let low = self.slip.stretch.low;
        let near = now.stick - low < 0.35 * (now.zeta - low);
        near || self.slip.chart == Chart::RadiusOut
    }

    fn by_stick_radius(&mut self, from: &Unknowns) -> Result<Leg, OdeError> {
        let mut slip = Slip { weight: Weight::One, ..self.slip };
        let target = slip.stretch.low.sqrt();
        let mut last = self.slip.instant(from);
        let mut radius = last.stick.sqrt();
        let mut y = [from[0], from[1], last.ring, from[3]];
        let mut trial = 0.3 * (target - radius);
        loop {
            let slope = |x: f64, y: &Unknowns| slip.slope(Clock::StickRadius, x, y);
            let mut walk = Stepper::new(radius, y, trial, TOLERANCE, slope)?;
            loop {
                let before = y;
                walk.step(target.max(radius - REACH * last.radius))?;
                radius = walk.x();
                let now;
                (y, now) = slip.settle(radius, walk.y());
                if now.slip_velocity <= 0.0 || now.ring <= 0.0 {
                    let crossing =
                        if now.ring <= 0.0 { Crossing::RingClosed } else { Crossing::SlipStop };
                    let failed = OdeError::NotFinite { x: radius };
                    return self
                        .until_zero(slip, crossing, &before)
                        .map(Leg::Arrived)
                        .ok_or(failed);
                }
                self.recorder.slip(&slip, Clock::StickRadius, &mut walk);
                if radius == target {
                    let crossing = Crossing::StretchEnd;
                    return Ok(Leg::Arrived(Arrival { crossing, y, now }));
                }
                let chart = Chart::onward(now.w, now.zeta);
                if now.slip_velocity < SLOW.min(0.9 * last.slip_velocity) {
                    y[0] = chart.coordinate(now.w, now.zeta);
                    return Ok(Leg::Slowed { chart, y });
                }
                last = now;
                if chart != slip.chart {
                    trial = walk.trial_step();
                    y[0] = chart.coordinate(now.w, now.zeta);
                    slip.chart = chart;
                    break;
                }
            }
        }
    }
}

fn with_coordinate(x: f64, y: &Unknowns) -> Unknowns {
    [x, y[1], y[2], y[3]]
}
