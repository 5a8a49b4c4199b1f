//! What takes the place of a piece whose rings were dragged: a parabola, or several.

use super::CoulombMemory;
use super::drag::{Step, cross};
use super::join::Sizes;
use super::piece::{Knot, Piece};
use super::storage::Vertices;
use crate::memory::Lateral;

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
/// Below which way of the tip beside the line of the tractions, over twice the largest limit, a layer at the
/// edge is thin.
const THIN: f64 = 0.06;
/// How far a piece may be off, over the growth of its bubble, where all its rings slip alike.
const OF_GROWTH: f64 = 0.2;
/// How far a piece is off its parabola, over its bubble, where it is looked at since it decays.
const DECAYS: f64 = 0.1;
/// How far a piece may be off over what is seen at one place.
const TWICE: f64 = 2.0;
/// Below which root of its lower end, over that of its upper, a flat parabola is not believed.
const WIDE: f64 = 0.8;
/// How near to its upper end a piece is split.
const HIGHEST: f64 = 0.8;

/// A piece whose rings were dragged: its ends and its middle.
#[derive(Clone, Copy)]
pub(super) struct Dragged<'a, V> {
    pub(super) old: &'a Piece<V>,
    pub(super) new: [V; 3],
    /// The squares of their ways.
    pub(super) ways: [f64; 3],
    /// Whether the lower end is the front, at its limit: from there the ways grow.
    pub(super) at_front: bool,
    /// Their stretches across the step.
    pub(super) across: [f64; 3],
    /// What is left of the error of the old piece.
    pub(super) left: f64,
}

impl<'a, V: Lateral> Dragged<'a, V> {
    /// A part of a piece.
    fn part_of(old: &'a Piece<V>, new: [V; 3], step: &Step<V>, left: f64) -> Self {
        let ways = old.ways(new);
        Self { old, new, ways, at_front: ways[0] == ways[1], across: step.across(new), left }
    }
}

impl<V: Lateral, S: Vertices<V>> CoulombMemory<V, S> {
    /// The piece in the place of one that was dragged, above vertex i; or several.
    #[inline(always)]
    pub(super) fn lay(
        &mut self,
        i: usize,
        dragged: &Dragged<'_, V>,
        step: &Step<V>,
        (sizes, halvings): (&Sizes, u32),
    ) {
        let Dragged { old, new, left, .. } = dragged;
        let bubble = self.draw(i, *new, sizes.straight(&old.high));
        let square = bubble.dot(bubble);
        let [miss, bulge] = sizes.allowed(&old.low, &old.high);
        let (mut split, mut missed) = dragged.kink(step, miss);
        if split.is_none() && square > bulge * bulge {
            // Where the angle seen from the tip is halved.
            let [low, high] = [new[0], new[2]].map(|anchor| step.shift.minus(anchor).length());
            split = Some((low / (low + high)).clamp(1.0 - HIGHEST, HIGHEST));
        } else if split.is_none() {
            let (part, off) = Drawn { dragged, bubble, square }.hides(step, LAYER * miss);
            split = part;
            missed += TWICE * off;
        }
        if let Some(part) = split
            && self.split(i, dragged, part, step, (sizes, halvings))
        {
            return;
        }
        let error = left + missed + dragged.left_out(bubble, step);
        self.stack.get_mut(i).force_slope = V::from_components([error, 0.0]);
    }

