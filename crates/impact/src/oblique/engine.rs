//! The event-driven walk through the regimes.

use carom_special::ode::{OdeError, Stepper, Tolerance};

use super::adhesion::{Segment, Tangential};
use super::groups::Groups;
use super::memory::{Shape, Stretch};
use super::slip::{Chart, Clock, Instant, Slip, Unknowns, Weight};
use super::trace::{Recorder, Silent};
use crate::closed_form;
use crate::normal::compression;

const TOLERANCE: Tolerance = Tolerance { absolute: 2e-12, relative: 2e-12 };
/// Half-width of the neighbourhood of the onset of slip that a series covers.
const ONSET: f64 = 1e-3;
/// Step of the stick radius in terms of the contact radius: its distance to the singular point
/// zeta = 0, which lies at an imaginary stick radius and which no error estimate sees beforehand.
const REACH: f64 = 0.5;
/// Slip velocity above which the stick radius may be the clock, and below which it is given up
/// again when the slip slows down.
const BRISK: f64 = 0.03;
const SLOW: f64 = 0.25;
/// Below this psi nothing distinguishes the impact from one without slip.
pub(super) const PSI_MIN: f64 = 1e-14;
/// Tangential velocity u at maximal compression below which the impact counts as reversible:
/// R_x = 1 - 2 u^2 to leading order, so this changes nothing in double precision.
const NEUTRAL: f64 = 1e-8;
/// A first sliding (chi > 1) or sticking (chi < 1) that ends within this share of the impact is
/// passed over: its end could not be told from touch.
const MOMENT: f64 = 1e-9;
/// A stop of the slip at a smaller normal velocity than this counts as one at maximal compression.
const AT_REST: f64 = 1e-6;
/// Steps of one slip phase and phases of one impact after which the walk gives up.
const MAX_STEPS: usize = 20_000;
const MAX_PHASES: usize = 200;

/// Why an oblique impact could not be followed to its end.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ObliqueError {
    /// The integration of a slip phase failed.
    #[error("partial slip at normal velocity w = {w}: {source}")]
    Integration {
        /// Normal velocity w where it failed.
        w: f64,
        /// The integrator's reason.
        source: OdeError,
    },
    /// The regimes kept changing.
    #[error("more than {phases} regimes, the last at normal velocity w = {w}")]
    TooManyPhases {
        /// Phases passed.
        phases: usize,
        /// Normal velocity w there.
        w: f64,
    },
}

/// What the contact does: which part of it sticks, and the sign of the traction on body 1.
///
/// The sign is relative to the initial tangential velocity of body 2 against body 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Regime {
    /// The whole contact sticks.
    Adhesion,
    /// A ring at the edge slips, with traction along +x on body 1.
    SlipForward,
    /// A ring at the edge slips, with traction along -x.
    SlipBackward,
    /// The whole contact slides, with traction along +x.
    SlideForward,
    /// The whole contact slides, with traction along -x.
    SlideBackward,
}

impl Regime {
    fn slip(sign: f64) -> Self {
        if sign > 0.0 { Self::SlipForward } else { Self::SlipBackward }
    }

    fn slide(sign: f64) -> Self {
        if sign > 0.0 { Self::SlideForward } else { Self::SlideBackward }
    }

    /// Short name: `adhesion`, `slip+`, `slip-`, `slide+`, `slide-`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Adhesion => "adhesion",
            Self::SlipForward => "slip+",
            Self::SlipBackward => "slip-",
            Self::SlideForward => "slide+",
            Self::SlideBackward => "slide-",
        }
    }
}

/// What ended the previous phase.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Event {
    /// First touch.
    Touch,
    /// The edge reached the friction limit: a slip ring opens.
    SlipStart,
    /// The slip ring stopped: its stresses are frozen (E1).
    SlipStop,
    /// The receding edge has overtaken the slip ring, which reopens the other way (E2).
    RingClosed,
    /// The stick area vanished (E3).
    StickEnd,
    /// Sliding stopped.
    SlideStop,
}

/// A stretch of time in one regime.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// The regime.
    pub regime: Regime,
    /// What began it.
    pub began_by: Event,
    /// Normal velocity w = zeta'/zeta'_A at its start, from 1 (touch) to -1 (separation).
    pub start: f64,
}

