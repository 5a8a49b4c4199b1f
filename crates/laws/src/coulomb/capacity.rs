//! Storage of fixed capacity.
//!
//! A step may need more vertices than the capacity and takes them from spare storage. Afterwards,
//! the pairs of pieces whose merging moves the curve least are merged until the vertices fit.

use super::energy::{NoObserver, StepObserver};
use super::join::{MAX_OVER_SAMPLED_MOVE, Pair};
use super::piece::End;
use super::storage::{SPARE_VERTICES, WithSpare};
use super::{BUBBLE_PER_TOLERANCE, CoulombMemory, Node};
use crate::memory::{Lateral, NodeStack, Nodes};

/// Above this capacity there is no spare storage.
const LARGEST_CAPACITY_WITH_SPARE: usize = 64;
/// The number of vertices that a step adds at most, with rare exceptions, before it joins pieces:
/// at a tolerance of at least `COARSE_TOLERANCE`, of at least `FINE_TOLERANCE`, and below.
const MAX_ADDED_AT_COARSE: usize = 4;
const MAX_ADDED_AT_FINE: usize = 16;
const MAX_ADDED: usize = 32;
const COARSE_TOLERANCE: f64 = 5e-3;
const FINE_TOLERANCE: f64 = 5e-4;

/// Storage with fewer free vertices than this is full.
const FREE_VERTICES_OF_FULL_STORAGE: usize = 3;
/// Number of pieces of a curve, times the cube root of the tolerance. In full storage the tolerance
/// follows from it: finer pieces would be merged again.
const PIECES_PER_TOLERANCE: f64 = 1.5;

impl<V: Lateral, S: NodeStack<Node<V>>> CoulombMemory<V, S> {
    /// A step of a pair in contact, for any capacity.
    #[inline]
    pub(super) fn step_within_room(
        &mut self,
        zeta: f64,
        shift: V,
        observer: &mut impl StepObserver<V>,
    ) {
        let capacity = self.stack.capacity();
        let needs = match self.tolerance {
            COARSE_TOLERANCE.. => MAX_ADDED_AT_COARSE,
            FINE_TOLERANCE.. => MAX_ADDED_AT_FINE,
            _ => MAX_ADDED,
        };
        if capacity <= LARGEST_CAPACITY_WITH_SPARE && self.stack.len() + needs > capacity {
            self.step_with_spare(zeta, shift, observer);
        } else {
            self.step_in_contact(zeta, shift, observer);
        }
    }

    /// A step in spare storage, after which pieces are merged until the vertices fit.
    #[inline(never)]
    fn step_with_spare(&mut self, zeta: f64, shift: V, observer: &mut impl StepObserver<V>) {
        let (mut tolerance, mut max_bubble) = (self.tolerance, self.max_bubble);
        let capacity = self.stack.capacity();
        if self.stack.len() + FREE_VERTICES_OF_FULL_STORAGE > capacity {
            let part = PIECES_PER_TOLERANCE / capacity as f64;
            tolerance = tolerance.max(part * part * part);
            max_bubble = max_bubble.max(BUBBLE_PER_TOLERANCE * part * part);
        }
        let mut memory = CoulombMemory {
            zeta: self.zeta,
            root: self.root,
            shift: self.shift,
            force: self.force,
            regime: self.regime,
            front: self.front,
            extent: self.extent,
            tolerance,
            max_bubble,
            stack: WithSpare::new(&mut self.stack),
        };
        memory.step_in_contact(zeta, shift, observer);
        let tip = memory.tip().end();
        let fits = memory.stack.permanent_capacity();
        if memory.stack.len() > fits {
            merge_until(&mut memory.stack, fits, tip, observer);
        }
        (self.zeta, self.root, self.shift, self.force) =
            (memory.zeta, memory.root, memory.shift, memory.force);
        (self.regime, self.front) = (memory.regime, memory.front);
    }
}

impl<V: Lateral, S: Nodes<Node<V>>> CoulombMemory<V, S> {
    /// Makes room for one vertex.
    #[inline]
    pub(super) fn make_room(&mut self, tip: End<V>) {
        let capacity = self.stack.capacity();
        if self.stack.len() >= capacity {
            merge_until(&mut self.stack, capacity - 1, tip, &mut NoObserver);
        }
    }
}

/// A measure of how merging two pieces may change a later load: the square of the displacement of
/// the curve times that of the share of these annuli in the force.
#[inline]
fn effect<V: Lateral, S: Nodes<Node<V>>>(stack: &S, i: usize, tip: End<V>) -> f64 {
    let pair = Pair::at(stack, i, tip);
    let width = pair.above.high.root - pair.below.low.root;
    Pair::least_move(&pair.samples()) * (width * width)
}

/// Merges the pairs of least effect until `fits` vertices are left; the force does not change.
#[cold]
#[inline(never)]
fn merge_until<V: Lateral, S: Nodes<Node<V>>>(
    stack: &mut S,
    fits: usize,
    tip: End<V>,
    observer: &mut impl StepObserver<V>,
) {
    let mut effects = [f64::INFINITY; LARGEST_CAPACITY_WITH_SPARE + SPARE_VERTICES + 1];
    let mut len = stack.len().min(effects.len());
    for (i, at) in effects[..len].iter_mut().enumerate().skip(1) {
        *at = effect(stack, i, tip);
    }
    while stack.len() > fits {
        let mut best = 1;
        for i in 2..len {
            if effects[i] < effects[best] {
                best = i;
            }
        }
        let pair = Pair::at(stack, best, tip);
        let bubble = pair.bubble();
        let moved = MAX_OVER_SAMPLED_MOVE * Pair::move_by(&pair.samples(), bubble).sqrt();
        pair.replace(stack, best, (bubble, moved), tip.anchor, observer);
        stack.count_merge();
        // The pairs below and above now have another end.
        effects.copy_within(best + 1..len, best);
        len -= 1;
        let (from, to) = (best.max(2) - 1, (best + 1).min(len));
        for (i, at) in effects.iter_mut().enumerate().take(to).skip(from) {
            *at = effect(stack, i, tip);
        }
    }
}
