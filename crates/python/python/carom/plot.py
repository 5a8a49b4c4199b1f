"""Plots with matplotlib, an optional dependency: `pip install carom[plot]`.

Each function draws into the given axes, or into new ones, and returns them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ._contact_theory import restitution as r_x
from ._records import HistoryPoint, Rebound, HertzState

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def _axes(axes: Axes | None) -> Axes:
    if axes is None:
        from matplotlib import pyplot

        axes = pyplot.subplots(layout="constrained")[1]
    return axes


def _label(record: type[HistoryPoint | Rebound | HertzState], name: str) -> str:
    unit = record.units[name]
    return f"{name} / {unit}" if unit else name


def restitution(kappa: ArrayLike, lam: ArrayLike, axes: Axes | None = None) -> Axes:
    """R_x of spheres over lambda, one curve for each kappa."""
    axes = _axes(axes)
    for one in np.atleast_1d(kappa):
        axes.plot(lam, r_x(one, lam), label=f"κ = {one:.4g}")
    axes.set(xlabel="λ", ylabel="R_x")
    axes.legend()
    return axes


def history(course: HistoryPoint, axes: Axes | None = None) -> Axes:
    """The forces of an impact over time."""
    axes = _axes(axes)
    for i, name in enumerate("xyz"):
        axes.plot(course.time, course.F[:, i], label=f"F_{name}")
    axes.set(xlabel=_label(HistoryPoint, "time"), ylabel=_label(HistoryPoint, "F"))
    axes.legend()
    return axes


def loop(shift: ArrayLike, loads: ArrayLike, axes: Axes | None = None) -> Axes:
    """The tangential force of a contact over its shift, as returned by `Contact.follow`."""
    axes = _axes(axes)
    axes.plot(shift, np.asarray(loads)[:, 0])
    axes.set(xlabel="xi / m", ylabel="F_x / N")
    return axes