/// An uncoupled oblique impact, followed from touch to separation.
///
/// ```
/// use carom_impact::oblique::{Groups, ObliqueImpact};
/// // Solid spheres, nu = 1/2 (kappa = 3/2), lambda = 3: the ball under a book, figure 3.7.
/// let impact = ObliqueImpact::new(Groups::of_spheres(1.5, 3.0)?)?;
/// assert!((impact.restitution() - 0.595_052).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ObliqueImpact {
    groups: Groups,
    restitution: f64,
    phases: Vec<Phase>,
}

impl ObliqueImpact {
    /// Follow the impact with these groups.
    ///
    /// # Errors
    /// [`ObliqueError`] if the walk does not reach separation: 3 of 3e5 random cases, all with
    /// chi > 20 (solid bodies have chi <= 7.5).
    pub fn new(groups: Groups) -> Result<Self, ObliqueError> {
        if groups.psi() < PSI_MIN {
            let restitution = closed_form::restitution_without_slip(groups.chi());
            let phase = Phase { regime: Regime::Adhesion, began_by: Event::Touch, start: 1.0 };
            return Ok(Self { groups, restitution, phases: vec![phase] });
        }
        Self::record(groups, &mut Silent)
    }

    pub(super) fn record<R: Recorder>(
        groups: Groups,
        recorder: &mut R,
    ) -> Result<Self, ObliqueError> {
        let mut walk = Walk::new(groups, recorder);
        // Energy never grows: the bound holds exactly, whatever the integration rounds to.
        let restitution = (0.0 - walk.run()?).clamp(-1.0, 1.0);
        Ok(Self { groups, restitution, phases: walk.phases })
    }

    /// The groups it was made with.
    #[must_use]
    pub fn groups(&self) -> Groups {
        self.groups
    }

    /// R_x = -(tangential velocity after)/(before), at the contact point.
    ///
    /// -1 without friction, +1 for a full reversal. For psi = 0 the limit (9.46).
    #[must_use]
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// The phases in order; the last ends with separation.
    #[must_use]
    pub fn phases(&self) -> &[Phase] {
        &self.phases
    }

    /// The regimes in order, without repeats.
    pub fn regimes(&self) -> impl Iterator<Item = Regime> + '_ {
        let phases = &self.phases;
        phases
            .iter()
            .enumerate()
            .filter(|(i, phase)| *i == 0 || phases[i - 1].regime != phase.regime)
            .map(|(_, phase)| phase.regime)
    }
}

/// The moving state, tangential quantities in units of the initial tangential velocity.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    pub(super) w: f64,
    pub(super) zeta: f64,
    pub(super) velocity: f64,
    pub(super) shift: f64,
    pub(super) traction: f64,
}

/// What to do next.
enum Next {
    Adhere,
    Slip {
        sign: f64,
        ring: f64,
        event: Event,
    },
    /// Go on slipping in the phase that was just entered.
    KeepSlipping {
        sign: f64,
        ring: f64,
        onset: f64,
    },
    Slide {
        sign: f64,
        event: Event,
    },
    Separate,
}

struct Walk<'r, R> {
    chi: f64,
    scale: f64,
    memory: Vec<Stretch>,
    state: State,
    phases: Vec<Phase>,
    recorder: &'r mut R,
}

impl<'r, R: Recorder> Walk<'r, R> {
    fn new(groups: Groups, recorder: &'r mut R) -> Self {
        let state = State { w: 1.0, zeta: 0.0, velocity: 1.0, shift: 0.0, traction: 0.0 };
        Self {
            chi: groups.chi(),
            scale: groups.psi(),
            memory: Vec::with_capacity(4),
            state,
            phases: Vec::with_capacity(8),
            recorder,
        }
    }

    /// The final tangential velocity in units of the initial one.
    fn run(&mut self) -> Result<f64, ObliqueError> {
        let moment = MOMENT * (self.chi - 1.0);
        let slides = self.scale > 1.0 + moment;
        let mut next = if slides {
            Next::Slide { sign: 1.0, event: Event::Touch }
        } else {
            self.adhere_from_touch()
        };
        for _ in 0..MAX_PHASES {
            next = match next {
                Next::Adhere => self.adhere(),
                Next::Slip { sign, ring, event } => {
                    self.enter(Regime::slip(sign), event);
                    self.slip(sign, ring, Weight::One)?
                }
                Next::KeepSlipping { sign, ring, onset } => {
                    self.slip(sign, ring, Weight::FromOnset(onset))?
                }
                Next::Slide { sign, event } => {
                    self.enter(Regime::slide(sign), event);
                    self.slide(sign)
                }
                Next::Separate => {
                    self.recorder.separation(&self.state);
                    return Ok(self.state.velocity);
                }
            };
        }
        Err(ObliqueError::TooManyPhases { phases: MAX_PHASES, w: self.state.w })
    }

