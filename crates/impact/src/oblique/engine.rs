//! The event-driven walk through the regimes.

use super::adhesion::{Segment, Tangential};
use super::groups::Groups;
use super::journey::{Arrival, Crossing, Journey};
use super::memory::{Shape, Stretch};
use super::regime::{Event, ObliqueError, Phase, Regime};
use super::slip::{Chart, Slip, Weight};
use super::trace::{Recorder, Silent};
use crate::closed_form;
use crate::normal::compression;

/// Half-width of the neighbourhood of the onset of slip that a series covers.
const ONSET: f64 = 1e-3;
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
/// Phases of one impact after which the walk gives up.
const MAX_PHASES: usize = 200;

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
