//! Return mapping of one annulus in a straight step: W moves along a tractrix from the point at
//! which the limit is reached.

use crate::memory::Lateral;

/// A straight step of approach and shift.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Step<V> {
    /// Approach at the end of the step.
    pub(super) zeta: f64,
    /// Shift at the end of the step.
    pub(super) shift: V,
    /// Increment of the approach.
    pub(super) dz: f64,
    pub(super) length: f64,
    /// Unit vector of the shift increment; zero if there is none.
    pub(super) ahead: V,
    /// Lengths below this are round-off.
    pub(super) round_off_length: f64,
    /// `dz/length`, and `1 - slope^2`.
    pub(super) slope: f64,
    pub(super) curve: f64,
}

/// Above this ratio of |dz| to the shift increment, the direction of the increment is round-off.
const MAX_SLOPE: f64 = 1e15;
/// Round-off of a length, over the sum of approach and shift.
const ROUND_OFF_PER_SIZE: f64 = 1e-15;
/// An annulus counts as at its limit if the square of its stretch over its limit is at least this.
const MIN_SQUARED_STRETCH_AT_LIMIT: f64 = 1.0 - 1e-14;
/// An excess over the limit counts only above this multiple of the round-off length.
pub(super) const MAX_EXCESS_OF_ROUND_OFF: f64 = 20.0;

impl<V: Lateral> Step<V> {
    #[inline]
    pub(crate) fn new(from: (f64, V), to: (f64, V)) -> Self {
        let (dz, dx) = (to.0 - from.0, to.1.minus(from.1));
        let length = dx.length();
        let round_off_length = round_off_length(to.0, to.1);
        if length == 0.0 || dz.abs() > MAX_SLOPE * length {
            return Self { zeta: to.0, shift: to.1, dz, round_off_length, ..Self::default() };
        }
        let slope = dz / length;
        Self {
            zeta: to.0,
            shift: to.1,
            dz,
            length,
            ahead: dx.times(1.0 / length),
            round_off_length,
            slope,
            curve: (1.0 - slope) * (1.0 + slope),
        }
    }

    /// Excess of an annulus over its limit at the end of the step if it did not slip: the square of
    /// its stretch less the square of its limit. Positive if it slips.
    #[inline]
    pub(super) fn excess(&self, depth: f64, anchor: V) -> f64 {
        let stretch = self.shift.minus(anchor);
        let limit = self.zeta - depth;
        stretch.dot(stretch) - limit * limit
    }

    /// The same excess at the start of the step.
    pub(super) fn excess_before(&self, depth: f64, anchor: V) -> f64 {
        let stretch = self.shift.minus(self.ahead.times(self.length)).minus(anchor);
        let limit = self.zeta - self.dz - depth;
        stretch.dot(stretch) - limit * limit.abs()
    }

    /// Whether an annulus exceeds its limit at the end by more than round-off. Round-off must not
    /// decide when the shift returns to an earlier point.
    #[inline]
    pub(super) fn is_beyond_limit(&self, depth: f64, anchor: V) -> bool {
        self.exceeds_round_off(self.excess(depth, anchor), depth)
    }

    /// Whether the excess of the annulus of this depth is more than round-off.
    #[inline]
    pub(super) fn exceeds_round_off(&self, excess: f64, depth: f64) -> bool {
        excess > 0.0
            && excess > MAX_EXCESS_OF_ROUND_OFF * self.round_off_length * (self.zeta - depth)
    }

    /// W at the end of the step of an annulus on the straight line behind the tip.
    #[inline]
    pub(super) fn behind(&self, depth: f64) -> V {
        self.shift.minus(self.ahead.times(self.zeta - depth))
    }

    /// Whether an annulus ends on the straight line behind the tip, to the length `exact`: its
    /// traction is parallel to the step and reaches the limit.
    #[inline]
    pub(super) fn is_in_line(&self, depth: f64, anchor: V, exact: f64) -> bool {
        let limit = self.zeta - depth;
        if self.dz > 0.0 && limit <= self.dz {
            return true; // comes into contact during the step
        }
        let stretch = self.shift.minus(anchor);
        let along = stretch.dot(self.ahead);
        let across = cross(self.ahead, stretch).abs();
        // The limit where it is reached, times 1 - slope. From there on the traction turns further.
        let met = limit - self.slope * along;
        self.slope.abs() < 1.0
            && along > limit
            && across <= exact
            && across * limit * (1.0 - self.slope) <= exact * met
    }