    fn enter(&mut self, regime: Regime, began_by: Event) {
        // A ring that opens into slip of its own sign slides at once: no phase of no length.
        if self.phases.last().is_some_and(|last| last.start == self.state.w && last.start < 1.0) {
            self.phases.pop();
        }
        self.phases.push(Phase { regime, began_by, start: self.state.w });
    }

    // ---- adhesion -------------------------------------------------------------------------

    fn adhere_from_touch(&mut self) -> Next {
        self.enter(Regime::Adhesion, Event::Touch);
        let segment = Segment::from_touch(self.chi);
        self.follow_adhesion(segment, 0.0)
    }

    fn adhere(&mut self) -> Next {
        let event = match self.phases.last() {
            Some(phase) if phase.regime == Regime::SlideForward => Event::SlideStop,
            Some(phase) if phase.regime == Regime::SlideBackward => Event::SlideStop,
            _ => Event::SlipStop,
        };
        self.enter(Regime::Adhesion, event);
        let segment = self.segment_from_here();
        let same = self.state.velocity.signum();
        self.follow_adhesion(segment, same)
    }

    fn segment_from_here(&self) -> Segment {
        let State { w, zeta, velocity, traction, .. } = self.state;
        let gradient = self.chi * traction / (zeta * zeta.sqrt());
        Segment::from_state(self.chi, w, Tangential { velocity, gradient })
    }

    // `resting` is the sign on whose limit |u| = w the phase begins, or 0.
    fn follow_adhesion(&mut self, first: Segment, resting: f64) -> Next {
        let mut segment = first;
        let mut leaving = resting;
        loop {
            if self.is_neutral(&segment) {
                return self.retrace(segment);
            }
            if let Some((w, sign)) = self.limit_reached(&segment, &mut leaving) {
                return self.open_ring(segment, w, sign);
            }
            if segment.low <= 0.0 {
                return self.open_ring(segment, 0.0, 1.0); // u = 0 at w = 0 to the last digit
            }
            self.move_along(&segment, segment.low);
            self.memory.push(Stretch::adhesion(segment));
            segment = self.segment_from_here();
        }
    }

    // Adhesion since touch that comes to rest with the normal motion releases as it loaded:
    // chi = 1, 8, .. (phi = 11, 31, ..).
    fn is_neutral(&self, segment: &Segment) -> bool {
        let sticks = || {
            (1..=20).all(|i| {
                let w = 0.05 * f64::from(i);
                self.scale * segment.at(w).velocity.abs() <= w * (1.0 + NEUTRAL)
            })
        };
        segment.low == 0.0
            && self.phases.len() == 1
            && segment.high == 1.0
            && segment.at(0.0).velocity.abs() < NEUTRAL
            && sticks()
    }

    // The first w (falling) at which |u| reaches w, and the sign of u there.
    fn limit_reached(&self, segment: &Segment, leaving: &mut f64) -> Option<(f64, f64)> {
        const SAMPLES: usize = 24;
        let margin = |w: f64, sign: f64| w - sign * self.scale * segment.at(w).velocity;
        let mut before = segment.high.min(self.state.w);
        let span = before - segment.low;
        for i in 1..=SAMPLES {
            let w = if i == SAMPLES { segment.low } else { before - span / SAMPLES as f64 };
            for sign in [1.0, -1.0] {
                let value = margin(w, sign);
                if sign == *leaving {
                    if value > 0.0 {
                        *leaving = 0.0;
                    }
                } else if value < 0.0 || (value == 0.0 && w > 0.0) {
                    return Some((falling_root(|w| margin(w, sign), w, before), sign));
                }
            }
            before = w;
        }
        None
    }

    fn move_along(&mut self, segment: &Segment, w: f64) {
        self.recorder.adhesion(self.chi, self.scale, segment, &mut self.state, w);
        let now = segment.at(w);
        let zeta = compression(w);
        self.state.w = w;
        self.state.zeta = zeta;
        self.state.velocity = now.velocity;
        self.state.traction = zeta * zeta.sqrt() * now.gradient / self.chi;
    }

