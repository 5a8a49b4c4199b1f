//! The curve W(s) as a chain of pieces, from the centre to the edge.

use super::CoulombMemory;
use super::piece::{End, Node, Piece};
use crate::memory::{Lateral, Nodes};

impl<V: Lateral, S: Nodes<Node<V>>> CoulombMemory<V, S> {
    /// The pieces of the curve, from the centre to the edge.
    pub(super) fn chain(&self) -> impl Iterator<Item = Piece<V>> + '_ {
        self.chain_to(End { depth: self.zeta, root: self.root, anchor: self.shift })
    }

    /// The same, with another upper end.
    pub(super) fn chain_to(&self, tip: End<V>) -> impl Iterator<Item = Piece<V>> + '_ {
        (0..self.stack.len()).map(move |i| {
            let end = match i + 1 < self.stack.len() {
                true => (*self.stack.get(i + 1)).end(),
                false => tip,
            };
            Piece::new(self.stack.get(i), end)
        })
    }
}