    /// W at the end of the step of the annulus of a depth.
    ///
    /// An annulus within its limit at both ends did not slip, since the friction cone is convex.
    /// Otherwise it reaches its limit once. From there the direction of the traction turns towards
    /// that of the step: `tan(theta/2)` decreases as `exp(-int dl/r)`, r the limit (8.56).
    #[inline(always)]
    pub(crate) fn drag(&self, depth: f64, anchor: V) -> V {
        let [x, y] = anchor.components();
        let (x, y) = self.drag_parts(depth, x, y);
        V::from_components([x, y])
    }

    /// The same by components, which stay in registers.
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

    /// The same for an annulus beyond its limit.
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

    /// The same for an annulus whose W was inaccurate: it exceeded its limit before the step and
    /// would not come within it. It is first returned to its limit at the start.
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

    /// W returned radially to the limit at the start of the step.
    pub(super) fn settled(&self, depth: f64, anchor: V) -> V {
        let start = self.shift.minus(self.ahead.times(self.length));
        let stretch = start.minus(anchor);
        let limit = (self.zeta - self.dz - depth).max(0.0);
        start.minus(stretch.times((limit / stretch.length()).min(1.0)))
    }

    /// Where an annulus reaches its limit. `along` and `across` are the components of its stretch
    /// at the end, parallel and normal to the step, if it did not slip.
    #[inline(always)]
    pub(super) fn met(&self, along: f64, across: f64, limit: f64) -> LimitPoint {
        if self.dz > 0.0 && limit <= self.dz {
            // It comes into contact during the step.
            return LimitPoint {
                rest: self.length * (limit / self.dz),
                at: 0.0,
                arm: 0.0,
                grazes: false,
                limit: 0.0,
                half: None,
            };
        }
        let (before, limit_before) = (along - self.length, limit - self.dz);
        let square = before * before + across * across;
        if square >= MIN_SQUARED_STRETCH_AT_LIMIT * (limit_before * limit_before) {
            // At its limit from the start, except for the error of the curve, and the stretch
            // grows.
            let arm = square.sqrt();
            if before < self.slope * arm {
                return self.met_late(along, across, limit);
            }
            let half = self.half(before, across, arm);
            return LimitPoint {
                rest: self.length,
                at: before,
                arm,
                limit: limit_before,
                half,
                grazes: false,
            };
        }
        // |stretch - rest| = limit - slope rest, from the end of the step, where nothing cancels.
        let half = along - self.slope * limit;
        let excess = along * along + across * across - limit * limit;
        let root = (half * half - self.curve * excess).sqrt();
        let rest = if half > 0.0 { excess / (half + root) } else { (half - root) / self.curve };
        let met = limit - self.slope * rest;
        if !(rest > 0.0 && rest <= self.length && met > 0.0) {
            return self.met_late(along, across, limit);
        }
        let at = along - rest;
        LimitPoint {
            rest,
            at,
            arm: met,
            limit: met,
            half: self.half(at, across, met),
            grazes: false,
        }
    }

    /// The same for an annulus that was beyond its limit before, or barely reaches it.
    #[cold]
    #[inline(never)]
    fn met_late(&self, along: f64, across: f64, limit: f64) -> LimitPoint {
        let half = along - self.slope * limit;
        let excess = along * along + across * across - limit * limit;
        let square = half * half - self.curve * excess;
        let root = square.max(0.0).sqrt();
        let rest = if half > 0.0 { excess / (half + root) } else { (half - root) / self.curve };
        // 0/0 on the cone itself, where 1 - slope^2 vanishes.
        let rest = if rest > 0.0 { rest } else { 0.0 };
        let grazes = square < 0.0 || rest == 0.0;
        let inside = rest <= self.length;
        let rest = rest.min(self.length);
        let (at, met) = (along - rest, limit - self.slope * rest);
        let arm = (at * at + across * across).sqrt();
        let grazes = grazes || (!inside && at < self.slope * arm);
        // Below the root of the least number a stretch has no length, and no direction but that of the step.
        let half = if met > 0.0 && arm > 0.0 { self.half(at, across, arm) } else { None };
        LimitPoint { rest, at, arm, limit: met, half, grazes }
    }

    /// The half angle from the step to the traction, see `LimitPoint::half`.
    #[inline(always)]
    fn half(&self, at: f64, across: f64, arm: f64) -> Option<[f64; 2]> {
        let offset = across.abs();
        // A traction opposite to the step would not persist, except in one direction.
        if offset <= 1e-16 * arm || (at < 0.0 && offset < self.round_off_length) {
            return None;
        }
        Some(if at > 0.0 { [arm + at, across] } else { [across, arm - at] })
    }

