//! A straight step: adhesion appends a piece; in slip the return mapping acts on what exceeds the
//! limit.

use super::CoulombMemory;
use super::drag::{MAX_EXCESS_OF_ROUND_OFF, Step, round_off_length};
use super::energy::{NoObserver, StepObserver};
use super::fit::{Dragged, MAX_HALVINGS};
use super::join::{ControlLengths, join_from};
use super::piece::{End, Node, Piece};
use crate::bounds::LEAST_APPROACH;
use crate::memory::{Lateral, MemoryRegime as Regime, NodeStack, Nodes};

/// Lengths up to these shares of the approach and of the shift count as zero.
const ZERO_LENGTH_SHARES: [f64; 2] = [1e-13, 1e-15];
/// Stretches of more approaches have less than ten digits beside the shift.
const MAX_APPROACHES: f64 = 1e6;
/// Share of the tolerance by which a join of pieces from the centre to the edge may move the curve.
const JOIN_SHARE_OF_TOLERANCE: f64 = 0.06;
/// Where the slipping part of the curve begins.
enum Front {
    /// Nothing slips.
    None,
    /// The centre slips.
    Bottom,
    /// On the piece above vertex `piece`, between the fraction `within` (sticks) and `beyond`
    /// (slips).
    On { piece: usize, within: f64, beyond: f64 },
}

impl<V: Lateral, S: NodeStack<Node<V>>> CoulombMemory<V, S> {
    /// A step with checked arguments.
    #[inline]
    pub(crate) fn step(&mut self, zeta: f64, shift: V) {
        self.step_observed(zeta, shift, &mut NoObserver);
    }

    #[inline]
    pub(super) fn step_observed(
        &mut self,
        zeta: f64,
        shift: V,
        observer: &mut impl StepObserver<V>,
    ) {
        if zeta <= LEAST_APPROACH {
            self.separate(zeta.min(0.0), shift);
            return;
        }
        if self.stack.is_empty() {
            self.touch(zeta, shift);
        }
        let dz = zeta - self.zeta;
        let dx = shift.minus(self.shift);
        if dz == 0.0 && dx == V::default() {
            return; // no step
        }
        let stretch = shift.minus(self.stack.get(0).anchor);
        let square = stretch.dot(stretch);
        if square > self.extent * self.extent {
            self.extent = square.sqrt();
        }
        if square > (MAX_APPROACHES * zeta) * (MAX_APPROACHES * zeta) {
            self.slide_far(zeta, shift, observer);
            return;
        }
        self.step_within_room(zeta, shift, observer);
    }

    /// A slide over so many approaches that round-off of the shift reaches the stretches. It is made with the origin at its
    /// end, where they are exact, so that the force is, too.
    #[cold]
    fn slide_far(&mut self, zeta: f64, shift: V, observer: &mut impl StepObserver<V>) {
        self.translate(shift.times(-1.0));
        self.step_within_room(zeta, V::default(), observer);
        self.translate(shift);
    }

    #[cold]
    fn separate(&mut self, zeta: f64, shift: V) {
        self.stack.truncate(0);
        (self.zeta, self.root, self.shift) = (zeta, 0.0, shift);
        (self.regime, self.front, self.force) = (Regime::Separated, 0.0, V::default());
    }

    /// Moves a separated pair to the point of its path at which contact begins.
    #[cold]
    pub(super) fn touch(&mut self, zeta: f64, shift: V) {
        let part = self.zeta / (self.zeta - zeta);
        self.shift = self.shift.plus(shift.minus(self.shift).times(part));
        (self.zeta, self.root, self.force) = (0.0, 0.0, V::default());
        self.extent = 0.0;
        self.stack.push(self.tip());
    }
}

