"""Walls of triangles."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _carom, _show
from ._arrays import number, numbers, spread, within
from ._types import Array

if TYPE_CHECKING:
    from collections.abc import Callable

KINDS = np.array(["face", "edge", "corner"])


class Places(NamedTuple):
    """Places where balls touch a surface: index of the ball, point (m), unit normal from there to its centre, distance of
    the centre (m), what is touched ('face', 'edge' or 'corner'), and whether the triangles there meet at more than the smooth
    angle, or end."""

    ball: NDArray[np.int64]
    point: Array
    normal: Array
    distance: Array
    kind: NDArray[np.str_]
    is_sharp: NDArray[np.bool_]


def _finite(name: str, values: Array) -> Array:
    for value in values[~np.isfinite(values)]:
        within(name, float(value), False, "finite")
    return values


class TriangleMesh:
    """A surface of triangles, as a wall: where balls touch it.

    `triangles` is an array (n, 3, 3) of corners (m), in any order, as `mesh.triangles` of trimesh or `vectors` of numpy-stl.
    Corners with the same coordinates are one, triangles in one plane are one face, and both sides count. A ball touches
    where the surface is nearer to its centre than anywhere close by, in several places if need be. Places whose normals
    differ by less than the angle `smooth` (rad) are one: a ball rolls over a finely triangulated surface with one contact.
    With `period`, three lengths (m) of which any may be 0, the surface repeats itself along the axes.

    A ball that falls on a floor of two triangles:

    >>> import carom
    >>> floor = carom.TriangleMesh([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 0, 0], [1, 1, 0], [0, 1, 0]]])
    >>> radius, mass, dt = 0.01, 0.01, 1e-6
    >>> contact = carom.GrainContacts(1, (radius, float("inf")), carom.Material(1e9, 0.3), 0.5)
    >>> place, velocity = [0.5, 0.4, radius], [0.0, 0.0, -0.1]
    >>> while place[2] <= radius:
    ...     place[2] += velocity[2] * dt
    ...     for point in floor.places(place, 1.01 * radius).point:
    ...         velocity[2] += contact.step(dt, place, velocity, place_2=point).force[0, 2] * dt / mass
    >>> print(velocity[2].round(3))
    0.1
    """

    def __init__(self, triangles: ArrayLike, *, smooth: float = np.pi / 18, period: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> None:
        given = numbers("triangles", triangles, "m")
        if given.ndim != 3 or given.shape[1:] != (3, 3):
            raise ValueError(f"triangles has the shape {given.shape}: must be (n, 3, 3), three corners of each triangle")
        lengths = numbers("period", period, "m")
        if lengths.shape != (3,):
            raise ValueError(f"period: must be three numbers, not {period!s:.60}")
        angle = number("smooth", smooth, "rad")
        rows = np.array(_finite("triangles", given), np.float64, order="C")
        self._native = _carom.TriangleMesh(rows.reshape(-1, 3), angle, lengths.tolist())
        self._given = (rows, angle, tuple(lengths.tolist()))

    def __len__(self) -> int:
        return len(self._given[0])

    def places(self, centers: ArrayLike, radii: ArrayLike) -> Places:
        """The places where balls with these centres, (n, 3) or (3,), and radii (m) touch the surface, ball by ball."""
        at = numbers("centers", centers, "m")
        if at.ndim not in (1, 2) or at.shape[-1] != 3:
            raise ValueError(f"centers has the shape {at.shape}: must be (3,) or (n, 3)")
        at = at.reshape(-1, 3)
        sizes = spread("radii", radii, (len(at),), "m")
        for size in sizes[~((sizes > 0) & (sizes < np.inf))]:
            within("radii", float(size), False, "finite and > 0")
        rows = np.column_stack([_finite("centers", at), sizes])
        found, words = self._native.places(np.require(rows, np.float64, "C"))
        point, normal, distance = found[:, :3], found[:, 3:6], found[:, 6]
        return Places(words[:, 0], point, normal, distance, KINDS[words[:, 1]], words[:, 2] == 1)

    def __reduce__(self) -> tuple[Callable[..., TriangleMesh], tuple[Array]]:
        triangles, smooth, period = self._given
        return partial(type(self), smooth=smooth, period=period), (triangles,)

    def _rows(self) -> list[_show.Row]:
        low, high = (end(self._given[0].reshape(-1, 3), 0) for end in (np.min, np.max))
        return [
            ("count", str(len(self)), "", "number of triangles"),
            ("low", _show.short(low), "m", "least coordinates"),
            ("high", _show.short(high), "m", "greatest coordinates"),
        ]

    def __repr__(self) -> str:
        return _show.text("TriangleMesh", self._rows())

    def _repr_html_(self) -> str:
        return _show.html("TriangleMesh", self._rows())