    /// W of a slipping annulus at the end of the step.
    #[inline(always)]
    fn turned(&self, met: &LimitPoint, limit: f64) -> V {
        let Some([near, far]) = met.half else {
            return self.shift.minus(self.ahead.times(limit.copysign(met.at)));
        };
        let [over, under] =
            exp_of_negative(log_tangent_decrease(met.rest, [met.limit, limit], self.slope));
        let (near, far) = (near * under, far * over);
        let scale = limit / (near * near + far * far);
        let (forward, aside) = ((near - far) * (near + far) * scale, 2.0 * near * far * scale);
        self.shift.minus(combine(self.ahead, forward, aside))
    }
}

/// The point of a step at which an annulus reaches its limit.
pub(super) struct LimitPoint {
    /// Length of the step from there to its end.
    pub(super) rest: f64,
    /// Component of the stretch parallel to the step.
    pub(super) at: f64,
    /// Length of the stretch; above the limit if W was inaccurate.
    pub(super) arm: f64,
    pub(super) limit: f64,
    /// Two numbers with the ratio (second to first) `tan(theta/2)`, theta the angle from the step
    /// to the traction. None if they are parallel.
    pub(super) half: Option<[f64; 2]>,
    /// Whether the annulus was beyond its limit before the step and would not come within it.
    pub(super) grazes: bool,
}

/// Decrease of log `tan(theta/2)` in slip, `int dl/r`, while the limit r changes linearly between
/// two values: the length over their logarithmic mean.
#[inline(always)]
pub(super) fn log_tangent_decrease(length: f64, [from, to]: [f64; 2], slope: f64) -> f64 {
    if slope == 0.0 {
        return length / to;
    }
    // log(to/from) = 2 artanh(z), z = (to - from)/(to + from)
    let inverse = 1.0 / (from + to);
    let z = slope * length * inverse;
    if z.abs() > 0.12 {
        return libm::log1p(slope * length / from) / slope;
    }
    let w = z * z;
    let (u, v) = (w * w, w * w * (w * w));
    let low = 1.0 + w * (1.0 / 3.0) + u * (1.0 / 5.0 + w * (1.0 / 7.0));
    let high = 1.0 / 9.0 + w * (1.0 / 11.0) + u * (1.0 / 13.0 + w * (1.0 / 15.0));
    2.0 * length * inverse * (low + v * high)
}

/// `exp(-x)` for x >= 0, to some units in the last place, as a numerator and a denominator: `2^-k`
/// times the Pade approximant of the rest, which is at most half of ln 2.
#[inline(always)]
pub(super) fn exp_of_negative(x: f64) -> [f64; 2] {
    /// Largest argument: the result is then negligible, and its square still a normal number.
    const MAX_ARGUMENT: f64 = 60.0;
    const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
    const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
    /// 1.5 * 2^52: adding it rounds to a whole number.
    const ROUNDING_SHIFT: f64 = 6_755_399_441_055_744.0;
    /// The bits of 1.0.
    const BITS_OF_ONE: u64 = 1023 << 52;
    let x = if x < MAX_ARGUMENT { x } else { MAX_ARGUMENT };
    let shifted = x * std::f64::consts::LOG2_E + ROUNDING_SHIFT;
    let halvings = shifted - ROUNDING_SHIFT;
    let r = (x - halvings * LN_2_HIGH) - halvings * LN_2_LOW;
    let w = r * r;
    let even = 1.0 + w * (1.0 / 9.0 + w * (1.0 / 1008.0));
    let odd = r * (0.5 + w * (1.0 / 72.0 + w * (1.0 / 30240.0)));
    [(even - odd) * f64::from_bits(BITS_OF_ONE.wrapping_sub(shifted.to_bits() << 52)), even + odd]
}

/// The length below which an approach and a shift are round-off.
#[inline]
pub(super) fn round_off_length<V: Lateral>(zeta: f64, shift: V) -> f64 {
    let [x, y] = shift.components();
    ROUND_OFF_PER_SIZE * (x.abs() + y.abs() + zeta)
}

/// `a x b`.
#[inline]
pub(super) fn cross<V: Lateral>(a: V, b: V) -> f64 {
    let ([a_x, a_y], [b_x, b_y]) = (a.components(), b.components());
    a_x * b_y - a_y * b_x
}

/// The vector with these components along a unit vector and normal to it, counter-clockwise.
#[inline]
fn combine<V: Lateral>(ahead: V, forward: f64, aside: f64) -> V {
    let [x, y] = ahead.components();
    V::from_components([x * forward - y * aside, y * forward + x * aside])
}
