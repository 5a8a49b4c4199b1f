//! The states of an oblique impact at chosen instants.

use carom_special::ode::{Stepper, Tolerance};
use carom_special::roots::bisect;

use super::adhesion::Segment;
use super::groups::Groups;
use super::impact::{ObliqueImpact, PSI_MIN};
use super::memory::Shape;
use super::onset::{Opened, Opening};
use super::position::Position;
use super::recorder::Recorder;
use super::regime::{ObliqueError, Regime};
use super::slip::{Clock, Pair, Slip, Unknowns};
use super::state::State;
use crate::normal::time;

/// Replaces psi = 0 in a history; the difference from the limit is less than this.
const PSI_NO_SLIP: f64 = 1e-13;

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-14, relative: 1e-14 };

/// One instant of an oblique impact.
///
/// Units: compression by zeta_max, time by zeta_max/zeta'_A; the tangential velocity by its
/// initial value u_0, the shift by u_0 zeta_max/zeta'_A, the force by
/// (2/3) c_x zeta_max^(3/2) u_0/zeta'_A. They stay finite for any friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TracePoint {
    /// Time since first contact.
    pub time: f64,
    /// Normal velocity w, from 1 to -1.
    pub normal_velocity: f64,
    /// Compression, 0 to 1.
    pub compression: f64,
    /// Tangential shift since first contact.
    pub shift: f64,
    /// Tangential velocity.
    pub velocity: f64,
    /// Tangential force on body 1.
    pub force: f64,
    /// Tangential force over the friction limit f F_z, between -1 and 1; 0 before first contact.
    pub friction_used: f64,
    /// Depth z* of the stick area (its radius is the square root); 0 while sliding.
    pub stick_depth: f64,
    /// Regime.
    pub regime: Regime,
}

impl ObliqueImpact {
    /// The states at the normal velocities `w`, which must fall from 1 to -1.
    ///
    /// # Errors
    /// [`ObliqueError`] as for [`ObliqueImpact::new`].
    pub fn trace(groups: Groups, w: &[f64]) -> Result<Vec<TracePoint>, ObliqueError> {
        let mut recorder = Trace { psi: groups.psi(), targets: w, points: Vec::new() };
        if groups.psi() >= PSI_MIN {
            Self::record(groups, &mut recorder)?;
            return Ok(recorder.points);
        }
        // Without slip: the limit psi -> 0, reached to round-off long before.
        recorder.psi = PSI_NO_SLIP;
        Self::record(Groups::new(groups.chi(), PSI_NO_SLIP).unwrap_or(groups), &mut recorder)?;
        for point in &mut recorder.points {
            (point.regime, point.friction_used) = (Regime::Adhesion, 0.0);
        }
        Ok(recorder.points)
    }
}

struct Trace<'a> {
    psi: f64,
    targets: &'a [f64],
    points: Vec<TracePoint>,
}

impl Trace<'_> {
    // The next target not below `w`. Separation, which w does not resolve, comes last.
    fn next(&mut self, w: f64) -> Option<f64> {
        let (&first, rest) = self.targets.split_first()?;
        if first < w || first <= -1.0 {
            return None;
        }
        self.targets = rest;
        Some(first)
    }

    fn push_slip(&mut self, slip: &Slip<'_>, pair: &Pair) {
        let state = State {
            position: pair.now,
            velocity: pair.velocity,
            shift: self.shift(slip, pair),
            traction: slip.load(pair).traction,
        };
        self.push(state, pair.stick.zeta(), Regime::slip(slip.sign));
    }

    fn push(&mut self, state: State, stick_depth: f64, regime: Regime) {
        let limit = state.position.cube();
        let friction_used = match regime {
            Regime::SlideForward => 1.0,
            Regime::SlideBackward => -1.0,
            _ if limit > 0.0 => self.psi * state.traction / limit,
            _ => 0.0,
        };
        self.points.push(TracePoint {
            time: time(state.position.w),
            normal_velocity: state.position.w,
            compression: state.position.zeta(),
            shift: state.shift,
            velocity: state.velocity,
            force: state.traction,
            friction_used,
            stick_depth,
            regime,
        });
    }
}

