"""A contact with memory in one direction, in array code: the exact law, with storage for a fixed number of annuli."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._table import Ops


class ContactState(NamedTuple):
    """The memory of contacts: approach and shift (m), and the curve of shifts without traction over the depth.

    `depth` and `anchor` have one axis more, over the nodes of the curve, of which the first `count` are used.
    """

    zeta: Any
    xi: Any
    depth: Any
    anchor: Any
    count: Any


def segment(ops: Ops, values: Any, index: Any, at: Any) -> Any:
    """The value at a place of the last axis."""
    return ops.where(index == at[..., None], values, 0.0).sum(-1)


def crossing(ops: Ops, low: Any, high: Any) -> Any:
    """The part of a segment at which what is `low` at its lower end, not below 0, and `high` at its upper falls to 0."""
    falls = low > high
    return ops.where(falls, low / ops.where(falls, low - high, 1.0), 0.0)


def moved(ops: Ops, state: ContactState, zeta: Any, xi: Any, slope: Any) -> ContactState:
    """The memory after a straight step; `slope` is f c_z/c_x, shift over approach of a contact that slides."""
    where = ops.where
    index = ops.index(state.depth)
    touches, meets = zeta > 0.0, ~(state.zeta > 0.0)
    # Where the bodies touch first the curve is one point.
    gap = where(meets & touches, state.zeta / where(meets & touches, state.zeta - zeta, 1.0), 0.0)
    first = state.xi + gap * (xi - state.xi)
    start, come = where(meets, 0.0, state.zeta), where(meets, first, state.xi)
    depth, anchor = state.depth, state.anchor
    before = where(meets, 0, state.count)
    # Of the old curve the part within the new contact counts.
    end = where(zeta < start, zeta, start)
    count = where((index < before[..., None]) & (depth < end[..., None]), 1, 0).sum(-1)
    some = count > 0
    last = where(some, count - 1, 0)
    low = [segment(ops, values, index, last) for values in (depth, anchor)]
    has_node = count < before
    high = [where(has_node, segment(ops, values, index, count), tip) for values, tip in ((depth, start), (anchor, come))]
    cut = where(some, low[1] + (high[1] - low[1]) * crossing(ops, end - low[0], end - high[0]), come)
    # Beyond the cone of friction about the new point an annulus slips: always an outer part of the contact.
    inside = (index < count[..., None]) & (abs(xi[..., None] - anchor) <= slope[..., None] * (zeta[..., None] - depth))
    kept = where(inside, 1, 0).sum(-1)
    holds = (kept == count) & (abs(xi - cut) <= slope * (zeta - end))
    begin = where(kept > 0, kept - 1, 0)
    low = [segment(ops, values, index, begin) for values in (depth, anchor)]
    is_top = kept >= count
    high = [where(is_top, tip, segment(ops, values, index, kept)) for values, tip in ((depth, end), (anchor, cut))]
    sign = where(xi >= high[1], 1.0, -1.0)
    slack = [slope * (zeta - s) - sign * (xi - w) for s, w in (low, high)]
    part = crossing(ops, slack[0], slack[1])
    slides = (kept == 0) & ~holds
    front = [where(holds, tip, a + part * (b - a)) for a, b, tip in zip(low, high, (end, cut))]
    front = [where(slides, 0.0, front[0]), where(slides, xi - sign * slope * zeta, front[1])]
    is_new = index == kept[..., None]
    depth = where(index < kept[..., None], depth, where(is_new, front[0][..., None], 0.0))
    anchor = where(index < kept[..., None], anchor, where(is_new, front[1][..., None], 0.0))
    return ContactState(zeta, xi, depth, anchor, where(touches, kept + 1, 0))


def load(ops: Ops, state: ContactState, stiffness: tuple[Any, Any]) -> tuple[Any, Any]:
    """F_x and F_z; NaN where the memory has more nodes than there is room for."""
    where = ops.where
    c_x, c_z = stiffness
    size = state.depth.shape[-1]
    index = ops.index(state.depth)
    zeta = where(state.zeta > 0.0, state.zeta, 0.0)
    used = index < state.count[..., None]
    # The upper end of each segment: the next node, or the edge.
    tip = index == (state.count - 1)[..., None]
    after = [where(tip, top[..., None], ops.shifted(values)) for values, top in ((state.depth, zeta), (state.anchor, state.xi))]
    long = used & (after[0] > state.depth)
    a, b = where(long, state.depth, 0.0), where(long, after[0], 1.0)
    low = where(a > 0.0, where(a > 0.0, a, 1.0) ** 0.5, 0.0)
    high = b**0.5
    w_a, w_b = where(long, state.anchor, 0.0), where(long, after[1], 0.0)
    steep = (w_b - w_a) / (b - a)
    # The integral of xi - W over sqrt(s).
    parts = (state.xi[..., None] - w_a + steep * a) * (high - low) - steep * (high * b - low * a) / 3.0
    force = c_x * where(long, parts, 0.0).sum(-1)
    normal = 2.0 / 3.0 * c_z * zeta * where(zeta > 0.0, where(zeta > 0.0, zeta, 1.0) ** 0.5, 0.0)
    return where(state.count < size, force, float("nan")), normal
