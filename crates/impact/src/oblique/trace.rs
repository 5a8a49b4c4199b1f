//! The course of an oblique impact at chosen instants.

use carom_special::ode::{DenseStep, Stepper, Tolerance};

use super::adhesion::Segment;
use super::engine::{ObliqueImpact, PSI_MIN, State};
use super::groups::Groups;
use super::regime::{ObliqueError, Regime};
use super::slip::{Clock, Slip, Unknowns};
use crate::normal::{compression, time};

/// Stands for psi = 0 where a history is wanted: it differs from the limit by less than this.
const PSI_NO_SLIP: f64 = 1e-13;

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-14, relative: 1e-14 };

/// One instant of an oblique impact.
///
/// Units: compression by zeta_max, time by zeta_max/zeta'_A; the tangential velocity by its
/// initial value u_0, the shift by u_0 zeta_max/zeta'_A, the force by
/// (2/3) c_x zeta_max^(3/2) u_0/zeta'_A. They stay finite for any friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TracePoint {
    /// Time since touch.
    pub time: f64,
    /// Normal velocity w, from 1 to -1.
    pub normal_velocity: f64,
    /// Compression, 0 to 1.
    pub compression: f64,
    /// Tangential shift since touch.
    pub shift: f64,
    /// Tangential velocity.
    pub velocity: f64,
    /// Tangential force on body 1.
    pub force: f64,
    /// Tangential force over the friction limit f F_z, between -1 and 1; 0 before touch.
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
        let mut recorder = Trace { scale: groups.psi(), targets: w, points: Vec::new() };
        if groups.psi() >= PSI_MIN {
            Self::record(groups, &mut recorder)?;
            return Ok(recorder.points);
        }
        // Without slip: the limit psi -> 0, reached to rounding long before.
        recorder.scale = PSI_NO_SLIP;
        Self::record(Groups::new(groups.chi(), PSI_NO_SLIP).unwrap_or(groups), &mut recorder)?;
        for point in &mut recorder.points {
            (point.regime, point.friction_used) = (Regime::Adhesion, 0.0);
        }
        Ok(recorder.points)
    }
}

/// Watches the walk.
pub(super) trait Recorder {
    /// Adhesion moves from `state` to the velocity `w` on `segment`; keeps `state.shift` up to date.
    fn adhesion(&mut self, chi: f64, scale: f64, segment: &Segment, state: &mut State, w: f64);
    /// The whole release retraces the adhesive loading on `segment`, from maximal compression.
    fn retrace(&mut self, chi: f64, segment: &Segment, state: &State);
    /// An accepted step of partial slip.
    fn slip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &mut self,
        slip: &Slip<'_>,
        clock: Clock,
        walk: &mut Stepper<4, F>,
    );
    /// Separation in `state`.
    fn separation(&mut self, state: &State);
    /// Sliding from `state` to the velocity `w`; keeps `state.shift` up to date.
    fn slide(&mut self, chi: f64, scale: f64, sign: f64, state: &mut State, w: f64);
}

/// Records nothing.
pub(super) struct Silent;

impl Recorder for Silent {
    fn adhesion(&mut self, _: f64, _: f64, _: &Segment, _: &mut State, _: f64) {}
    fn retrace(&mut self, _: f64, _: &Segment, _: &State) {}
    fn slip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &mut self,
        _: &Slip<'_>,
        _: Clock,
        _: &mut Stepper<4, F>,
    ) {
    }
    fn separation(&mut self, _: &State) {}
    fn slide(&mut self, _: f64, _: f64, _: f64, _: &mut State, _: f64) {}
}

struct Trace<'a> {
    scale: f64,
    targets: &'a [f64],
    points: Vec<TracePoint>,
}

