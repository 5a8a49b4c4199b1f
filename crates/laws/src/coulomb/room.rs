//! Storage of fixed capacity: room for the vertices that a step needs.
//!
//! A step may need more vertices than there is room for, and takes them from a spare. The pairs of pieces
//! whose merging moves the curve least are then merged until the rest fits.

use super::energy::{Notes, Unnoted};
use super::join::{BETWEEN, Pair};
use super::piece::End;
use super::storage::{Roomy, SPARE, Vertices};
use super::{BULGE, CoulombMemory};
use crate::memory::{Lateral, VertexStack};

/// From this capacity on there is room enough.
const MUCH: usize = 64;
/// How many vertices a step adds at most, but rarely, before it joins pieces: at a coarse tolerance, and
/// above a fine one.
const FEW: usize = 4;
const MORE: usize = 16;
const COARSE: f64 = 5e-3;
const FINE: f64 = 5e-4;

/// Storage with less room than this is full.
const FULL: usize = 3;
/// The pieces that a curve needs, times the third root of the tolerance: more do not last in storage that is
/// full, and to draw them finer than they last gains nothing.
const PIECES: f64 = 1.5;

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// A step of a pair in contact, whatever room there is.
    #[inline]
    pub(super) fn step_within_room(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        let room = VertexStack::capacity(&self.stack);
        let needs = match self.tolerance {
            COARSE.. => FEW,
            FINE.. => MORE,
            _ => room,
        };
        if room < MUCH && VertexStack::len(&self.stack) + needs > room {
            self.step_with_spare(zeta, shift, notes);
        } else {
            self.go(zeta, shift, notes);
        }
    }

    /// A step with room to spare, then merges until the vertices fit.
    #[inline(never)]
    fn step_with_spare(&mut self, zeta: f64, shift: V, notes: &mut impl Notes<V>) {
        let (mut tolerance, mut bulge) = (self.tolerance, self.bulge);
        let room = VertexStack::capacity(&self.stack);
        if VertexStack::len(&self.stack) + FULL > room {
            let part = PIECES / room as f64;
            tolerance = tolerance.max(part * part * part);
            bulge = bulge.max(BULGE * part * part);
        }
        let mut wide = CoulombMemory {
            zeta: self.zeta,
            root: self.root,
            shift: self.shift,
            force: self.force,
            regime: self.regime,
            front: self.front,
            extent: self.extent,
            tolerance,
            bulge,
            stack: Roomy::new(&mut self.stack),
        };
        wide.go(zeta, shift, notes);
        let tip = wide.tip().end();
        let fits = wide.stack.lasting();
        if wide.stack.len() > fits {
            merge_until(&mut wide.stack, fits, tip, notes);
        }
        (self.zeta, self.root, self.shift, self.force) =
            (wide.zeta, wide.root, wide.shift, wide.force);
        (self.regime, self.front) = (wide.regime, wide.front);
    }
}

impl<V: Lateral, S: Vertices<V>> CoulombMemory<V, S> {
    /// Room for one vertex.
    #[inline]
    pub(super) fn make_room(&mut self, tip: End<V>) {
        let room = self.stack.capacity();
        if self.stack.len() >= room {
            merge_until(&mut self.stack, room - 1, tip, &mut Unnoted);
        }
    }
}

/// What merging two pieces may change a load to come by: how far the curve moves, and the part of the force
/// that these rings carry.
#[inline]
fn effect<V: Lateral, S: Vertices<V>>(stack: &S, i: usize, tip: End<V>) -> f64 {
    let pair = Pair::at(stack, i, tip);
    let width = pair.above.high.root - pair.below.low.root;
    Pair::least_move(&pair.places()) * (width * width)
}

/// Merges the pairs of least effect until so many vertices are left; the force stays.
#[cold]
#[inline(never)]
fn merge_until<V: Lateral, S: Vertices<V>>(
    stack: &mut S,
    fits: usize,
    tip: End<V>,
    notes: &mut impl Notes<V>,
) {
    let mut effects = [f64::INFINITY; MUCH + SPARE + 1];
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
        let moved = BETWEEN * Pair::move_by(&pair.places(), bubble).sqrt();
        pair.replace(stack, best, (bubble, moved), tip.anchor, notes);
        stack.count_merge();
        // The pairs below and above now end elsewhere.
        effects.copy_within(best + 1..len, best);
        len -= 1;
        let (from, to) = (best.max(2) - 1, (best + 1).min(len));
        for (i, at) in effects.iter_mut().enumerate().take(to).skip(from) {
            *at = effect(stack, i, tip);
        }
    }
}
