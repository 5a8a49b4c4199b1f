//! What takes the place of a piece whose rings were dragged: a parabola, or several.

use super::CoulombMemory;
use super::drag::Step;
use super::join::Sizes;
use super::piece::{Knot, Piece};
use crate::memory::{Lateral, VertexStack};

/// How far a parabola may be off in a boundary layer, as a share of what a join may move.
const LAYER: f64 = 0.8;
/// Between which ratios of limits a piece may hide a boundary layer, and how near to its upper end
/// that is looked for.
const HIDES: f64 = 0.43;
const NEAR: f64 = 0.75;
/// Where the lowest piece is looked at again: the contact may recede to there, and then what is off
/// counts for more.
const DEEP: f64 = 0.25;
/// Below which root of its lower end, over that of its upper, a piece is the lowest, or next to it.
const LOW: f64 = 0.25;
/// How often a piece may be halved in one step.
pub(super) const HALVINGS: u32 = 6;
/// Below which root of its lower end, over that of its upper, a flat parabola is not believed.
const WIDE: f64 = 0.8;
/// How near to its upper end a piece is split.
const HIGHEST: f64 = 0.8;

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// The piece in whose place the old one above vertex i was dragged, its ends and its middle, or
    /// several.
    pub(super) fn lay(
        &mut self,
        i: usize,
        old: &Piece<V>,
        new: [V; 3],
        step: &Step<V>,
        (sizes, halvings): (&Sizes, u32),
    ) {
        let bubble = self.draw(i, new, sizes.straight(&old.high));
        let square = bubble.dot(bubble);
        let [miss, bulge] = sizes.allowed(&old.low, &old.high);
        if square > bulge * bulge {
            // Where the angle seen from the tip is halved.
            let [low, high] = [new[0], new[2]].map(|anchor| step.shift.minus(anchor).length());
            let part = (low / (low + high)).clamp(1.0 - HIGHEST, HIGHEST);
            self.split(i, old, (part, new), step, (sizes, halvings));
            return;
        }
        let drawn = Drawn { old, new, bubble };
        if let Some(part) = drawn.hides(step, LAYER * miss) {
            self.split(i, old, (part, new), step, (sizes, halvings));
        }
    }

    /// Draws a parabola through three anchors above vertex i, or what is straight; its bubble.
    #[inline]
    fn draw(&mut self, i: usize, new: [V; 3], straight: f64) -> V {
        let bubble = new[1].minus(new[0].plus(new[2]).times(0.5));
        let is_straight = bubble.dot(bubble) <= straight * straight;
        let vertex = self.stack.get_mut(i);
        vertex.anchor = new[0];
        vertex.slope = if is_straight { V::default() } else { bubble };
        bubble
    }

    /// The same of a piece of which a part sticks, up to or from a part of its depth.
    #[cold]
    pub(super) fn lay_kinked(
        &mut self,
        i: usize,
        old: &Piece<V>,
        (part, new): (f64, [V; 3]),
        step: &Step<V>,
        sizes: &Sizes,
    ) {
        self.draw(i, new, sizes.straight(&old.high));
        self.split(i, old, (part, new), step, (sizes, HALVINGS));
    }

    /// Lays two pieces in the place of one, if there is room.
    fn split(
        &mut self,
        i: usize,
        old: &Piece<V>,
        (part, new): (f64, [V; 3]),
        step: &Step<V>,
        (sizes, halvings): (&Sizes, u32),
    ) {
        let at = old.cut(part);
        let thin = !(at.depth > old.low.depth && at.depth < old.high.depth);
        if thin || halvings == 0 || self.stack.len() >= self.stack.capacity() {
            return;
        }
        let rest = 1.0 - part;
        let below = Piece { low: old.low, high: at, bubble: old.bubble.times(part * part) };
        let above = Piece { low: at, high: old.high, bubble: old.bubble.times(rest * rest) };
        let anchor = step.drag(at.depth, at.anchor);
        let knot = Knot {
            depth: at.depth,
            root: at.root,
            anchor,
            bubble: V::default(),
            force: V::default(),
        };
        self.stack.insert(i + 1, knot.vertex());
        let middle = |piece: &Piece<V>| step.drag(piece.middle_depth(), piece.middle());
        let [low, high] = [[new[0], middle(&below), anchor], [anchor, middle(&above), new[2]]];
        self.lay(i + 1, &above, high, step, (sizes, halvings - 1));
        self.lay(i, &below, low, step, (sizes, halvings - 1));
    }
}

