"""Friction of impacts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import overload

from numpy.typing import ArrayLike

from . import _carom
from ._arrays import line, number, numbers
from ._types import Array, Number, Numbers, Several


@dataclass(frozen=True)
class SlipSpeedFriction:
    """Friction f = a + b exp(-c v) that depends on the slip speed v: a + b at rest, a at high speeds. c in s/m.

    `collide`, `collide_many`, `history` and `roll` take it as `friction`. In an impact the slip speed is the tangential speed of the contact
    point at the first touch; the coefficient is then constant during the impact.

    >>> import carom
    >>> friction = carom.SlipSpeedFriction(0.1, 0.2, 0.9)
    >>> round(friction.at(0.0), 12), round(friction.at(2.0), 3)
    (0.3, 0.133)
    >>> steel = carom.Material(208e9, 0.3)
    >>> ball = carom.sphere(0.01, steel, 0.033, velocity=(2, 0, -0.5))
    >>> rebound = carom.collide(ball, carom.plane(steel), friction)
    >>> rebound.friction == friction.at(2.0)
    True
    """

    a: float
    b: float
    c: float

    def __post_init__(self) -> None:
        for name, unit in (("a", ""), ("b", ""), ("c", "s/m")):
            object.__setattr__(self, name, number(name, getattr(self, name), unit))
        _carom.slip_speed_friction(self._numbers(), line([]))

    def _numbers(self) -> tuple[float, float, float]:
        return self.a, self.b, self.c

    @overload
    def at(self, speed: Number) -> float: ...
    @overload
    def at(self, speed: Several) -> Array: ...
    @overload
    def at(self, speed: ArrayLike) -> Numbers: ...
    def at(self, speed: ArrayLike) -> Numbers:
        """The coefficient at a slip speed, m/s, or at each of an array."""
        speeds = numbers("speed", speed, "m/s")
        found = line(_carom.slip_speed_friction(self._numbers(), line(speeds))).reshape(speeds.shape)
        return found if speeds.ndim else float(found)


def by_speed(friction: object) -> tuple[float, float, float] | None:
    """The numbers of friction by the slip speed; None for a coefficient."""
    return friction._numbers() if isinstance(friction, SlipSpeedFriction) else None
