//! Fits parabolas to a piece after its annuli have slipped.

use super::CoulombMemory;
use super::drag::{Step, cross};
use super::join::ControlLengths;
use super::piece::{Node, Piece};
use crate::memory::{Lateral, Nodes};

/// Largest error of a parabola in a boundary layer, as a share of the displacement allowed to a
/// join.
const MAX_LAYER_ERROR_OF_JOIN: f64 = 0.8;
/// Largest ratio of the friction limits at the upper and the lower end at which a piece may contain
/// a boundary layer.
const MAX_LIMIT_RATIO_OF_LAYER: f64 = 0.43;
/// Smallest fraction of a piece at which a boundary layer is sought.
const MIN_PART_OF_LAYER: f64 = 0.75;
/// Fraction of the innermost piece at which its error is checked again, and share of the allowed
/// error there. The contact may recede to this point, where an error counts for more.
const PART_CHECKED_AT_CENTRE: f64 = 0.25;
/// A piece is innermost, or next to it, if the root of the depth of its lower end is below this
/// share of that of its upper end.
const MAX_ROOT_RATIO_AT_CENTRE: f64 = 0.25;
/// How often a piece may be halved in one step.
pub(super) const MAX_HALVINGS: u32 = 6;
/// The slip at an end grows unevenly if its square exceeds this multiple of the square of the slip
/// at the middle.
const MIN_UNEVEN_RATIO_OF_SQUARED_MOVES: f64 = 36.0;
/// Largest error of an oscillating piece, over the angle by which its tractions turn times the
/// difference of their limits.
const OSCILLATION_PER_TURN: f64 = 0.06;
/// Deviation of the middle from the chord, in the same unit, from which on a piece does not
/// oscillate.
const BUBBLE_PER_TURN: f64 = 0.25;
/// Largest error at the edge of the contact, over the stretch normal to the step at the middle of
/// the piece.
const EDGE_ERROR_PER_STRETCH: f64 = 0.1;
/// Largest error of a piece that begins at the slip front, over the change of its deviation.
const FRONT_ERROR_PER_BUBBLE_CHANGE: f64 = 0.5;
/// Largest offset of the tip from the line of the tractions, over twice the largest limit, at which
/// a boundary layer at the edge is thin.
const MAX_TIP_OFFSET_OF_LAYER: f64 = 0.06;
/// Largest error of a piece whose annuli all slip, over the change of its deviation.
const ERROR_PER_BUBBLE_CHANGE: f64 = 0.2;
/// An exponential decay is checked if its error, over the deviation of the middle, is above this.
const MIN_DECAY_CHECKED: f64 = 0.1;
/// Factor from an error seen at one point to the largest error of the piece.
const LARGEST_OVER_SAMPLED_ERROR: f64 = 2.0;
/// A small deviation is trusted only if the root of the depth of the lower end is at least this
/// share of that of the upper end.
const MIN_ROOT_RATIO_OF_NARROW_PIECE: f64 = 0.8;
/// Largest fraction at which a piece is split.
const MAX_SPLIT_PART: f64 = 0.8;

/// A piece after the return mapping, by its ends and its middle.
#[derive(Clone, Copy)]
pub(super) struct Dragged<'a, V> {
    pub(super) old: &'a Piece<V>,
    pub(super) new: [V; 3],
    /// Squares of the displacements of lower end, middle and upper end.
    pub(super) squared_moves: [f64; 3],
    /// Whether the lower end is the slip front, just at its limit: the displacement grows from
    /// there.
    pub(super) at_front: bool,
    /// Sizes of their stretches normal to the step.
    pub(super) across: [f64; 3],
    /// What remains of the error of the old piece.
    pub(super) remaining_error: f64,
}

impl<'a, V: Lateral> Dragged<'a, V> {
    /// A part of a piece.
    fn part_of(old: &'a Piece<V>, new: [V; 3], step: &Step<V>, remaining_error: f64) -> Self {
        let squared_moves = old.squared_moves(new);
        Self {
            old,
            new,
            squared_moves,
            at_front: squared_moves[0] == squared_moves[1],
            across: step.across(new),
            remaining_error,
        }
    }
}

