//! A piece of the curve W(s): a parabola on its chord.

use super::drag::Step;
use crate::memory::Lateral;

/// The lower end of a piece of the curve W(s).
///
/// The piece is `W = chord + 4 tau (1 - tau) bubble`, with tau from 0 to 1 over the depth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Node<V> {
    pub(crate) depth: f64,
    /// The square root of the depth.
    pub(super) root: f64,
    pub(super) anchor: V,
    /// Deviation of the middle of the piece above from its chord.
    pub(super) bubble: V,
    /// Force of the part of the contact deeper than this node.
    pub(super) force: V,
    /// Estimated error of W on the piece above.
    pub(super) error: f64,
}

/// The upper end of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<V> {
    pub(super) depth: f64,
    pub(super) root: f64,
    pub(super) anchor: V,
}

impl<V: Lateral> Node<V> {
    #[inline]
    pub(super) fn end(&self) -> End<V> {
        End { depth: self.depth, root: self.root, anchor: self.anchor }
    }
}

/// A piece between two ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece<V> {
    pub(super) low: End<V>,
    pub(super) high: End<V>,
    pub(super) bubble: V,
    /// Estimated error of W.
    pub(super) error: f64,
}

impl<V: Lateral> Piece<V> {
    #[inline]
    pub(super) fn new(node: &Node<V>, high: End<V>) -> Self {
        Self { low: node.end(), high, bubble: node.bubble, error: node.error }
    }

    /// Error of the force due to the error of W in a contact of this approach,
    /// `(3/2) int error dt`. Two tractions of an annulus differ by at most twice its limit.
    pub(super) fn force_error(&self, zeta: f64) -> f64 {
        let error = self.error.min(2.0 * (zeta - self.low.depth));
        1.5 * error * (self.high.root - self.low.root)
    }

    /// W at a fraction of the piece, from 0 at the lower end to 1 at the upper.
    #[inline]
    pub(super) fn at(&self, part: f64) -> V {
        let chord = self.high.anchor.minus(self.low.anchor).times(part);
        self.low.anchor.plus(chord).plus(self.bubble.times(4.0 * part * (1.0 - part)))
    }

    /// The derivative of W by this fraction.
    #[inline]
    pub(super) fn rate(&self, part: f64) -> V {
        self.high.anchor.minus(self.low.anchor).plus(self.bubble.times(4.0 - 8.0 * part))
    }

    #[inline]
    pub(super) fn middle(&self) -> V {
        self.low.anchor.plus(self.high.anchor).times(0.5).plus(self.bubble)
    }

    /// Squares of the distances of the lower end, the middle and the upper end to three other
    /// points.
    #[inline]
    pub(super) fn squared_moves(&self, new: [V; 3]) -> [f64; 3] {
        let squared_distance = |from: V, to: V| to.minus(from).dot(to.minus(from));
        [
            squared_distance(self.low.anchor, new[0]),
            squared_distance(self.middle(), new[1]),
            squared_distance(self.high.anchor, new[2]),
        ]
    }

    #[inline]
    pub(super) fn middle_depth(&self) -> f64 {
        0.5 * (self.low.depth + self.high.depth)
    }

    #[inline]
    pub(super) fn depth_at(&self, part: f64) -> f64 {
        self.low.depth + part * (self.high.depth - self.low.depth)
    }

    /// The point at a fraction of the piece, as an end.
    #[inline]
    pub(super) fn cut(&self, part: f64) -> End<V> {
        let depth = self.depth_at(part);
        End { depth, root: depth.sqrt(), anchor: self.at(part) }
    }

    /// The force of its annuli, `(3/2) int sqrt(s) dW`.
    #[inline]
    pub(super) fn force(&self) -> V {
        let [chord, bubble] = weights(&self.low, &self.high);
        let rise = self.high.anchor.minus(self.low.anchor);
        rise.times(chord).minus(self.bubble.times(bubble))
    }

    /// The slip front: the fraction at which the limit is reached, between a fraction `within` the
    /// limit and one `beyond` it.
    #[inline]
    pub(super) fn front(&self, step: &Step<V>, within: f64, beyond: f64) -> f64 {
        let (low, high) = (self.at(within), self.at(beyond));
        let stretch = step.shift.minus(high);
        let rise = high.minus(low);
        let length = (beyond - within) * (self.high.depth - self.low.depth);
        let limit = step.zeta - self.depth_at(beyond);
        // |stretch + t rise|^2 = (limit + t length)^2 on this part of the chord, t from its upper
        // end, so that nothing cancels near the edge.
        let curve = rise.dot(rise) - length * length;
        let slope = stretch.dot(rise) - limit * length;
        let excess = stretch.dot(stretch) - limit * limit;
        let root = (slope * slope - curve * excess).max(0.0).sqrt();
        let down = if slope <= 0.0 { excess / (root - slope) } else { (slope + root) / -curve };
        // Not a number only if all points coincide.
        let down = if down <= 1.0 { down.max(0.0) } else { 1.0 };
        let part = beyond - (beyond - within) * down;
        if self.bubble == V::default() {
            return part;
        }
        self.on_curve(step, part, within, beyond)
    }

    /// Newton's method from the front on the chord to that on the parabola.
    fn on_curve(&self, step: &Step<V>, mut part: f64, within: f64, beyond: f64) -> f64 {
        let length = self.high.depth - self.low.depth;
        for _ in 0..6 {
            let (depth, anchor) = (self.depth_at(part), self.at(part));
            let rise = step.shift.minus(anchor).dot(self.rate(part));
            let slope = 2.0 * ((step.zeta - depth) * length - rise);
            // The excess must grow from stick towards slip.
            if slope * (beyond - within) <= 0.0 {
                return part;
            }
            let next = part - step.excess(depth, anchor) / slope;
            let before = part;
            part = next.clamp(within.min(beyond), within.max(beyond));
            if (part - before).abs() < 1e-8 {
                break;
            }
        }
        part
    }
}

/// The force per rise of the chord and, with negative sign, per deviation of the middle.
#[inline]
pub(super) fn weights<V>(low: &End<V>, high: &End<V>) -> [f64; 2] {
    let (a, b) = (low.root, high.root);
    let sum = a + b;
    if sum == 0.0 {
        return [0.0; 2];
    }
    let inverse = 1.0 / sum;
    let product = a * b * inverse;
    [sum - product, 0.8 * (high.depth - low.depth) * inverse * (1.0 + product * inverse)]
}
