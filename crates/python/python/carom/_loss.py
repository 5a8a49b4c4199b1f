"""Losses of impacts in the material."""

from __future__ import annotations

from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import flag, line, number, numbers, path
from ._types import Array, Number, Numbers, Several

# Speeds and restitutions, if the restitution is given by speed.
Table = tuple[list[float], list[float]] | None


@dataclass(frozen=True)
class RestitutionBySpeed:
    """Normal restitutions that were measured at several speeds of approach along the normal, m/s.

    `collide`, `collide_many` and `history` take it as `normal_restitution`. It is straight between the speeds, and constant
    below the first and above the last one, as `numpy.interp`. The speeds grow; restitutions are from 0 to 1.

    >>> import carom
    >>> measured = carom.RestitutionBySpeed([0.5, 1.0, 3.0], [0.9, 0.8, 0.7])
    >>> measured.at([0.1, 0.75, 9.0]).round(12).tolist()
    [0.9, 0.85, 0.7]
    >>> rubber = carom.Material(2e7, 0.5)
    >>> ball = carom.sphere(0.02, rubber, 0.03, velocity=(0, 0, -2))
    >>> rebound = carom.collide(ball, carom.plane(carom.RIGID), 0.3, normal_restitution=measured)
    >>> float(round(rebound.body_1_velocity[2], 12))  # 0.75 times 2 m/s
    1.5
    """

    speed: tuple[float, ...]
    restitution: tuple[float, ...]

    def __post_init__(self) -> None:
        for name, unit in (("speed", "m/s"), ("restitution", "")):
            object.__setattr__(self, name, tuple(path(name, getattr(self, name), unit).tolist()))
        self.at([])

    def _table(self) -> tuple[list[float], list[float]]:
        return list(self.speed), list(self.restitution)

    @overload
    def at(self, speed: Number) -> float: ...
    @overload
    def at(self, speed: Several) -> Array: ...
    @overload
    def at(self, speed: ArrayLike) -> Numbers: ...
    def at(self, speed: ArrayLike) -> Numbers:
        """The restitution at a speed of approach, m/s, or at each of an array."""
        speeds = numbers("speed", speed, "m/s")
        found = line(_carom.restitution_by_speed(self._table(), line(speeds))).reshape(speeds.shape)
        return found if speeds.ndim else float(found)


def loss_of(
    normal_restitution: float | RestitutionBySpeed, loss: str | None, wave_loss: bool, relaxation: float
) -> tuple[str, float, Table]:
    """The cause of the loss in the material; its coefficient or relaxation time, or a table."""
    if normal_restitution is None:
        raise TypeError("normal_restitution: must be a number; for the loss by waves pass wave_loss=True")
    if not isinstance(normal_restitution, RestitutionBySpeed):
        normal_restitution = number("normal_restitution", normal_restitution)
    relaxation = number("relaxation", relaxation, "s")
    cause, values, table = losses_of(normal_restitution, loss, wave_loss, relaxation)
    return cause, float(values), table


def losses_of(
    normal_restitution: ArrayLike | RestitutionBySpeed, loss: str | None, wave_loss: bool, relaxation: ArrayLike
) -> tuple[str, Array, Table]:
    """The same for many impacts: a number, or one for each."""
    table = None
    if isinstance(normal_restitution, RestitutionBySpeed):
        table, normal_restitution = normal_restitution._table(), 0.0
    coefficients = numbers("normal_restitution", normal_restitution)
    times = numbers("relaxation", relaxation, "s")
    is_given, relaxes = bool(np.any(coefficients != 1.0)), bool(np.any(times != 0.0))
    if loss is not None and not is_given and coefficients.ndim == 0:
        raise ValueError("loss: is the cause of a normal_restitution, which must be a number below 1 then")
    given = [("normal_restitution", is_given), ("wave_loss=True", flag("wave_loss", wave_loss)), ("relaxation", relaxes)]
    causes = [name for name, is_there in given if is_there]
    if len(causes) > 1:
        raise ValueError(f"{causes[0]} and {causes[1]} are mutually exclusive")
    if wave_loss:
        return "waves", np.zeros(()), None
    return ("relaxation", times, None) if relaxes else (loss or "viscous", coefficients, table)