impl<V: Lateral, S: Nodes<Node<V>>> CoulombMemory<V, S> {
    /// Fits one parabola, or several, to a piece above vertex `i` after the return mapping.
    #[inline(always)]
    pub(super) fn fit(
        &mut self,
        i: usize,
        dragged: &Dragged<'_, V>,
        step: &Step<V>,
        (lengths, halvings): (&ControlLengths, u32),
    ) {
        let Dragged { old, new, remaining_error, .. } = dragged;
        let bubble = self.fit_parabola(i, *new, lengths.straight(&old.high));
        let square = bubble.dot(bubble);
        let [max_move, max_bubble] = lengths.allowed(&old.low, &old.high);
        let (mut split, mut missed) = dragged.kink(step, max_move);
        if split.is_none() && square > max_bubble * max_bubble {
            // The split halves the angle seen from the tip.
            let [low, high] = [new[0], new[2]].map(|anchor| step.shift.minus(anchor).length());
            split = Some((low / (low + high)).clamp(1.0 - MAX_SPLIT_PART, MAX_SPLIT_PART));
        } else if split.is_none() {
            let (part, deviation) = FittedParabola { dragged, bubble, square }
                .split_or_error(step, MAX_LAYER_ERROR_OF_JOIN * max_move);
            split = part;
            missed += LARGEST_OVER_SAMPLED_ERROR * deviation;
        }
        if let Some(part) = split
            && self.split(i, dragged, part, step, (lengths, halvings))
        {
            return;
        }
        let error = remaining_error + missed + dragged.fit_error(bubble, step);
        self.stack.get_mut(i).error = error;
    }

    /// The same for a part of a piece.
    #[inline(never)]
    fn fit_part(
        &mut self,
        i: usize,
        dragged: &Dragged<'_, V>,
        step: &Step<V>,
        lengths: (&ControlLengths, u32),
    ) {
        self.fit(i, dragged, step, lengths);
    }

    /// Fits a parabola, or a straight line, to three values of W above vertex `i`; returns the
    /// deviation of the middle.
    #[inline]
    fn fit_parabola(&mut self, i: usize, new: [V; 3], straight: f64) -> V {
        let bubble = new[1].minus(new[0].plus(new[2]).times(0.5));
        let is_straight = bubble.dot(bubble) <= straight * straight;
        let vertex = self.stack.get_mut(i);
        vertex.anchor = new[0];
        vertex.bubble = if is_straight { V::default() } else { bubble };
        bubble
    }

    /// Fits two pieces in place of one, if there is room.
    #[inline(never)]
    fn split(
        &mut self,
        i: usize,
        &Dragged { old, new, remaining_error, .. }: &Dragged<'_, V>,
        part: f64,
        step: &Step<V>,
        (lengths, halvings): (&ControlLengths, u32),
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
        let node = Node {
            depth: at.depth,
            root: at.root,
            anchor,
            bubble: V::default(),
            force: V::default(),
            error: remaining_error,
        };
        self.stack.insert(i + 1, node);
        let middle = |piece: &Piece<V>| step.drag(piece.middle_depth(), piece.middle());
        let [low, high] = [[new[0], middle(&below), anchor], [anchor, middle(&above), new[2]]];
        let lengths = (lengths, halvings - 1);
        self.fit_part(i + 1, &Dragged::part_of(&above, high, step, remaining_error), step, lengths);
        self.fit_part(i, &Dragged::part_of(&below, low, step, remaining_error), step, lengths);
        true
    }
}

