//! Two pieces of the curve in the place of one: where it costs next to nothing, or for want of room.

use super::drag::cross;
use super::energy::Notes;
use super::piece::{End, Knot, Piece, weights};
use crate::memory::{Lateral, VertexStack};

/// Lengths that count in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes {
    /// The largest stretch there has been.
    pub(super) extent: f64,
    /// How far a join may move the curve, over the approach at which it comes to light again or,
    /// where that is smaller, the extent.
    pub(super) miss: f64,
    /// The largest bubble over the same.
    pub(super) bulge: f64,
    /// What is no length at all.
    pub(super) exact: f64,
}

impl Sizes {
    /// By what the errors of a piece are measured: its own approach, since the contact may recede
    /// to it.
    #[inline]
    fn of<V>(&self, high: &End<V>) -> f64 {
        high.depth.min(self.extent)
    }

    #[inline]
    pub(super) fn miss<V>(&self, high: &End<V>) -> f64 {
        self.miss * self.of(high)
    }

    #[inline]
    pub(super) fn bulge<V>(&self, high: &End<V>) -> f64 {
        self.bulge * self.of(high)
    }
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

    /// The piece that takes the place of both.
    #[inline]
    fn one(&self, bubble: V) -> Piece<V> {
        Piece { low: self.below.low, high: self.above.high, bubble }
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

    /// The places whose moves count: the vertex taken out and both middles, each as its part of
    /// the one piece and its way off the chord.
    #[inline]
    fn places(&self) -> [(f64, V); 3] {
        let part = self.part();
        let [rise, _] = self.rises();
        let foot = self.below.low.anchor;
        let off = |part: f64, anchor: V| (part, anchor.minus(foot).minus(rise.times(part)));
        [
            off(part, self.below.high.anchor),
            off(0.5 * part, self.below.middle()),
            off(0.5 * (1.0 + part), self.above.middle()),
        ]
    }

    /// The square of how far the curve moves.
    #[inline]
    fn move_by(places: &[(f64, V); 3], bubble: V) -> f64 {
        let square = |(part, off): &(f64, V)| {
            let by = off.minus(bubble.times(4.0 * part * (1.0 - part)));
            by.dot(by)
        };
        places.iter().map(square).fold(0.0, f64::max)
    }

    /// Whether no bubble at all keeps the moves of the vertex and of a middle within a length.
    #[inline]
    fn is_hopeless(places: &[(f64, V); 3], miss: f64) -> bool {
        let weight = |part: f64| part * (1.0 - part);
        let [(part, off), rest @ ..] = places;
        let vertex = weight(*part);
        rest.iter().any(|(part, middle)| {
            let middle_weight = weight(*part);
            let gap = off.times(middle_weight).minus(middle.times(vertex));
            let allowed = (vertex + middle_weight) * miss;
            gap.dot(gap) > allowed * allowed
        })
    }

    /// The bubble of one piece in the place of both, if it may take it.
    #[inline]
    fn joint(&self, sizes: &Sizes) -> Option<V> {
        let places = self.places();
        if self.in_line(sizes.exact) {
            let off = places[0].1;
            return (off.dot(off) <= sizes.exact * sizes.exact).then(V::default);
        }
        let miss = sizes.miss(&self.above.high);
        if Self::is_hopeless(&places, miss) {
            return None;
        }
        let bubble = self.bubble();
        let bulge = sizes.bulge(&self.above.high);
        let holds =
            bubble.dot(bubble) <= bulge * bulge && Self::move_by(&places, bubble) <= miss * miss;
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
    notes: &mut impl Notes<V>,
) -> bool {
    let pair = Pair::at(stack, i, tip);
    let joint = pair.joint(sizes);
    if let Some(bubble) = joint {
        notes.joined([&pair.below, &pair.above], &pair.one(bubble), tip.anchor);
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
        let effect = Pair::move_by(&pair.places(), bubble).sqrt()
            * (pair.above.high.root - pair.below.low.root);
        if effect < best.0 {
            best = (effect, i, bubble);
        }
    }
    stack.get_mut(best.1 - 1).slope = best.2;
    stack.remove(best.1);
    stack.count_merge();
}
