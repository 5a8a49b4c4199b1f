"""R_x of the stored table in array code that other libraries can differentiate and compile."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from . import _carom

#: Coefficients of a polynomial in one direction, and rows and columns of the first cells of a region.
ORDER, FIRST = 8, 4
#: The range of chi in the table, and regions of chi and psi in its order.
CHI = (0.5, 6.5)
STICK_LOW, STICK_BACK, STICK_FORTH, SLIDE_BACK, SLIDE_FORTH, SLIDE_FAR, SLIDE_SLIP = range(7)
#: Kinds of nodes: without a polynomial, with one, halved along chi; halved across beyond.
EXACT, LEAF, ACROSS_CHI = range(3)


class Ops(Protocol):
    """What a library of arrays does."""

    def where(self, condition: Any, one: Any, other: Any) -> Any: ...
    def take(self, table: Any, index: Any) -> Any: ...
    def integer(self, values: Any) -> Any: ...
    def log(self, values: Any) -> Any: ...
    def index(self, values: Any) -> Any: ...
    def zeros(self, shape: tuple[int, ...]) -> Any: ...
    def shifted(self, values: Any) -> Any: ...
    def broadcast(self, values: list[Any]) -> list[Any]: ...
    def stack(self, parts: list[Any]) -> Any: ...


@dataclass(frozen=True)
class Table:
    """The table as arrays: two curves between regions, the tree of cells, and Chebyshev coefficients of its leaves."""

    stick: Any
    slide: Any
    far: float
    kinds: Any
    values: Any
    leaves: Any
    depth: int


@functools.cache
def stored() -> Table:
    """The table of the library."""
    data = _carom.restitution_tables()[0]
    numbers = np.frombuffer(data, "<f8", 2 * ORDER + 1)
    at = numbers.nbytes
    nodes, leaves = np.frombuffer(data, "<u4", 2, at)
    words = np.frombuffer(data, "<u4", nodes, at + 8)
    one = np.dtype([("constant", "<f8"), ("unit", "<f8"), ("rest", "<i4", ORDER * ORDER - 1)])
    rows = np.frombuffer(data, one, leaves, at + 8 + 4 * int(nodes))
    flat = np.concatenate([rows["constant"][:, None], rows["rest"] * rows["unit"][:, None]], axis=1)
    kinds, values = (words & 3).astype(np.int64), (words >> 2).astype(np.int64)
    # The longest way from a first cell to a leaf.
    depth, level = 0, np.arange(7 * FIRST * FIRST)
    while len(level := level[kinds[level] >= ACROSS_CHI]):
        level, depth = np.concatenate([values[level], values[level] + 1]), depth + 1
    stick, slide = numbers[:ORDER].copy(), numbers[ORDER : 2 * ORDER].copy()
    return Table(stick, slide, float(numbers[-1]), kinds, values, flat.reshape(-1).copy(), depth)


def chebyshev(x: Any) -> list[Any]:
    """T_0 to T_7."""
    t2 = 2.0 * x * x - 1.0
    t3 = x * (2.0 * t2 - 1.0)
    t4 = 2.0 * t2 * t2 - 1.0
    t5 = 2.0 * t2 * t3 - x
    return [1.0, x, t2, t3, t4, t5, 2.0 * t3 * t3 - 1.0, 2.0 * t3 * t4 - x]


def on_curve(coefficients: Any, t: Any) -> Any:
    """chi of a curve at t from 0 to 1."""
    return sum(float(one) * by for one, by in zip(coefficients, chebyshev(2.0 * t - 1.0)))


def locate(ops: Ops, table: Table, chi: Any, psi: Any) -> tuple[Any, Any, Any]:
    """The region of a point that does not slide throughout, and the place in it; both from 0 to 1."""
    where = ops.where
    sticks, low = psi < 1.0, chi < 1.0
    # Values of branches that are not taken are replaced by harmless ones, so that derivatives are finite.
    y = where(sticks, psi, 0.5)
    curve = on_curve(table.stick, y)
    high = where(sticks & ~low, chi, 0.5 * (CHI[1] + curve))
    back = high < curve
    x = where(low, (chi - CHI[0]) / (1.0 - CHI[0]), where(back, (high - 1.0) / (curve - 1.0), (high - curve) / (CHI[1] - curve)))
    stuck = where(low, STICK_LOW, where(back, STICK_BACK, STICK_FORTH))
    chi = where(sticks, 3.0, chi)
    share = where(sticks, 0.5 * table.far, (psi - 1.0) / (chi - 1.0))
    whole = (chi - 1.0) / (CHI[1] - 1.0)
    slips, far = ~sticks & (psi >= chi), share >= table.far
    near = where(far, 0.5, share / table.far)
    moves = near > 0.0
    root = where(moves, where(moves, near, 1.0) ** 0.2, 0.0)
    curve = on_curve(table.slide, near)
    behind = chi < curve
    across = where(behind, (chi - 1.0) / (curve - 1.0), (chi - curve) / (CHI[1] - curve))
    region = where(slips, SLIDE_SLIP, where(far, SLIDE_FAR, where(behind, SLIDE_BACK, SLIDE_FORTH)))
    place = where(slips, share - 1.0, where(far, (share - table.far) / (1.0 - table.far), root))
    return (
        where(sticks, stuck, region),
        where(sticks, x, where(slips | far, whole, across)),
        where(sticks, y, place),
    )


def leaf(ops: Ops, table: Table, region: Any, x: Any, y: Any) -> tuple[Any, Any, Any]:
    """The node of a place, and the position in its cell from -1 to 1."""
    x, y = FIRST * x, FIRST * y
    column, row = (ops.integer(ops.where(one < FIRST, one, FIRST - 0.5)) for one in (x, y))
    index = ops.integer(region) * (FIRST * FIRST) + column * FIRST + row
    x, y = 2.0 * (x - column) - 1.0, 2.0 * (y - row) - 1.0
    for _ in range(table.depth):
        kind, first = ops.take(table.kinds, index), ops.take(table.values, index)
        along, across = kind == ACROSS_CHI, kind > ACROSS_CHI
        place = ops.where(along, x, y)
        child = ops.where(place < 0.0, 0, 1)
        halved = 2.0 * place + ops.where(place < 0.0, 1.0, -1.0)
        index = ops.where(along | across, first + child, index)
        x, y = ops.where(along, halved, x), ops.where(across, halved, y)
    return index, x, y


def restitution(ops: Ops, table: Table, chi: Any, psi: Any) -> Any:
    """R_x(chi, psi); NaN where the table has none: chi outside 0.5 to 6.5, psi < 0, and some cells with chi > 5.2."""
    slides = (psi >= 1.0) & (psi >= 2.0 * chi - 1.0)
    fits = (chi >= CHI[0]) & (chi <= CHI[1]) & (psi >= 0.0)
    inside = fits & ~slides
    region, x, y = locate(ops, table, ops.where(inside, chi, 3.0), ops.where(inside, psi, 0.5))
    index, x, y = leaf(ops, table, region, x, y)
    begin = ops.take(table.values, index) * (ORDER * ORDER)
    by_x, by_y = chebyshev(x), chebyshev(y)
    value = 0.0 * x
    for j in range(ORDER):
        row = sum(ops.take(table.leaves, begin + (ORDER * j + i)) * by_x[i] for i in range(ORDER))
        value = value + by_y[j] * row
    known = inside & (ops.take(table.kinds, index) == LEAF)
    sliding = 2.0 * chi / ops.where(slides, psi, 1.0) - 1.0
    return ops.where(slides, sliding, ops.where(known, value, float("nan")))
