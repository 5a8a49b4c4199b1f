//! Storage of fixed capacity: room for the vertices that a step needs.
//!
//! A step that may need more vertices than there is room for takes place in a larger storage of its
//! own. The pairs of pieces whose merging moves the curve least are then merged until the rest fits.

use super::CoulombMemory;
use super::energy::{Notes, Unnoted};
use super::join::{BETWEEN, Pair};
use super::piece::End;
use crate::memory::{Fixed, Lateral, VertexStack};

/// The room of a step in small storage at a coarse tolerance, and in any other.
const SOME: usize = 24;
const MUCH: usize = 64;
/// Up to how many vertices storage is small.
const SMALL: usize = 16;
/// Below this tolerance a step may add many vertices before it joins pieces.
const COARSE: f64 = 5e-3;
/// How many it adds at most, but rarely, at a coarse tolerance.
const SPARE: usize = 4;

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// Whether a step may need more vertices than there is room for.
    #[inline]
    pub(super) fn is_short(&self) -> bool {
        let capacity = self.stack.capacity();
        let spare = if self.tolerance < COARSE { capacity } else { SPARE };
        capacity < MUCH && self.stack.len() + spare > capacity
    }

    /// A step in larger storage, then merges until the vertices fit.
    #[inline(never)]
    pub(super) fn step_with_room(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        if self.tolerance < COARSE || self.stack.capacity() > SMALL {
            self.step_in::<MUCH>(zeta, shift, notes);
        } else {
            self.step_in::<SOME>(zeta, shift, notes);
        }
    }

    #[inline]
    fn step_in<const N: usize>(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        let mut wide = CoulombMemory::<V, Fixed<V, N>> {
            zeta: self.zeta,
            root: self.root,
            shift: self.shift,
            force: self.force,
            regime: self.regime,
            front: self.front,
            extent: self.extent,
            tolerance: self.tolerance,
            bulge: self.bulge,
            stack: Fixed::default(),
        };
        for i in 0..self.stack.len() {
            wide.stack.push(*self.stack.get(i));
        }
        wide.go(zeta, shift, notes);
        while wide.stack.len() > self.stack.capacity() {
            let tip = wide.tip().end();
            merge_least(&mut wide.stack, tip, notes);
            self.stack.count_merge();
        }
        self.stack.truncate(0);
        for i in 0..wide.stack.len() {
            self.stack.push(*wide.stack.get(i));
        }
        (self.zeta, self.root, self.shift, self.force) =
            (wide.zeta, wide.root, wide.shift, wide.force);
        (self.regime, self.front) = (wide.regime, wide.front);
    }

    /// Room for one vertex.
    #[inline]
    pub(super) fn make_room(&mut self, tip: End<V>) {
        if self.stack.len() >= self.stack.capacity() {
            merge_least(&mut self.stack, tip, &mut Unnoted);
            self.stack.count_merge();
        }
    }
}

/// Merges the pair that may change a load to come least; the force stays.
#[cold]
fn merge_least<V: Lateral, S: VertexStack<V>>(
    stack: &mut S,
    tip: End<V>,
    notes: &mut impl Notes<V>,
) {
    let mut best = (f64::INFINITY, 1);
    for i in 1..stack.len() {
        let pair = Pair::at(stack, i, tip);
        let width = pair.above.high.root - pair.below.low.root;
        let effect = Pair::least_move(&pair.places()) * (width * width);
        if effect < best.0 {
            best = (effect, i);
        }
    }
    let pair = Pair::at(stack, best.1, tip);
    let bubble = pair.bubble();
    let moved = BETWEEN * Pair::move_by(&pair.places(), bubble).sqrt();
    pair.replace(stack, best.1, (bubble, moved), tip.anchor, notes);
}
