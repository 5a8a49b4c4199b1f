"""Converts arrays of any shape to flat arrays for the native functions, with broadcasting."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import ArrayLike

from ._carom import RangeError, available_room
from ._quantities import bare
from ._types import Array, Numbers

# Allocations up to this number of bytes are not checked.
FEW = 1 << 24


def line(x: ArrayLike) -> Array:
    """The numbers as a flat array."""
    return np.require(x, np.float64, ["C", "A"]).reshape(-1)


def numbers(name: str, x: ArrayLike, unit: str = "") -> Array:
    """Real numbers, in this unit. Truth values, complex numbers, times, masked values and other units raise an error that
    names the argument."""
    x = bare(name, x, unit)
    try:
        given = np.asarray(x)
        if given.dtype.kind in "bcSUmM" or np.ma.is_masked(x) or x is None or _has_truths(x):
            raise TypeError
        return np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name}: must be real numbers, not {str(x):.60}") from None


def _has_truths(x: object) -> bool:
    """Whether a list of numbers holds truth values, which count as 1 and 0 in an array."""
    return isinstance(x, list | tuple) and any(isinstance(one, bool | np.bool_) for one in x)


def flag(name: str, x: object) -> bool:
    """A truth value."""
    if not isinstance(x, bool | np.bool_):
        raise TypeError(f"{name}: must be True or False, not {x!r:.60}")
    return bool(x)


def switch(name: str, x: object) -> bool | None:
    """A truth value, or None."""
    if x is None:
        return None
    if not isinstance(x, bool | np.bool_):
        raise TypeError(f"{name}: must be None, True or False, not {x!r:.60}")
    return bool(x)


def number(name: str, x: object, unit: str = "") -> float:
    """A single real number, in this unit."""
    if type(x) is float:
        return x
    given = numbers(name, x, unit)  # type: ignore[arg-type]
    if given.ndim:
        raise ValueError(f"{name}: must be a number, not {str(x):.60}")
    return float(given)


def path(name: str, x: ArrayLike, unit: str) -> Array:
    """A one-dimensional array of numbers in this unit."""
    given = numbers(name, x, unit)
    if given.ndim != 1:
        raise ValueError(f"{name} has the shape {given.shape}: must be one-dimensional, a list of numbers")
    return line(given)


def row(name: str, x: ArrayLike, unit: str) -> Array:
    """The numbers of an argument in this unit: a list, or one alone."""
    given = numbers(name, x, unit)
    return line(given) if given.ndim == 0 else path(name, x, unit)


def spread(name: str, x: ArrayLike, shape: tuple[int, ...], unit: str = "") -> Array:
    """The numbers of an argument, broadcast to a shape."""
    given = numbers(name, x, unit)
    try:
        return np.broadcast_to(given, shape)
    except ValueError:
        raise ValueError(f"{name} has the shape {given.shape}: must be a number or of the shape {shape}") from None


def two(name: str, x: object, unit: str) -> tuple[float, float]:
    """Two numbers in this unit."""
    pair = numbers(name, x, unit)  # type: ignore[arg-type]
    if pair.shape != (2,):
        raise ValueError(f"{name}: must be two numbers, not {str(x):.60}")
    return float(pair[0]), float(pair[1])


def blocks(influence: Mapping[str, ArrayLike] | None) -> list[tuple[str, int, Array]]:
    """Name, columns and numbers of each block of influence numbers."""
    chosen = []
    for name, block in ({} if influence is None else influence).items():
        array = numbers(f"influence[{name!r}]", block, "m/Pa")
        if array.ndim != 2:
            raise ValueError(f"influence[{name!r}] has {array.ndim} dimensions: must be an array of rows")
        chosen.append((str(name), array.shape[1], line(array)))
    if influence is not None and not chosen:
        raise ValueError("influence is empty: must have blocks of numbers, at least 'zz'")
    return chosen


def counted(name: str, x: object, each: int = 1) -> int:
    """A count of items of at least `each` bytes: a non-negative integer for which there is enough
    memory."""
    try:
        whole = operator.index(bare(name, x, ""))
    except TypeError:
        raise TypeError(f"{name}: must be a whole number, not {str(x):.60}") from None
    if 0 <= whole * each <= FEW or 0 <= whole * each <= available_room():
        return whole
    raise _refused(name, whole, "at least 0" if whole < 0 else "few enough for the free memory")


def within(name: str, x: float, holds: bool, allowed: str) -> float:
    """A number that is in its range."""
    if not holds:
        raise _refused(name, x, allowed)
    return x


def _refused(name: str, x: float, allowed: str) -> RangeError:
    error = RangeError(f"{name} = {x} is out of range: must be {allowed}")
    error.field, error.value, error.index = name, float(x), None
    return error


def counts(name: str, x: object, allowed: str) -> tuple[int, int]:
    """Two counts."""
    pair = bare(name, x, "")
    if np.shape(pair) != (2,):
        raise ValueError(f"{name}: must be {allowed}, not {str(x):.60}")
    return counted(name, pair[0]), counted(name, pair[1])


def alike(given: Mapping[str, Array]) -> list[Array]:
    """Numbers and arrays of arguments, broadcast to one shape."""
    try:
        return list(np.broadcast_arrays(*given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {values.shape}" for name, values in given.items() if values.ndim)
        raise ValueError(f"arrays must have shapes that fit each other, not {shapes}") from None


def over(function: Callable[..., Array], /, **arguments: ArrayLike) -> Numbers:
    """Applies a native function to broadcast arguments; numbers in give a number."""
    arrays = alike({name: numbers(name, x) for name, x in arguments.items()})
    values = function(*(line(x) for x in arrays)).reshape(arrays[0].shape)
    return values if values.ndim else float(values)


def rows(name: str, x: ArrayLike, count: int) -> Array:
    """`count` vectors of three components; a single vector is repeated."""
    given = numbers(name, x)
    if given.shape not in ((3,), (count, 3)):
        turned = "; transpose it" if given.ndim == 2 and given.shape[0] == 3 else ""
        raise ValueError(f"{name} has the shape {given.shape}: must be (3,) or (n, 3), of {count} motions{turned}")
    return np.require(np.broadcast_to(given, (count, 3)), np.float64, ["C", "A"])
