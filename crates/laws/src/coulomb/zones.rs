//! Zones of stick and slip within a piece that contain neither its ends nor its middle.
//!
//! The excess of an annulus over its limit is a polynomial of fourth degree along a piece. Between
//! two annuli that stick, one can slip only where the piece is curved, since the limit is a convex
//! cone. Between two that slip, one may stick where the piece is steeper than the cone.

use super::drag::{MAX_EXCESS_OF_ROUND_OFF, Step};
use super::piece::{End, Piece};
use crate::memory::Lateral;

/// Largest number of Newton steps to an extremum, and the change that counts as none.
const MAX_NEWTON_STEPS: u32 = 24;
const ZERO_CHANGE: f64 = 1e-6;
/// The halves of a piece.
const HALVES: [[f64; 2]; 2] = [[0.0, 0.5], [0.5, 1.0]];

impl<V: Lateral> Piece<V> {
    /// Whether a piece may leave the friction cone although its lower end and its middle stick.
    /// `excess` is that of the middle.
    #[inline(always)]
    pub(super) fn may_slip(&self, step: &Step<V>, excess: f64) -> bool {
        let square = self.bubble.dot(self.bubble);
        // The margin to the limit is concave on a chord, and a half piece deviates from its chord
        // by at most part (1 - part) |bubble|.
        let limit = step.zeta - self.middle_depth();
        square > 0.0 && !(excess < 0.0 && excess * excess >= 4.0 * limit * limit * square)
    }

    /// Whether all annuli of a piece are in contact at the end of a step and exceed their limit by no more than
    /// round-off.
    pub(super) fn sticks(&self, step: &Step<V>) -> bool {
        let middle = step.excess(self.middle_depth(), self.middle());
        let is_within = |end: End<V>| !step.is_beyond_limit(end.depth, end.anchor);
        self.high.depth <= step.zeta
            && is_within(self.low)
            && is_within(self.high)
            && !step.exceeds_round_off(middle, self.middle_depth())
            && !self.may_slip(step, middle)
    }

    /// Two fractions of a piece, of which the first sticks and the second slips, if the piece
    /// leaves the friction cone although its lower end and its middle stick.
    #[cold]
    pub(super) fn look_for_slip(&self, step: &Step<V>) -> Option<[f64; 2]> {
        let rate = self.excess_rate(step);
        HALVES.into_iter().find_map(|[from, to]| {
            let part = rate.zero([from, to], 1.0)?;
            let beyond = step.is_beyond_limit(self.depth_at(part), self.at(part));
            beyond.then_some([from, part])
        })
    }

    /// Half the derivative of the excess by the fraction.
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

    /// Whether a piece whose ends and middle all stick, or all slip, may do the opposite between.
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
        // The curvature of a half, by its slope and its deviation: four times the sag of its excess
        // below the chord.
        let turned = 3.0 * rise.dot(bubble).abs() + 6.0 * bubble.dot(bubble);
        let bent = 2.0 * stretch.dot(bubble).abs() + turned;
        let sag = 0.25 * (rise.dot(rise) - length * length) + bent;
        sag > middle && self.sags(step, sag, middle)
    }

    /// Whether the excess may vanish by such a sag, given its value at the middle. Between two
    /// points of excess a and b it does above `(sqrt(a) + sqrt(b))^2`.
    #[inline]
    fn sags(&self, step: &Step<V>, sag: f64, middle: f64) -> bool {
        let least_sag = |end: End<V>| {
            let end = step.excess(end.depth, end.anchor);
            if end < middle { middle + 3.0 * end } else { end + 3.0 * middle }
        };
        sag > least_sag(self.low) || sag > least_sag(self.high)
    }

    /// The fraction at which a piece whose ends and middle all stick, or all slip, does the
    /// opposite.
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
            (excess < -MAX_EXCESS_OF_ROUND_OFF * step.round_off_length * limit).then_some(part)
        })
    }
}

/// A polynomial of third degree, by its coefficients.
struct Cubic([f64; 4]);

impl Cubic {
    /// Value and derivative.
    #[inline]
    fn at(&self, x: f64) -> [f64; 2] {
        let [a, b, c, d] = self.0;
        [a + x * (b + x * (c + x * d)), b + x * (2.0 * c + x * (3.0 * d))]
    }

    /// Where the polynomial, times `sign`, changes from positive to negative between two points: by
    /// Newton's method, with bisection as fallback.
    #[inline]
    fn zero(&self, [mut from, mut to]: [f64; 2], sign: f64) -> Option<f64> {
        if sign * self.at(from)[0] <= 0.0 || sign * self.at(to)[0] >= 0.0 {
            return None;
        }
        let mut x = 0.5 * (from + to);
        for _ in 0..MAX_NEWTON_STEPS {
            let [value, slope] = self.at(x);
            if sign * value > 0.0 {
                from = x
            } else {
                to = x
            }
            let next = x - value / slope;
            let before = x;
            x = if next > from && next < to { next } else { 0.5 * (from + to) };
            if (x - before).abs() < ZERO_CHANGE {
                break;
            }
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Curved pieces between the depths 0 and 1, each with a step that ends at some approach and shift.
    fn drawn() -> impl Iterator<Item = (Piece<[f64; 2]>, Step<[f64; 2]>)> {
        let mut state = 3_u64;
        let mut unit = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        std::iter::repeat_with(move || {
            let mut vector = |size: f64| [size * unit(), size * unit()];
            let (anchor, top) = (vector(1.0), vector(1.5));
            let (low, bubble) = (End { depth: 0.0, root: 0.0, anchor }, vector(0.5));
            let high = End { depth: 1.0, root: 1.0, anchor: top };
            let shift = vector(1.5);
            let [more, _] = vector(0.5);
            let step = Step::new((1.0, anchor), (1.5 + more, shift));
            (Piece { low, high, bubble, error: 0.0 }, step)
        })
        .take(20_000)
    }

    fn excess(piece: &Piece<[f64; 2]>, step: &Step<[f64; 2]>, part: f64) -> f64 {
        step.excess(piece.depth_at(part), piece.at(part))
    }

    #[test]
    fn the_rate_of_the_excess_is_half_its_derivative() {
        let small = 1e-5;
        for (piece, step) in drawn().take(200) {
            for part in [0.1, 0.35, 0.5, 0.8] {
                let [low, high] =
                    [-small, small].map(|by| excess(&piece, &step, part + by) / (4.0 * small));
                let [rate, _] = piece.excess_rate(&step).at(part);
                assert!((rate - (high - low)).abs() < 1e-8, "{rate} {}", high - low);
            }
        }
    }

    /// Of pieces whose ends and middle are of one kind, those that hide the other kind are looked at.
    #[test]
    fn no_zone_hides_in_a_piece_that_is_passed_over() {
        let mut hidden = [0; 2];
        for (piece, step) in drawn() {
            let signs = [0.0, 0.5, 1.0].map(|part| excess(&piece, &step, part) > 0.0);
            let slips = signs[1];
            if signs != [slips; 3] {
                continue;
            }
            let mut between = (1..100).map(|i| excess(&piece, &step, 0.01 * f64::from(i)));
            if between.any(|excess| (excess > 0.0) != slips) {
                hidden[usize::from(slips)] += 1;
                assert!(piece.may_hide(&step, slips), "{piece:?} {step:?}");
            }
        }
        assert!(hidden.iter().all(|count| *count > 10), "{hidden:?}");
    }
}
