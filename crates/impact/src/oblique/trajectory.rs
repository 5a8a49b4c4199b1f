//! The trajectory of an oblique impact through its regimes, from event to event.

use super::adhesion::{Segment, Tangential};
use super::groups::Groups;
use super::limit::Limit;
use super::memory::{Frozen, Shape, Stretch};
use super::onset::{Onset, Opened, Opening};
use super::position::Position;
use super::recorder::Recorder;
use super::regime::{Event, ObliqueError, Phase, Regime};
use super::slip::{Clock, Slip};
use super::slip_integration::{FIRST_STEP, SlipEnd, SlipEvent, SlipIntegration};
use super::state::State;

/// The impact counts as reversible if the tangential velocity u at maximum compression is below
/// this: R_x = 1 - 2 u^2 to leading order, so that the result does not change in double precision.
const MAX_REVERSIBLE_VELOCITY: f64 = 1e-8;
/// A first sliding (chi > 1) or sticking (chi < 1) phase is skipped if it ends within this share of
/// the impact, since its end cannot be distinguished from first contact.
const MIN_SHARE_OF_PHASE: f64 = 1e-9;
/// A stop of slip counts as one at maximum compression if the normal velocity is below this.
const MAX_SPEED_AT_MAXIMUM: f64 = 1e-6;
/// Largest number of phases of one impact.
const MAX_PHASES: usize = 200;

/// The slip annulus at the beginning of a slip phase.
#[derive(Debug, Clone)]
struct Ring {
    /// tau* of its inner edge.
    stick: f64,
    /// tau + tau*.
    gap: f64,
    /// The series of the onset, if the phase begins with one.
    opening: Option<Box<Opening>>,
}

/// What to do next.
enum Next {
    Adhere,
    /// Slip that begins at the edge.
    Slip {
        sign: f64,
        event: Event,
    },
    /// Continues slip in the phase that was just entered.
    KeepSlipping {
        sign: f64,
        ring: Ring,
    },
    Slide {
        sign: f64,
        event: Event,
    },
    Separate,
}

/// The motion from first contact to separation.
pub(super) struct Trajectory<'r, R> {
    chi: f64,
    psi: f64,
    memory: Vec<Stretch>,
    state: State,
    pub(super) phases: Vec<Phase>,
    recorder: &'r mut R,
}

impl<'r, R: Recorder> Trajectory<'r, R> {
    pub(super) fn new(groups: Groups, recorder: &'r mut R) -> Self {
        let state = State { position: Position::TOUCH, velocity: 1.0, shift: 0.0, traction: 0.0 };
        Self {
            chi: groups.chi(),
            psi: groups.psi(),
            memory: Vec::with_capacity(4),
            state,
            phases: Vec::with_capacity(8),
            recorder,
        }
    }

    /// The final tangential velocity in units of the initial one.
    pub(super) fn run(&mut self) -> Result<f64, ObliqueError> {
        let moment = MIN_SHARE_OF_PHASE * (self.chi - 1.0);
        let slides = self.psi > 1.0 + moment;
        let mut next = if slides {
            Next::Slide { sign: 1.0, event: Event::Touch }
        } else {
            self.adhere_from_touch()
        };
        for _ in 0..MAX_PHASES {
            next = match next {
                Next::Adhere => self.adhere(),
                Next::Slip { sign, event } => {
                    self.enter(Regime::slip(sign), event);
                    let stick = self.state.position.tau.abs();
                    self.slip(sign, Ring { stick, gap: 0.0, opening: None })?
                }
                Next::KeepSlipping { sign, ring } => self.slip(sign, ring)?,
                Next::Slide { sign, event } => {
                    self.enter(Regime::slide(sign), event);
                    self.slide(sign)
                }
                Next::Separate => {
                    let last = self.phases.last().map_or(Regime::Adhesion, |phase| phase.regime);
                    self.recorder.separation(&self.state, last);
                    return Ok(self.state.velocity);
                }
            };
        }
        Err(ObliqueError::TooManyPhases { phases: MAX_PHASES, w: self.state.position.w })
    }

    fn enter(&mut self, regime: Regime, began_by: Event) {
        // An annulus that opens into slip of its own sign slides at once: a phase of zero length is
        // not recorded.
        let start = self.state.position.w;
        if self.phases.last().is_some_and(|last| last.start == start && start < 1.0) {
            self.phases.pop();
        }
        self.phases.push(Phase { regime, began_by, start });
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
        let State { position, velocity, traction, .. } = self.state;
        let now = Tangential { velocity, flux: self.chi * traction };
        let segment = Segment::from_state(self.chi, &position, now);
        self.follow_adhesion(segment, velocity.signum())
    }

