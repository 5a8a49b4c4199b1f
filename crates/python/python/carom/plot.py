"""Plots with matplotlib, an optional dependency: `pip install carom[plot]`.

Each function draws into the given axes (`axes` or `ax`), or into new ones, and returns them. Colours can be told apart by the colour
blind, curves also by their dashes. matplotlib is imported when a function is called.

>>> import carom
>>> steel = carom.MaterialPair(carom.Material(208e9, 0.3))
>>> x, y = carom.cells((32, 32), size=(3e-4, 3e-4))
>>> solver = carom.Solver((x**2 + y**2) / 0.02, (3e-4, 3e-4), steel, friction=0.3)
>>> step = solver.step(F_z=10.0)
>>> axes = carom.plot.pressure(solver)  # doctest: +SKIP
"""

from __future__ import annotations

from itertools import cycle
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import numbers
from ._case_results import Gridded
from ._contact_theory import restitution as r_x
from ._records import HistoryPoints
from ._solver import Solver, cells
from ._types import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: A solver after a step, or the result of a case.
Grid = Union[Solver, Gridded]

__all__ = ["history", "loop", "pressure", "restitution", "stick_slip", "tractions"]

#: Okabe and Ito's colours, in the order of the command's pictures.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#333333")
#: From zero to the largest value, the warm half of the command's colours of fields.
FIELD = ("#F7F7F7", "#FDAE6B", "#A63603")
DASHES = ("-", "--", "-.", ":")
#: Largest number of arrows along an axis.
ARROWS = 18
PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))


def __dir__() -> list[str]:
    return __all__


def _axes(axes: Axes | None, ax: Axes | None) -> Axes:
    if axes is not None and ax is not None:
        raise TypeError("axes and ax are both given: they are the same argument")
    axes = ax if axes is None else axes
    if axes is None:
        from matplotlib import pyplot

        axes = pyplot.subplots(layout="constrained")[1]
    return axes


def _curves(axes: Axes, x: Array, curves: dict[str, Array]) -> None:
    """A curve for each name, which differ in colour and dashes."""
    for (name, y), colour, dash in zip(curves.items(), cycle(COLOURS), cycle(DASHES)):
        axes.plot(x, y, color=colour, linestyle=dash, label=name)


def _scaled(values: Array, unit: str) -> tuple[Array, str]:
    """Values in a unit with a prefix, so that the largest lies between 1 and 1000; and that unit."""
    values = np.asarray(values)
    largest = float(np.abs(values).max(initial=0.0))
    factor, prefix = next(((f, p) for f, p in PREFIXES if largest >= f), (1.0, ""))
    return values / factor, prefix + unit


def _places(of: Grid) -> tuple[Array, Array, str]:
    """x and y of the cell centres, (nx,) and (ny,), and their unit."""
    if isinstance(of, Gridded):
        x, y = of.x, of.y
    else:
        across, up = cells(of.shape, of.size)
        x, y = across[0], up[:, 0]
    both, unit = _scaled(np.concatenate([x, y]), "m")
    return both[: len(x)], both[len(x) :], unit


def _map(of: Grid, axes: Axes, title: str) -> tuple[Axes, Array, Array]:
    """Axes of a picture of the contact, and the cell centres in their unit; the view is the contact with a margin."""
    if not hasattr(of, "cells") or not hasattr(of, "pressure"):
        what = "a Solver after a step, or a case that was solved or rolled"
        raise TypeError(f"of: must be {what}, not {type(of).__name__}")
    x, y, unit = _places(of)
    axes.set(xlabel=f"x / {unit}", ylabel=f"y / {unit}", title=title, aspect="equal")
    touching = of.cells > 0
    if touching.any():
        for places, along, limit in ((x, 0, axes.set_xlim), (y, 1, axes.set_ylim)):
            inside = places[touching.any(axis=along)]
            half = 0.5 * (places[1] - places[0]) if len(places) > 1 else 0.5
            margin = 0.08 * (inside[-1] - inside[0]) + half
            low, high = max(inside[0] - margin, places[0] - half), min(inside[-1] + margin, places[-1] + half)
            limit(low, high)
    return axes, x, y


def _field(axes: Axes, x: Array, y: Array, of: Grid, values: Array, name: str) -> None:
    """Values that are not negative as colours within the contact, with a bar."""
    from matplotlib.colors import LinearSegmentedColormap

    scaled, unit = _scaled(values, "Pa")
    colours = LinearSegmentedColormap.from_list("carom", FIELD)
    shown = np.ma.masked_where(of.cells == 0, scaled)
    drawn = axes.pcolormesh(x, y, shown, cmap=colours, vmin=0.0, vmax=float(scaled.max(initial=0.0)) or 1.0)
    axes.figure.colorbar(drawn, ax=axes, label=f"{name} / {unit}")


