"""Special functions over arrays: elliptic integrals of the axis ratio, hypergeometric functions, gamma.

The elliptic integrals take the axis ratio k' = a/b, not the modulus k = sqrt(1 - k'^2) nor m = k^2: nearly
round and very slender ellipses keep all their digits; a > b is allowed.

>>> from carom import special
>>> special.k(1.0)  # pi/2
1.5707963267948966
>>> import numpy as np
>>> np.round(special.e([0.5, 1.0, 2.0]), 6)
array([1.211056, 1.570796, 2.422112])
"""

from __future__ import annotations

from functools import partial
from typing import overload

from numpy.typing import ArrayLike

from . import _carom
from ._arrays import number, over
from ._types import Array, Number, Numbers, Several, of_one, of_two

__all__ = ["b", "c", "d", "e", "gamma", "hyp2f1", "hyp3f2", "inc_d", "inc_e", "inc_f", "k", "ln_gamma"]


@of_one
def k(axis_ratio: ArrayLike) -> Numbers:
    """K, the complete elliptic integral of the first kind, of the axis ratio a/b > 0."""
    return over(partial(_carom.complete, "k"), axis_ratio=axis_ratio)


@of_one
def e(axis_ratio: ArrayLike) -> Numbers:
    """E, the complete elliptic integral of the second kind, of the axis ratio a/b > 0."""
    return over(partial(_carom.complete, "e"), axis_ratio=axis_ratio)


@of_one
def d(axis_ratio: ArrayLike) -> Numbers:
    """D = (K - E)/k^2, of the axis ratio a/b > 0."""
    return over(partial(_carom.complete, "d"), axis_ratio=axis_ratio)


@of_one
def b(axis_ratio: ArrayLike) -> Numbers:
    """B = K - D, of the axis ratio a/b > 0.

    >>> b(1e-9) + d(1e-9) == k(1e-9)
    True
    """
    return over(partial(_carom.complete, "b"), axis_ratio=axis_ratio)


@of_one
def c(axis_ratio: ArrayLike) -> Numbers:
    """C = (D - B)/k^2, of the axis ratio a/b > 0."""
    return over(partial(_carom.complete, "c"), axis_ratio=axis_ratio)


@of_two
def inc_f(axis_ratio: ArrayLike, phi: ArrayLike) -> Numbers:
    """F, the incomplete elliptic integral of the first kind, phi from 0 to pi/2."""
    return over(partial(_carom.incomplete, "f"), axis_ratio=axis_ratio, phi=phi)


@of_two
def inc_e(axis_ratio: ArrayLike, phi: ArrayLike) -> Numbers:
    """E, the incomplete elliptic integral of the second kind, phi from 0 to pi/2."""
    return over(partial(_carom.incomplete, "e"), axis_ratio=axis_ratio, phi=phi)


@of_two
def inc_d(axis_ratio: ArrayLike, phi: ArrayLike) -> Numbers:
    """D = (F - E)/k^2, incomplete, phi from 0 to pi/2."""
    return over(partial(_carom.incomplete, "d"), axis_ratio=axis_ratio, phi=phi)


@of_one
def gamma(x: ArrayLike) -> Numbers:
    """The gamma function.

    >>> gamma(5.0)
    24.0
    """
    return over(_carom.gamma, x=x)


@of_one
def ln_gamma(x: ArrayLike) -> Numbers:
    """The logarithm of the gamma function."""
    return over(_carom.ln_gamma, x=x)


@overload
def hyp2f1(a: float, b: float, c: float, x: Number) -> float: ...
@overload
def hyp2f1(a: float, b: float, c: float, x: Several) -> Array: ...
@overload
def hyp2f1(a: float, b: float, c: float, x: ArrayLike) -> Numbers: ...
def hyp2f1(a: float, b: float, c: float, x: ArrayLike) -> Numbers:
    """Gauss's hypergeometric function 2F1(a, b; c; x), x from 0 to 1; a, b and c from -5 to 5, c no pole."""
    return over(partial(_carom.hyp2f1, number("a", a), number("b", b), number("c", c)), x=x)


@overload
def hyp3f2(s: float, a: float, b: float, c: float, x: Number) -> float: ...
@overload
def hyp3f2(s: float, a: float, b: float, c: float, x: Several) -> Array: ...
@overload
def hyp3f2(s: float, a: float, b: float, c: float, x: ArrayLike) -> Numbers: ...
def hyp3f2(s: float, a: float, b: float, c: float, x: ArrayLike) -> Numbers:
    """3F2(s, a, b; s + 1, c; x), x from 0 to 1."""
    function = partial(_carom.hyp3f2, number("s", s), number("a", a), number("b", b), number("c", c))
    return over(function, x=x)
