"""Arrays of any shape, broadcast against each other, as lines for the native functions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Numbers = float | Array


def line(x: ArrayLike) -> Array:
    """The numbers one after the other."""
    return np.require(x, np.float64, ["C", "A"]).reshape(-1)


def over(function: Callable[..., Array], *arguments: ArrayLike) -> Numbers:
    """The values of a native function over broadcast arguments; a number for numbers."""
    arrays = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in arguments))
    values = function(*(line(x) for x in arrays)).reshape(arrays[0].shape)
    return values if values.ndim else float(values)


def rows(x: ArrayLike | None, count: int) -> Array:
    """`count` vectors of three; one vector stands for all, None for zeros."""
    given = np.zeros(3) if x is None else np.asarray(x, dtype=np.float64)
    return np.require(np.broadcast_to(given, (count, 3)), np.float64, ["C", "A"])
