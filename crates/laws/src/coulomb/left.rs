//! What is left of the error of an anchor after its ring has slipped.
//!
//! A step does not expand the distance of two anchors of a ring, so that no error grows. Tractions that
//! turn towards the step come closer: a ring meets its limit r at an angle theta from the step, and that
//! turns as `tan(theta/2)` falls, `d theta ~ sin(theta)`. An anchor that is off across its traction by
//! `r d theta` is thus off in proportion to `r sin(theta)`, its stretch across the step, which until the
//! limit is met does not change.
//!
//! An error that is not small begins farther from the step, at `u = tan(theta/2)`. There the share is larger by
//! `1 + (u^2 - t^2)(1 - q^2)/((1 + t^2)(1 + q^2 u^2))` at most, where t is that of the anchor and q t that after
//! the way l: `1 - q^2 <= 2 l/r`.

use super::drag::{Step, cross};
use super::piece::Piece;
use crate::memory::Lateral;

/// The angle that a traction is off from which on nothing is said to be less.
const LARGEST_TURN: f64 = 0.5;
/// A stretch across the step that is none, over the round-off of the shift.
const ACROSS: f64 = 1e6;

impl<V: Lateral> Step<V> {
    /// The stretches of rings across the step.
    #[inline(always)]
    pub(super) fn across(&self, anchors: [V; 3]) -> [f64; 3] {
        anchors.map(|anchor| cross(self.ahead, self.shift.minus(anchor)).abs())
    }

    /// What is left of the error of a piece all of whose rings slip, from its lower end and its middle, to
    /// stretches across the step of these sizes.
    #[inline(always)]
    pub(super) fn left(&self, piece: &Piece<V>, [new, new_there, _]: [f64; 3]) -> f64 {
        let error = piece.error;
        if error == 0.0 {
            return 0.0;
        }
        let [old, old_there, _] = self.across([piece.low.anchor, piece.middle(), piece.low.anchor]);
        let least = ACROSS * self.grain;
        if old <= least || old_there <= least {
            let [end, there] =
                [(piece.low.depth, piece.low.anchor), (piece.middle_depth(), piece.middle())]
                    .map(|(depth, anchor)| self.left_in_line(depth, anchor, error));
            return if end > there { end } else { there };
        }
        // The larger of both shares.
        let (new, old, depth) = if new * old_there > new_there * old {
            (new, old, piece.low.depth)
        } else {
            (new_there, old_there, piece.middle_depth())
        };
        let inverse = 1.0 / self.least_limit(depth);
        let turn = error * inverse;
        if turn > LARGEST_TURN {
            return error;
        }
        let sine = (old * inverse).min(1.0);
        let square = sine * sine;
        // At least t, and by how much u may be above it over 1 + t^2.
        let tangent = sine * (0.5 + square * (0.125 + 0.375 * square));
        let more = 0.7 * turn;
        let farther = more * (2.0 * tangent + more * (1.0 + tangent * tangent));
        let by = new * (1.0 + farther * (2.0 * self.length * inverse).min(1.0));
        if by < old { error * (by / old) } else { error }
    }

    /// The smaller of the limits of a ring before and after.
    #[inline]
    fn least_limit(&self, depth: f64) -> f64 {
        let limit = self.zeta - depth;
        if self.dz > 0.0 { limit - self.dz } else { limit }
    }

    /// What is left of the error of a ring that is on one line with the step: the angle falls as the
    /// exponential of the way over the limit, at least.
    #[cold]
    pub(super) fn left_in_line(&self, depth: f64, anchor: V, error: f64) -> f64 {
        let limit = self.zeta - depth;
        if self.dz > 0.0 && limit <= self.dz {
            return 0.0; // it touches on the way
        }
        if self.length == 0.0 || self.slope >= 1.0 {
            return error;
        }
        let along = self.shift.minus(anchor).dot(self.ahead);
        let rest = ((along - limit) / (1.0 - self.slope)).clamp(0.0, self.length);
        let met = limit - self.slope * rest;
        if along <= rest || error >= LARGEST_TURN * met {
            return error;
        }
        let way = rest / if met > limit { met } else { limit };
        let turn = error / met;
        let share = limit * (1.0 + turn * turn) / (met * (1.0 + way * (1.0 + 0.5 * way)));
        if share < 1.0 { error * share } else { error }
    }
}
