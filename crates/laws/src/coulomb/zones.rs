//! Zones of stick and slip within a piece that its ends and its middle do not show.
//!
//! The excess of a ring over its limit is a polynomial of fourth degree along a piece. Between two
//! rings that stick, one slips only where the piece bends: the limit is a convex cone. Between two
//! that slip, one may stick where the piece is steeper than the cone.

use super::drag::{BEYOND, Step};
use super::piece::Piece;
use crate::memory::Lateral;

/// Bisections of a half to its extreme.
const BISECTIONS: u32 = 24;

impl<V: Lateral> Piece<V> {
    /// Two parts of the piece, the first of which sticks and the second of which slips, if its
    /// lower end and its middle stick and it bends out of the cone between them, or above.
    #[inline]
    pub(super) fn hidden_slip(&self, step: &Step<V>) -> Option<[f64; 2]> {
        let square = self.bubble.dot(self.bubble);
        if square == 0.0 {
            return None;
        }
        // The margin to the limit is concave on a chord, and a half piece leaves its chord by at most
        // part (1 - part) |bubble|.
        let limit = step.zeta - self.middle_depth();
        let excess = step.excess(self.middle_depth(), self.middle());
        if excess < 0.0 && excess * excess >= 4.0 * limit * limit * square {
            return None;
        }
        self.look_for_slip(step)
    }

    #[cold]
    fn look_for_slip(&self, step: &Step<V>) -> Option<[f64; 2]> {
        [[0.0, 0.5], [0.5, 1.0]].into_iter().find_map(|[from, to]| {
            let part = self.extreme(step, [from, to], 1.0)?;
            let beyond = step.is_beyond(self.depth_at(part), self.at(part));
            beyond.then_some([from, part])
        })
    }

    /// Half the derivative of the excess by the part.
    #[inline]
    fn excess_rate(&self, step: &Step<V>, part: f64) -> f64 {
        let length = self.high.depth - self.low.depth;
        let limit = step.zeta - self.depth_at(part);
        limit * length - step.shift.minus(self.at(part)).dot(self.rate(part))
    }

    /// The part at which the excess times a sign has its largest value between two parts, if it has
    /// it within.
    fn extreme(&self, step: &Step<V>, [mut from, mut to]: [f64; 2], sign: f64) -> Option<f64> {
        let rate = |part: f64| sign * self.excess_rate(step, part);
        if rate(from) <= 0.0 || rate(to) >= 0.0 {
            return None;
        }
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (from + to);
            if rate(middle) > 0.0 { from = middle } else { to = middle }
        }
        Some(0.5 * (from + to))
    }

    /// The part of a dragged piece whose ends and middle all stick, or all slip, at which it does the
    /// other.
    #[inline]
    pub(super) fn hidden_zone(&self, step: &Step<V>, slips: bool) -> Option<f64> {
        let middle = self.middle();
        let square = self.bubble.dot(self.bubble);
        if !slips {
            return self.hidden_slip(step).map(|[_, beyond]| beyond);
        }
        // A half bends by its steepness and its bubble, a quarter of that is the sag of the excess.
        let rise = self.high.anchor.minus(self.low.anchor);
        let length = self.high.depth - self.low.depth;
        let bent = step.shift.minus(middle).dot(self.bubble).abs();
        let sag = 0.25 * (rise.dot(rise) - length * length) + 2.0 * (bent + square);
        if sag <= 0.0 {
            return None;
        }
        let least = step
            .excess(self.low.depth, self.low.anchor)
            .min(step.excess(self.high.depth, self.high.anchor))
            .min(step.excess(self.middle_depth(), middle));
        if sag <= 4.0 * least {
            return None;
        }
        self.look_for_stick(step)
    }

    #[cold]
    fn look_for_stick(&self, step: &Step<V>) -> Option<f64> {
        [[0.0, 0.5], [0.5, 1.0]].into_iter().find_map(|ends| {
            let part = self.extreme(step, ends, -1.0)?;
            let limit = step.zeta - self.depth_at(part);
            let excess = step.excess(self.depth_at(part), self.at(part));
            (excess < -BEYOND * step.grain * limit).then_some(part)
        })
    }
}