    // `resting` is the sign of the limit |u| = w at which the phase begins, or 0.
    fn follow_adhesion(&mut self, segment: Segment, resting: f64) -> Next {
        if self.is_neutral(&segment) {
            return self.retrace(&segment);
        }
        // Without a limit u = 0 at w = 0 to full accuracy.
        let (w, sign) =
            Limit::new(self.chi, self.psi).reached(&segment, resting).unwrap_or((0.0, 1.0));
        self.open_ring(segment, w, sign)
    }

    // Adhesion from first contact, with tangential velocity zero at maximum compression, releases
    // as it loaded: chi = 1, 8, .. (phi = 11, 31, ..).
    fn is_neutral(&self, segment: &Segment) -> bool {
        let sticks = || {
            (1..=20).all(|i| {
                let w = 0.05 * f64::from(i);
                self.psi * segment.velocity_at(w).abs() <= w * (1.0 + MAX_REVERSIBLE_VELOCITY)
            })
        };
        self.phases.len() == 1
            && segment.high == 1.0
            && segment.velocity_at(0.0).abs() < MAX_REVERSIBLE_VELOCITY
            && sticks()
    }

    fn move_along(&mut self, segment: &Segment, position: Position) {
        self.recorder.adhesion(self.chi, self.psi, segment, &mut self.state, position.w);
        let now = segment.at(&position);
        self.state.position = position;
        self.state.velocity = now.velocity;
        self.state.traction = now.flux / self.chi;
    }

    fn retrace(&mut self, segment: &Segment) -> Next {
        self.move_along(segment, Position::MAXIMUM);
        self.recorder.retrace(self.chi, segment, &self.state);
        // The tangential motion runs backwards with the normal one: R_x = 1.
        self.state =
            State { position: Position::SEPARATION, velocity: -1.0, shift: 0.0, traction: 0.0 };
        Next::Separate
    }

    fn open_ring(&mut self, segment: Segment, w: f64, sign: f64) -> Next {
        let (inner, shift) = (self.state.position.tau, self.state.shift);
        let touch = segment.high;
        let position = Position::of_velocity(w);
        self.move_along(&segment, position);
        let now = segment.at(&position);
        let onset = Onset { chi: self.chi, psi: self.psi, sign, position, now, touch };
        let opening = onset.open();
        let Opened { stick, gap, .. } = opening.at(opening.reach);
        let shape = Shape::Adhesion(Box::new(segment));
        self.memory.push(Stretch { inner, outer: position.tau, shift, shape });
        self.enter(Regime::slip(sign), Event::SlipStart);
        let ring = Ring { stick: stick.tau, gap, opening: Some(Box::new(opening)) };
        Next::KeepSlipping { sign, ring }
    }

    // ---- partial slip ---------------------------------------------------------------------

    fn slip(&mut self, sign: f64, ring: Ring) -> Result<Next, ObliqueError> {
        let mut ring = ring;
        loop {
            while self.memory.last().is_some_and(|top| ring.stick >= top.inner) {
                self.memory.pop();
            }
            let Some(top) = self.memory.last() else {
                return Ok(Next::Slide { sign, event: Event::StickEnd });
            };
            if let Shape::Slip(frozen) = &top.shape
                && frozen.sign == sign
            {
                // Stresses frozen by slip of the same sign extend the annulus at once.
                ring.stick = top.inner;
                ring.gap = self.state.position.tau + ring.stick;
                self.memory.pop();
                continue;
            }
            let SlipEnd { event, pair } = self.cross(sign, &ring)?;
            ring = Ring { stick: pair.stick.tau, gap: pair.gap * self.psi.min(1.0), opening: None };
            match event {
                SlipEvent::StretchEnd => {
                    self.memory.pop();
                }
                SlipEvent::SlipStop => return Ok(self.freeze(sign, &pair.stick)),
                SlipEvent::RingClosed => {
                    if let Some(top) = self.memory.last_mut() {
                        top.outer = pair.stick.tau;
                    }
                    return Ok(Next::Slip { sign: -sign, event: Event::RingClosed });
                }
            }
        }
    }