impl<V: Lateral> Dragged<'_, V> {
    /// Error of a parabola at a quarter of the piece, over the deviation of its middle, if the
    /// stretch normal to the step decays exponentially along the piece, by the factor `s^2` in each
    /// half: `(1 - s)(3 + s)/(4 (1 + s)^2)`. This is an upper bound.
    #[inline(always)]
    fn decay_error(&self) -> f64 {
        let [low, middle, high] = self.across;
        let end = if low > high { low } else { high };
        if end > middle { 0.75 * (end - middle) / (end + 5.0 * middle) } else { 0.0 }
    }

    /// Estimated error of the parabola if all annuli slip: of third order in the angle between the
    /// tractions, or as they decay, and proportional to the slip.
    #[inline(always)]
    fn fit_error(&self, bubble: V, step: &Step<V>) -> f64 {
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let (old, squared_moves) = (self.old, self.squared_moves);
        let travel = larger(squared_moves[0], larger(squared_moves[1], squared_moves[2]));
        let limit = step.zeta - old.low.depth;
        let limit = limit * limit;
        let inverse = 1.0 / limit;
        let square = bubble.dot(bubble);
        let bent = larger(square, old.bubble.dot(old.bubble)) * inverse;
        let decay_error = self.decay_error();
        let share = larger(bent * bent.sqrt(), 4.0 * decay_error * decay_error * square * inverse);
        let smooth = share * if travel < limit { travel } else { limit };
        // The change of the deviation contains terms that a parabola does not show: more if the
        // slip grows towards one end.
        let grown = bubble.minus(old.bubble);
        let uneven = MIN_UNEVEN_RATIO_OF_SQUARED_MOVES * squared_moves[1];
        let unseen = match self.at_front {
            _ if squared_moves[2] > uneven || squared_moves[0] > uneven => 2.0,
            true => FRONT_ERROR_PER_BUBBLE_CHANGE,
            false => ERROR_PER_BUBBLE_CHANGE,
        };
        larger(smooth, unseen * unseen * grown.dot(grown)).sqrt()
    }

    /// Where to split a piece of which a part sticks and a part slips, and its error if it is not
    /// split. Slip may lie inside stick, and there may be several zones.
    #[inline(always)]
    fn kink(&self, step: &Step<V>, max_move: f64) -> (Option<f64>, f64) {
        let slips = self.squared_moves.map(|travel| travel > 0.0);
        if slips[0] != slips[1] || slips[1] != slips[2] {
            return self.kink_between(step, max_move);
        }
        if self.old.may_hide(step, slips[0]) {
            return self.kink_hidden(step, max_move, slips[0]);
        }
        (None, 0.0)
    }

    #[cold]
    fn kink_hidden(&self, step: &Step<V>, max_move: f64, slips: bool) -> (Option<f64>, f64) {
        let old = self.old;
        let Some(part) = old.hidden_zone(step, slips) else { return (None, 0.0) };
        let depth = old.depth_at(part);
        let deviation = 0.5 * step.excess(depth, old.at(part)).abs() / (step.zeta - depth);
        ((deviation > max_move).then_some(part), deviation)
    }

    #[cold]
    fn kink_between(&self, step: &Step<V>, max_move: f64) -> (Option<f64>, f64) {
        let (old, squared_moves) = (self.old, self.squared_moves);
        let margin =
            |part: f64| step.zeta - old.depth_at(part) - step.shift.minus(old.at(part)).length();
        let mut largest = 0.0;
        for (stuck, slips) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
            if squared_moves[stuck] > 0.0 || squared_moves[slips] == 0.0 {
                continue;
            }
            // The kink is where both vanish. The parabola misses about half its height.
            let [from, to] = [stuck, slips].map(|k| 0.5 * k as f64);
            let (travel, margin) = (squared_moves[slips].sqrt(), margin(from));
            let deviation =
                if margin > 0.0 { 0.5 * travel * margin / (travel + margin) } else { 0.0 };
            if deviation > max_move {
                return (Some(old.front(step, from, to)), deviation);
            }
            largest = deviation.max(largest);
        }
        (None, largest)
    }
}

/// The parabola through the ends and the middle of a piece after the return mapping.
struct FittedParabola<'a, V> {
    dragged: &'a Dragged<'a, V>,
    bubble: V,
    /// Square of the deviation of the middle.
    square: f64,
}