impl<V: Lateral, S: Nodes<Node<V>>> CoulombMemory<V, S> {
    /// A step of a pair in contact, in storage that has room.
    #[inline]
    pub(super) fn step_in_contact(
        &mut self,
        zeta: f64,
        shift: V,
        observer: &mut impl StepObserver<V>,
    ) {
        let (dz, dx) = (zeta - self.zeta, shift.minus(self.shift));
        // On the cone itself, to round-off, new annuli may be treated as slipping.
        let growth = dz - round_off_length(zeta, shift);
        if growth > 0.0 && dx.dot(dx) <= growth * growth {
            self.adhere(zeta, shift, observer);
        } else {
            self.slip(zeta, shift, observer);
        }
        (self.zeta, self.shift) = (zeta, shift);
    }

    #[inline]
    fn lengths(&self, end: End<V>) -> ControlLengths {
        let [x, y] = end.anchor.components();
        ControlLengths {
            extent: self.extent,
            max_move: JOIN_SHARE_OF_TOLERANCE * self.tolerance,
            max_bubble: self.max_bubble,
            exact: ZERO_LENGTH_SHARES[0] * end.depth + ZERO_LENGTH_SHARES[1] * (x.abs() + y.abs()),
        }
    }

    /// The tip of the curve (zeta, X) as a node.
    #[inline]
    pub(super) fn tip(&self) -> Node<V> {
        Node {
            depth: self.zeta,
            root: self.root,
            anchor: self.shift,
            bubble: V::default(),
            force: self.force,
            error: 0.0,
        }
    }

    /// Appends the piece formed in complete adhesion (6.45), (7.54).
    #[inline]
    fn adhere(&mut self, zeta: f64, shift: V, observer: &mut impl StepObserver<V>) {
        let end = End { depth: zeta, root: zeta.sqrt(), anchor: shift };
        let top = self.make_tip_a_vertex();
        self.force = self.force.plus(Piece::new(&self.tip(), end).force());
        if top > 0 {
            let lengths = self.lengths(end);
            observer.fitted(self.chain_to(end), shift);
            join_from(&mut self.stack, top, end, &lengths, observer);
        }
        (self.root, self.regime, self.front) = (end.root, Regime::Adhesion, self.zeta);
        self.hold_limit(end);
    }

    /// Makes the tip a vertex, the lower end of the next piece, and returns its index.
    #[inline]
    fn make_tip_a_vertex(&mut self) -> usize {
        let top = self.stack.len() - 1;
        if self.stack.get(top).depth >= self.zeta {
            return top;
        }
        let tip = self.tip();
        self.make_room(tip.end());
        self.stack.push(tip);
        self.stack.len() - 1
    }

