//! One ring on a straight step: its anchor is dragged, on a tractrix, from where the limit is met.

use crate::memory::Lateral;

/// A straight step of the rigid shift.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Step<V> {
    /// The approach at the end.
    pub(super) zeta: f64,
    /// The shift at the end.
    pub(super) shift: V,
    /// The growth of the approach.
    pub(super) dz: f64,
    pub(super) length: f64,
    /// The direction of the step; zero if there is none.
    pub(super) ahead: V,
    /// What is across by round-off only.
    grain: f64,
    /// dz over the length, and one less its square.
    pub(super) slope: f64,
    curve: f64,
}

/// A step so steep that its direction does not matter to round-off.
const STEEP: f64 = 1e15;
/// What is across by round-off, over approach and shift.
const GRAIN: f64 = 1e-15;

impl<V: Lateral> Step<V> {
    #[inline]
    pub(super) fn new(from: (f64, V), to: (f64, V)) -> Self {
        let (dz, dx) = (to.0 - from.0, to.1.minus(from.1));
        let length = dx.length();
        if length == 0.0 || dz.abs() > STEEP * length {
            return Self { zeta: to.0, shift: to.1, dz, ..Self::default() };
        }
        let slope = dz / length;
        let [x, y] = to.1.components();
        Self {
            zeta: to.0,
            shift: to.1,
            dz,
            length,
            ahead: dx.times(1.0 / length),
            grain: GRAIN * (x.abs() + y.abs() + to.0),
            slope,
            curve: (1.0 - slope) * (1.0 + slope),
        }
    }

    /// How far the ring of a depth and an anchor is beyond its limit at the end: positive if it
    /// was dragged. The square of its stretch less that of the limit.
    #[inline]
    pub(super) fn excess(&self, depth: f64, anchor: V) -> f64 {
        let stretch = self.shift.minus(anchor);
        let limit = self.zeta - depth;
        stretch.dot(stretch) - limit * limit
    }

    /// The anchor, at the end, of a ring that lies on the line behind the end.
    #[inline]
    pub(super) fn behind(&self, depth: f64) -> V {
        self.shift.minus(self.ahead.times(self.zeta - depth))
    }

    /// The anchor of the ring of a depth at the end of the step.
    ///
    /// A ring within its limit at both ends never slipped, since the limit is a convex cone. Else
    /// it leaves its limit once, and from there the traction's direction turns towards that of the
    /// step, `tan(theta/2)` falling as `exp(-int dl/r)`, r the limit (8.56).
    #[inline]
    pub(super) fn drag(&self, depth: f64, anchor: V) -> V {
        let limit = self.zeta - depth;
        let stretch = self.shift.minus(anchor);
        let square = stretch.dot(stretch);
        if square <= limit * limit {
            return anchor;
        }
        if limit <= 0.0 {
            return self.shift;
        }
        if self.length == 0.0 {
            return self.shift.minus(stretch.times(limit / square.sqrt()));
        }
        let along = stretch.dot(self.ahead);
        let across = cross(self.ahead, stretch);
        let [forward, aside] = self.turned(along, across, limit);
        self.shift.minus(combine(self.ahead, forward, aside))
    }

    /// Where a ring meets its limit, from the stretch along and across the step that it would have
    /// at the end had it not slipped.
    #[inline]
    pub(super) fn met(&self, along: f64, across: f64, limit: f64) -> Met {
        if self.dz > 0.0 && limit <= self.dz {
            // It touches on the way.
            return Met {
                rest: self.length * (limit / self.dz),
                at: 0.0,
                limit: 0.0,
                tangent: None,
            };
        }
        // |stretch - rest| = limit - slope rest, from the end, where nothing cancels.
        let half = along - self.slope * limit;
        let excess = along * along + across * across - limit * limit;
        let root = (half * half - self.curve * excess).max(0.0).sqrt();
        let rest = if half > 0.0 { excess / (half + root) } else { (half - root) / self.curve };
        // Not positive only where it is beyond its limit by round-off, on its way back.
        let rest = if rest > 0.0 { rest.min(self.length) } else { 0.0 };
        let (at, met) = (along - rest, limit - self.slope * rest);
        let arm = (at * at + across * across).sqrt();
        let on_line = if arm == 0.0 || met <= 0.0 {
            return Met { rest, at: 0.0, limit: met, tangent: None };
        } else if at < 0.0 {
            // Against the step a ring would not stay, but in one direction.
            across.abs() < self.grain.max(1e-16 * arm)
        } else {
            across.abs() < 1e-16 * arm
        };
        let tangent = if at > 0.0 { across / (arm + at) } else { (arm - at) / across };
        Met { rest, at, limit: met, tangent: (!on_line).then_some(tangent) }
    }

    /// The stretch of a slipping ring at the end, along and across the step.
    #[inline]
    fn turned(&self, along: f64, across: f64, limit: f64) -> [f64; 2] {
        let met = self.met(along, across, limit);
        let Some(tangent) = met.tangent else {
            return [if met.at < 0.0 { -limit } else { limit }, 0.0];
        };
        let tangent = tangent * libm::exp(-met.rest * pull(met.limit, limit));
        let scale = limit / (1.0 + tangent * tangent);
        [(1.0 - tangent) * (1.0 + tangent) * scale, 2.0 * tangent * scale]
    }
}

/// A ring where it meets its limit.
pub(super) struct Met {
    /// The way from there to the end.
    pub(super) rest: f64,
    /// The stretch along the step.
    pub(super) at: f64,
    pub(super) limit: f64,
    /// `tan(theta/2)`, theta from the step to the traction; none if they are on one line.
    pub(super) tangent: Option<f64>,
}

/// One over the logarithmic mean of the limits at both ends.
#[inline]
pub(super) fn pull(met: f64, limit: f64) -> f64 {
    let growth = (limit - met) / met;
    let part = if growth.abs() < 0.01 {
        // log(1 + g)/g, the next term is below 2e-15
        let g = growth;
        1.0 + g
            * (-1.0 / 2.0
                + g * (1.0 / 3.0
                    + g * (-1.0 / 4.0 + g * (1.0 / 5.0 + g * (-1.0 / 6.0 + g * (1.0 / 7.0))))))
    } else {
        libm::log1p(growth) / growth
    };
    part / met
}

/// `a x b`.
#[inline]
pub(super) fn cross<V: Lateral>(a: V, b: V) -> f64 {
    let ([a_x, a_y], [b_x, b_y]) = (a.components(), b.components());
    a_x * b_y - a_y * b_x
}

/// The vector of these parts along a unit vector and across it, counter-clockwise.
#[inline]
fn combine<V: Lateral>(ahead: V, forward: f64, aside: f64) -> V {
    let [x, y] = ahead.components();
    V::from_components([x * forward - y * aside, y * forward + x * aside])
}