    fn freeze(&mut self, sign: f64, stick: &Position) -> Next {
        let position = self.state.position;
        let mut stored = 0.0;
        if let Some(top) = self.memory.last_mut() {
            stored = top.pull(self.chi, self.psi, stick) / self.chi;
            top.outer = stick.tau;
        }
        let frozen = Frozen { sign, offset: stored - sign * stick.cube() };
        let ring = (position.zeta() - stick.zeta()) / self.psi;
        self.memory.push(Stretch {
            inner: stick.tau,
            outer: position.tau.abs(),
            shift: self.state.shift - sign * ring,
            shape: Shape::Slip(frozen),
        });
        self.after_stop(sign, Event::SlipStop)
    }

    fn after_stop(&mut self, sign: f64, event: Event) -> Next {
        let w = self.state.position.w;
        if w > MAX_SPEED_AT_MAXIMUM {
            return Next::Adhere;
        }
        if w > 0.0 {
            self.come_to_rest();
        }
        Next::Slip { sign: -sign, event }
    }

    // Continues to maximum compression under the present force: adhesion over an interval w changes
    // the velocity by the order of w^3 only.
    fn come_to_rest(&mut self) {
        let State { position, traction, .. } = self.state;
        self.state.velocity -= self.chi * traction / position.cube() * position.w;
        self.state.position = Position::MAXIMUM;
        if let Some(top) = self.memory.last_mut() {
            top.outer = 0.0;
        }
    }

    // Integrates within one stretch of memory up to the first event.
    fn cross(&mut self, sign: f64, ring: &Ring) -> Result<SlipEnd, ObliqueError> {
        let State { position, velocity, .. } = self.state;
        let w = position.w;
        let Some(stretch) = self.memory.last() else {
            return Err(ObliqueError::TooManyPhases { phases: self.phases.len(), w });
        };
        let slip = Slip::new([self.chi, self.psi], sign, stretch);
        let gap = ring.gap / slip.unit;
        let (slip, start, rest, trial) = match &ring.opening {
            Some(opening) => {
                self.recorder.onset(&slip, opening);
                let rest = opening.at(opening.reach).excess / slip.unit;
                let start = slip.at(Clock::Memory, ring.stick, &[gap, rest]);
                (slip, start, rest, 0.5 * (ring.stick - stretch.outer))
            }
            None => {
                let start = slip.pair(gap, ring.stick, velocity);
                let slip = slip.entered(&start);
                (slip, start, slip.rest(&start), FIRST_STEP)
            }
        };
        let mut integration = SlipIntegration { slip, recorder: &mut *self.recorder };
        let met = integration
            .run(start, rest, trial)
            .map_err(|source| ObliqueError::Integration { w, source })?;
        let load = slip.load(&met.pair);
        self.state = State {
            position: met.pair.now,
            velocity: met.pair.velocity,
            shift: self.recorder.shift(&slip, &met.pair),
            traction: load.traction,
        };
        Ok(met)
    }

    // ---- sliding --------------------------------------------------------------------------

    // F_x = s f F_z: u = u0 + s chi (w - w0); slip velocity u - s w.
    fn slide(&mut self, sign: f64) -> Next {
        let State { position: Position { w, radius, .. }, velocity, .. } = self.state;
        let pull = sign * self.chi / self.psi;
        // Zero of u - s w, both in units of zeta'_A. For chi <= 1 sliding only accelerates.
        let stop = if self.chi <= 1.0 {
            f64::NEG_INFINITY
        } else {
            (self.chi * w - sign * self.psi * velocity) / (self.chi - 1.0)
        };
        self.memory.clear();
        let stops = stop > -1.0 && stop < w;
        let end = if stops { stop } else { -1.0 };
        self.recorder.slide(self.chi, self.psi, sign, &mut self.state, end);
        let position = Position::of_velocity(end);
        // 1 + w without cancellation if w is nearly -1
        let fall = match w < 0.0 {
            _ if stops => w - end,
            true => radius.powi(5) / (1.0 - w),
            false => 1.0 + w,
        };
        self.state.position = position;
        self.state.velocity = velocity - pull * fall;
        self.state.traction = sign * position.cube() / self.psi;
        if !stops {
            return Next::Separate;
        }
        self.memory.push(Stretch {
            inner: 1.0,
            outer: position.tau.abs(),
            shift: self.state.shift - sign * position.zeta() / self.psi,
            shape: Shape::Slip(Frozen { sign, offset: 0.0 }),
        });
        self.after_stop(sign, Event::SlideStop)
    }
}