    /// Applies the return mapping to the annuli that exceed their limit at the end of the step.
    fn slip(&mut self, zeta: f64, shift: V, observer: &mut impl StepObserver<V>) {
        let step = Step::new((self.zeta, self.shift), (zeta, shift));
        let released = zeta < self.zeta;
        if zeta > self.zeta {
            self.make_tip_a_vertex();
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
                } else if self.regime == Regime::Separated {
                    // A first contact whose slip is within the round-off of a large shift.
                    (self.regime, self.front) = (Regime::Adhesion, self.zeta);
                }
                return;
            }
            Front::Bottom => (0, false),
            Front::On { piece, within, beyond } => self.cut(&step, old, piece, within, beyond),
        };
        let slides = self.drag_from((first, sticks), &step, old, &self.lengths(end));
        self.report(first, slides && matches!(front, Front::Bottom), zeta);
        self.finish(end, first.saturating_sub(1));
        observer.fitted(self.chain_to(end), shift);
        self.join_from(first.max(1), end, observer);
    }

    /// Removes the curve above an approach and returns its end there, before the return mapping.
    #[inline]
    fn old_end(&mut self, zeta: f64) -> End<V> {
        let mut end = self.tip().end();
        if zeta > self.zeta {
            // Annuli that come into contact during the step have no stretch at first.
            return End { depth: zeta, root: zeta.sqrt(), anchor: self.shift };
        }
        if zeta < self.zeta {
            let mut top = self.stack.len() - 1;
            while self.stack.get(top).depth >= zeta {
                end = (*self.stack.get(top)).end();
                self.stack.truncate(top);
                top -= 1;
            }
            let node = *self.stack.get(top);
            let piece = Piece::new(&node, end);
            let part = (zeta - node.depth) / (end.depth - node.depth);
            end = End { depth: zeta, root: zeta.sqrt(), anchor: piece.at(part) };
            self.stack.get_mut(top).bubble = node.bubble.times(part * part);
        }
        end
    }

    /// The upper end of the piece above a vertex.
    #[inline]
    fn end_of(&self, i: usize, tip: End<V>) -> End<V> {
        if i + 1 < self.stack.len() { (*self.stack.get(i + 1)).end() } else { tip }
    }

    /// The slip front: the deepest point that slips. Annuli above it may stick.
    #[inline]
    fn find_front(&self, step: &Step<V>, old: End<V>) -> Front {
        let len = self.stack.len();
        let mut node = *self.stack.get(0);
        if step.is_beyond_limit(node.depth, node.anchor) {
            return Front::Bottom;
        }
        for i in 0..len {
            let piece = Piece::new(&node, self.end_of(i, old));
            let excess = step.excess(piece.middle_depth(), piece.middle());
            if step.exceeds_round_off(excess, piece.middle_depth()) {
                return Front::On { piece: i, within: 0.0, beyond: 0.5 };
            }
            let high = piece.high;
            let beyond = step.is_beyond_limit(high.depth, high.anchor);
            // A zone of slip may lie below the upper end and contain neither an end nor the middle.
            if piece.may_slip(step, excess)
                && let Some([within, beyond]) = piece.look_for_slip(step)
            {
                return Front::On { piece: i, within, beyond };
            }
            if beyond {
                return Front::On { piece: i, within: 0.5, beyond: 1.0 };
            }
            if i + 1 < len {
                node = *self.stack.get(i + 1);
            }
        }
        Front::None
    }

    /// Makes the front a vertex. Returns its index and whether it sticks, being just at its limit.
    fn cut(
        &mut self,
        step: &Step<V>,
        old: End<V>,
        i: usize,
        within: f64,
        beyond: f64,
    ) -> (usize, bool) {
        let node = *self.stack.get(i);
        let piece = Piece::new(&node, self.end_of(i, old));
        let part = piece.front(step, within, beyond);
        let cut = piece.cut(part);
        let round_off_length = MAX_EXCESS_OF_ROUND_OFF * step.round_off_length;
        if cut.depth <= node.depth + round_off_length {
            return (i, false);
        }
        if cut.depth >= piece.high.depth - round_off_length {
            // The front is the vertex above, or the slip annulus is too thin to count.
            return ((i + 1).min(self.stack.len() - 1), false);
        }
        let rest = 1.0 - part;
        let front = Node {
            depth: cut.depth,
            root: cut.root,
            anchor: cut.anchor,
            bubble: node.bubble.times(rest * rest),
            force: V::default(),
            error: node.error,
        };
        self.stack.get_mut(i).bubble = node.bubble.times(part * part);
        self.stack.insert(i + 1, front);
        (i + 1, true)
    }

    /// Applies the return mapping from the edge down to vertex `first`, which sticks if `sticks`.
    /// Returns whether all annuli slipped.
    fn drag_from(
        &mut self,
        (first, sticks): (usize, bool),
        step: &Step<V>,
        old: End<V>,
        lengths: &ControlLengths,
    ) -> bool {
        let mut old = old;
        let mut new = step.shift;
        let end = End { depth: step.zeta, root: old.root, anchor: new };
        let straight = lengths.straight(&end);
        let near = |depth: f64, anchor: V| {
            let offset = anchor.minus(step.behind(depth));
            offset.dot(offset) <= straight * straight
        };
        // Whether the curve above lies on a straight line behind the tip: after the step, and
        // before it.
        let mut in_line = true;
        let mut was_in_line =
            old.depth >= self.zeta || step.is_in_line(old.depth, old.anchor, lengths.exact);
        let mut slides = !sticks;
        // The error of the straight piece behind the tip.
        let mut error = 0.0;
        for i in (first..self.stack.len()).rev() {
            let node = *self.stack.get(i);
            let piece = Piece::new(&node, old);
            was_in_line = was_in_line
                && node.bubble == V::default()
                && step.is_in_line(node.depth, node.anchor, lengths.exact);
            if was_in_line {
                if node.error > 0.0 {
                    error = step
                        .remaining_error_in_line(node.depth, node.anchor, node.error)
                        .max(error);
                }
                (old, new) = (piece.low, step.behind(node.depth));
                self.fit_line(i, new, error);
                continue;
            }
            let sticks = sticks && i == first;
            let low = if sticks { node.anchor } else { step.drag(node.depth, node.anchor) };
            let middle = step.drag(piece.middle_depth(), piece.middle());
            in_line = in_line
                && near(node.depth, low)
                && (node.depth >= self.zeta || near(piece.middle_depth(), middle));
            if in_line {
                let remaining_error = step.remaining_error(&piece, step.across([low, middle, new]));
                error = if remaining_error > error { remaining_error } else { error };
                self.fit_line(i, low, error);
            } else {
                let new = [low, middle, new];
                let squared_moves = piece.squared_moves(new);
                slides = slides && squared_moves[0] > 0.0 && squared_moves[1] > 0.0;
                let across = step.across(new);
                let slips =
                    squared_moves[0] > 0.0 && squared_moves[1] > 0.0 && squared_moves[2] > 0.0;
                let remaining_error =
                    if slips { step.remaining_error(&piece, across) } else { node.error };
                let squared_moves = if sticks {
                    [squared_moves[1], squared_moves[1], squared_moves[2]]
                } else {
                    squared_moves
                };
                let at_front = squared_moves[0] == squared_moves[1];
                let dragged =
                    Dragged { old: &piece, new, squared_moves, at_front, across, remaining_error };
                self.fit(i, &dragged, step, (lengths, MAX_HALVINGS));
            }
            (old, new) = (piece.low, low);
        }
        slides
    }

    /// Replaces the curve above vertex `i` by one straight piece to the tip.
    #[inline]
    fn fit_line(&mut self, i: usize, anchor: V, error: f64) {
        self.stack.truncate(i + 1);
        let vertex = self.stack.get_mut(i);
        (vertex.anchor, vertex.bubble) = (anchor, V::default());
        vertex.error = error;
    }

    /// Sums the forces from a vertex upwards and ends the step.
    #[inline]
    pub(super) fn finish(&mut self, end: End<V>, first: usize) {
        let mut node = *self.stack.get(first);
        for i in first + 1..self.stack.len() {
            let next = *self.stack.get(i);
            let force = node.force.plus(Piece::new(&node, next.end()).force());
            self.stack.get_mut(i).force = force;
            node = Node { force, ..next };
        }
        self.force = node.force.plus(Piece::new(&node, end).force());
        self.root = end.root;
        self.hold_limit(end);
    }

    /// Scales the force back to its limit. Round-off of the shift may exceed the limit if the
    /// approach is small against the shift.
    #[inline]
    fn hold_limit(&mut self, end: End<V>) {
        let (limit, square) = (end.depth * end.root, self.force.dot(self.force));
        if square > limit * limit * (1.0 + 8.0 * f64::EPSILON) {
            self.force = self.force.times(limit / square.sqrt());
        }
    }

    /// Joins pieces from a vertex upwards where the tolerance allows.
    #[inline]
    fn join_from(&mut self, first: usize, end: End<V>, observer: &mut impl StepObserver<V>) {
        if first < self.stack.len() {
            let lengths = self.lengths(end);
            join_from(&mut self.stack, first, end, &lengths, observer);
        }
    }

    /// Sets the regime and the slip front, which is vertex `first`.
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
