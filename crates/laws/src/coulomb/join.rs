//! Two pieces of the curve in the place of one, where it costs next to nothing.

use super::drag::cross;
use super::energy::Notes;
use super::piece::{End, Knot, Piece, weights};
use super::storage::Vertices;
use crate::memory::Lateral;

/// Lengths that count in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes {
    /// The largest stretch there has been.
    pub(super) extent: f64,
    /// How far a join may move the curve of the whole contact, over the approach at which it comes to
    /// light again or, where that is smaller, the extent.
    pub(super) miss: f64,
    /// The largest bubble of the whole contact over the same.
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

    /// How far a join may move the curve between two ends, and how large a bubble may be there: the
    /// more, the smaller the part of these rings in the force of the contact that they are the edge of,
    /// `1 - sqrt(low/high)`.
    #[inline]
    pub(super) fn allowed<V>(&self, low: &End<V>, high: &End<V>) -> [f64; 2] {
        let size = self.of(high);
        let inverse = high.root / (high.root - low.root);
        let at_most = |most: f64| if inverse < most { inverse } else { most };
        [self.miss * size * at_most(NARROWEST), self.bulge * size * at_most(NARROW)]
    }

    /// What is a straight line.
    #[inline]
    pub(super) fn straight<V>(&self, high: &End<V>) -> f64 {
        self.exact.max(STRAIGHT * self.miss * self.of(high))
    }
}

/// How much more a join may move what has a small part in the force than the whole contact, and how
/// much larger its bubble may be. What is drawn stays within the tolerance.
const NARROWEST: f64 = 10.0;
const NARROW: f64 = 2.5;
/// What is a straight line, as a share of what a join may move.
const STRAIGHT: f64 = 1e-6;
/// How far a parabola that vanishes at one end lies off at most, over its larger value at the middle
/// and the other end.
pub(super) const BETWEEN: f64 = 1.125;
/// The sine below which three anchors lie on a line.
const IN_LINE: f64 = 1e-9;

/// A place on two neighbouring pieces: its way off their common chord, and how far it would lie off
/// on one parabola, over its bubble.
pub(super) struct Place<V> {
    off: V,
    weight: f64,
}

/// The larger of two numbers that are ones.
#[inline]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Two neighbouring pieces of the curve.
pub(super) struct Pair<V> {
    pub(super) below: Piece<V>,
    pub(super) above: Piece<V>,
}

impl<V: Lateral> Pair<V> {
    #[inline(always)]
    pub(super) fn at<S: Vertices<V>>(stack: &S, i: usize, tip: End<V>) -> Self {
        let (below, here) = (Knot::of(stack.get(i - 1)), Knot::of(stack.get(i)));
        let end = if i + 1 < stack.len() { Knot::of(stack.get(i + 1)).end() } else { tip };
        Self { below: Piece::new(&below, here.end()), above: Piece::new(&here, end) }
    }

    /// The piece that takes the place of both.
    #[inline]
    pub(super) fn one(&self, bubble: V) -> Piece<V> {
        let error = larger(self.below.error, self.above.error);
        Piece { low: self.below.low, high: self.above.high, bubble, error }
    }

    /// The rises of both together and of the lower one.
    #[inline(always)]
    fn rises(&self) -> [V; 2] {
        let foot = self.below.low.anchor;
        [self.above.high.anchor.minus(foot), self.below.high.anchor.minus(foot)]
    }

    /// The share of the lower one in the depth.
    #[inline(always)]
    fn part(&self) -> f64 {
        let (low, high) = (self.below.low.depth, self.above.high.depth);
        (self.below.high.depth - low) / (high - low)
    }

    /// Whether both are straight and on one line, to and fro, as all are on a collinear path.
    #[inline(always)]
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
    pub(super) fn bubble(&self) -> V {
        let [chord, bubble] = weights(&self.below.low, &self.above.high);
        let [rise, _] = self.rises();
        rise.times(chord).minus(self.below.force()).minus(self.above.force()).times(1.0 / bubble)
    }

    /// The places whose moves count: the vertex taken out and both middles.
    #[inline(always)]
    pub(super) fn places(&self) -> [Place<V>; 3] {
        let part = self.part();
        let rest = 1.0 - part;
        let [rise, first] = self.rises();
        let off = first.minus(rise.times(part));
        let half = off.times(0.5);
        [
            Place { off, weight: 4.0 * part * rest },
            Place { off: half.plus(self.below.bubble), weight: part * (1.0 + rest) },
            Place { off: half.plus(self.above.bubble), weight: rest * (1.0 + part) },
        ]
    }

