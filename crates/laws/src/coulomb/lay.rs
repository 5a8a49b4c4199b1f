//! What takes the place of a piece whose rings were dragged: a parabola, or several.

use super::CoulombMemory;
use super::drag::Step;
use super::join::Sizes;
use super::piece::{Knot, Piece};
use super::step::STRAIGHT;
use crate::memory::{Lateral, VertexStack};

/// How far a parabola may be off in a boundary layer, as a share of what a join may move.
const LAYER: f64 = 0.4;
/// Between which ratios of limits a piece may hide a boundary layer, and how near to its upper end
/// that is looked for.
const HIDES: f64 = 0.43;
const NEAR: f64 = 0.75;
/// How near to its upper end a piece is split.
const HIGHEST: f64 = 0.8;

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// The piece in whose place the old one above vertex i was dragged, or several.
    pub(super) fn lay(
        &mut self,
        i: usize,
        old: &Piece<V>,
        new: [V; 2],
        step: &Step<V>,
        (sizes, halvings): (&Sizes, u32),
    ) {
        let middle = step.drag(old.middle_depth(), old.middle());
        let bubble = middle.minus(new[0].plus(new[1]).times(0.5));
        let miss = sizes.miss(&old.high);
        let straight = sizes.exact.max(STRAIGHT * miss);
        let square = bubble.dot(bubble);
        let vertex = self.stack.get_mut(i);
        vertex.anchor = new[0];
        vertex.slope = if square <= straight * straight { V::default() } else { bubble };
        if halvings == 0 || self.stack.len() >= self.stack.capacity() {
            return;
        }
        let bulge = sizes.bulge(&old.high);
        let part = if square > bulge * bulge {
            // Where the angle seen from the tip is halved.
            let [low, high] = new.map(|anchor| step.shift.minus(anchor).length());
            (low / (low + high)).clamp(1.0 - HIGHEST, HIGHEST)
        } else if square > LAYER * LAYER * miss * miss {
            match layer(old, new, bubble, step, LAYER * miss) {
                Some(part) => part,
                None => return,
            }
        } else {
            return;
        };
        let at = old.cut(part);
        if !(at.depth > old.low.depth && at.depth < old.high.depth) {
            return; // too thin, or at the tip itself
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
        self.lay(i + 1, &above, [anchor, new[1]], step, (sizes, halvings - 1));
        self.lay(i, &below, [new[0], anchor], step, (sizes, halvings - 1));
    }
}

/// Where a dragged piece is to be split since its parabola, though flat, is off by more than allowed
/// near its upper end: rings of limits below the length of the step have turned, others have not.
#[inline]
fn layer<V: Lateral>(
    old: &Piece<V>,
    new: [V; 2],
    bubble: V,
    step: &Step<V>,
    allowed: f64,
) -> Option<f64> {
    let [low, high] = [old.low.depth, old.high.depth].map(|depth| step.zeta - depth);
    if high > HIDES * low {
        return None;
    }
    let [low, high] = [low, high].map(|limit| limit + step.length);
    let part = ((low - (low * high).sqrt()) / (low - high)).max(NEAR);
    let depth = old.depth_at(part);
    let on = new[0].plus(new[1].minus(new[0]).times(part));
    let on = on.plus(bubble.times(4.0 * part * (1.0 - part)));
    let off = step.drag(depth, old.at(part)).minus(on);
    (off.dot(off) > allowed * allowed).then_some(part)
}
