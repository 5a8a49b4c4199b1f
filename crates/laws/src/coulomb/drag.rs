//! One ring on a straight step: its anchor is dragged, on a tractrix, from where the limit is met.

use crate::memory::Lateral;

/// A straight step of the rigid shift.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Step<V> {
    /// The approach at the end.
    pub(super) zeta: f64,
    /// The shift at the end.
    pub(super) shift: V,
    /// The growth of the approach.
    pub(super) dz: f64,
    pub(super) length: f64,
    /// The direction of the step; zero if there is none.
    pub(super) ahead: V,
    /// What is no length to round-off.
    pub(super) grain: f64,
    /// dz over the length, and one less its square.
    pub(super) slope: f64,
    curve: f64,
}

/// A step so steep that its direction does not matter to round-off.
const STEEP: f64 = 1e15;
/// What is no length to round-off, over approach and shift.
const GRAIN: f64 = 1e-15;
/// The square of the share of its limit from which a ring is at it, but for round-off.
const AT_LIMIT: f64 = 1.0 - 1e-14;
/// What is beyond the limit by round-off, over the grain.
pub(super) const BEYOND: f64 = 20.0;

impl<V: Lateral> Step<V> {
    #[inline]
    pub(crate) fn new(from: (f64, V), to: (f64, V)) -> Self {
        let (dz, dx) = (to.0 - from.0, to.1.minus(from.1));
        let length = dx.length();
        let grain = grain(to.0, to.1);
        if length == 0.0 || dz.abs() > STEEP * length {
            return Self { zeta: to.0, shift: to.1, dz, grain, ..Self::default() };
        }
        let slope = dz / length;
        Self {
            zeta: to.0,
            shift: to.1,
            dz,
            length,
            ahead: dx.times(1.0 / length),
            grain,
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

    /// The same at the start.
    pub(super) fn excess_before(&self, depth: f64, anchor: V) -> f64 {
        let stretch = self.shift.minus(self.ahead.times(self.length)).minus(anchor);
        let limit = self.zeta - self.dz - depth;
        stretch.dot(stretch) - limit * limit.abs()
    }

    /// Whether a ring is beyond its limit at the end by more than round-off, which must not decide
    /// where the shift returns to where it has been.
    #[inline]
    pub(super) fn is_beyond(&self, depth: f64, anchor: V) -> bool {
        self.counts(self.excess(depth, anchor), depth)
    }

    /// Whether an excess of the ring of a depth is more than round-off.
    #[inline]
    pub(super) fn counts(&self, excess: f64, depth: f64) -> bool {
        excess > 0.0 && excess > BEYOND * self.grain * (self.zeta - depth)
    }

    /// The anchor, at the end, of a ring that lies on the line behind the end.
    #[inline]
    pub(super) fn behind(&self, depth: f64) -> V {
        self.shift.minus(self.ahead.times(self.zeta - depth))
    }

    /// Whether a ring ends behind the end, to a length, since it is on one line with the step before
    /// and meets its limit ahead.
    #[inline]
    pub(super) fn is_in_line(&self, depth: f64, anchor: V, exact: f64) -> bool {
        let limit = self.zeta - depth;
        if self.dz > 0.0 && limit <= self.dz {
            return true; // it touches on the way
        }
        let stretch = self.shift.minus(anchor);
        let along = stretch.dot(self.ahead);
        let across = cross(self.ahead, stretch).abs();
        // The limit where it is met, times 1 - slope; from there on the traction turns on.
        let met = limit - self.slope * along;
        self.slope.abs() < 1.0
            && along > limit
            && across <= exact
            && across * limit * (1.0 - self.slope) <= exact * met
    }

    /// The anchor of the ring of a depth at the end of the step.
    ///
    /// A ring within its limit at both ends never slipped, since the limit is a convex cone. Else
    /// it leaves its limit once, and from there the traction's direction turns towards that of the
    /// step, `tan(theta/2)` falling as `exp(-int dl/r)`, r the limit (8.56).
    #[inline(always)]
    pub(crate) fn drag(&self, depth: f64, anchor: V) -> V {
        let [x, y] = anchor.components();
        let (x, y) = self.drag_parts(depth, x, y);
        V::from_components([x, y])
    }

    /// The same of the parts of an anchor, which stay in registers.
    #[inline(never)]
    fn drag_parts(&self, depth: f64, x: f64, y: f64) -> (f64, f64) {
        let anchor = V::from_components([x, y]);
        let limit = self.zeta - depth;
        let stretch = self.shift.minus(anchor);
        let square = stretch.dot(stretch);
        if square <= limit * limit {
            return (x, y);
        }
        let [x, y] = self.slipped((depth, anchor), stretch, square, limit).components();
        (x, y)
    }

    /// The same of a ring that is beyond its limit.
    #[inline(always)]
    fn slipped(&self, (depth, anchor): (f64, V), stretch: V, square: f64, limit: f64) -> V {
        if limit <= 0.0 {
            return self.shift;
        }
        if self.length == 0.0 {
            return self.shift.minus(stretch.times(limit / square.sqrt()));
        }
        let along = stretch.dot(self.ahead);
        let across = cross(self.ahead, stretch);
        let met = self.met(along, across, limit);
        if met.grazes {
            return self.drag_settled(depth, anchor);
        }
        self.turned(&met, limit)
    }

    /// The same of a ring that was drawn beyond its limit and would not have come within it: it
    /// settles on its limit before the step.
    #[cold]
    fn drag_settled(&self, depth: f64, anchor: V) -> V {
        let (limit, anchor) = (self.zeta - depth, self.settled(depth, anchor));
        let stretch = self.shift.minus(anchor);
        if stretch.dot(stretch) <= limit * limit {
            return anchor;
        }
        let met = self.met(stretch.dot(self.ahead), cross(self.ahead, stretch), limit);
        self.turned(&met, limit)
    }

    /// The anchor from which a ring is at its limit at the start.
    pub(super) fn settled(&self, depth: f64, anchor: V) -> V {
        let start = self.shift.minus(self.ahead.times(self.length));
        let stretch = start.minus(anchor);
        let limit = (self.zeta - self.dz - depth).max(0.0);
        start.minus(stretch.times((limit / stretch.length()).min(1.0)))
    }

    /// Where a ring meets its limit, from the stretch along and across the step that it would have
    /// at the end had it not slipped.
    #[inline(always)]
    pub(super) fn met(&self, along: f64, across: f64, limit: f64) -> Met {
        if self.dz > 0.0 && limit <= self.dz {
            // It touches on the way.
            return Met {
                rest: self.length * (limit / self.dz),
                at: 0.0,
                arm: 0.0,
                grazes: false,
                limit: 0.0,
                half: None,
            };
        }
        let (before, held) = (along - self.length, limit - self.dz);
        let square = before * before + across * across;
        if square >= AT_LIMIT * (held * held) {
            // At its limit from the start, but for what the curve was off, and on its way out.
            let arm = square.sqrt();
            if before < self.slope * arm {
                return self.met_late(along, across, limit);
            }
            let half = self.half(before, across, arm);
            return Met { rest: self.length, at: before, arm, limit: held, half, grazes: false };
        }
        // |stretch - rest| = limit - slope rest, from the end, where nothing cancels.
        let half = along - self.slope * limit;
        let excess = along * along + across * across - limit * limit;
        let root = (half * half - self.curve * excess).sqrt();
        let rest = if half > 0.0 { excess / (half + root) } else { (half - root) / self.curve };
        let met = limit - self.slope * rest;
        if !(rest > 0.0 && rest <= self.length && met > 0.0) {
            return self.met_late(along, across, limit);
        }
        let at = along - rest;
        Met { rest, at, arm: met, limit: met, half: self.half(at, across, met), grazes: false }
    }

    /// The same of a ring that was drawn beyond its limit, or hardly comes to be.
    #[cold]
    #[inline(never)]
    fn met_late(&self, along: f64, across: f64, limit: f64) -> Met {
        let half = along - self.slope * limit;
        let excess = along * along + across * across - limit * limit;
        let square = half * half - self.curve * excess;
        let root = square.max(0.0).sqrt();
        let rest = if half > 0.0 { excess / (half + root) } else { (half - root) / self.curve };
        // On the cone itself, where the step has no curve, nothing over nothing.
        let rest = if rest > 0.0 { rest } else { 0.0 };
        let grazes = square < 0.0 || rest == 0.0;
        let inside = rest <= self.length;
        let rest = rest.min(self.length);
        let (at, met) = (along - rest, limit - self.slope * rest);
        let arm = (at * at + across * across).sqrt();
        let grazes = grazes || (!inside && at < self.slope * arm);
        let half = if met > 0.0 { self.half(at, across, arm) } else { None };
        Met { rest, at, arm, limit: met, half, grazes }
    }

    /// The half angle from the step to the traction, see [`Met`].
    #[inline(always)]
    fn half(&self, at: f64, across: f64, arm: f64) -> Option<[f64; 2]> {
        let off = across.abs();
        // Against the step a ring would not stay, but in one direction.
        if off <= 1e-16 * arm || (at < 0.0 && off < self.grain) {
            return None;
        }
        Some(if at > 0.0 { [arm + at, across] } else { [across, arm - at] })
    }

    /// The anchor of a slipping ring at the end.
    #[inline(always)]
    fn turned(&self, met: &Met, limit: f64) -> V {
        let Some([near, far]) = met.half else {
            return self.shift.minus(self.ahead.times(limit.copysign(met.at)));
        };
        let [over, under] = decay(fall(met.rest, [met.limit, limit], self.slope));
        let (near, far) = (near * under, far * over);
        let scale = limit / (near * near + far * far);
        let (forward, aside) = ((near - far) * (near + far) * scale, 2.0 * near * far * scale);
        self.shift.minus(combine(self.ahead, forward, aside))
    }
}

/// A ring where it meets its limit.
pub(super) struct Met {
    /// The way from there to the end.
    pub(super) rest: f64,
    /// The stretch along the step.
    pub(super) at: f64,
    /// The stretch; beyond the limit if it was drawn so.
    pub(super) arm: f64,
    pub(super) limit: f64,
    /// Two numbers whose ratio, second to first, is `tan(theta/2)`, theta from the step to the
    /// traction; none if they are on one line.
    pub(super) half: Option<[f64; 2]>,
    /// Whether the ring was not within its limit before.
    pub(super) grazes: bool,
}

/// By how much the logarithm of `tan(theta/2)` falls on a way over which the limit grows by the
/// slope from one to another, `int dl/r`: the way over the logarithmic mean of both.
#[inline(always)]
pub(super) fn fall(way: f64, [from, to]: [f64; 2], slope: f64) -> f64 {
    if slope == 0.0 {
        return way / to;
    }
    // log(to/from) = 2 artanh(z), z = (to - from)/(to + from)
    let inverse = 1.0 / (from + to);
    let z = slope * way * inverse;
    if z.abs() > 0.12 {
        return libm::log1p(slope * way / from) / slope;
    }
    let w = z * z;
    let (u, v) = (w * w, w * w * (w * w));
    let low = 1.0 + w * (1.0 / 3.0) + u * (1.0 / 5.0 + w * (1.0 / 7.0));
    let high = 1.0 / 9.0 + w * (1.0 / 11.0) + u * (1.0 / 13.0 + w * (1.0 / 15.0));
    2.0 * way * inverse * (low + v * high)
}

/// `exp(-x)` of an x that is not negative, to some units in the last place, as two numbers to be
/// divided: by `2^-k` and Pade's fraction of what is left, at most half of ln 2.
#[inline(always)]
pub(super) fn decay(x: f64) -> [f64; 2] {
    /// Beyond, nothing is left, and its square would be no normal number.
    const FARTHEST: f64 = 60.0;
    const HIGH: f64 = 6.931_471_803_691_238e-1;
    const LOW: f64 = 1.908_214_929_270_587_7e-10;
    /// Its last place is one: what is added to it becomes whole.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    /// One.
    const HALVED: u64 = 1023 << 52;
    let x = if x < FARTHEST { x } else { FARTHEST };
    let whole = x * std::f64::consts::LOG2_E + WHOLE;
    let halvings = whole - WHOLE;
    let r = (x - halvings * HIGH) - halvings * LOW;
    let w = r * r;
    let even = 1.0 + w * (1.0 / 9.0 + w * (1.0 / 1008.0));
    let odd = r * (0.5 + w * (1.0 / 72.0 + w * (1.0 / 30240.0)));
    [(even - odd) * f64::from_bits(HALVED.wrapping_sub(whole.to_bits() << 52)), even + odd]
}

/// What is no length to round-off, at an approach and a shift.
#[inline]
pub(super) fn grain<V: Lateral>(zeta: f64, shift: V) -> f64 {
    let [x, y] = shift.components();
    GRAIN * (x.abs() + y.abs() + zeta)
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
