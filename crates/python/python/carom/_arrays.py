"""Arrays of any shape, broadcast against each other, as lines for the native functions."""

from __future__ import annotations

import operator
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._carom import RangeError, available_room

Array = NDArray[np.float64]
Numbers = float | Array

# Bytes that are taken without asking the system.
FEW = 1 << 24


def line(x: ArrayLike) -> Array:
    """The numbers one after the other."""
    return np.require(x, np.float64, ["C", "A"]).reshape(-1)


def numbers(name: str, x: ArrayLike) -> Array:
    """Real numbers; what is none is an error that names its argument: imaginary parts, times, what is masked."""
    try:
        given = np.asarray(x)
        if given.dtype.kind in "cSUmM" or np.ma.is_masked(x):
            raise TypeError
        return np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name}: must be real numbers, not {str(x):.60}") from None


def path(name: str, x: ArrayLike) -> Array:
    """Numbers in one line."""
    given = numbers(name, x)
    if given.ndim != 1:
        raise ValueError(f"{name} has the shape {given.shape}: must be one line of numbers")
    return line(given)


def spread(name: str, x: ArrayLike, shape: tuple[int, ...]) -> Array:
    """The numbers of an argument, one of them for many."""
    given = numbers(name, x)
    try:
        return np.broadcast_to(given, shape)
    except ValueError:
        raise ValueError(f"{name} has the shape {given.shape}: must be a number or of the shape {shape}") from None


def two(name: str, x: object) -> tuple[float, float]:
    """Two numbers."""
    pair = numbers(name, x)  # type: ignore[arg-type]
    if pair.shape != (2,):
        raise ValueError(f"{name}: must be two numbers, not {str(x):.60}")
    return float(pair[0]), float(pair[1])


def counted(name: str, x: object, each: int = 1) -> int:
    """A number of things of at least so many bytes: a whole one, for which there is room."""
    whole = operator.index(x)  # type: ignore[arg-type]
    if 0 <= whole * each <= FEW or 0 <= whole * each <= available_room():
        return whole
    allowed = "at least 0" if whole < 0 else "so many as the memory holds"
    error = RangeError(f"{name} = {whole} is out of range: must be {allowed}")
    error.field, error.value, error.index = name, float(whole), None
    raise error


def over(function: Callable[..., Array], *arguments: ArrayLike) -> Numbers:
    """The values of a native function over broadcast arguments; a number for numbers."""
    arrays = np.broadcast_arrays(*(numbers(f"argument {i}", x) for i, x in enumerate(arguments, 1)))
    values = function(*(line(x) for x in arrays)).reshape(arrays[0].shape)
    return values if values.ndim else float(values)


def rows(name: str, x: ArrayLike, count: int) -> Array:
    """`count` vectors of three; one vector stands for all."""
    given = numbers(name, x)
    if given.shape not in ((3,), (count, 3)):
        raise ValueError(f"{name} has the shape {given.shape}: must be (3,) or {(count, 3)}")
    return np.require(np.broadcast_to(given, (count, 3)), np.float64, ["C", "A"])
