//! Replaces two segments of the memory polyline by one if the storage is full.

use super::{Lateral, Vertex, VertexStack};
use crate::profile::NormalProfile;

/// Adds a vertex on top; if the storage is full, two segments are merged first.
#[inline]
pub(super) fn push<V: Lateral, S: VertexStack<V>, P: NormalProfile>(
    stack: &mut S,
    vertex: Vertex<V>,
    profile: &P,
) {
    if stack.len() == stack.capacity() {
        merge(stack, vertex.depth, profile);
    }
    stack.push(vertex);
}

/// Removes the vertex between the two segments that are closest to a single one: the vertex whose
/// removal changes later loads least, measured by the displacement of the anchor times the
/// stiffness of the springs concerned. The new force slope is the mean over both segments, so that
/// no force changes.
#[cold]
fn merge<V: Lateral, S: VertexStack<V>, P: NormalProfile>(
    stack: &mut S,
    next_depth: f64,
    profile: &P,
) {
    let len = stack.len();
    let end = |i: usize| if i + 1 < len { stack.get(i + 1).depth } else { next_depth };
    let mut best = (f64::INFINITY, 1);
    let stiffness = |depth: f64| profile.stiffness(depth);
    let mut springs = [stiffness(stack.get(0).depth), stiffness(stack.get(1).depth)];
    for i in 1..len {
        let above = stiffness(end(i));
        let growth = above - springs[0];
        let cost = gap(stack.get(i - 1), stack.get(i), end(i)) * (growth * growth);
        if cost < best.0 {
            best = (cost, i);
        }
        springs = [springs[1], above];
    }
    let i = best.1;
    let end = end(i);
    let (below, here) = (*stack.get(i - 1), *stack.get(i));
    let slope = chord(&below, &here, end);
    let growth = here.force_at(end, profile).minus(below.force);
    *stack.get_mut(i - 1) = Vertex {
        slope,
        force_slope: growth.times(1.0 / profile.growth(below.depth, end - below.depth)),
        curb: (1.0 - slope.dot(slope)).max(0.0),
        ..below
    };
    stack.remove(i);
    stack.count_merge();
}

/// The slope of one segment that replaces the two that meet at `here` and extend to `end`.
fn chord<V: Lateral>(below: &Vertex<V>, here: &Vertex<V>, end: f64) -> V {
    here.anchor_at(end).minus(below.anchor).times(1.0 / (end - below.depth))
}

/// The square of the displacement of the anchor. In adhesion the anchor may jump at the vertex.
fn gap<V: Lateral>(below: &Vertex<V>, here: &Vertex<V>, end: f64) -> f64 {
    let line = below.anchor.plus(chord(below, here, end).times(here.depth - below.depth));
    let inner = below.anchor_at(here.depth).minus(line);
    let outer = here.anchor.minus(line);
    inner.dot(inner).max(outer.dot(outer))
}
