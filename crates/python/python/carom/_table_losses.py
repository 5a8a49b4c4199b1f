"""R_x of a viscous material from the stored table, in array code."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from . import _carom, _table
from ._table import Ops

#: Restitutions of the table, after that of elastic bodies, and its nodes of chi, of psi to 1 and of psi beyond.
LOSSES = np.array([1.0, 0.99, 0.98, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1])
CHIS, PSIS, PSIS_BEYOND = 25, 17, 33
#: The range of chi, whose logarithms have equal distances.
CHI = (0.66, 6.5)


@functools.cache
def stored() -> Any:
    """R_x by restitution, chi and psi, in one row."""
    return np.frombuffer(_carom.restitution_tables()[1], "<f4").astype(float)


def cubic(t: Any) -> list[Any]:
    """Weights of four nodes at 0, 1, 2 and 3."""
    a, b, c, d = t, t - 1.0, t - 2.0, t - 3.0
    return [-b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0, a * b * c / 6.0]


def evenly(ops: Ops, place: Any, count: int) -> tuple[Any, list[Any]]:
    """The first of four nodes about a place, and their weights."""
    first = ops.integer(ops.where(place >= 1.0, place, 1.0)) - 1
    first = ops.where(first < count - 4, first, count - 4)
    return first, cubic(place - first)


def of_losses(ops: Ops, e: Any) -> tuple[Any, list[Any]]:
    """The first of four restitutions about e, and their weights."""
    below = sum(ops.where(e <= float(loss), 1, 0) for loss in LOSSES[1:])
    first = ops.where(below >= 1, below - 1, 0)
    first = ops.where(first < len(LOSSES) - 4, first, len(LOSSES) - 4)
    nodes = [ops.take(LOSSES, first + k) for k in range(4)]
    weights = []
    for own in nodes:
        weight = 1.0 + 0.0 * e
        for other in nodes:
            if other is not own:
                weight = weight * (e - other) / (own - other)
        weights.append(weight)
    return first, weights


def border(ops: Ops, chi: Any, e: Any) -> Any:
    """psi from which the contact slides throughout."""
    own = chi * (1.0 + e) - e
    return ops.where(own > 1.0, own, 1.0)


def restitution(ops: Ops, chi: Any, psi: Any, e: Any) -> Any:
    """R_x(chi, psi) with a normal restitution; NaN where the table has none: e below .1, chi outside .66 to 6.5."""
    where = ops.where
    elastic = e >= 1.0
    slides = psi >= border(ops, chi, e)
    inside = ~slides & ~elastic & (psi >= 0.0) & (chi >= CHI[0]) & (chi <= CHI[1]) & (e >= LOSSES[-1])
    chi_in, psi_in, e_in = where(inside, chi, 3.0), where(inside, psi, 0.5), where(inside, e, 0.5)
    sticks = psi_in < 1.0
    part = where(sticks, 0.0, (psi_in - 1.0) / (where(sticks, 2.0, border(ops, chi_in, e_in)) - 1.0))
    column, of_chi = evenly(ops, ops.log(chi_in / CHI[0]) * ((CHIS - 1) / float(np.log(CHI[1] / CHI[0]))), CHIS)
    # psi up to 1, and its part beyond, have nodes of their own.
    rows = [evenly(ops, where(sticks, psi_in, 0.5) * (PSIS - 1), PSIS), evenly(ops, part * (PSIS_BEYOND - 1), PSIS_BEYOND)]
    row = where(sticks, rows[0][0], rows[1][0] + PSIS)
    of_psi = [where(sticks, one, other) for one, other in zip(rows[0][1], rows[1][1])]
    first, of_e = of_losses(ops, e_in)
    alike = _table.restitution(ops, _table.stored(), where(elastic, chi, chi_in), where(
        elastic, psi, where(sticks, psi_in, 1.0 + part * (border(ops, chi_in, 1.0) - 1.0))))
    width = PSIS + PSIS_BEYOND
    value = 0.0
    for k in range(4):
        loss = where(first + k >= 1, first + k - 1, 0)
        start = (loss * CHIS + column) * width + row
        own = sum(
            of_chi[i] * sum(of_psi[j] * ops.take(stored(), start + (width * i + j)) for j in range(4)) for i in range(4)
        )
        value = value + of_e[k] * where(first + k >= 1, own, alike)
    slid = chi * (1.0 + e) / where(slides, psi, 1.0) - 1.0
    found = where(slides, slid, where(inside, value, float("nan")))
    return where(elastic, alike, where((e >= 0.0) & (psi >= 0.0) & (chi > 0.0), found, float("nan")))