/// Where a piece is to be split since a part of it sticks and a part slips, given the squares of the
/// ways of its ends and its middle: slip may lie below stick, and in several zones.
#[inline]
pub(super) fn kink<V: Lateral>(
    old: &Piece<V>,
    ways: [f64; 3],
    step: &Step<V>,
    sizes: &Sizes,
) -> Option<f64> {
    let slips = ways.map(|way| way > 0.0);
    if slips[0] == slips[1] && slips[1] == slips[2] {
        return None;
    }
    kink_between(old, ways, step, sizes)
}

#[cold]
fn kink_between<V: Lateral>(
    old: &Piece<V>,
    ways: [f64; 3],
    step: &Step<V>,
    sizes: &Sizes,
) -> Option<f64> {
    let [miss, _] = sizes.allowed(&old.low, &old.high);
    let margin =
        |part: f64| step.zeta - old.depth_at(part) - step.shift.minus(old.at(part)).length();
    [(0, 1), (1, 0), (1, 2), (2, 1)].into_iter().find_map(|(stuck, slips)| {
        if ways[stuck] > 0.0 || ways[slips] == 0.0 {
            return None;
        }
        // The kink lies where both vanish; the parabola leaves out about half its height.
        let [from, to] = [stuck, slips].map(|k| 0.5 * k as f64);
        let (way, margin) = (ways[slips].sqrt(), margin(from));
        let counts = way * margin > 2.0 * miss * (way + margin);
        counts.then(|| old.front(step, from, to))
    })
}

/// The parabola in the place of a dragged piece, through its ends and its middle.
struct Drawn<'a, V> {
    old: &'a Piece<V>,
    new: [V; 3],
    bubble: V,
}

impl<V: Lateral> Drawn<'_, V> {
    /// Where the piece is to be split since its parabola, though flat, is off by more than allowed.
    #[inline]
    fn hides(&self, step: &Step<V>, allowed: f64) -> Option<f64> {
        let bent = self.bubble.dot(self.bubble) > allowed * allowed;
        let doubtful = bent || self.old.low.root < WIDE * self.old.high.root;
        if doubtful && let Some(part) = self.layer(step, allowed) {
            return Some(part);
        }
        let deep = bent && self.old.low.root < LOW * self.old.high.root;
        (deep && self.off(step, DEEP) > DEEP * allowed).then_some(DEEP)
    }

    /// The same near its upper end: rings of limits below the length of the step, or below what the
    /// contact receded, have turned, others have not.
    #[inline]
    fn layer(&self, step: &Step<V>, allowed: f64) -> Option<f64> {
        let [low, high] = [self.old.low.depth, self.old.high.depth].map(|depth| step.zeta - depth);
        if high > HIDES * low {
            return None;
        }
        let [low, high] = [low, high].map(|limit| limit + step.length.max(-step.dz));
        let part = ((low - (low * high).sqrt()) / (low - high)).max(NEAR);
        (self.off(step, part) > allowed).then_some(part)
    }

    /// How far the parabola is off at a part of the depth.
    #[inline]
    fn off(&self, step: &Step<V>, part: f64) -> f64 {
        let [low, _, high] = self.new;
        let on = low.plus(high.minus(low).times(part));
        let on = on.plus(self.bubble.times(4.0 * part * (1.0 - part)));
        step.drag(self.old.depth_at(part), self.old.at(part)).minus(on).length()
    }
}
