//! Storage of the vertices of a memory: a stack that grows, or one of fixed capacity.

use super::lateral::Lateral;
use crate::profile::NormalProfile;

/// The lower end of a segment of the memory polyline.
///
/// On the segment that begins here the anchor is `W(s) = anchor + slope (s - depth)`, and the force
/// of the part of the contact deeper than s is `force + force_slope (F_z(s) - F_z(depth))`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Vertex<V> {
    /// The depth z at which the segment begins.
    pub depth: f64,
    /// The anchor W(z).
    pub anchor: V,
    /// The slope m of the anchor, |m| <= 1.
    pub slope: V,
    /// The slope of the force; differs from m only where two segments were merged.
    pub force_slope: V,
    /// The force of the part of the contact deeper than this vertex.
    pub force: V,
    /// `1 - m.m`, exactly zero on slip segments.
    pub curb: f64,
}

impl<V: Lateral> Vertex<V> {
    /// The anchor at a depth on this segment.
    #[inline]
    #[must_use]
    pub fn anchor_at(&self, depth: f64) -> V {
        self.anchor.plus(self.slope.times(depth - self.depth))
    }

    /// The force of the part of the contact deeper than a point of this segment.
    #[inline]
    #[must_use]
    pub fn force_at<P: NormalProfile>(&self, depth: f64, profile: &P) -> V {
        let by = depth - self.depth;
        if by > 0.0 {
            self.force.plus(self.force_slope.times(profile.growth(self.depth, by)))
        } else {
            self.force
        }
    }

    /// Whether it was formed in slip.
    #[inline]
    #[must_use]
    pub fn is_slip(&self) -> bool {
        self.curb == 0.0
    }
}

/// A stack of vertices; the deepest part of the contact (depth zero) is at its bottom.
pub trait VertexStack<V: Lateral>: Clone + Default {
    /// Number of vertices.
    fn len(&self) -> usize;

    /// Whether it is empty: the bodies are separated.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The vertex at an index below [`VertexStack::len`], counted from the bottom.
    fn get(&self, index: usize) -> &Vertex<V>;

    /// The vertex at an index, mutable.
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V>;

    /// Removes all vertices except the lowest `len`; `len` is at most [`VertexStack::len`].
    fn truncate(&mut self, len: usize);

    /// The greatest number of vertices.
    fn capacity(&self) -> usize;

    /// Adds a vertex on top; [`VertexStack::len`] must be below [`VertexStack::capacity`].
    fn push(&mut self, vertex: Vertex<V>);

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

    /// How often two segments were merged because the storage was full.
    fn merges(&self) -> u32;

    /// Counts a merge of two segments.
    fn count_merge(&mut self);
}

/// Number of vertices stored inline before the stack uses the heap.
const IN_LINE: usize = 8;

/// A stack of unlimited size: eight vertices inline, more on the heap. It loses no history.
#[derive(Debug, Clone, PartialEq)]
pub struct Growing<V> {
    in_line: [Vertex<V>; IN_LINE],
    len: usize,
    heap: Vec<Vertex<V>>,
}

impl<V: Lateral> Default for Growing<V> {
    fn default() -> Self {
        Self { in_line: [Vertex::default(); IN_LINE], len: 0, heap: Vec::new() }
    }
}

impl<V: Lateral> VertexStack<V> for Growing<V> {
    #[inline]
    fn len(&self) -> usize {
        self.len
    }

    #[inline]
    fn get(&self, index: usize) -> &Vertex<V> {
        if index < IN_LINE { &self.in_line[index] } else { &self.heap[index - IN_LINE] }
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V> {
        if index < IN_LINE { &mut self.in_line[index] } else { &mut self.heap[index - IN_LINE] }
    }

    #[inline]
    fn truncate(&mut self, len: usize) {
        if self.len > IN_LINE {
            self.heap.truncate(len.saturating_sub(IN_LINE));
        }
        self.len = len;
    }

    #[inline]
    fn capacity(&self) -> usize {
        usize::MAX
    }

    #[inline]
    fn push(&mut self, vertex: Vertex<V>) {
        match self.in_line.get_mut(self.len) {
            Some(place) => *place = vertex,
            None => self.heap.push(vertex),
        }
        self.len += 1;
    }

    fn merges(&self) -> u32 {
        0
    }

    fn count_merge(&mut self) {}
}

/// A stack of at most N vertices (N >= 4): plain data that can be stored in an array of another
/// program.
///
/// When it is full, the law removes the vertex whose removal changes later loads least: two
/// segments are replaced by one that carries the same force, below the friction limit.
/// [`VertexStack::merges`] counts such merges. In two directions
/// [`CoulombMemory::error_estimate`](crate::coulomb::CoulombMemory::error_estimate) estimates their
/// effect.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Fixed<V, const N: usize> {
    // At the front because every step reads it.
    len: u32,
    merges: u32,
    vertices: [Vertex<V>; N],
}

impl<V: Lateral, const N: usize> Default for Fixed<V, N> {
    fn default() -> Self {
        const { assert!(N >= 4, "a memory of fixed capacity needs room for four vertices") };
        Self { vertices: [Vertex::default(); N], len: 0, merges: 0 }
    }
}

impl<V: Lateral, const N: usize> Fixed<V, N> {
    /// The state as plain data: the array of vertices, the number of those in use, and the number
    /// of merges.
    #[must_use]
    pub fn parts(&self) -> (&[Vertex<V>; N], u32, u32) {
        (&self.vertices, self.len, self.merges)
    }
}

impl<V: Lateral, const N: usize> VertexStack<V> for Fixed<V, N> {
    #[inline]
    fn len(&self) -> usize {
        self.len as usize
    }

    #[inline]
    fn get(&self, index: usize) -> &Vertex<V> {
        &self.vertices[index]
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut Vertex<V> {
        &mut self.vertices[index]
    }

    #[inline]
    fn truncate(&mut self, len: usize) {
        self.len = len as u32;
    }

    #[inline]
    fn capacity(&self) -> usize {
        N
    }

    #[inline]
    fn push(&mut self, vertex: Vertex<V>) {
        self.vertices[self.len as usize] = vertex;
        self.len += 1;
    }

    #[inline]
    fn merges(&self) -> u32 {
        self.merges
    }

    fn count_merge(&mut self) {
        self.merges = self.merges.saturating_add(1);
    }
}