impl Trace<'_> {
    // The next target not below `w`; separation itself, which w does not resolve, comes last.
    fn next(&mut self, w: f64) -> Option<f64> {
        let (&first, rest) = self.targets.split_first()?;
        if first < w || first <= -1.0 {
            return None;
        }
        self.targets = rest;
        Some(first)
    }

    fn push(&mut self, state: State, stick_depth: f64, regime: Regime) {
        let limit = state.zeta * state.zeta.sqrt();
        let friction_used = match regime {
            Regime::SlideForward => 1.0,
            Regime::SlideBackward => -1.0,
            _ if limit > 0.0 => self.scale * state.traction / limit,
            _ => 0.0,
        };
        self.points.push(TracePoint {
            time: time(state.w),
            normal_velocity: state.w,
            compression: state.zeta,
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
        let mut reached = state.w;
        while let Some(target) = self.next(w) {
            state.shift += adhesion_shift(segment, reached, target);
            reached = target;
            let now = segment.at(target);
            let zeta = compression(target);
            let traction = zeta * zeta.sqrt() * now.gradient / chi;
            let shift = state.shift;
            let point = State { w: target, zeta, velocity: now.velocity, shift, traction };
            self.push(point, zeta, Regime::Adhesion);
        }
        state.shift += adhesion_shift(segment, reached, w);
    }

    fn retrace(&mut self, chi: f64, segment: &Segment, state: &State) {
        while let Some(target) = self.next(-1.0) {
            let loading = segment.at(-target);
            let zeta = compression(target);
            let point = State {
                w: target,
                zeta,
                velocity: -loading.velocity,
                shift: state.shift - adhesion_shift(segment, -target, 0.0),
                traction: zeta * zeta.sqrt() * loading.gradient / chi,
            };
            self.push(point, zeta, Regime::Adhesion);
        }
    }

    fn slip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &mut self,
        slip: &Slip<'_>,
        clock: Clock,
        walk: &mut Stepper<4, F>,
    ) {
        let end = slip.at_clock(clock, walk.x(), walk.y()).w;
        if self.targets.first().is_none_or(|&target| target < end) {
            return;
        }
        let dense = walk.dense();
        while let Some(target) = self.next(end) {
            let x = clock_reading(slip, clock, &dense, target);
            let y = dense.at(x);
            let now = slip.at_clock(clock, x, &y);
            let state = State {
                w: now.w,
                zeta: now.zeta,
                velocity: y[1],
                shift: y[3],
                traction: now.traction,
            };
            let regime = if slip.sign > 0.0 { Regime::SlipForward } else { Regime::SlipBackward };
            self.push(state, now.stick, regime);
        }
    }

    fn separation(&mut self, state: &State) {
        let regime = self.points.last().map_or(Regime::Adhesion, |last| last.regime);
        let remaining = std::mem::take(&mut self.targets).len();
        for _ in 0..remaining {
            self.push(*state, 0.0, regime);
        }
    }

    fn slide(&mut self, chi: f64, scale: f64, sign: f64, state: &mut State, w: f64) {
        let start = *state;
        let pull = sign * chi / scale;
        // e = int u dt with u = u0 + s chi (w - w0) and int w dt = zeta
        let at = |w: f64| {
            let zeta = compression(w);
            let drift = start.velocity - pull * start.w;
            State {
                w,
                zeta,
                velocity: start.velocity + pull * (w - start.w),
                shift: start.shift + drift * (time(w) - time(start.w)) + pull * (zeta - start.zeta),
                traction: sign * zeta * zeta.sqrt() / scale,
            }
        };
        let regime = if sign > 0.0 { Regime::SlideForward } else { Regime::SlideBackward };
        while let Some(target) = self.next(w) {
            self.push(at(target), 0.0, regime);
        }
        state.shift = at(w).shift;
    }
}

// The clock reading within a step at which the normal velocity is `w`: bisection on the dense output.
fn clock_reading(slip: &Slip<'_>, clock: Clock, dense: &DenseStep<4>, w: f64) -> f64 {
    let (mut early, mut late) = (dense.start(), dense.end());
    for _ in 0..60 {
        let middle = 0.5 * (early + late);
        if slip.at_clock(clock, middle, &dense.at(middle)).w > w {
            early = middle;
        } else {
            late = middle;
        }
    }
    0.5 * (early + late)
}

// Shift while adhering from velocity `from` down to `to`: int u dt, with sqrt(zeta) as variable
// near touch and w near maximal compression.
fn adhesion_shift(segment: &Segment, from: f64, to: f64) -> f64 {
    const SPLIT: f64 = 0.5;
    let by_velocity = |w: f64, _: &[f64; 1]| {
        let zeta = compression(w);
        [-0.8 * segment.at(w).velocity / (zeta * zeta.sqrt())]
    };
    let by_radius = |a: f64, _: &[f64; 1]| {
        let w = (1.0 - a.powi(5)).max(0.0).sqrt();
        [2.0 * a * segment.at(w).velocity / w]
    };
    let radius = |w: f64| compression(w).sqrt();
    if to >= SPLIT {
        integrate(radius(from), radius(to), by_radius)
    } else if from <= SPLIT {
        integrate(from, to, by_velocity)
    } else {
        integrate(radius(from), radius(SPLIT), by_radius) + integrate(SPLIT, to, by_velocity)
    }
}

fn integrate(from: f64, to: f64, slope: impl FnMut(f64, &[f64; 1]) -> [f64; 1]) -> f64 {
    if from == to {
        return 0.0;
    }
    let Ok(mut walk) = Stepper::new(from, [0.0], to - from, TOLERANCE, slope) else {
        return f64::NAN;
    };
    while walk.x() != to {
        if walk.step(to).is_err() {
            break;
        }
    }
    walk.y()[0]
}
