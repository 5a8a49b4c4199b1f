//! Two segments of chapter 7's polyline in the place of one, for want of room.

use super::{Lateral, Vertex, VertexStack};
use crate::profile::NormalProfile;

/// Puts a vertex on top; where there is no room, two segments become one.
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

/// Takes out the vertex between the two segments that are most nearly one: where a load to come may change
/// least, by the anchor's move times the stiffness of the springs that it moves. The slope of the force
/// over both takes the place of theirs, so that no force changes.
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

/// The slope of one segment in place of the two that meet at `here` and reach up to `end`.
fn chord<V: Lateral>(below: &Vertex<V>, here: &Vertex<V>, end: f64) -> V {
    here.anchor_at(end).minus(below.anchor).times(1.0 / (end - below.depth))
}

/// The square of the anchor's move. In adhesion it may jump at the vertex.
fn gap<V: Lateral>(below: &Vertex<V>, here: &Vertex<V>, end: f64) -> f64 {
    let line = below.anchor.plus(chord(below, here, end).times(here.depth - below.depth));
    let inner = below.anchor_at(here.depth).minus(line);
    let outer = here.anchor.minus(line);
    inner.dot(inner).max(outer.dot(outer))
}
