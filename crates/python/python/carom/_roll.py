"""Rolling contact of any gap on a grid."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import blocks, line, number, numbers, two
from ._carom import Material, MaterialPair
from ._case_results import Rolled, gridded
from ._friction import SlipSpeedFriction, by_speed
from ._records import RollStates
from ._validity import warn

MOTIONS = (("zeta", "F_z"), ("creepage", "F_x"), ("creepage_across", "F_y"), ("spin", "M_z"))
UNITS = {"zeta": "m", "F_z": "N", "F_x": "N", "F_y": "N", "spin": "rad/m", "M_z": "N*m"}


def roll(
    gap: ArrayLike,
    size: tuple[float, float],
    materials: MaterialPair | Material,
    friction: ArrayLike | SlipSpeedFriction,
    *,
    zeta: ArrayLike | None = None,
    F_z: ArrayLike | None = None,
    creepage: ArrayLike | None = None,
    F_x: ArrayLike | None = None,
    creepage_across: ArrayLike | None = None,
    F_y: ArrayLike | None = None,
    spin: ArrayLike | None = None,
    M_z: ArrayLike | None = None,
    direction: float = 0.0,
    step: float | None = None,
    spin_offset: float = 0.0,
    distance: float | None = None,
    speed: float = 1.0,
    tolerance: float = 1e-9,
    cut: bool = False,
    influence: Mapping[str, ArrayLike] | None = None,
) -> Rolled:
    """Rolls two bodies on each other: creep forces in the steady state, or step by step from rest.

    `gap`, `size`, `materials`, `friction`, `tolerance`, `cut` and `influence` are those of `Solver`. The contact moves over the bodies
    in the `direction` from +x towards +y (degrees). Each motion is given by its creepage (motion of body 2 against body 1
    per distance rolled; spin in rad/m) or by its load on body 1: numbers, or arrays of one shape (n,) for n rows. What is
    not given is a creepage of 0. Friction cannot hold loads above its limit: `CaromError`.

    `step` is the distance at which the surfaces are compared, by default the width of a cell; `spin_offset` the place in
    it at which a spin shifts them, from 0 at its end to 1 at its start. With a `distance` (m) the contact rolls from rest
    by one value of each motion. With a `SlipSpeedFriction` each cell has the friction of its own slip at the `speed`, in the
    steady state that is reached from rest.

    A steel ball, braked by a given force:

    >>> import carom
    >>> steel = carom.MaterialPair(carom.Material(208e9, 0.3))
    >>> x, y = carom.cells((40, 40), size=(3e-4, 3e-4))
    >>> rolled = carom.roll((x**2 + y**2) / (2 * 0.01), (3e-4, 3e-4), steel, 0.3, F_z=10.0, F_x=[0.0, -1.0, -2.0])
    >>> bool(rolled.rows.creepage[2] < 2 * rolled.rows.creepage[1] < 0)  # beyond proportion
    True
    >>> rolled.rows.F_x.round(6)
    array([ 0., -1., -2.])
    """
    heights = numbers("gap", gap, "m")
    if heights.ndim != 2:
        raise ValueError(f"gap has {heights.ndim} dimensions: must be an array (ny, nx)")
    ny, nx = heights.shape
    by_slip = by_speed(friction)
    rest = friction.a + friction.b if isinstance(friction, SlipSpeedFriction) else friction
    fine = numbers("friction", rest)
    if fine.shape not in ((), (ny, nx)):
        raise ValueError(f"friction has the shape {fine.shape}: must be a number or {(ny, nx)}")
    width, height = two("size", size, "m")
    given = _given(
        ((zeta, F_z), (creepage, F_x), (creepage_across, F_y), (spin, M_z)), distance is not None
    )
    cell = [width / max(nx, 1), height / max(ny, 1)]
    rows, (fields, states), (exceeded, is_outside), others = _carom.roll(
        [nx, ny],
        cell,
        line(heights),
        materials,
        line(fine),
        by_slip,
        given,
        math.radians(number("direction", direction, "deg")),
        number("spin_offset", spin_offset),
        None if step is None else number("step", step, "m"),
        None if distance is None else number("distance", distance, "m"),
        number("speed", speed, "m/s"),
        number("tolerance", tolerance),
        bool(cut),
        blocks(influence),
    )
    warn((exceeded + others, is_outside))
    axes = [(np.arange(n) - 0.5 * (n - 1)) * d for n, d in zip((nx, ny), cell, strict=True)]
    return Rolled(
        {
            "rows": RollStates._shaped(rows, (len(rows["creepage"]),)),
            "coefficients": None,
            **gridded(axes, fields, states, exceeded + others),
        }
    )


def _given(
    values: tuple[tuple[ArrayLike | None, ArrayLike | None], ...], is_single: bool
) -> list[tuple[bool, np.typing.NDArray[np.float64]]]:
    """What drives each row: for each motion whether it is a load, and its values."""
    chosen = []
    for (shift, load), names in zip(values, MOTIONS, strict=True):
        if shift is not None and load is not None:
            raise ValueError(f"{names[0]} and {names[1]} are both given: give one of them")
        if shift is None and load is None and names[0] == "zeta":
            raise ValueError("zeta or F_z must be given")
        name, value = (names[1], load) if load is not None else (names[0], shift)
        chosen.append((load is not None, name, numbers(name, 0.0 if value is None else value, UNITS.get(name, ""))))
    shapes = {array.shape for _, _, array in chosen if array.ndim}
    if len(shapes) > 1 or any(len(shape) > 1 for shape in shapes):
        told = ", ".join(f"{name} {array.shape}" for _, name, array in chosen if array.ndim)
        raise ValueError(f"{told}: must be numbers or arrays of one shape (n,)")
    shape = shapes.pop() if shapes else (1,)
    if is_single and shape != (1,):
        raise ValueError(f"distance: rolling from rest takes one value of each motion, not {shape[0]}")
    return [(is_load, line(np.broadcast_to(array, shape))) for is_load, _, array in chosen]