impl Recorder for Trace<'_> {
    fn adhesion(&mut self, chi: f64, _: f64, segment: &Segment, state: &mut State, w: f64) {
        let mut reached = state.position.w;
        while let Some(target) = self.next(w) {
            state.shift += adhesion_shift(segment, reached, target);
            reached = target;
            let position = Position::of_velocity(target);
            let now = segment.at(&position);
            let (shift, traction) = (state.shift, now.flux / chi);
            let point = State { position, velocity: now.velocity, shift, traction };
            self.push(point, position.zeta(), Regime::Adhesion);
        }
        state.shift += adhesion_shift(segment, reached, w);
    }

    fn retrace(&mut self, chi: f64, segment: &Segment, state: &State) {
        while let Some(target) = self.next(-1.0) {
            let loading = segment.at(&Position::of_velocity(-target));
            let position = Position::of_velocity(target);
            let point = State {
                position,
                velocity: -loading.velocity,
                shift: state.shift - adhesion_shift(segment, -target, 0.0),
                traction: loading.flux / chi,
            };
            self.push(point, position.zeta(), Regime::Adhesion);
        }
    }

    fn slip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &mut self,
        slip: &Slip<'_>,
        clock: Clock,
        stepper: &mut Stepper<2, F>,
    ) {
        let end = slip.at(clock, stepper.x(), stepper.y()).now.w;
        if self.targets.first().is_none_or(|&target| target < end) {
            return;
        }
        let dense = stepper.dense();
        while let Some(target) = self.next(end) {
            let velocity = |x: f64| slip.at(clock, x, &dense.at(x)).now.w;
            let x = reading(velocity, [dense.start(), dense.end()], target);
            self.push_slip(slip, &slip.at(clock, x, &dense.at(x)));
        }
    }

    fn onset(&mut self, slip: &Slip<'_>, opening: &Opening) {
        while let Some(target) = self.next(opening.velocity(opening.reach)) {
            let x = reading(|x| opening.velocity(x), [0.0, opening.reach], target);
            let Opened { stick, gap, excess } = opening.at(x);
            let y = [gap / slip.unit, excess / slip.unit];
            self.push_slip(slip, &slip.at(Clock::Memory, stick.tau, &y));
        }
    }

    // In slip e - e*(z*) = s (zeta - z*)/psi.
    fn shift(&self, slip: &Slip<'_>, pair: &Pair) -> f64 {
        let stretch = slip.stretch;
        let stored = match &stretch.shape {
            Shape::Adhesion(segment) => adhesion_shift(segment, segment.high, pair.stick.w),
            Shape::Slip(frozen) => {
                let inner = Position::at(stretch.inner);
                frozen.sign * (pair.stick.zeta() - inner.zeta()) / self.psi
            }
        };
        stretch.shift + stored + slip.sign * slip.load(pair).ring
    }

    fn separation(&mut self, state: &State, regime: Regime) {
        let remaining = std::mem::take(&mut self.targets).len();
        for _ in 0..remaining {
            self.push(*state, 0.0, regime);
        }
    }

    fn slide(&mut self, chi: f64, psi: f64, sign: f64, state: &mut State, w: f64) {
        let start = *state;
        let pull = sign * chi / psi;
        // e = int u dt with u = u0 + s chi (w - w0) and int w dt = zeta
        let at = |w: f64| {
            let position = Position::of_velocity(w);
            let drift = start.velocity - pull * start.position.w;
            let (duration, rise) =
                (time(w) - time(start.position.w), position.zeta() - start.position.zeta());
            State {
                position,
                velocity: start.velocity + pull * (w - start.position.w),
                shift: start.shift + drift * duration + pull * rise,
                traction: sign * position.cube() / psi,
            }
        };
        let regime = if sign > 0.0 { Regime::SlideForward } else { Regime::SlideBackward };
        while let Some(target) = self.next(w) {
            self.push(at(target), 0.0, regime);
        }
        state.shift = at(w).shift;
    }
}

// The clock value in a range at which the normal velocity is `w`: bisection.
fn reading(velocity: impl Fn(f64) -> f64, range: [f64; 2], w: f64) -> f64 {
    let [early, late] = bisect(range, 60, |x| velocity(x) > w);
    0.5 * (early + late)
}

// Shift in adhesion while the velocity falls from `from` to `to`: int u dt.
fn adhesion_shift(segment: &Segment, from: f64, to: f64) -> f64 {
    // dt = -2 a (1 + a)^2/omega d tau
    let slope = |tau: f64, _: &[f64; 1]| {
        let position = Position::at(tau);
        let more = 1.0 + position.radius;
        [-2.0 * position.radius * more * more / position.omega * segment.velocity(&position)]
    };
    integrate(Position::of_velocity(from).tau, Position::of_velocity(to).tau, slope)
}

fn integrate(from: f64, to: f64, slope: impl FnMut(f64, &[f64; 1]) -> [f64; 1]) -> f64 {
    if from == to {
        return 0.0;
    }
    let Ok(mut stepper) = Stepper::new(from, [0.0], to - from, TOLERANCE, slope) else {
        return f64::NAN;
    };
    while stepper.x() != to {
        if stepper.step(to).is_err() {
            break;
        }
    }
    stepper.y()[0]
}
