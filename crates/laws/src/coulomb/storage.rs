//! The operations of a step on the storage of vertices, and storage with spare capacity for one
//! step.

use crate::memory::{Lateral, Vertex, VertexStack};

/// Vertices during a step, see [`VertexStack`].
pub trait Vertices<V: Lateral> {
    fn len(&self) -> usize;
    fn get(&self, index: usize) -> &Vertex<V>;
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V>;
    fn truncate(&mut self, len: usize);
    fn capacity(&self) -> usize;
    fn push(&mut self, vertex: Vertex<V>);
    fn count_merge(&mut self);

    /// Inserts a vertex below the one at an index; there must be room for it.
    #[inline]
    fn insert(&mut self, index: usize, vertex: Vertex<V>) {
        let len = self.len();
        self.push(vertex);
        for i in (index..len).rev() {
            *self.get_mut(i + 1) = *self.get(i);
        }
        *self.get_mut(index) = vertex;
    }

    /// Removes the vertex at an index.
    #[inline]
    fn remove(&mut self, index: usize) {
        let last = self.len() - 1;
        for i in index..last {
            *self.get_mut(i) = *self.get(i + 1);
        }
        self.truncate(last);
    }
}

impl<V: Lateral, S: VertexStack<V>> Vertices<V> for S {
    #[inline]
    fn len(&self) -> usize {
        VertexStack::len(self)
    }

    #[inline]
    fn get(&self, index: usize) -> &Vertex<V> {
        VertexStack::get(self, index)
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V> {
        VertexStack::get_mut(self, index)
    }

    #[inline]
    fn truncate(&mut self, len: usize) {
        VertexStack::truncate(self, len);
    }

    #[inline]
    fn capacity(&self) -> usize {
        VertexStack::capacity(self)
    }

    #[inline]
    fn push(&mut self, vertex: Vertex<V>) {
        VertexStack::push(self, vertex);
    }

    #[inline]
    fn count_merge(&mut self) {
        VertexStack::count_merge(self);
    }
}

/// Number of vertices that a step may need beyond the capacity, in blocks.
pub(super) const SPARE_VERTICES: usize = SPARE_BLOCKS * BLOCK;
const SPARE_BLOCKS: usize = 6;
const BLOCK: usize = 8;

/// Storage with spare capacity for one step. Vertices within the capacity are not copied.
pub(super) struct WithSpare<'a, V, S> {
    storage: &'a mut S,
    /// Allocated on demand: most steps need none.
    spare: [Option<[Vertex<V>; BLOCK]>; SPARE_BLOCKS],
    spare_len: usize,
}

impl<'a, V: Lateral, S: VertexStack<V>> WithSpare<'a, V, S> {
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
    fn spare_mut(&mut self, index: usize) -> &mut Vertex<V> {
        &mut self.spare[index / BLOCK].get_or_insert_with(|| [Vertex::default(); BLOCK])
            [index % BLOCK]
    }
}

impl<V: Lateral, S: VertexStack<V>> Vertices<V> for WithSpare<'_, V, S> {
    #[inline]
    fn len(&self) -> usize {
        self.storage.len() + self.spare_len
    }

    #[inline]
    fn get(&self, index: usize) -> &Vertex<V> {
        let capacity = self.storage.capacity();
        let past = index.wrapping_sub(capacity);
        match self.spare.get(past / BLOCK) {
            Some(Some(part)) => &part[past % BLOCK],
            _ => self.storage.get(index),
        }
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V> {
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
    fn push(&mut self, vertex: Vertex<V>) {
        if self.storage.len() < self.storage.capacity() {
            self.storage.push(vertex);
        } else {
            *self.spare_mut(self.spare_len) = vertex;
            self.spare_len += 1;
        }
    }

    fn count_merge(&mut self) {
        self.storage.count_merge();
    }
}
