//! Joins two pieces of the curve if one parabola is accurate enough.

use super::drag::cross;
use super::energy::StepObserver;
use super::piece::{End, Node, Piece, weights};
use crate::memory::{Lateral, Nodes};

/// The lengths that control splitting and joining in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct ControlLengths {
    /// Largest stretch of the centre since first contact.
    pub(super) extent: f64,
    /// Largest displacement of the curve by a join of pieces that reach from the centre to the edge,
    /// over the approach or, if it is smaller, over `extent`.
    pub(super) max_move: f64,
    /// Largest deviation from its chord of a parabola from the centre to the edge, over the same
    /// length.
    pub(super) max_bubble: f64,
    /// Lengths up to this count as zero.
    pub(super) exact: f64,
}

impl ControlLengths {
    /// The length that makes the errors of a piece relative: its own approach, to which the contact
    /// may recede, or `extent`.
    #[inline]
    fn of<V>(&self, high: &End<V>) -> f64 {
        high.depth.min(self.extent)
    }

    /// The allowed displacement of a join and the allowed deviation from the chord between two
    /// ends. Both are larger, the smaller the share `1 - sqrt(low/high)` of these annuli in the
    /// force of the contact of which they are the edge.
    #[inline]
    pub(super) fn allowed<V>(&self, low: &End<V>, high: &End<V>) -> [f64; 2] {
        let size = self.of(high);
        let inverse = high.root / (high.root - low.root);
        let at_most = |most: f64| if inverse < most { inverse } else { most };
        [
            self.max_move * size * at_most(MAX_MOVE_FACTOR),
            self.max_bubble * size * at_most(MAX_BUBBLE_FACTOR),
        ]
    }

    /// Deviations up to this count as a straight line.
    #[inline]
    pub(super) fn straight<V>(&self, high: &End<V>) -> f64 {
        self.exact.max(STRAIGHT_SHARE_OF_MOVE * self.max_move * self.of(high))
    }
}

/// Largest factors by which narrow pieces, with a small share in the force, may exceed `max_move`
/// and `max_bubble`. Fitted pieces stay within the tolerance.
const MAX_MOVE_FACTOR: f64 = 10.0;
const MAX_BUBBLE_FACTOR: f64 = 2.5;
/// Largest deviation of a straight line, as a share of the displacement allowed to a join.
const STRAIGHT_SHARE_OF_MOVE: f64 = 1e-6;
/// Largest deviation of a parabola that vanishes at one end, over the larger of its values at the
/// middle and the other end.
pub(super) const MAX_OVER_SAMPLED_MOVE: f64 = 1.125;
/// Three points of the curve are collinear below this sine.
const COLLINEAR_SINE: f64 = 1e-9;

/// A point of two neighbouring pieces: its distance from their common chord, and the distance of
/// one parabola there, over the deviation of its middle.
pub(super) struct Sample<V> {
    deviation: V,
    weight: f64,
}

