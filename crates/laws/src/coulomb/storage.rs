//! What a step needs of the storage of vertices, and storage that has more room than it lasts for.

use crate::memory::{Lateral, Vertex, VertexStack};

/// Vertices in the course of a step, see [`VertexStack`].
pub trait Vertices<V: Lateral> {
    fn len(&self) -> usize;
    fn get(&self, index: usize) -> &Vertex<V>;
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V>;
    fn truncate(&mut self, len: usize);
    fn capacity(&self) -> usize;
    fn push(&mut self, vertex: Vertex<V>);
    fn count_merge(&mut self);

    /// Puts a vertex below the one at a position; there is room for it.
    #[inline]
    fn insert(&mut self, index: usize, vertex: Vertex<V>) {
        let len = self.len();
        self.push(vertex);
        for i in (index..len).rev() {
            *self.get_mut(i + 1) = *self.get(i);
        }
        *self.get_mut(index) = vertex;
    }

    /// Takes the vertex at a position out.
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

/// How many vertices a step may need beyond the room there is, in parts.
pub(super) const SPARE: usize = PARTS * PART;
const PARTS: usize = 6;
const PART: usize = 8;

/// Storage with room to spare for one step. What fits stays where it is.
pub(super) struct Roomy<'a, V, S> {
    own: &'a mut S,
    /// None until they are needed: most steps do without.
    spare: [Option<[Vertex<V>; PART]>; PARTS],
    spared: usize,
}

impl<'a, V: Lateral, S: VertexStack<V>> Roomy<'a, V, S> {
    #[inline]
    pub(super) fn new(own: &'a mut S) -> Self {
        Self { own, spare: [None; PARTS], spared: 0 }
    }

    /// How many vertices last.
    #[inline]
    pub(super) fn lasting(&self) -> usize {
        self.own.capacity()
    }

    #[inline]
    fn spare_mut(&mut self, index: usize) -> &mut Vertex<V> {
        &mut self.spare[index / PART].get_or_insert_with(|| [Vertex::default(); PART])[index % PART]
    }
}

impl<V: Lateral, S: VertexStack<V>> Vertices<V> for Roomy<'_, V, S> {
    #[inline]
    fn len(&self) -> usize {
        self.own.len() + self.spared
    }

    #[inline]
    fn get(&self, index: usize) -> &Vertex<V> {
        let room = self.own.capacity();
        let past = index.wrapping_sub(room);
        match self.spare.get(past / PART) {
            Some(Some(part)) => &part[past % PART],
            _ => self.own.get(index),
        }
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V> {
        let room = self.own.capacity();
        if index < room { self.own.get_mut(index) } else { self.spare_mut(index - room) }
    }

    #[inline]
    fn truncate(&mut self, len: usize) {
        let room = self.own.capacity();
        self.spared = len.saturating_sub(room);
        if len < room {
            self.own.truncate(len);
        }
    }

    #[inline]
    fn capacity(&self) -> usize {
        self.own.capacity() + SPARE
    }

    #[inline]
    fn push(&mut self, vertex: Vertex<V>) {
        if self.own.len() < self.own.capacity() {
            self.own.push(vertex);
        } else {
            *self.spare_mut(self.spared) = vertex;
            self.spared += 1;
        }
    }

    fn count_merge(&mut self) {
        self.own.count_merge();
    }
}