    fn retrace(&mut self, segment: Segment) -> Next {
        self.move_along(&segment, 0.0);
        self.recorder.retrace(self.chi, &segment, &self.state);
        // The tangential motion runs backwards with the normal one: R_x = 1.
        self.state = State { w: -1.0, zeta: 0.0, velocity: -1.0, shift: 0.0, traction: 0.0 };
        Next::Separate
    }

    // At the onset the stick depth leaves the rim as the mirror image of the motion: with
    // q(x) = (u - s w) zeta^(-3/2) = q1 x + q2 x^2 + .., x* = -x + a x^2 - a^2 x^3 + O(x^4), a = -2 q2/(3 q1).
    fn open_ring(&mut self, segment: Segment, w: f64, sign: f64) -> Next {
        self.move_along(&segment, w);
        let onset = segment.at(w);
        let one_minus = (1.0 - w) * (1.0 + w);
        let first = sign * self.scale * onset.gradient - 1.0;
        let second = 0.5 * sign * self.scale * segment.curvature(self.chi, w);
        // zeta^(-3/2) = (1 - w^2)^(-3/5): its logarithmic derivative is (6/5) w/(1 - w^2)
        let a = -2.0 / 3.0 * (second / first + 1.2 * w / one_minus);
        // The mirror image must stay within the adhesion it mirrors.
        let x = (ONSET * (1.0 - w)).min(0.03 / a.abs()).min(0.5 * (segment.high - w));
        let sum = a * x * x * (1.0 + a * x); // x* - x, both measured from the onset
        let (w_now, apart) = (w - x, 2.0 * x + sum);
        // S - S* = (w* - w)(w* + w)
        let s = (1.0 - w_now) * (1.0 + w_now);
        let fall = apart * (2.0 * w + sum) / s;
        let zeta = compression(w_now);
        let ring = -zeta * libm::expm1(0.4 * libm::log1p(-fall)) / self.scale;
        self.memory.push(Stretch { high: self.state.zeta, ..Stretch::adhesion(segment.clone()) });
        self.enter(Regime::slip(sign), Event::SlipStart);
        self.move_along(&segment, w_now);
        Next::KeepSlipping { sign, ring, onset: w }
    }

    // ---- partial slip ---------------------------------------------------------------------

    fn slip(&mut self, sign: f64, ring: f64, weight: Weight) -> Result<Next, ObliqueError> {
        let mut ring = ring;
        loop {
            let stick = self.state.zeta - self.scale * ring;
            while self.memory.last().is_some_and(|top| stick <= top.low) {
                self.memory.pop();
            }
            let Some(top) = self.memory.last() else {
                return Ok(Next::Slide { sign, event: Event::StickEnd });
            };
            if let Shape::Slip(frozen) = &top.shape
                && frozen.sign == sign
            {
                // Stresses frozen by slip of the same sign join the ring at once.
                ring += (stick - top.low) / self.scale;
                self.memory.pop();
                continue;
            }
            let end = self.cross(sign, ring, weight)?;
            ring = end.now.ring;
            match end.crossing {
                Crossing::StretchEnd => {
                    self.memory.pop();
                }
                Crossing::ChartEnd => {}
                Crossing::SlipStop => return Ok(self.freeze(sign, ring)),
                Crossing::RingClosed => {
                    let zeta = self.state.zeta;
                    if let Some(top) = self.memory.last_mut() {
                        top.high = zeta;
                    }
                    return Ok(Next::Slip { sign: -sign, ring: 0.0, event: Event::RingClosed });
                }
            }
        }
    }

    fn freeze(&mut self, sign: f64, ring: f64) -> Next {
        let (zeta, scale) = (self.state.zeta, self.scale);
        let stick = zeta - scale * ring;
        let mut traction = 0.0;
        if let Some(top) = self.memory.last_mut() {
            traction = top.at(stick, stick.sqrt(), self.chi).traction;
            top.high = stick;
        }
        self.memory.push(Stretch::slip(stick, zeta, sign, traction, scale));
        self.after_stop(sign, Event::SlipStop)
    }

