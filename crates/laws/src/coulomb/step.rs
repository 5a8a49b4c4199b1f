//! A straight step: adhesion lays a piece down, slip drags what is beyond its limit.

use super::CoulombMemory;
use super::drag::{BEYOND, Step, grain};
use super::energy::{Notes, Unnoted};
use super::join::{Sizes, join_from};
use super::lay::{Dragged, HALVINGS};
use super::piece::{End, Knot, Piece};
use super::storage::Vertices;
use crate::memory::{Lateral, MemoryRegime as Regime, VertexStack};

/// What counts as no length at all, over the approach and over the shift.
const EXACT: [f64; 2] = [1e-13, 1e-15];
/// The share of the tolerance by which a join may move the curve of the whole contact.
const SHARE: f64 = 0.06;
/// Where the slipping part of the curve begins.
enum Front {
    /// Nothing slips.
    None,
    /// The deepest ring slips.
    Bottom,
    /// On the piece above a vertex, between a part that sticks and one that slips.
    On { piece: usize, within: f64, beyond: f64 },
}

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// A step that was checked.
    #[inline]
    pub(crate) fn step(&mut self, zeta: f64, shift: V) {
        self.step_noted(zeta, shift, &mut Unnoted);
    }

    #[inline]
    pub(super) fn step_noted(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        if zeta <= 0.0 {
            self.separate(zeta, shift);
            return;
        }
        if self.stack.is_empty() {
            self.touch(zeta, shift);
        }
        let dz = zeta - self.zeta;
        let dx = shift.minus(self.shift);
        if dz == 0.0 && dx == V::default() {
            return; // not a step at all
        }
        let stretch = shift.minus(self.stack.get(0).anchor);
        let square = stretch.dot(stretch);
        if square > self.extent * self.extent {
            self.extent = square.sqrt();
        }
        self.step_within_room(zeta, shift, notes);
    }

    #[cold]
    fn separate(&mut self, zeta: f64, shift: V) {
        self.stack.truncate(0);
        (self.zeta, self.root, self.shift) = (zeta, 0.0, shift);
        (self.regime, self.front, self.force) = (Regime::Separated, 0.0, V::default());
    }

    /// Moves a separated pair to the point of its path at which it touches.
    #[cold]
    pub(super) fn touch(&mut self, zeta: f64, shift: V) {
        let part = self.zeta / (self.zeta - zeta);
        self.shift = self.shift.plus(shift.minus(self.shift).times(part));
        (self.zeta, self.root, self.force) = (0.0, 0.0, V::default());
        self.extent = 0.0;
        self.stack.push(self.tip().vertex());
    }
}

impl<V: Lateral, S: Vertices<V>> CoulombMemory<V, S> {
    /// A step of a pair in contact, in storage that has room.
    #[inline]
    pub(super) fn go(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        let (dz, dx) = (zeta - self.zeta, shift.minus(self.shift));
        // On the cone itself, to round-off, the rings that touch may as well slip.
        let clear = dz - grain(zeta, shift);
        if clear > 0.0 && dx.dot(dx) <= clear * clear {
            self.adhere(zeta, shift, notes);
        } else {
            self.slip(zeta, shift, notes);
        }
        (self.zeta, self.shift) = (zeta, shift);
    }

    #[inline]
    fn sizes(&self, end: End<V>) -> Sizes {
        let [x, y] = end.anchor.components();
        Sizes {
            extent: self.extent,
            miss: SHARE * self.tolerance,
            bulge: self.bulge,
            exact: EXACT[0] * end.depth + EXACT[1] * (x.abs() + y.abs()),
        }
    }

    /// The tip of the curve, as a vertex to be.
    #[inline]
    pub(super) fn tip(&self) -> Knot<V> {
        Knot {
            depth: self.zeta,
            root: self.root,
            anchor: self.shift,
            bubble: V::default(),
            force: self.force,
            error: 0.0,
        }
    }

    /// The piece laid down in complete adhesion (6.45), (7.54).
    #[inline]
    fn adhere(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        let end = End { depth: zeta, root: zeta.sqrt(), anchor: shift };
        let top = self.grow();
        self.force = self.force.plus(Piece::new(&self.tip(), end).force());
        if top > 0 {
            let sizes = self.sizes(end);
            notes.drawn(self.chain_to(end), shift);
            join_from(&mut self.stack, top, end, &sizes, notes);
        }
        (self.root, self.regime, self.front) = (end.root, Regime::Adhesion, self.zeta);
        self.hold_limit(end);
    }

    /// Makes the tip a vertex, the foot of the piece to come, and returns its place.
    #[inline]
    fn grow(&mut self) -> usize {
        let top = self.stack.len() - 1;
        if self.stack.get(top).depth >= self.zeta {
            return top;
        }
        let tip = self.tip();
        self.make_room(tip.end());
        self.stack.push(tip.vertex());
        self.stack.len() - 1
    }

