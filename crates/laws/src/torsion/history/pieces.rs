//! The pieces of a history, in order.

use std::ops::Deref;

use crate::torsion::segment::Segment;

/// Room for the pieces that most steps add, so that they need no other place in memory.
pub(super) const PIECES_OF_A_STEP: usize = 4;

/// The pieces of a history from the centre outwards.
#[derive(Debug, Default)]
pub(in crate::torsion) struct Pieces {
    list: Vec<Segment>,
    /// How many of them are as they were when the history was taken up.
    same: usize,
}

impl Pieces {
    /// Takes up pieces that were kept.
    pub(super) fn kept(pieces: &[Segment]) -> Self {
        let mut list = Vec::with_capacity(pieces.len() + PIECES_OF_A_STEP);
        list.extend_from_slice(pieces);
        Self { list, same: pieces.len() }
    }

    /// How many of the first pieces are as they were when the history was taken up.
    pub(super) const fn same(&self) -> usize {
        self.same
    }

    pub(in crate::torsion) fn push(&mut self, piece: Segment) {
        self.list.push(piece);
    }

    /// Keeps the first pieces only.
    pub(in crate::torsion) fn truncate(&mut self, count: usize) {
        self.list.truncate(count);
        self.same = self.same.min(count);
    }

    pub(in crate::torsion) fn replace(&mut self, i: usize, piece: Segment) {
        self.list[i] = piece;
        self.same = self.same.min(i);
    }

    /// Puts one piece in the place of another and the one above it. Demands do not decrease outwards.
    pub(super) fn join(&mut self, i: usize, piece: Segment) {
        self.list.remove(i + 1);
        self.replace(i, piece);
        let outside = self.list[i + 1..].iter_mut();
        let low = outside.take_while(|outer| outer.demand < piece.demand);
        low.for_each(|outer| outer.demand = piece.demand);
    }
}

impl Clone for Pieces {
    fn clone(&self) -> Self {
        Self { same: self.same, ..Self::kept(&self.list) }
    }
}

impl Deref for Pieces {
    type Target = [Segment];

    fn deref(&self) -> &[Segment] {
        &self.list
    }
}

impl FromIterator<Segment> for Pieces {
    fn from_iter<I: IntoIterator<Item = Segment>>(pieces: I) -> Self {
        Self { list: pieces.into_iter().collect(), same: 0 }
    }
}

impl PartialEq for Pieces {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list
    }
}
