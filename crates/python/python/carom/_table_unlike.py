"""R_x of spheres and planes of unlike materials from the stored table, in array code."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from . import _carom, _table
from ._table import Ops
from ._table_losses import evenly

#: Nodes by gamma/f, lambda, D_xx/D_zz, kappa and gamma^2; the first two have equal distances of x/(x + middle).
SPREADS, LAMBDAS, RATIOS, KAPPAS, SQUARES = 25, 25, 9, 5, 4
SPREAD, LAMBDA = (12.0, 1.5), (8.0, 2.0)
RATIO, KAPPA = (1.0, 6.0), (1.0, 1.5)
HEAD = 24


@functools.cache
def stored() -> Any:
    """R_x, a row for each gamma/f and lambda."""
    entries = np.frombuffer(_carom.restitution_tables()[2], "<f4", offset=HEAD)
    return entries.astype(float).reshape(SPREADS * LAMBDAS, RATIOS * KAPPAS * SQUARES)


def lagrange(count: int, x: Any) -> list[Any]:
    """Weights of Chebyshev's points at a place from -1 to 1."""
    points = [-float(np.cos((i + 0.5) * np.pi / count)) for i in range(count)]
    weights = []
    for own in points:
        others = [point for point in points if point != own]
        weight = 1.0 / float(np.prod([own - other for other in others]))
        for other in others:
            weight = weight * (x - other)
        weights.append(weight)
    return weights


def place(span: tuple[float, float], value: Any) -> Any:
    """A value as a place from -1 to 1."""
    return (2.0 * value - (span[1] + span[0])) / (span[1] - span[0])


def even(ops: Ops, value: Any, span: tuple[float, float], count: int) -> tuple[Any, list[Any]]:
    """The first of four nodes about a value, and their weights."""
    most, middle = span
    part = value / (value + middle) * ((most + middle) / most)
    return evenly(ops, ops.where(part < 1.0, part, 1.0) * (count - 1), count)


def restitution(ops: Ops, kappa: Any, lam: Any, gamma: Any, friction: Any, ratio: Any) -> Any:
    """R_x; that of like bodies where gamma = 0, -1 without friction, NaN where the table has none."""
    where = ops.where
    like, without = gamma == 0.0, friction == 0.0
    size = where(gamma < 0.0, -gamma, gamma)
    holds = (kappa >= 0.75) & (kappa <= 1.5 + 1e-12) & (lam >= 0.0) & (size <= 1.5 - kappa + 1e-12) & (friction >= 0.0)
    inside = holds & ~like & ~without & (size <= SPREAD[0] * friction) & (lam <= LAMBDA[0]) & (friction <= 1.0)
    inside = inside & (ratio >= RATIO[0]) & (ratio <= RATIO[1]) & (kappa >= KAPPA[0])
    kappa_in, size_in, f_in = where(inside, kappa, 1.2), where(inside, size, 0.1), where(inside, friction, 0.5)
    kappa_in = where(kappa_in < KAPPA[1], kappa_in, KAPPA[1])
    lam_in, ratio_in = where(inside, lam, 1.0), where(inside, ratio, 3.5)
    spread = size_in / f_in
    most = where(KAPPA[1] - kappa_in < spread, KAPPA[1] - kappa_in, spread)
    some = most > 0.0
    share = where(some, size_in / where(some, most, 1.0), 0.0) ** 2
    # What the table misses of like bodies is taken off in this part.
    part = 1.0 / (1.0 + spread * spread)
    (row, of_spread), (column, of_lambda) = even(ops, spread, SPREAD, SPREADS), even(ops, lam_in, LAMBDA, LAMBDAS)
    rows: Any = 0.0
    for i, weight in enumerate([*of_spread, -part]):
        for j in range(4):
            index = (row + i if i < 4 else 0 * row) * LAMBDAS + column + j
            rows = rows + (weight * of_lambda[j])[..., None] * ops.take(stored(), index)
    by_ratio, by_kappa = lagrange(RATIOS, place(RATIO, ratio_in)), lagrange(KAPPAS, place(KAPPA, kappa_in))
    by_square = lagrange(SQUARES, place((0.0, 1.0), share))
    coupled: Any = 0.0
    for i in range(RATIOS):
        for j in range(KAPPAS):
            begin = (i * KAPPAS + j) * SQUARES
            line = sum(by_square[k] * rows[..., begin + k] for k in range(SQUARES))
            coupled = coupled + by_ratio[i] * by_kappa[j] * line
    alike = _table.restitution(ops, _table.stored(), ratio / kappa, lam / kappa)
    value = coupled + part * alike
    value = where(value > 1.0, 1.0, where(value < -1.0, -1.0, value))
    return where(holds, where(without, -1.0, where(like, alike, where(inside, value, float("nan")))), float("nan"))