    /// Drags what is beyond its limit at the end of the step.
    fn slip(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        let step = Step::new((self.zeta, self.shift), (zeta, shift));
        let released = zeta < self.zeta;
        if zeta > self.zeta {
            self.grow();
        }
        let old = self.old_end(zeta);
        self.make_room(old);
        let front = self.find_front(&step, old);
        let end = End { depth: zeta, root: old.root, anchor: shift };
        let (first, sticks) = match front {
            Front::None => {
                self.finish(end, self.stack.len() - 1);
                if released {
                    (self.regime, self.front) = (Regime::Release, zeta);
                }
                return;
            }
            Front::Bottom => (0, false),
            Front::On { piece, within, beyond } => self.cut(&step, old, piece, within, beyond),
        };
        let slides = self.drag_from((first, sticks), &step, old, &self.sizes(end));
        self.report(first, slides && matches!(front, Front::Bottom), zeta);
        self.finish(end, first.saturating_sub(1));
        notes.drawn(self.chain_to(end), shift);
        self.join_from(first.max(1), end, notes);
    }

    /// Cuts the curve at an approach; its end there before anything is dragged.
    #[inline]
    fn old_end(&mut self, zeta: f64) -> End<V> {
        let mut end = self.tip().end();
        if zeta > self.zeta {
            // The rings that touch on the way have no stretch to begin with.
            return End { depth: zeta, root: zeta.sqrt(), anchor: self.shift };
        }
        if zeta < self.zeta {
            let mut top = self.stack.len() - 1;
            while self.stack.get(top).depth >= zeta {
                end = Knot::of(self.stack.get(top)).end();
                self.stack.truncate(top);
                top -= 1;
            }
            let knot = Knot::of(self.stack.get(top));
            let piece = Piece::new(&knot, end);
            let part = (zeta - knot.depth) / (end.depth - knot.depth);
            end = End { depth: zeta, root: zeta.sqrt(), anchor: piece.at(part) };
            self.stack.get_mut(top).slope = knot.bubble.times(part * part);
        }
        end
    }

    /// The upper end of the piece above a vertex.
    #[inline]
    fn end_of(&self, i: usize, tip: End<V>) -> End<V> {
        if i + 1 < self.stack.len() { Knot::of(self.stack.get(i + 1)).end() } else { tip }
    }

    /// The lowest place that slips; there may be others that stick above it.
    #[inline]
    fn find_front(&self, step: &Step<V>, old: End<V>) -> Front {
        let len = self.stack.len();
        let mut knot = Knot::of(self.stack.get(0));
        if step.is_beyond(knot.depth, knot.anchor) {
            return Front::Bottom;
        }
        for i in 0..len {
            let piece = Piece::new(&knot, self.end_of(i, old));
            let excess = step.excess(piece.middle_depth(), piece.middle());
            if step.counts(excess, piece.middle_depth()) {
                return Front::On { piece: i, within: 0.0, beyond: 0.5 };
            }
            let high = piece.high;
            let beyond = step.is_beyond(high.depth, high.anchor);
            // Before the upper end there may be a band that no end and no middle sees.
            if piece.may_slip(step, excess)
                && let Some([within, beyond]) = piece.look_for_slip(step)
            {
                return Front::On { piece: i, within, beyond };
            }
            if beyond {
                return Front::On { piece: i, within: 0.5, beyond: 1.0 };
            }
            if i + 1 < len {
                knot = Knot::of(self.stack.get(i + 1));
            }
        }
        Front::None
    }

    /// Makes the front a vertex and returns its place, and whether it is at its limit, so that it sticks.
    fn cut(
        &mut self,
        step: &Step<V>,
        old: End<V>,
        i: usize,
        within: f64,
        beyond: f64,
    ) -> (usize, bool) {
        let knot = Knot::of(self.stack.get(i));
        let piece = Piece::new(&knot, self.end_of(i, old));
        let part = piece.front(step, within, beyond);
        let cut = piece.cut(part);
        let grain = BEYOND * step.grain;
        if cut.depth <= knot.depth + grain {
            return (i, false);
        }
        if cut.depth >= piece.high.depth - grain {
            // The vertex above is the front, or a ring at the edge too thin to be seen.
            return ((i + 1).min(self.stack.len() - 1), false);
        }
        let rest = 1.0 - part;
        let front = Knot {
            depth: cut.depth,
            root: cut.root,
            anchor: cut.anchor,
            bubble: knot.bubble.times(rest * rest),
            force: V::default(),
            error: knot.error,
        };
        self.stack.get_mut(i).slope = knot.bubble.times(part * part);
        self.stack.insert(i + 1, front.vertex());
        (i + 1, true)
    }

