//! Two pieces of the curve in the place of one: where it costs next to nothing, or for want of room.

use super::drag::cross;
use super::piece::{End, Knot, Piece, weights};
use crate::memory::{Lateral, VertexStack};

/// Lengths that count in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes {
    /// How far a join may move the curve.
    pub(super) miss: f64,
    /// The largest bubble.
    pub(super) bulge: f64,
    /// What is no length at all.
    pub(super) exact: f64,
}

/// The sine below which three anchors lie on a line.
const IN_LINE: f64 = 1e-9;

/// Two neighbouring pieces of the curve.
struct Pair<V> {
    below: Piece<V>,
    above: Piece<V>,
}

impl<V: Lateral> Pair<V> {
    #[inline]
    fn at<S: VertexStack<V>>(stack: &S, i: usize, tip: End<V>) -> Self {
        let (below, here) = (Knot::of(stack.get(i - 1)), Knot::of(stack.get(i)));
        let end = if i + 1 < stack.len() { Knot::of(stack.get(i + 1)).end() } else { tip };
        Self { below: Piece::new(&below, here.end()), above: Piece::new(&here, end) }
    }

    /// The rises of both together and of the lower one.
    #[inline]
    fn rises(&self) -> [V; 2] {
        let foot = self.below.low.anchor;
        [self.above.high.anchor.minus(foot), self.below.high.anchor.minus(foot)]
    }

    /// The share of the lower one in the depth.
    #[inline]
    fn part(&self) -> f64 {
        let (low, high) = (self.below.low.depth, self.above.high.depth);
        (self.below.high.depth - low) / (high - low)
    }

    /// Whether both are straight and on one line, to and fro, as all are on a collinear path.
    #[inline]
    fn in_line(&self, exact: f64) -> bool {
        if self.below.bubble != V::default() || self.above.bubble != V::default() {
            return false;
        }
        let [rise, first] = self.rises();
        let (long, short) = (rise.dot(rise), first.dot(first));
        let area = cross(rise, first);
        let within = (IN_LINE * IN_LINE * short.min(long)).max(exact * exact);
        area * area <= within * long.max(short)
    }

    /// The bubble of the one piece that leaves the force as it is.
    #[inline]
    fn bubble(&self) -> V {
        let [chord, bubble] = weights(&self.below.low, &self.above.high);
        let [rise, _] = self.rises();
        rise.times(chord).minus(self.below.force()).minus(self.above.force()).times(1.0 / bubble)
    }

    /// The square of the way by which the curve moves at a part of the one piece.
    #[inline]
    fn move_at(&self, part: f64, anchor: V, bubble: V) -> f64 {
        let [rise, _] = self.rises();
        let on = rise.times(part).plus(bubble.times(4.0 * part * (1.0 - part)));
        let off = anchor.minus(self.below.low.anchor).minus(on);
        off.dot(off)
    }

    /// How far the curve moves, at the vertex taken out and at both middles.
    #[inline]
    fn miss(&self, bubble: V) -> f64 {
        let part = self.part();
        self.move_at(part, self.below.high.anchor, bubble)
            .max(self.move_at(0.5 * part, self.below.middle(), bubble))
            .max(self.move_at(0.5 * (1.0 + part), self.above.middle(), bubble))
            .sqrt()
    }

    /// The bubble of one piece in the place of both, if it may take it.
    #[inline]
    fn joint(&self, sizes: &Sizes) -> Option<V> {
        if self.in_line(sizes.exact) {
            let off = self.move_at(self.part(), self.below.high.anchor, V::default());
            return (off <= sizes.exact * sizes.exact).then(V::default);
        }
        let bubble = self.bubble();
        let holds =
            bubble.dot(bubble) <= sizes.bulge * sizes.bulge && self.miss(bubble) <= sizes.miss;
        holds.then_some(bubble)
    }
}

/// Joins the piece below vertex i and that above, if they may be.
#[inline]
pub(super) fn join<V: Lateral, S: VertexStack<V>>(
    stack: &mut S,
    i: usize,
    tip: End<V>,
    sizes: &Sizes,
) -> bool {
    let joint = Pair::at(stack, i, tip).joint(sizes);
    if let Some(bubble) = joint {
        stack.get_mut(i - 1).slope = bubble;
        stack.remove(i);
    }
    joint.is_some()
}

/// Makes room for some vertices: joins the pairs that may change a load to come least.
#[inline]
pub(super) fn make_room<V: Lateral, S: VertexStack<V>>(stack: &mut S, room: usize, tip: End<V>) {
    while room > stack.capacity() - stack.len() {
        join_least(stack, tip);
    }
}

#[cold]
fn join_least<V: Lateral, S: VertexStack<V>>(stack: &mut S, tip: End<V>) {
    let mut best = (f64::INFINITY, 1, V::default());
    for i in 1..stack.len() {
        let pair = Pair::at(stack, i, tip);
        let bubble = pair.bubble();
        let effect = pair.miss(bubble) * (pair.above.high.root - pair.below.low.root);
        if effect < best.0 {
            best = (effect, i, bubble);
        }
    }
    stack.get_mut(best.1 - 1).slope = best.2;
    stack.remove(best.1);
    stack.count_merge();
}
