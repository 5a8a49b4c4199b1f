//! Storage of the vertices of a memory: a stack that grows, or one of fixed capacity.

use std::fmt;

use super::lateral::Lateral;
use crate::coulomb::Node;
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

/// The nodes of a curve over the depth: from the bottom, which stands for the deepest part of the contact (depth
/// zero), upwards.
pub trait Nodes<T: Copy> {
    /// Number of nodes.
    fn len(&self) -> usize;

    /// Whether it is empty: the bodies are separated.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The node at an index below [`Nodes::len`], counted from the bottom.
    fn get(&self, index: usize) -> &T;

    /// The node at an index, mutable.
    fn get_mut(&mut self, index: usize) -> &mut T;

    /// Removes all nodes except the lowest `len`; `len` is at most [`Nodes::len`].
    fn truncate(&mut self, len: usize);

    /// The greatest number of nodes.
    fn capacity(&self) -> usize;

    /// Adds a node on top; [`Nodes::len`] must be below [`Nodes::capacity`].
    fn push(&mut self, node: T);

    /// Inserts a node below the one at an index; there must be room for it.
    #[inline]
    fn insert(&mut self, index: usize, node: T) {
        let len = self.len();
        self.push(node);
        for i in (index..len).rev() {
            *self.get_mut(i + 1) = *self.get(i);
        }
        *self.get_mut(index) = node;
    }

    /// Removes the node at an index.
    #[inline]
    fn remove(&mut self, index: usize) {
        let last = self.len() - 1;
        for i in index..last {
            *self.get_mut(i) = *self.get(i + 1);
        }
        self.truncate(last);
    }

    /// Counts a merge of two segments.
    fn count_merge(&mut self);
}

/// Storage of nodes between steps.
pub trait NodeStack<T: Copy>: Nodes<T> + Clone + fmt::Debug + Default + PartialEq {
    /// How often two segments were merged because the storage was full.
    fn merges(&self) -> u32;
}

/// Storage of the vertices of a polyline; it names the storage of the same kind and capacity for the nodes of
/// Coulomb's curve.
pub trait VertexStack<V: Lateral>: NodeStack<Vertex<V>> {
    /// Storage of the nodes of [`CoulombMemory`](crate::coulomb::CoulombMemory).
    type Curve: NodeStack<Node<V>>;
}

impl<V: Lateral> VertexStack<V> for Growing<V> {
    type Curve = GrowingStack<Node<V>>;
}

impl<V: Lateral, const N: usize> VertexStack<V> for Fixed<V, N> {
    type Curve = FixedStack<Node<V>, N>;
}

/// Vertices of a polyline in storage that grows.
pub type Growing<V> = GrowingStack<Vertex<V>>;
/// At most N vertices of a polyline.
pub type Fixed<V, const N: usize> = FixedStack<Vertex<V>, N>;

/// Number of nodes stored inline before the stack uses the heap.
const IN_LINE: usize = 8;

/// A stack of unlimited size: eight nodes inline, more on the heap. It loses no history.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowingStack<T> {
    in_line: [T; IN_LINE],
    len: usize,
    heap: Vec<T>,
}

impl<T: Copy + Default> Default for GrowingStack<T> {
    fn default() -> Self {
        Self { in_line: [T::default(); IN_LINE], len: 0, heap: Vec::new() }
    }
}

impl<T: Copy + Default> Nodes<T> for GrowingStack<T> {
    #[inline]
    fn len(&self) -> usize {
        self.len
    }

    #[inline]
    fn get(&self, index: usize) -> &T {
        if index < IN_LINE { &self.in_line[index] } else { &self.heap[index - IN_LINE] }
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut T {
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
    fn push(&mut self, node: T) {
        match self.in_line.get_mut(self.len) {
            Some(place) => *place = node,
            None => self.heap.push(node),
        }
        self.len += 1;
    }

    fn count_merge(&mut self) {}
}

impl<T: Copy + fmt::Debug + Default + PartialEq> NodeStack<T> for GrowingStack<T> {
    fn merges(&self) -> u32 {
        0
    }
}

/// A stack of at most N nodes (N >= 4): plain data that can be stored in an array of another
/// program.
///
/// When it is full, the law removes the node whose removal changes later loads least: two
/// segments are replaced by one that carries the same force, below the friction limit.
/// [`NodeStack::merges`] counts such merges. In two directions
/// [`CoulombMemory::error_estimate`](crate::coulomb::CoulombMemory::error_estimate) estimates their
/// effect.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct FixedStack<T, const N: usize> {
    // At the front because every step reads it.
    len: u32,
    merges: u32,
    nodes: [T; N],
}

impl<T: Copy + Default, const N: usize> Default for FixedStack<T, N> {
    fn default() -> Self {
        const { assert!(N >= 4, "a memory of fixed capacity needs room for four nodes") };
        Self { nodes: [T::default(); N], len: 0, merges: 0 }
    }
}

impl<T: Copy + Default, const N: usize> Nodes<T> for FixedStack<T, N> {
    #[inline]
    fn len(&self) -> usize {
        self.len as usize
    }

    #[inline]
    fn get(&self, index: usize) -> &T {
        &self.nodes[index]
    }

    #[inline]
    fn get_mut(&mut self, index: usize) -> &mut T {
        &mut self.nodes[index]
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
    fn push(&mut self, node: T) {
        self.nodes[self.len as usize] = node;
        self.len += 1;
    }

    fn count_merge(&mut self) {
        self.merges = self.merges.saturating_add(1);
    }
}

impl<T: Copy + fmt::Debug + Default + PartialEq, const N: usize> NodeStack<T> for FixedStack<T, N> {
    #[inline]
    fn merges(&self) -> u32 {
        self.merges
    }
}