    /// Drags the curve from a vertex up, which may stick, from the edge down; whether all of it slips.
    fn drag_from(
        &mut self,
        (first, sticks): (usize, bool),
        step: &Step<V>,
        old: End<V>,
        sizes: &Sizes,
    ) -> bool {
        let mut old = old;
        let mut new = step.shift;
        let end = End { depth: step.zeta, root: old.root, anchor: new };
        let straight = sizes.straight(&end);
        let near = |depth: f64, anchor: V| {
            let off = anchor.minus(step.behind(depth));
            off.dot(off) <= straight * straight
        };
        // Behind the tip after the step, and before it.
        let mut in_line = true;
        let mut was_in_line =
            old.depth >= self.zeta || step.is_in_line(old.depth, old.anchor, sizes.exact);
        let mut slides = !sticks;
        // The error of the straight piece behind the tip.
        let mut error = 0.0;
        for i in (first..self.stack.len()).rev() {
            let knot = Knot::of(self.stack.get(i));
            let piece = Piece::new(&knot, old);
            was_in_line = was_in_line
                && knot.bubble == V::default()
                && step.is_in_line(knot.depth, knot.anchor, sizes.exact);
            if was_in_line {
                if knot.error > 0.0 {
                    error = step.left_in_line(knot.depth, knot.anchor, knot.error).max(error);
                }
                (old, new) = (piece.low, step.behind(knot.depth));
                self.lay_line(i, new, error);
                continue;
            }
            let sticks = sticks && i == first;
            let low = if sticks { knot.anchor } else { step.drag(knot.depth, knot.anchor) };
            let middle = step.drag(piece.middle_depth(), piece.middle());
            in_line = in_line
                && near(knot.depth, low)
                && (knot.depth >= self.zeta || near(piece.middle_depth(), middle));
            if in_line {
                let left = step.left(&piece, step.across([low, middle, new]));
                error = if left > error { left } else { error };
                self.lay_line(i, low, error);
            } else {
                let new = [low, middle, new];
                let ways = piece.ways(new);
                slides = slides && ways[0] > 0.0 && ways[1] > 0.0;
                let across = step.across(new);
                let slips = ways[0] > 0.0 && ways[1] > 0.0 && ways[2] > 0.0;
                let left = if slips { step.left(&piece, across) } else { knot.error };
                let ways = if sticks { [ways[1], ways[1], ways[2]] } else { ways };
                let at_front = ways[0] == ways[1];
                let dragged = Dragged { old: &piece, new, ways, at_front, across, left };
                self.lay(i, &dragged, step, (sizes, HALVINGS));
            }
            (old, new) = (piece.low, low);
        }
        slides
    }

    /// One piece, straight behind the tip.
    #[inline]
    fn lay_line(&mut self, i: usize, anchor: V, error: f64) {
        self.stack.truncate(i + 1);
        let vertex = self.stack.get_mut(i);
        (vertex.anchor, vertex.slope) = (anchor, V::default());
        vertex.force_slope = V::from_components([error, 0.0]);
    }

    /// The forces from a vertex up, and the end of the step.
    #[inline]
    pub(super) fn finish(&mut self, end: End<V>, first: usize) {
        let mut knot = Knot::of(self.stack.get(first));
        for i in first + 1..self.stack.len() {
            let next = Knot::of(self.stack.get(i));
            let force = knot.force.plus(Piece::new(&knot, next.end()).force());
            self.stack.get_mut(i).force = force;
            knot = Knot { force, ..next };
        }
        self.force = knot.force.plus(Piece::new(&knot, end).force());
        self.root = end.root;
        self.hold_limit(end);
    }

    /// Takes the force back to its limit, beyond which round-off of the shift may bring it where the
    /// approach is small beside the shift.
    #[inline]
    fn hold_limit(&mut self, end: End<V>) {
        let (limit, square) = (end.depth * end.root, self.force.dot(self.force));
        if square > limit * limit * (1.0 + 8.0 * f64::EPSILON) {
            self.force = self.force.times(limit / square.sqrt());
        }
    }

    /// Joins what can be joined from a vertex up.
    #[inline]
    fn join_from(&mut self, first: usize, end: End<V>, notes: &mut impl Notes<V>) {
        if first < self.stack.len() {
            let sizes = self.sizes(end);
            join_from(&mut self.stack, first, end, &sizes, notes);
        }
    }

    /// What the step did: the front is vertex `first`.
    #[inline]
    fn report(&mut self, first: usize, slides: bool, zeta: f64) {
        let front = self.stack.get(first).depth;
        let slipped = matches!(self.regime, Regime::Slip | Regime::Reversal | Regime::Sliding);
        let back = slipped && front > self.front && front < zeta;
        self.regime = match (slides, back) {
            (true, _) => Regime::Sliding,
            (false, true) => Regime::Reversal,
            (false, false) => Regime::Slip,
        };
        self.front = front;
    }
}