impl<V: Lateral> FittedParabola<'_, V> {
    /// Where to split the piece if the error of its parabola exceeds the allowed one, and the
    /// error: as seen at sampled points, or as estimated if none was sampled.
    #[inline(always)]
    fn split_or_error(&self, step: &Step<V>, allowed: f64) -> (Option<f64>, f64) {
        let old = self.dragged.old;
        let bent = self.square > allowed * allowed;
        let limits = [step.zeta - old.low.depth, step.zeta - old.high.depth];
        let (mut seen_error, mut sampled) = (0.0, false);
        if limits[1] <= MAX_LIMIT_RATIO_OF_LAYER * limits[0] {
            seen_error = self.edge_error(step, limits);
            let wide = old.low.root < MIN_ROOT_RATIO_OF_NARROW_PIECE * old.high.root;
            if bent || wide || seen_error > allowed {
                let (part, deviation) = self.boundary_layer(step, limits);
                if deviation > allowed {
                    return (Some(part), deviation);
                }
                (seen_error, sampled) = (deviation, true);
            }
            if limits[1] <= 0.0
                && let Some((part, deviation)) = self.tip_layer(step, limits[0], allowed)
            {
                if deviation > allowed {
                    return (Some(part), deviation);
                }
                seen_error = deviation.max(seen_error);
            }
        }
        if bent && old.low.root < MAX_ROOT_RATIO_AT_CENTRE * old.high.root {
            let deviation = self.deviation(step, PART_CHECKED_AT_CENTRE);
            if deviation > PART_CHECKED_AT_CENTRE * allowed {
                return (Some(PART_CHECKED_AT_CENTRE), deviation.max(seen_error));
            }
            (seen_error, sampled) = (deviation.max(seen_error), true);
        }
        if sampled {
            return (None, seen_error);
        }
        let mut estimated_error = self.oscillation_error(step, limits);
        if self.dragged.at_front {
            estimated_error = estimated_error
                .max(FRONT_ERROR_PER_BUBBLE_CHANGE * self.bubble.minus(old.bubble).length());
        }
        let decay_error = self.dragged.decay_error();
        if decay_error > MIN_DECAY_CHECKED
            && self.square * (decay_error * decay_error) > allowed * allowed
        {
            let [low, _, high] = self.dragged.across;
            let deviation = self.deviation(
                step,
                if low > high { 1.0 - MIN_PART_OF_LAYER } else { MIN_PART_OF_LAYER },
            );
            if deviation > allowed {
                return (Some(0.5), deviation);
            }
        }
        if estimated_error > allowed {
            let deviation = self.deviation(step, MIN_PART_OF_LAYER);
            if deviation > allowed {
                return (Some(0.5), deviation);
            }
            return (None, deviation.max(seen_error));
        }
        (None, estimated_error + LARGEST_OVER_SAMPLED_ERROR * seen_error)
    }

    /// Error of a piece that oscillates about its parabola: its tractions turn by an angle, but the
    /// deviation is smaller than that angle and the limits at both ends imply.
    #[inline(always)]
    fn oscillation_error(&self, step: &Step<V>, [from, to]: [f64; 2]) -> f64 {
        let new = &self.dragged.new;
        let [low, high] = [new[0], new[2]].map(|anchor| step.shift.minus(anchor));
        // The sine of the angle times the difference of the limits, times both limits.
        let turn = cross(low, high).abs() * (from - to);
        let product = from * to;
        let least_bubble = BUBBLE_PER_TURN * turn;
        if self.square * (product * product) >= least_bubble * least_bubble {
            return 0.0;
        }
        let travel = step.length.max(-step.dz);
        OSCILLATION_PER_TURN * turn * travel / (product * (travel + from))
    }

    /// Error near the edge, where tractions turn within the step although that at the middle does
    /// not.
    #[inline(always)]
    fn edge_error(&self, step: &Step<V>, [low, high]: [f64; 2]) -> f64 {
        let [_, across, _] = self.dragged.across;
        let (travel, middle) = (step.length, 0.5 * (low + high));
        EDGE_ERROR_PER_STRETCH * across * if travel < middle { travel / middle } else { 1.0 }
    }

    /// Error at the edge of the contact, and where. The tip lies beside the line of the tractions
    /// of the annuli below. Only annuli whose limit is about as small as this offset have turned
    /// towards it.
    #[inline(always)]
    fn tip_layer(&self, step: &Step<V>, limit: f64, allowed: f64) -> Option<(f64, f64)> {
        let Dragged { old, new, .. } = self.dragged;
        let [middle, high] = [new[1], old.high.anchor].map(|anchor| step.shift.minus(anchor));
        // The offset of the tip times half the limit.
        let beside = cross(middle, high).abs();
        if beside <= 0.5 * allowed * limit || beside > MAX_TIP_OFFSET_OF_LAYER * limit * limit {
            return None;
        }
        let part = 1.0 - 4.0 * beside / (limit * limit);
        Some((part, self.deviation(step, part)))
    }

    /// Error near the upper end, and where. Tractions have turned in annuli whose limit is below
    /// the length of the step, or below the decrease of the approach; in others they have not.
    #[inline(always)]
    fn boundary_layer(&self, step: &Step<V>, limits: [f64; 2]) -> (f64, f64) {
        let [low, high] = limits.map(|limit| limit + step.length.max(-step.dz));
        let part = ((low - (low * high).sqrt()) / (low - high)).max(MIN_PART_OF_LAYER);
        (part, self.deviation(step, part))
    }

    /// Error of the parabola at a fraction of the depth.
    #[inline]
    fn deviation(&self, step: &Step<V>, part: f64) -> f64 {
        let Dragged { old, new: [low, _, high], .. } = *self.dragged;
        let on = low.plus(high.minus(low).times(part));
        let on = on.plus(self.bubble.times(4.0 * part * (1.0 - part)));
        step.drag(old.depth_at(part), old.at(part)).minus(on).length()
    }
}
