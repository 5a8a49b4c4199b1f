//! How an error of W decreases in slip.
//!
//! A step does not increase the distance of two values of W of an annulus, so that no error grows.
//! Tractions that turn towards the step approach each other. An annulus reaches its limit r at an
//! angle theta from the step, and theta decreases with `tan(theta/2)`, `d theta ~ sin(theta)`. An
//! error of W normal to the traction, `r d theta`, is therefore proportional to `r sin(theta)`.
//! This is the stretch normal to the step, which does not change before the limit is reached.
//!
//! An error that is not small begins farther from the step, at `u = tan(theta/2)`. There the
//! remaining share is larger by at most `1 + (u^2 - t^2)(1 - q^2)/((1 + t^2)(1 + q^2 u^2))`, where
//! t belongs to W and q t to the end of the path l: `1 - q^2 <= 2 l/r`.

use super::drag::{Step, cross};
use super::piece::Piece;
use crate::memory::Lateral;

/// Largest angular error of a traction (rad) for which a decrease is claimed.
const MAX_TURN: f64 = 0.5;
/// A stretch normal to the step is round-off up to this multiple of the round-off of the shift.
const MAX_ACROSS_OF_ROUND_OFF: f64 = 1e6;

impl<V: Lateral> Step<V> {
    /// Sizes of the stretches normal to the step.
    #[inline(always)]
    pub(super) fn across(&self, anchors: [V; 3]) -> [f64; 3] {
        anchors.map(|anchor| cross(self.ahead, self.shift.minus(anchor)).abs())
    }

    /// What remains of the error of a piece whose annuli all slip. The arguments are the stretches
    /// normal to the step after slip, at the lower end, the middle and the upper end.
    #[inline(always)]
    pub(super) fn remaining_error(&self, piece: &Piece<V>, [new, new_there, _]: [f64; 3]) -> f64 {
        let error = piece.error;
        if error == 0.0 {
            return 0.0;
        }
        let [old, old_there, _] = self.across([piece.low.anchor, piece.middle(), piece.low.anchor]);
        let least = MAX_ACROSS_OF_ROUND_OFF * self.round_off_length;
        if old <= least || old_there <= least {
            let [end, there] =
                [(piece.low.depth, piece.low.anchor), (piece.middle_depth(), piece.middle())]
                    .map(|(depth, anchor)| self.remaining_error_in_line(depth, anchor, error));
            return if end > there { end } else { there };
        }
        // The larger of the remaining shares at both points.
        let (new, old, depth) = if new * old_there > new_there * old {
            (new, old, piece.low.depth)
        } else {
            (new_there, old_there, piece.middle_depth())
        };
        let inverse = 1.0 / self.least_limit(depth);
        let turn = error * inverse;
        if turn > MAX_TURN {
            return error;
        }
        let sine = (old * inverse).min(1.0);
        let square = sine * sine;
        // Upper bounds: of t, and of how much u exceeds it, over 1 + t^2.
        let tangent = sine * (0.5 + square * (0.125 + 0.375 * square));
        let more = 0.7 * turn;
        let farther = more * (2.0 * tangent + more * (1.0 + tangent * tangent));
        let by = new * (1.0 + farther * (2.0 * self.length * inverse).min(1.0));
        if by < old { error * (by / old) } else { error }
    }

    /// The smaller of the limits of an annulus before and after the step.
    #[inline]
    fn least_limit(&self, depth: f64) -> f64 {
        let limit = self.zeta - depth;
        if self.dz > 0.0 { limit - self.dz } else { limit }
    }

    /// What remains of the error of an annulus whose traction is parallel to the step: the angle
    /// decreases at least as the exponential of the path over the limit.
    #[cold]
    pub(super) fn remaining_error_in_line(&self, depth: f64, anchor: V, error: f64) -> f64 {
        let limit = self.zeta - depth;
        if self.dz > 0.0 && limit <= self.dz {
            return 0.0; // comes into contact during the step
        }
        if self.length == 0.0 || self.slope >= 1.0 {
            return error;
        }
        let along = self.shift.minus(anchor).dot(self.ahead);
        let rest = ((along - limit) / (1.0 - self.slope)).clamp(0.0, self.length);
        let met = limit - self.slope * rest;
        if along <= rest || error >= MAX_TURN * met {
            return error;
        }
        let path = rest / if met > limit { met } else { limit };
        let turn = error / met;
        let share = limit * (1.0 + turn * turn) / (met * (1.0 + path * (1.0 + 0.5 * path)));
        if share < 1.0 { error * share } else { error }
    }
}
