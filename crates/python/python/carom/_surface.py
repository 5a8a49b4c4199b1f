"""Height maps of surfaces: from files of instruments, arrays and objects of other packages."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import line, number, numbers
from ._quantities import bare
from ._records import SurfaceMeasures
from ._types import Array
from ._validity import CaromWarning

#: Metres of the words for units.
UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "nm": 1e-9, "A": 1e-10, "Å": 1e-10, "pm": 1e-12}
#: What stands for missing points.
MISSING = ("fill", "no contact")


@dataclass(frozen=True, eq=False)
class Surface:
    """Heights of a surface on a regular grid, towards the other body.

    `heights` is an array (ny, nx) in m, y and x ascending, NaN where a point is missing; `size` is the length along x and
    y in m (points times spacing), None if it is not known.
    """

    heights: Array
    size: tuple[float, float] | None

    def __post_init__(self) -> None:
        heights = np.array(numbers("heights", self.heights, "m"), dtype=np.float64, order="C")
        if heights.ndim != 2 or not heights.size:
            raise ValueError(f"heights has the shape {heights.shape}: must be an array (ny, nx)")
        if np.isinf(heights).any() or np.isnan(heights).all():
            raise ValueError("heights: must be finite, or NaN where a point is missing, and one measured at least")
        heights.flags.writeable = False
        object.__setattr__(self, "heights", heights)
        object.__setattr__(self, "size", None if self.size is None else _sides(self.size))

    @property
    def shape(self) -> tuple[int, int]:
        """Shape of the map, (ny, nx)."""
        ny, nx = self.heights.shape
        return ny, nx

    @property
    def missing(self) -> int:
        """Number of points without a height."""
        return int(np.isnan(self.heights).sum())

    @property
    def gap(self) -> Array:
        """The gap to a plane that rests on the highest point, m: infinite where a point is missing."""
        return np.where(np.isnan(self.heights), np.inf, np.nanmax(self.heights) - self.heights)

    def _spacing(self) -> list[float] | None:
        ny, nx = self.shape
        return None if self.size is None else [self.size[0] / nx, self.size[1] / ny]

    def measures(self, *, periodic: bool = False) -> SurfaceMeasures:
        """Roughness, slope, curvature, tilt, missing points, spikes and Hurst's exponent."""
        return SurfaceMeasures._of(self._measured(periodic)[0])

    def warnings(self, *, periodic: bool = False) -> list[str]:
        """What should be mended before a contact: a tilt, missing points, spikes, a slope or unit, a step at the border."""
        return self._measured(periodic)[1]

    def _measured(self, periodic: bool) -> tuple[dict[str, Array], list[str]]:
        return _carom.surface_measures(self.shape[1], line(self.heights), self._spacing(), bool(periodic))

    def prepared(
        self, *, crop: Sequence[int] | None = None, level: str | None = None, missing: str | None = None
    ) -> Surface:
        """A part of the map (left, lower, right, upper, in points from 0), less its `level` ("mean", "plane" or
        "quadratic", by least squares), with `missing` points filled ("fill") by a smooth patch of the heights around them, or
        left ("no contact")."""
        if missing not in (None, *MISSING):
            raise ValueError(f"missing = {missing!r}: must be 'fill' or 'no contact'")
        if crop is not None and (len(crop) != 4 or min(crop) < 0):
            raise ValueError(f"crop = {crop}: must be four numbers of points (left, lower, right, upper), from 0")
        part = None if crop is None else [int(place) for place in crop]
        found = _carom.surface_prepared(
            self.shape[1], line(self.heights), self._spacing(), part, level, missing == "fill"
        )
        return _of(found)


def _of(found: tuple[int, Array, Sequence[float] | None]) -> Surface:
    """A map as the native functions give it."""
    columns, flat, spacing = found
    heights = flat.reshape(-1, columns)
    size = None if spacing is None else (spacing[0] * columns, spacing[1] * heights.shape[0])
    return Surface(heights, size)


def _metres(name: str, unit: str | None) -> float | None:
    if unit is not None and unit not in UNITS:
        raise ValueError(f"{name} = {unit!r}: must be one of {', '.join(sorted(UNITS))}")
    return None if unit is None else UNITS[unit]


