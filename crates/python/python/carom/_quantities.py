"""Quantities that carry a unit, of any package (unyt, astropy, pint): converted to the unit of the argument, or refused."""

from __future__ import annotations

from inspect import isroutine
from typing import Any

import numpy as np

#: Types of numbers without a unit.
PLAIN = frozenset({float, int, bool, np.bool_, *(np.dtype(code).type for code in "bhilqBHILQefdg")})
#: What a unit in words may be where there is none.
NONE = ("", "1", "dimensionless")


def bare(name: str, x: Any, unit: str) -> Any:
    """The same numbers in this unit, without their own. Raises a ValueError if the units do not fit.

    Every argument comes by here, from `_arrays`, but for plain numbers of native functions. What has no unit is left as
    it is, and so is what is no number.
    """
    if type(x) in PLAIN or type(x) is np.ndarray and x.dtype.kind != "O":
        return x
    if isinstance(x, (list, tuple)):
        return x if PLAIN.issuperset(map(type, x)) else [bare(name, one, unit) for one in x]
    # The unit belongs to the argument, to the array in it (xarray), or to the type of its entries (pandas).
    for where in ("", "data", "dtype", "values"):
        holder = getattr(x, where, None) if where else x
        told = _unit(holder)
        if isinstance(told, str) and told in (unit, *NONE):
            break
        if told is not None:
            return _converted(name, holder, told, unit)
    if hasattr(x, "__array__"):
        array = np.asanyarray(x)
        if array.dtype.kind == "O":
            return bare(name, array.tolist(), unit)
    return x


def _unit(of: Any) -> Any:
    """The unit that an object carries; None without one."""
    told = (getattr(of, attribute, None) for attribute in ("units", "unit"))
    return next((unit for unit in told if unit is not None and not isroutine(unit)), None)


def _converted(name: str, x: Any, told: Any, unit: str) -> Any:
    """The numbers of a quantity by its own conversion: an angle may count as a number, and a number needs no unit."""
    convert = getattr(x, "to_value", None) or getattr(x, "m_as", None)
    for wanted in dict.fromkeys((unit, unit.replace("rad/", "1/"), "")):
        try:
            return convert(wanted)  # type: ignore[misc]
        except Exception:  # of any package, whose errors have no common base
            continue
    allowed = f"must be in {unit}, in a unit that converts to it, or without a unit" if unit else "must be without a unit"
    text = f"{str(x).splitlines()[0]:.60} has the unit {told}: {allowed}"
    raise ValueError(f"{name}: {text}")
