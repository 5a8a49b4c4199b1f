"""Calls whose arguments do not fit: an error that tells what may be meant."""

from __future__ import annotations

import functools
import inspect
import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

from ._carom import meant

Parameter = inspect.Parameter


def help_calls(module: ModuleType) -> None:
    """Lets the public functions of a module, and its classes written in Python, tell of arguments that do not fit."""
    for name in vars(module)["__all__"]:
        made = getattr(module, name)
        if inspect.isfunction(made):
            told = helped(made, made)
            setattr(sys.modules[made.__module__], name, told)
            setattr(module, name, told)
        elif inspect.isclass(made):
            for method in ("__init__", "step", "advance", "follow"):
                if inspect.isfunction(vars(made).get(method)):
                    of = made if method == "__init__" else vars(made)[method]
                    setattr(made, method, helped(vars(made)[method], of))


def helped(function: Callable[..., Any], made: Callable[..., Any]) -> Callable[..., Any]:
    """The same function; arguments that do not fit raise a `TypeError` that tells what `made` takes."""

    @functools.wraps(function)
    def call(*given: Any, **named: Any) -> Any:
        try:
            return function(*given, **named)
        except TypeError as error:
            if error.__traceback__ is None or error.__traceback__.tb_next is not None:
                raise
            raise told(made, inspect.signature(function), len(given), named) or error from None

    return call


def told(made: Callable[..., Any], taken: inspect.Signature, count: int, named: dict[str, Any]) -> TypeError | None:
    """What does not fit in a call with so many arguments by place, and these by name."""
    for name in named:
        if name not in taken.parameters:
            return unknown(made, name)
    placed = [name for name, one in taken.parameters.items() if one.kind is not Parameter.KEYWORD_ONLY]
    by_name = [f"{name}=.." for name, one in taken.parameters.items() if one.kind is Parameter.KEYWORD_ONLY]
    if count > len(placed) and by_name:
        by_place = ", ".join(name for name in placed if name != "self")
        return TypeError(f"{made.__qualname__}() takes {by_place} by place, further arguments by name: {', '.join(by_name)}")
    given = {*placed[:count], *named}
    absent = [name for name, one in taken.parameters.items() if one.default is Parameter.empty and name not in given]
    return lacking(made, absent) if absent else None


def unknown(made: Callable[..., Any], name: str) -> TypeError:
    """The error of an argument that a function or a class does not have."""
    valid = takes(made)
    hint = meant(name, valid) or "."
    return TypeError(f"{made.__qualname__}() has no argument `{name}`{hint} It takes {', '.join(valid)}")


def lacking(made: Callable[..., Any], names: list[str]) -> TypeError:
    """The error of arguments that a function or a class needs and that are not given."""
    *others, last = (f"`{name}`" for name in names)
    listed = f"{', '.join(others)} and {last}" if others else last
    return TypeError(f"{made.__qualname__}() needs {listed}. It takes {', '.join(takes(made))}")


def takes(made: Callable[..., Any]) -> list[str]:
    """The names of the arguments of a function or a class."""
    own = inspect.signature(made).parameters.values()
    return [one.name for one in own if one.name != "self"]