    /// The square of how far the curve moves.
    #[inline(always)]
    pub(super) fn move_by(places: &[Place<V>; 3], bubble: V) -> f64 {
        let [vertex, below, above] = places.each_ref().map(|place| {
            let by = place.off.minus(bubble.times(place.weight));
            by.dot(by)
        });
        larger(vertex, larger(below, above))
    }

    /// How far apart the vertex and a middle are from one parabola, times what is second.
    #[inline(always)]
    fn gap(vertex: &Place<V>, middle: &Place<V>) -> [f64; 2] {
        let gap = vertex.off.times(middle.weight).minus(middle.off.times(vertex.weight));
        let weight = vertex.weight + middle.weight;
        [gap.dot(gap), weight * weight]
    }

    /// The square of how far the vertex or a middle moves at least, whatever the bubble.
    #[inline]
    pub(super) fn least_move([vertex, below, above]: &[Place<V>; 3]) -> f64 {
        let [low, high] = [below, above].map(|middle| {
            let [gap, weight] = Self::gap(vertex, middle);
            gap / weight
        });
        larger(low, high)
    }

    /// Whether no bubble that is allowed keeps the moves within a length.
    #[inline(always)]
    fn is_hopeless([vertex, below, above]: &[Place<V>; 3], miss: f64, bulge: f64) -> bool {
        let reach = miss + vertex.weight * bulge;
        let square = miss * miss;
        vertex.off.dot(vertex.off) > reach * reach
            || [above, below].into_iter().any(|middle| {
                let [gap, weight] = Self::gap(vertex, middle);
                gap > square * weight
            })
    }

    /// The bubble of one piece in the place of both, if it may take it, and how far their anchors
    /// move at most.
    #[inline(always)]
    fn joint(&self, sizes: &Sizes) -> Option<(V, f64)> {
        let places = self.places();
        if self.in_line(sizes.exact) {
            let off = places[0].off;
            return (off.dot(off) <= sizes.exact * sizes.exact).then(|| (V::default(), 0.0));
        }
        let [miss, bulge] = sizes.allowed(&self.below.low, &self.above.high);
        if Self::is_hopeless(&places, miss, bulge) {
            return None;
        }
        let bubble = self.bubble();
        let square = Self::move_by(&places, bubble);
        let holds = bubble.dot(bubble) <= bulge * bulge && square <= miss * miss;
        holds.then(|| (bubble, BETWEEN * square.sqrt()))
    }
}

impl<V: Lateral> Pair<V> {
    /// One piece in the place of both, between which vertex i lies, that moves their anchors so far; returns it.
    #[inline]
    pub(super) fn replace<S: Vertices<V>>(
        &self,
        stack: &mut S,
        i: usize,
        (bubble, moved): (V, f64),
        shift: V,
        notes: &mut impl Notes<V>,
    ) -> Piece<V> {
        let one = self.one(bubble);
        notes.joined([&self.below, &self.above], &one, shift);
        stack.get_mut(i - 1).slope = bubble;
        stack.get_mut(i - 1).force_slope = V::from_components([one.error + moved, 0.0]);
        stack.remove(i);
        Piece { error: one.error + moved, ..one }
    }
}

/// Joins what may be joined of the pieces from that below vertex i on.
#[inline]
pub(super) fn join_from<V: Lateral, S: Vertices<V>>(
    stack: &mut S,
    mut i: usize,
    tip: End<V>,
    sizes: &Sizes,
    notes: &mut impl Notes<V>,
) {
    let mut here = Knot::of(stack.get(i));
    let mut below = Piece::new(&Knot::of(stack.get(i - 1)), here.end());
    loop {
        let next = (i + 1 < stack.len()).then(|| Knot::of(stack.get(i + 1)));
        let high = next.map_or(tip, |next| next.end());
        let pair = Pair { below, above: Piece::new(&here, high) };
        if let Some((bubble, moved)) = pair.joint(sizes) {
            below = pair.replace(stack, i, (bubble, moved), tip.anchor, notes);
        } else {
            below = pair.above;
            i += 1;
        }
        match next {
            Some(next) => here = next,
            None => return,
        }
    }
}
