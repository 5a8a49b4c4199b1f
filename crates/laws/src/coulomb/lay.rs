//! What takes the place of a piece whose rings were dragged: a parabola, or several.

use super::CoulombMemory;
use super::drag::{Step, cross};
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
/// The square of a way over that of the middle's beyond which it grows unevenly.
const UNEVEN: f64 = 36.0;
/// How far a piece that winds may be off its parabola, over the angle by which its tractions turn times
/// the difference of their limits; and the bubble of one that does not.
const WINDING: f64 = 0.06;
const EXPECTED: f64 = 0.25;
/// How far a piece may be off at the rim, over the traction across the step at its middle.
const RIM: f64 = 0.1;
/// How far a piece that begins at the front may be off, over the growth of its bubble.
const AT_FRONT: f64 = 0.5;
/// How far a piece may be off over what is seen at one place.
const TWICE: f64 = 2.0;
/// Below which root of its lower end, over that of its upper, a flat parabola is not believed.
const WIDE: f64 = 0.8;
/// How near to its upper end a piece is split.
const HIGHEST: f64 = 0.8;

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// The piece in whose place the old one above vertex i was dragged, its ends and its middle, by
    /// ways of these squares; or several. So much is left of the error of the old one.
    pub(super) fn lay(
        &mut self,
        i: usize,
        (old, ways, left): (&Piece<V>, [f64; 3], f64),
        new: [V; 3],
        step: &Step<V>,
        (sizes, halvings): (&Sizes, u32),
    ) {
        let bubble = self.draw(i, new, sizes.straight(&old.high));
        let square = bubble.dot(bubble);
        let [miss, bulge] = sizes.allowed(&old.low, &old.high);
        let (mut split, mut missed) = kink(old, ways, step, miss);
        if split.is_none() && square > bulge * bulge {
            // Where the angle seen from the tip is halved.
            let [low, high] = [new[0], new[2]].map(|anchor| step.shift.minus(anchor).length());
            split = Some((low / (low + high)).clamp(1.0 - HIGHEST, HIGHEST));
        } else if split.is_none() {
            // The caller gives the lower end of such a piece the way of its middle.
            let drawn = Drawn { old, new, bubble, at_front: ways[0] == ways[1] };
            let (part, off) = drawn.hides(step, LAYER * miss);
            split = part;
            missed += TWICE * off;
        }
        if let Some(part) = split
            && self.split(i, (old, left), (part, new), step, (sizes, halvings))
        {
            return;
        }
        let error = left + missed + left_out(old, ways, bubble, step);
        self.stack.get_mut(i).force_slope = V::from_components([error, 0.0]);
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

    /// Lays two pieces in the place of one, if there is room.
    fn split(
        &mut self,
        i: usize,
        (old, left): (&Piece<V>, f64),
        (part, new): (f64, [V; 3]),
        step: &Step<V>,
        (sizes, halvings): (&Sizes, u32),
    ) -> bool {
        let at = old.cut(part);
        let thin = !(at.depth > old.low.depth && at.depth < old.high.depth);
        if thin || halvings == 0 || self.stack.len() >= self.stack.capacity() {
            return false;
        }
        let rest = 1.0 - part;
        let below = Piece { high: at, bubble: old.bubble.times(part * part), ..*old };
        let above = Piece { low: at, bubble: old.bubble.times(rest * rest), ..*old };
        let anchor = step.drag(at.depth, at.anchor);
        let knot = Knot {
            depth: at.depth,
            root: at.root,
            anchor,
            bubble: V::default(),
            force: V::default(),
            error: left,
        };
        self.stack.insert(i + 1, knot.vertex());
        let middle = |piece: &Piece<V>| step.drag(piece.middle_depth(), piece.middle());
        let [low, high] = [[new[0], middle(&below), anchor], [anchor, middle(&above), new[2]]];
        let halvings = halvings - 1;
        self.lay(i + 1, (&above, above.ways(high), left), high, step, (sizes, halvings));
        self.lay(i, (&below, below.ways(low), left), low, step, (sizes, halvings));
        true
    }
}

/// How far the dragged anchors may be off a parabola through three of them, all of which slip, given
/// the squares of their ways and of its bubble: of third order in the angle by which the tractions
/// differ, and in proportion to the way.
#[inline]
fn left_out<V: Lateral>(old: &Piece<V>, ways: [f64; 3], bubble: V, step: &Step<V>) -> f64 {
    let larger = |a: f64, b: f64| if a > b { a } else { b };
    let way = larger(ways[0], larger(ways[1], ways[2]));
    let limit = step.zeta - old.low.depth;
    let bent = larger(bubble.dot(bubble), old.bubble.dot(old.bubble)).sqrt() / limit;
    let way = way.sqrt();
    let smooth = bent * bent.sqrt() * if way < limit { way } else { limit };
    // The way grows to one end as no parabola does.
    let uneven = ways[2] > UNEVEN * ways[1] || ways[0] > UNEVEN * ways[1];
    if uneven { smooth + 2.0 * bubble.minus(old.bubble).length() } else { smooth }
}