    fn after_stop(&mut self, sign: f64, event: Event) -> Next {
        if self.state.w > AT_REST {
            return Next::Adhere;
        }
        if self.state.w > 0.0 {
            self.come_to_rest();
        }
        Next::Slip { sign: -sign, ring: 0.0, event }
    }

    // On to maximal compression under the present force: an adhesion of length w alters the
    // velocity by the order of w^3 only.
    fn come_to_rest(&mut self) {
        let State { w, zeta, traction, .. } = self.state;
        self.state.velocity -= self.chi * traction / (zeta * zeta.sqrt()) * w;
        (self.state.w, self.state.zeta) = (0.0, 1.0);
        if let Some(top) = self.memory.last_mut() {
            top.high = 1.0;
        }
    }

    // Integrate within one chart and one stretch of memory up to the first event.
    fn cross(&mut self, sign: f64, ring: f64, weight: Weight) -> Result<Arrival, ObliqueError> {
        let State { w, zeta, velocity, shift, .. } = self.state;
        let Some(stretch) = self.memory.last() else {
            return Err(ObliqueError::TooManyPhases { phases: self.phases.len(), w });
        };
        let chart = Chart::onward(w, zeta);
        let slip = Slip { chi: self.chi, scale: self.scale, sign, stretch, chart, weight };
        let y = [chart.coordinate(w, zeta), velocity, ring * weight.at(w), shift];
        let arrival = Journey { slip, recorder: &mut *self.recorder }
            .run(y)
            .map_err(|source| ObliqueError::Integration { w, source })?;
        let Arrival { now, y, .. } = arrival;
        self.state =
            State { w: now.w, zeta: now.zeta, velocity: y[1], shift: y[3], traction: now.traction };
        Ok(arrival)
    }

    // ---- sliding --------------------------------------------------------------------------

    // F_x = s f F_z: u = u0 + s chi (w - w0); slip velocity u - s w.
    fn slide(&mut self, sign: f64) -> Next {
        let State { w, velocity, .. } = self.state;
        let pull = sign * self.chi / self.scale;
        let at = |now: f64| velocity + pull * (now - w);
        // Zero of u - s w, both in units of zeta_dot_A; for chi <= 1 the sliding only accelerates.
        let stop = if self.chi <= 1.0 {
            f64::NEG_INFINITY
        } else {
            (self.chi * w - sign * self.scale * velocity) / (self.chi - 1.0)
        };
        self.memory.clear();
        let stops = stop > -1.0 && stop < w;
        let end = if stops { stop } else { -1.0 };
        self.recorder.slide(self.chi, self.scale, sign, &mut self.state, end);
        self.state.w = end;
        self.state.zeta = compression(end);
        self.state.velocity = at(end);
        let limit = self.state.zeta * self.state.zeta.sqrt();
        self.state.traction = sign * limit / self.scale;
        if !stops {
            return Next::Separate;
        }
        self.memory.push(Stretch::slip(0.0, self.state.zeta, sign, 0.0, self.scale));
        self.after_stop(sign, Event::SlideStop)
    }
}

/// How an integration within one stretch and one chart ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Crossing {
    StretchEnd,
    ChartEnd,
    SlipStop,
    RingClosed,
}

/// Where an integration ended.
struct Arrival {
    crossing: Crossing,
    y: Unknowns,
    now: Instant,
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
struct Journey<'a, R> {
    slip: Slip<'a>,
    recorder: &'a mut R,
}

impl<R: Recorder> Journey<'_, R> {
    fn run(&mut self, start: Unknowns) -> Result<Arrival, OdeError> {
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

// The largest root below `high` of a function positive there and not positive at `low`.
fn falling_root(f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let (mut f_low, mut f_high) = (f(low), f(high));
    let mut side = 0;
    for _ in 0..200 {
        if high - low <= f64::EPSILON * high.abs() {
            break;
        }
        // Illinois variant of regula falsi.
        let w = (low * f_high - high * f_low) / (f_high - f_low);
        let w = if w > low && w < high { w } else { 0.5 * (low + high) };
        let value = f(w);
        if value > 0.0 {
            (high, f_high) = (w, value);
            if side == 1 {
                f_low *= 0.5;
            }
            side = 1;
        } else {
            (low, f_low) = (w, value);
            if side == -1 {
                f_high *= 0.5;
            }
            side = -1;
            if value == 0.0 {
                break;
            }
        }
    }
    low
}