    /// The same of a part of one.
    #[inline(never)]
    fn lay_part(
        &mut self,
        i: usize,
        dragged: &Dragged<'_, V>,
        step: &Step<V>,
        sizes: (&Sizes, u32),
    ) {
        self.lay(i, dragged, step, sizes);
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
    #[inline(never)]
    fn split(
        &mut self,
        i: usize,
        &Dragged { old, new, left, .. }: &Dragged<'_, V>,
        part: f64,
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
        let sizes = (sizes, halvings - 1);
        self.lay_part(i + 1, &Dragged::part_of(&above, high, step, left), step, sizes);
        self.lay_part(i, &Dragged::part_of(&below, low, step, left), step, sizes);
        true
    }
}

impl<V: Lateral> Dragged<'_, V> {
    /// How far the stretch across the step is off its parabola at a quarter, over its bubble, where it decays
    /// from one end to the other as an exponential, by `s^2` in each half:
    /// `(1 - s)(3 + s)/(4 (1 + s)^2)`, and not more than this.
    #[inline(always)]
    fn decays(&self) -> f64 {
        let [low, middle, high] = self.across;
        let end = if low > high { low } else { high };
        if end > middle { 0.75 * (end - middle) / (end + 5.0 * middle) } else { 0.0 }
    }

    /// How far the dragged anchors may be off a parabola of this bubble through three of them, all of which
    /// slip: of third order in the angle by which the tractions differ, or as they decay, and in proportion
    /// to the way.
    #[inline(always)]
    fn left_out(&self, bubble: V, step: &Step<V>) -> f64 {
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let (old, ways) = (self.old, self.ways);
        let way = larger(ways[0], larger(ways[1], ways[2]));
        let limit = step.zeta - old.low.depth;
        let limit = limit * limit;
        let inverse = 1.0 / limit;
        let square = bubble.dot(bubble);
        let bent = larger(square, old.bubble.dot(old.bubble)) * inverse;
        let decays = self.decays();
        let share = larger(bent * bent.sqrt(), 4.0 * decays * decays * square * inverse);
        let smooth = share * if way < limit { way } else { limit };
        // Its bubble has grown, with what a parabola does not show: more where the way grows to one end.
        let grown = bubble.minus(old.bubble);
        let uneven = UNEVEN * ways[1];
        let unseen = match self.at_front {
            _ if ways[2] > uneven || ways[0] > uneven => 2.0,
            true => AT_FRONT,
            false => OF_GROWTH,
        };
        larger(smooth, unseen * unseen * grown.dot(grown)).sqrt()
    }

    /// Where the piece is to be split since a part of it sticks and a part slips, and how far it is off if
    /// it is not split: slip may lie below stick, and in several zones.
    #[inline(always)]
    fn kink(&self, step: &Step<V>, miss: f64) -> (Option<f64>, f64) {
        let slips = self.ways.map(|way| way > 0.0);
        if slips[0] != slips[1] || slips[1] != slips[2] {
            return self.kink_between(step, miss);
        }
        if self.old.may_hide(step, slips[0]) {
            return self.kink_hidden(step, miss, slips[0]);
        }
        (None, 0.0)
    }

    #[cold]
    fn kink_hidden(&self, step: &Step<V>, miss: f64, slips: bool) -> (Option<f64>, f64) {
        let old = self.old;
        let Some(part) = old.hidden_zone(step, slips) else { return (None, 0.0) };
        let depth = old.depth_at(part);
        let off = 0.5 * step.excess(depth, old.at(part)).abs() / (step.zeta - depth);
        ((off > miss).then_some(part), off)
    }

    #[cold]
    fn kink_between(&self, step: &Step<V>, miss: f64) -> (Option<f64>, f64) {
        let (old, ways) = (self.old, self.ways);
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
}

/// The parabola in the place of a dragged piece, through its ends and its middle.
struct Drawn<'a, V> {
    dragged: &'a Dragged<'a, V>,
    bubble: V,
    /// Its bubble times itself.
    square: f64,
}