def pressure(of: Grid, axes: Axes | None = None, *, ax: Axes | None = None) -> Axes:
    """The pressure of a contact on a grid, of a `Solver` after a step, or of a case that was solved or rolled."""
    axes, x, y = _map(of, _axes(axes, ax), "pressure")
    _field(axes, x, y, of, of.pressure, "p")
    return axes


def stick_slip(of: Grid, axes: Axes | None = None, *, ax: Axes | None = None) -> Axes:
    """Where the contact sticks and where it slips."""
    from matplotlib.colors import BoundaryNorm, ListedColormap
    from matplotlib.patches import Patch

    axes, x, y = _map(of, _axes(axes, ax), "stick and slip")
    colours = {"sticks": COLOURS[0], "slips": COLOURS[4]}
    states = np.ma.masked_equal(of.cells, 0)
    axes.pcolormesh(x, y, states, cmap=ListedColormap(list(colours.values())), norm=BoundaryNorm([0.5, 1.5, 2.5], 2))
    present = [i in of.cells for i in (1, 2)]
    names = [Patch(color=colour, label=name) for (name, colour), is_there in zip(colours.items(), present) if is_there]
    axes.legend(handles=names, loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    return axes


def tractions(of: Grid, axes: Axes | None = None, *, ax: Axes | None = None) -> Axes:
    """The size of the tangential tractions on body 1, with arrows in their direction."""
    axes, x, y = _map(of, _axes(axes, ax), "tractions on body 1")
    size = np.hypot(of.traction_x, of.traction_y)
    _field(axes, x, y, of, size, "traction")
    rows, columns = np.nonzero(of.cells)
    if size.any():
        each = 1 + int(max(np.ptp(rows), np.ptp(columns))) // ARROWS
        some = (rows % each == 0) & (columns % each == 0) & (size[rows, columns] > 1e-3 * size.max())
        rows, columns = rows[some], columns[some]
        u, v = (traction[rows, columns] / size.max() for traction in (of.traction_x, of.traction_y))
        reach = 0.9 * each * min(abs(x[1] - x[0]), abs(y[1] - y[0]))
        arrows: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "pivot": "mid", "width": 0.004}
        axes.quiver(x[columns], y[rows], u * reach, v * reach, color=COLOURS[-1], scale=1.0, **arrows)
    return axes


def restitution(kappa: ArrayLike, lam: ArrayLike, axes: Axes | None = None, *, ax: Axes | None = None) -> Axes:
    """R_x of spheres over lambda, one curve for each kappa; see `carom.restitution`."""
    axes, over = _axes(axes, ax), numbers("lam", lam)
    _curves(axes, over, {f"κ = {one:.4g}": np.asarray(r_x(one, over)) for one in np.atleast_1d(numbers("kappa", kappa))})
    axes.grid(color="#E4E4E4")
    axes.set(xlabel=r"$\lambda$", ylabel="$R_x$")
    axes.legend()
    return axes


def history(course: HistoryPoints, axes: Axes | None = None, *, ax: Axes | None = None) -> Axes:
    """The forces on body 1 in the course of an impact; a component that is zero throughout is left out."""
    if not isinstance(course, HistoryPoints):
        raise TypeError(f"course: must be what carom.history(...) returns, not {type(course).__name__}")
    axes = _axes(axes, ax)
    time, unit = _scaled(course.time, "s")
    force, newton = _scaled(course.F, "N")
    curves = {f"$F_{name}$": force[:, i] for i, name in enumerate("xyz")}
    _curves(axes, time, {name: curve for name, curve in curves.items() if curve.any()})
    axes.grid(color="#E4E4E4")
    axes.set(xlabel=f"time / {unit}", ylabel=f"force / {newton}")
    axes.legend()
    return axes


def loop(shift: ArrayLike, loads: ArrayLike, axes: Axes | None = None, *, ax: Axes | None = None) -> Axes:
    """The tangential force F_x of a contact over its shift, with loads as `Contact.follow` returns them."""
    axes = _axes(axes, ax)
    across, unit = _scaled(numbers("shift", shift, "m"), "m")
    force, newton = _scaled(numbers("loads", loads, "N")[..., 0], "N")
    axes.plot(across, force, color=COLOURS[0])
    axes.grid(color="#E4E4E4")
    axes.set(xlabel=rf"$\xi$ / {unit}", ylabel=rf"$F_x$ / {newton}")
    return axes