def of_object(source: object, unit: float | None) -> Surface | None:
    """The map of an object of another package; None if it is none. SurfaceTopography has arrays (nx, ny) and a unit,
    surfalize (ny, nx) in micrometres."""
    if hasattr(source, "heights") and callable(source.heights) and hasattr(source, "physical_sizes"):
        own = unit or _metres("unit of the topography", getattr(source, "unit", None)) or 1.0
        heights = np.ma.filled(np.ma.asarray(source.heights(), dtype=float), np.nan).T * own
        x, y = (float(side) * own for side in source.physical_sizes)
        return Surface(np.array(heights, order="C"), (x, y))
    if all(hasattr(source, name) for name in ("step_x", "step_y", "data")):
        micro = 1e-6
        rows, step_x, step_y = (getattr(source, name) for name in ("data", "step_x", "step_y"))
        heights = np.asarray(rows, dtype=np.float64) * micro
        ny, nx = heights.shape
        return Surface(heights, (float(step_x) * micro * nx, float(step_y) * micro * ny))
    return None


def _of_array(source: ArrayLike, unit: float | None) -> Surface:
    masked = np.ma.isMaskedArray(source)
    data = np.ma.filled(np.ma.asarray(source, dtype=float), np.nan) if masked else numbers("source", bare("source", source, "m"))
    if data.ndim != 2 or data.size == 0:
        raise ValueError(f"source has the shape {data.shape}: must be an array (ny, nx)")
    if np.isinf(data).any():
        raise ValueError("source has infinite heights: must be finite, or NaN where a point is missing")
    return Surface(np.array(data * (1.0 if unit is None else unit), order="C"), None)


def surface(
    source: object,
    *,
    unit: str | None = None,
    scale: float = 1.0,
    size: tuple[float, float] | float | None = None,
    range: float | None = None,
    crop: Sequence[int] | None = None,
    level: str | None = None,
    missing: str | None = None,
) -> Surface:
    """The height map of a file, of bytes, of an array (ny, nx), or of an object of SurfaceTopography or surfalize.

    Files are x3p, sur, sdf, npy, PNG in greys or texts, known by their content; `unit` is what their numbers are in if they
    do not state it, `range` the height of white in a PNG (m), `scale` a factor of the heights, `size` the length along x
    and y (m). Masked points and NaN are missing. `crop`, `level` and `missing` as for `Surface.prepared`.

    >>> import carom, numpy as np
    >>> tilted = np.add.outer(1e-9 * np.arange(4), 2e-9 * np.arange(5))
    >>> surface = carom.surface(tilted, size=(5e-6, 4e-6), level="plane")
    >>> surface.shape, bool(abs(surface.heights).max() < 1e-20)
    ((4, 5), True)
    """
    metres = _metres("unit", unit)
    found = of_object(source, metres)
    if found is None and isinstance(source, (str, os.PathLike, bytes, bytearray)):
        content = bytes(source) if isinstance(source, (bytes, bytearray)) else _content(source)
        white = None if range is None else number("range", range, "m")
        read, known, notes = _carom.surface_read(content, metres, white)
        for note in notes:
            warnings.warn(note, CaromWarning, stacklevel=2)
        if not known and scale == 1.0 and not notes:
            text = "the file does not state the unit of its heights: they are taken as m; unit='m' confirms it"
            warnings.warn(text, CaromWarning, stacklevel=2)
        found = _of(read)
    elif found is None:
        found = _of_array(source, metres)  # type: ignore[arg-type]
    factor = number("scale", scale)
    if not (np.isfinite(factor) and factor > 0):
        raise ValueError(f"scale = {factor}: must be finite and > 0")
    sides = found.size if size is None else _sides(size)
    whole = Surface(found.heights * factor, sides)
    return whole.prepared(crop=crop, level=level, missing=missing)


def _content(path: str | os.PathLike[str]) -> bytes:
    with open(path, "rb") as file:
        return file.read()


def _sides(size: tuple[float, float] | float) -> tuple[float, float]:
    given = np.broadcast_to(numbers("size", size, "m"), (2,))
    if not (np.isfinite(given).all() and (given > 0).all()):
        raise ValueError(f"size = {size}: must be finite and > 0")
    return float(given[0]), float(given[1])
