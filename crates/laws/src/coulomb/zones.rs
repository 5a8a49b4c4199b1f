//! Zones of stick and slip within a piece that its ends and its middle do not show.
//!
//! The excess of a ring over its limit is a polynomial of fourth degree along a piece. Between two
//! rings that stick, one slips only where the piece bends: the limit is a convex cone. Between two
//! that slip, one may stick where the piece is steeper than the cone.

use super::drag::{BEYOND, Step};
use super::piece::{End, Piece};
use crate::memory::Lateral;

/// Steps from the middle of a half to its extreme, and what is no step.
const STEPS: u32 = 24;
const NEAR: f64 = 1e-6;
/// The halves of a piece.
const HALVES: [[f64; 2]; 2] = [[0.0, 0.5], [0.5, 1.0]];

impl<V: Lateral> Piece<V> {
    /// Whether the piece may bend out of the cone, if its lower end and its middle, which is in excess by
    /// so much, stick.
    #[inline(always)]
    pub(super) fn may_slip(&self, step: &Step<V>, excess: f64) -> bool {
        let square = self.bubble.dot(self.bubble);
        // The margin to the limit is concave on a chord, and a half piece leaves its chord by at most
        // part (1 - part) |bubble|.
        let limit = step.zeta - self.middle_depth();
        square > 0.0 && !(excess < 0.0 && excess * excess >= 4.0 * limit * limit * square)
    }

    /// Two parts of the piece, the first of which sticks and the second of which slips, if its
    /// lower end and its middle stick and it bends out of the cone between them, or above.
    #[cold]
    pub(super) fn look_for_slip(&self, step: &Step<V>) -> Option<[f64; 2]> {
        let rate = self.excess_rate(step);
        HALVES.into_iter().find_map(|[from, to]| {
            let part = rate.zero([from, to], 1.0)?;
            let beyond = step.is_beyond(self.depth_at(part), self.at(part));
            beyond.then_some([from, part])
        })
    }

    /// Half the derivative of the excess by the part.
    #[inline]
    fn excess_rate(&self, step: &Step<V>) -> Cubic {
        let length = self.high.depth - self.low.depth;
        let limit = step.zeta - self.low.depth;
        let stretch = step.shift.minus(self.low.anchor);
        let rate = self.rate(0.0);
        Cubic([
            limit * length - stretch.dot(rate),
            rate.dot(rate) - length * length + 8.0 * stretch.dot(self.bubble),
            -12.0 * rate.dot(self.bubble),
            32.0 * self.bubble.dot(self.bubble),
        ])
    }

    /// Whether a dragged piece whose ends and middle all stick, or all slip, may do the other between.
    #[inline(always)]
    pub(super) fn may_hide(&self, step: &Step<V>, slips: bool) -> bool {
        let stretch = step.shift.minus(self.middle());
        let limit = step.zeta - self.middle_depth();
        let middle = stretch.dot(stretch) - limit * limit;
        if !slips {
            return self.may_slip(step, middle);
        }
        let rise = self.high.anchor.minus(self.low.anchor);
        let length = self.high.depth - self.low.depth;
        let bubble = self.bubble;
        // A half bends by its steepness and its bubble: four times the sag of its excess below the chord.
        let turned = 3.0 * rise.dot(bubble).abs() + 6.0 * bubble.dot(bubble);
        let bent = 2.0 * stretch.dot(bubble).abs() + turned;
        let sag = 0.25 * (rise.dot(rise) - length * length) + bent;
        sag > middle && self.sags(step, sag, middle)
    }

    /// Whether the excess, its value at the middle given, may vanish by such a sag: between two places where it
    /// is a and b it does above `(sqrt(a) + sqrt(b))^2`.
    #[inline]
    fn sags(&self, step: &Step<V>, sag: f64, middle: f64) -> bool {
        let held = |end: End<V>| {
            let end = step.excess(end.depth, end.anchor);
            if end < middle { middle + 3.0 * end } else { end + 3.0 * middle }
        };
        sag > held(self.low) || sag > held(self.high)
    }

    /// The part of a dragged piece whose ends and middle all stick, or all slip, at which it does the
    /// other.
    #[cold]
    pub(super) fn hidden_zone(&self, step: &Step<V>, slips: bool) -> Option<f64> {
        if slips {
            self.look_for_stick(step)
        } else {
            self.look_for_slip(step).map(|[_, beyond]| beyond)
        }
    }

    fn look_for_stick(&self, step: &Step<V>) -> Option<f64> {
        let rate = self.excess_rate(step);
        HALVES.into_iter().find_map(|ends| {
            let part = rate.zero(ends, -1.0)?;
            let limit = step.zeta - self.depth_at(part);
            let excess = step.excess(self.depth_at(part), self.at(part));
            (excess < -BEYOND * step.grain * limit).then_some(part)
        })
    }
}

/// A polynomial of third degree, by its coefficients.
struct Cubic([f64; 4]);

impl Cubic {
    /// Its value and its derivative.
    #[inline]
    fn at(&self, x: f64) -> [f64; 2] {
        let [a, b, c, d] = self.0;
        [a + x * (b + x * (c + x * d)), b + x * (2.0 * c + x * (3.0 * d))]
    }

    /// Where it, times a sign, changes from above to below zero between two places: by Newton's steps, or
    /// halves.
    #[inline]
    fn zero(&self, [mut from, mut to]: [f64; 2], sign: f64) -> Option<f64> {
        if sign * self.at(from)[0] <= 0.0 || sign * self.at(to)[0] >= 0.0 {
            return None;
        }
        let mut x = 0.5 * (from + to);
        for _ in 0..STEPS {
            let [value, slope] = self.at(x);
            if sign * value > 0.0 {
                from = x
            } else {
                to = x
            }
            let next = x - value / slope;
            let before = x;
            x = if next > from && next < to { next } else { 0.5 * (from + to) };
            if (x - before).abs() < NEAR {
                break;
            }
        }
        Some(x)
    }
}