impl<V: Lateral> Drawn<'_, V> {
    /// Where the piece is to be split since its parabola is off by more than allowed, and by how much it
    /// is seen to be, or may be if nothing was looked at.
    #[inline(always)]
    fn hides(&self, step: &Step<V>, allowed: f64) -> (Option<f64>, f64) {
        let old = self.dragged.old;
        let bent = self.square > allowed * allowed;
        let limits = [step.zeta - old.low.depth, step.zeta - old.high.depth];
        let (mut seen, mut looked) = (0.0, false);
        if limits[1] <= HIDES * limits[0] {
            seen = self.at_rim(step, limits);
            let wide = old.low.root < WIDE * old.high.root;
            if bent || wide || seen > allowed {
                let (part, off) = self.layer(step, limits);
                if off > allowed {
                    return (Some(part), off);
                }
                (seen, looked) = (off, true);
            }
            if limits[1] <= 0.0
                && let Some((part, off)) = self.at_tip(step, limits[0], allowed)
            {
                if off > allowed {
                    return (Some(part), off);
                }
                seen = off.max(seen);
            }
        }
        if bent && old.low.root < LOW * old.high.root {
            let off = self.off(step, DEEP);
            if off > DEEP * allowed {
                return (Some(DEEP), off.max(seen));
            }
            (seen, looked) = (off.max(seen), true);
        }
        if looked {
            return (None, seen);
        }
        let mut hidden = self.winding(step, limits);
        if self.dragged.at_front {
            hidden = hidden.max(AT_FRONT * self.bubble.minus(old.bubble).length());
        }
        let decays = self.dragged.decays();
        if decays > DECAYS && self.square * (decays * decays) > allowed * allowed {
            let [low, _, high] = self.dragged.across;
            let off = self.off(step, if low > high { 1.0 - NEAR } else { NEAR });
            if off > allowed {
                return (Some(0.5), off);
            }
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
    #[inline(always)]
    fn winding(&self, step: &Step<V>, [from, to]: [f64; 2]) -> f64 {
        let new = &self.dragged.new;
        let [low, high] = [new[0], new[2]].map(|anchor| step.shift.minus(anchor));
        // The sine of the angle times the difference of the limits, times both limits.
        let turn = cross(low, high).abs() * (from - to);
        let product = from * to;
        let expected = EXPECTED * turn;
        if self.square * (product * product) >= expected * expected {
            return 0.0;
        }
        let way = step.length.max(-step.dz);
        WINDING * turn * way / (product * (way + from))
    }

    /// How far the parabola may be off near the rim, where tractions turn within the step that have not
    /// at the middle.
    #[inline(always)]
    fn at_rim(&self, step: &Step<V>, [low, high]: [f64; 2]) -> f64 {
        let [_, across, _] = self.dragged.across;
        let (way, middle) = (step.length, 0.5 * (low + high));
        RIM * across * if way < middle { way / middle } else { 1.0 }
    }

    /// How far the parabola is off at the edge of the contact, and where: the tip lies beside the line of the
    /// tractions below, and only rings of limits about as small as that have turned to it.
    #[inline(always)]
    fn at_tip(&self, step: &Step<V>, limit: f64, allowed: f64) -> Option<(f64, f64)> {
        let Dragged { old, new, .. } = self.dragged;
        let [middle, high] = [new[1], old.high.anchor].map(|anchor| step.shift.minus(anchor));
        // Its way beside the line, times half the limit.
        let beside = cross(middle, high).abs();
        if beside <= 0.5 * allowed * limit || beside > THIN * limit * limit {
            return None;
        }
        let part = 1.0 - 4.0 * beside / (limit * limit);
        Some((part, self.off(step, part)))
    }

    /// How far the parabola is off near its upper end, and where: rings of limits below the length of
    /// the step, or below what the contact receded, have turned, others have not.
    #[inline(always)]
    fn layer(&self, step: &Step<V>, limits: [f64; 2]) -> (f64, f64) {
        let [low, high] = limits.map(|limit| limit + step.length.max(-step.dz));
        let part = ((low - (low * high).sqrt()) / (low - high)).max(NEAR);
        (part, self.off(step, part))
    }

    /// How far the parabola is off at a part of the depth.
    #[inline]
    fn off(&self, step: &Step<V>, part: f64) -> f64 {
        let Dragged { old, new: [low, _, high], .. } = *self.dragged;
        let on = low.plus(high.minus(low).times(part));
        let on = on.plus(self.bubble.times(4.0 * part * (1.0 - part)));
        step.drag(old.depth_at(part), old.at(part)).minus(on).length()
    }
}
