//! The operations of a step on the storage of vertices, and storage with spare capacity for one
//! step.

use super::Node;
use crate::memory::{Lateral, NodeStack, Nodes};

/// Number of vertices that a step may need beyond the capacity, in blocks.
pub(super) const SPARE_VERTICES: usize = SPARE_BLOCKS * BLOCK;
const SPARE_BLOCKS: usize = 6;
const BLOCK: usize = 8;

/// Storage with spare capacity for one step. Vertices within the capacity are not copied.
pub(super) struct WithSpare<'a, V, S> {
    storage: &'a mut S,
    /// Allocated on demand: most steps need none.
    spare: [Option<[Node<V>; BLOCK]>; SPARE_BLOCKS],
    spare_len: usize,
}

impl<'a, V: Lateral, S: NodeStack<Node<V>>> WithSpare<'a, V, S> {
    #[inline]
    pub(super) fn new(storage: &'a mut S) -> Self {
        Self { storage, spare: [None; SPARE_BLOCKS], spare_len: 0 }
    }

    /// The number of vertices that remain after the step.
    #[inline]
    pub(super) fn permanent_capacity(&self) -> usize {
        self.storage.capacity()
    }

    #[inline]
    fn spare_mut(&mut self, index: usize) -> &mut Node<V> {
        &mut self.spare[index / BLOCK].get_or_insert_with(|| [Node::default(); BLOCK])
            [index % BLOCK]
    }
}

impl<V: Lateral, S: NodeStack<Node<V>>> Nodes<Node<V>> for WithSpare<'_, V, S> {
    #[inline]
    fn len(&self) -> usize {
        self.storage.len() + self.spare_len
    }

    #[inline]
    fn get(&self, index: usize) -> &Node<V> {
        let capacity = self.storage.capacity();
        let past = index.wrapping_sub(capacity);
        match self.spare.get(past / BLOCK) {
            Some(Some(part)) => &part[past % BLOCK],
            _ => self.storage.get(index),
        }
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut Node<V> {
        let capacity = self.storage.capacity();
        if index < capacity {
            self.storage.get_mut(index)
        } else {
            self.spare_mut(index - capacity)
        }
    }

    #[inline]
    fn truncate(&mut self, len: usize) {
        let capacity = self.storage.capacity();
        self.spare_len = len.saturating_sub(capacity);
        if len < capacity {
            self.storage.truncate(len);
        }
    }

    #[inline]
    fn capacity(&self) -> usize {
        self.storage.capacity() + SPARE_VERTICES
    }

    #[inline]
    fn push(&mut self, node: Node<V>) {
        if self.storage.len() < self.storage.capacity() {
            self.storage.push(node);
        } else {
            *self.spare_mut(self.spare_len) = node;
            self.spare_len += 1;
        }
    }

    fn count_merge(&mut self) {
        self.storage.count_merge();
    }
}