/// The larger of two numbers, neither of which is NaN.
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
    pub(super) fn at<S: Nodes<Node<V>>>(stack: &S, i: usize, tip: End<V>) -> Self {
        let (below, here) = ((*stack.get(i - 1)), (*stack.get(i)));
        let end = if i + 1 < stack.len() { (*stack.get(i + 1)).end() } else { tip };
        Self { below: Piece::new(&below, here.end()), above: Piece::new(&here, end) }
    }

    /// The piece that replaces both.
    #[inline]
    pub(super) fn merged(&self, bubble: V) -> Piece<V> {
        let error = larger(self.below.error, self.above.error);
        Piece { low: self.below.low, high: self.above.high, bubble, error }
    }

    /// The rise of both together and that of the lower one.
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

    /// Whether both are straight and collinear, also if they reverse: true for all pieces of a path
    /// along a line.
    #[inline(always)]
    fn is_collinear(&self, exact: f64) -> bool {
        if self.below.bubble != V::default() || self.above.bubble != V::default() {
            return false;
        }
        let [rise, first] = self.rises();
        let (long, short) = (rise.dot(rise), first.dot(first));
        let area = cross(rise, first);
        let within = (COLLINEAR_SINE * COLLINEAR_SINE * short.min(long)).max(exact * exact);
        area * area <= within * long.max(short)
    }

    /// The deviation of the one piece that leaves the force unchanged.
    #[inline]
    pub(super) fn bubble(&self) -> V {
        let [chord, bubble] = weights(&self.below.low, &self.above.high);
        let [rise, _] = self.rises();
        rise.times(chord).minus(self.below.force()).minus(self.above.force()).times(1.0 / bubble)
    }

    /// The sampled points: the vertex to be removed and both middles.
    #[inline(always)]
    pub(super) fn samples(&self) -> [Sample<V>; 3] {
        let part = self.part();
        let rest = 1.0 - part;
        let [rise, first] = self.rises();
        let deviation = first.minus(rise.times(part));
        let half = deviation.times(0.5);
        [
            Sample { deviation, weight: 4.0 * part * rest },
            Sample { deviation: half.plus(self.below.bubble), weight: part * (1.0 + rest) },
            Sample { deviation: half.plus(self.above.bubble), weight: rest * (1.0 + part) },
        ]
    }

    /// The square of the displacement of the curve.
    #[inline(always)]
    pub(super) fn move_by(samples: &[Sample<V>; 3], bubble: V) -> f64 {
        let [vertex, below, above] = samples.each_ref().map(|sample| {
            let by = sample.deviation.minus(bubble.times(sample.weight));
            by.dot(by)
        });
        larger(vertex, larger(below, above))
    }

    /// The distance of the vertex and a middle from one common parabola: squares of numerator and
    /// denominator.
    #[inline(always)]
    fn gap(vertex: &Sample<V>, middle: &Sample<V>) -> [f64; 2] {
        let gap =
            vertex.deviation.times(middle.weight).minus(middle.deviation.times(vertex.weight));
        let weight = vertex.weight + middle.weight;
        [gap.dot(gap), weight * weight]
    }

    /// The square of the smallest possible displacement of the vertex and the middles, for any
    /// deviation.
    #[inline]
    pub(super) fn least_move([vertex, below, above]: &[Sample<V>; 3]) -> f64 {
        let [low, high] = [below, above].map(|middle| {
            let [gap, weight] = Self::gap(vertex, middle);
            gap / weight
        });
        larger(low, high)
    }

    /// Whether every allowed deviation moves the curve by more than `max_move`.
    #[inline(always)]
    fn cannot_join(
        [vertex, below, above]: &[Sample<V>; 3],
        max_move: f64,
        max_bubble: f64,
    ) -> bool {
        let reach = max_move + vertex.weight * max_bubble;
        let square = max_move * max_move;
        vertex.deviation.dot(vertex.deviation) > reach * reach
            || [above, below].into_iter().any(|middle| {
                let [gap, weight] = Self::gap(vertex, middle);
                gap > square * weight
            })
    }

    /// The deviation of the one piece and the largest displacement of the curve, if the join is
    /// allowed.
    #[inline(always)]
    fn join_bubble(&self, lengths: &ControlLengths) -> Option<(V, f64)> {
        let samples = self.samples();
        if self.is_collinear(lengths.exact) {
            let deviation = samples[0].deviation;
            return (deviation.dot(deviation) <= lengths.exact * lengths.exact)
                .then(|| (V::default(), 0.0));
        }
        let [max_move, max_bubble] = lengths.allowed(&self.below.low, &self.above.high);
        if Self::cannot_join(&samples, max_move, max_bubble) {
            return None;
        }
        let bubble = self.bubble();
        let square = Self::move_by(&samples, bubble);
        let holds = bubble.dot(bubble) <= max_bubble * max_bubble && square <= max_move * max_move;
        holds.then(|| (bubble, MAX_OVER_SAMPLED_MOVE * square.sqrt()))
    }
}

impl<V: Lateral> Pair<V> {
    /// Replaces both pieces, of which vertex `i` is the common end, by one with the deviation
    /// `bubble` that moves the curve by at most `moved`; returns it.
    #[inline]
    pub(super) fn replace<S: Nodes<Node<V>>>(
        &self,
        stack: &mut S,
        i: usize,
        (bubble, moved): (V, f64),
        shift: V,
        observer: &mut impl StepObserver<V>,
    ) -> Piece<V> {
        let merged = self.merged(bubble);
        observer.joined([&self.below, &self.above], &merged, shift);
        stack.get_mut(i - 1).bubble = bubble;
        stack.get_mut(i - 1).error = merged.error + moved;
        stack.remove(i);
        Piece { error: merged.error + moved, ..merged }
    }
}

/// Joins pieces where the tolerance allows, from the one below vertex `i` upwards.
#[inline]
pub(super) fn join_from<V: Lateral, S: Nodes<Node<V>>>(
    stack: &mut S,
    mut i: usize,
    tip: End<V>,
    lengths: &ControlLengths,
    observer: &mut impl StepObserver<V>,
) {
    let mut here = *stack.get(i);
    let mut below = Piece::new(stack.get(i - 1), here.end());
    loop {
        let next = (i + 1 < stack.len()).then(|| *stack.get(i + 1));
        let high = next.map_or(tip, |next| next.end());
        let pair = Pair { below, above: Piece::new(&here, high) };
        if let Some((bubble, moved)) = pair.join_bubble(lengths) {
            below = pair.replace(stack, i, (bubble, moved), tip.anchor, observer);
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