/// Where a piece is to be split since a part of it sticks and a part slips, given the squares of the
/// ways of its ends and its middle, and how far it is off if it is not split: slip may lie below stick,
/// and in several zones.
#[inline]
fn kink<V: Lateral>(
    old: &Piece<V>,
    ways: [f64; 3],
    step: &Step<V>,
    miss: f64,
) -> (Option<f64>, f64) {
    let slips = ways.map(|way| way > 0.0);
    if slips[0] == slips[1] && slips[1] == slips[2] {
        let Some(part) = old.hidden_zone(step, slips[0]) else { return (None, 0.0) };
        let depth = old.depth_at(part);
        let off = 0.5 * step.excess(depth, old.at(part)).abs() / (step.zeta - depth);
        return ((off > miss).then_some(part), off);
    }
    kink_between(old, ways, step, miss)
}

#[cold]
fn kink_between<V: Lateral>(
    old: &Piece<V>,
    ways: [f64; 3],
    step: &Step<V>,
    miss: f64,
) -> (Option<f64>, f64) {
    let margin =
        |part: f64| step.zeta - old.depth_at(part) - step.shift.minus(old.at(part)).length();
    let mut largest = 0.0;
    for (stuck, slips) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
        if ways[stuck] > 0.0 || ways[slips] == 0.0 {
            continue;
        }
        // The kink lies where both vanish; the parabola leaves out about half its height.
        let [from, to] = [stuck, slips].map(|k| 0.5 * k as f64);
        let (way, margin) = (ways[slips].sqrt(), margin(from));
        let off = if margin > 0.0 { 0.5 * way * margin / (way + margin) } else { 0.0 };
        if off > miss {
            return (Some(old.front(step, from, to)), off);
        }
        largest = off.max(largest);
    }
    (None, largest)
}

/// The parabola in the place of a dragged piece, through its ends and its middle.
struct Drawn<'a, V> {
    old: &'a Piece<V>,
    new: [V; 3],
    bubble: V,
    /// Whether its lower end is the front, at its limit: from there the ways grow.
    at_front: bool,
}

impl<V: Lateral> Drawn<'_, V> {
    /// Where the piece is to be split since its parabola is off by more than allowed, and by how much it
    /// is seen to be, or may be if nothing was looked at.
    #[inline]
    fn hides(&self, step: &Step<V>, allowed: f64) -> (Option<f64>, f64) {
        let bent = self.bubble.dot(self.bubble) > allowed * allowed;
        let wide = self.old.low.root < WIDE * self.old.high.root;
        let rim = self.at_rim(step);
        let (mut seen, mut looked) = (rim, false);
        if (bent || wide || rim > allowed)
            && let Some((part, off)) = self.layer(step)
        {
            if off > allowed {
                return (Some(part), off);
            }
            (seen, looked) = (off, true);
        }
        if bent && self.old.low.root < LOW * self.old.high.root {
            let off = self.off(step, DEEP);
            if off > DEEP * allowed {
                return (Some(DEEP), off.max(seen));
            }
            (seen, looked) = (off.max(seen), true);
        }
        if looked {
            return (None, seen);
        }
        let mut hidden = self.winding(step);
        if self.at_front {
            hidden = hidden.max(AT_FRONT * self.bubble.minus(self.old.bubble).length());
        }
        if hidden > allowed {
            let off = self.off(step, NEAR);
            if off > allowed {
                return (Some(0.5), off);
            }
            return (None, off.max(seen));
        }
        (None, hidden + TWICE * seen)
    }

    /// How far the piece may wind to and fro about its parabola: its tractions turn by an angle, but its
    /// bubble is smaller than the angle and the limits at both ends let expect.
    #[inline]
    fn winding(&self, step: &Step<V>) -> f64 {
        let [low, high] = [self.new[0], self.new[2]].map(|anchor| step.shift.minus(anchor));
        let length = self.old.high.depth - self.old.low.depth;
        let (from, to) = (step.zeta - self.old.low.depth, step.zeta - self.old.high.depth);
        // The sine of the angle times the difference of the limits, times both limits.
        let turn = cross(low, high).abs() * length;
        let product = from * to;
        let expected = EXPECTED * turn;
        if self.bubble.dot(self.bubble) * (product * product) >= expected * expected {
            return 0.0;
        }
        let way = step.length.max(-step.dz);
        WINDING * turn * way / (product * (way + from))
    }

    /// How far the parabola may be off near the rim, where tractions turn within the step that have not
    /// at the middle.
    #[inline]
    fn at_rim(&self, step: &Step<V>) -> f64 {
        let [low, high] = [self.old.low.depth, self.old.high.depth].map(|depth| step.zeta - depth);
        if high > HIDES * low {
            return 0.0;
        }
        let across = cross(step.ahead, step.shift.minus(self.new[1])).abs();
        let (way, middle) = (step.length, 0.5 * (low + high));
        RIM * across * if way < middle { way / middle } else { 1.0 }
    }

    /// How far the parabola is off near its upper end, and where: rings of limits below the length of
    /// the step, or below what the contact receded, have turned, others have not.
    #[inline]
    fn layer(&self, step: &Step<V>) -> Option<(f64, f64)> {
        let [low, high] = [self.old.low.depth, self.old.high.depth].map(|depth| step.zeta - depth);
        if high > HIDES * low {
            return None;
        }
        let [low, high] = [low, high].map(|limit| limit + step.length.max(-step.dz));
        let part = ((low - (low * high).sqrt()) / (low - high)).max(NEAR);
        Some((part, self.off(step, part)))
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
