"""Types of arguments and results: numbers in give a number, arrays in give an array."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: An array of numbers, as functions return it.
Array = NDArray[np.float64]
#: A number or an array of them, as functions return it where the types of the arguments leave both open.
Numbers = Union[float, Array]
#: One number.
Number = Union[float, "np.floating[Any]", "np.integer[Any]"]
#: Several numbers, of any shape.
Several = Union[
    "NDArray[np.floating[Any]]", "NDArray[np.integer[Any]]", Sequence[float], Sequence[Sequence[float]]
]
#: A vector, or a few numbers in a row.
Vector = Union[Sequence[float], "NDArray[np.floating[Any]]", "NDArray[np.integer[Any]]"]


class OfOne(Protocol):
    """A function of one argument, applied to each entry of an array."""

    @overload
    def __call__(self, x: Number, /) -> float: ...
    @overload
    def __call__(self, x: Several, /) -> Array: ...
    @overload
    def __call__(self, x: ArrayLike, /) -> Numbers: ...


class OfTwo(Protocol):
    """A function of two arguments, applied to each entry of two arrays of the same shape, with broadcasting."""

    @overload
    def __call__(self, x: Number, y: Number, /) -> float: ...
    @overload
    def __call__(self, x: Several, y: ArrayLike, /) -> Array: ...
    @overload
    def __call__(self, x: ArrayLike, y: Several, /) -> Array: ...
    @overload
    def __call__(self, x: ArrayLike, y: ArrayLike, /) -> Numbers: ...


def of_one(function: Callable[[ArrayLike], Numbers]) -> OfOne:
    """The same function, whose result is a number if its argument is one."""
    return function  # type: ignore[return-value]


def of_two(function: Callable[[ArrayLike, ArrayLike], Numbers]) -> OfTwo:
    """The same function, whose result is a number if both arguments are."""
    return function  # type: ignore[return-value]
