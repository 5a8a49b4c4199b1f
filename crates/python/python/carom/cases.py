"""Cases from TOML files, with the same readers and results as the command `carom`.

An error in a case raises a ValueError that names the field, its line and the allowed range.

>>> import carom, pathlib, tempfile
>>> path = pathlib.Path(tempfile.mkdtemp()) / "ball.toml"
>>> _ = path.write_text(carom.cases.new("impact"))  # a commented case, ready to run
>>> rebound = carom.cases.impact(path)
>>> bool(rebound.energy_after < rebound.energy_before)
True
"""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import NDArray

from . import _carom
from ._record import Result
from ._records import HistorySteps, Rebound, Rebounds, SolverSteps
from ._types import Array
from ._solver import FIELDS
from ._validity import heed

Path = str | os.PathLike[str]

__all__ = ["Solved", "Sweep", "history", "impact", "new", "solve"]


class Sweep(Rebounds, one=Rebound):
    """The impacts of a case that sweeps over one of its fields."""

    @property
    def swept(self) -> tuple[str, str, Array]:
        """Name, unit and values of that field: the index of `to_pandas` and the coordinate of `to_xarray`."""
        assert self._swept is not None
        return self._swept


def new(kind: str) -> str:
    """A commented case of a kind, with all its fields; it runs without changes.

    Kinds: impact, hertz, history, scene, solve, roll, stress.

    >>> import carom
    >>> carom.cases.new("solve").splitlines()[0]
    '# A contact with friction on a grid, step by step.'
    """
    return _carom.case_new(kind)


def impact(path: Path) -> Rebound | Sweep:
    """The impact of a case; for a sweep all impacts, arrays (n,), computed in parallel.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "balls.toml"
    >>> once = carom.cases.new("impact")
    >>> _ = path.write_text(once.replace("friction = 0.2", "friction = [0.05, 0.1, 0.2]"))
    >>> rebounds = carom.cases.impact(path)
    >>> assert isinstance(rebounds, carom.cases.Sweep)  # for type checkers: the file has several impacts
    >>> rebounds.swept[0], rebounds.R_x.shape
    ('contact.friction', (3,))
    """
    swept, columns = _carom.case_impact(os.fspath(path))
    if swept is None:
        return heed(Rebound._of(columns))
    return heed(Sweep._shaped(columns, (len(swept[2]),), swept))


def history(path: Path) -> HistorySteps:
    """A contact that is pressed, shifted and twisted: arrays (n,) with an entry for each step.

    Columns of the twist are NaN if the case has none.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "loop.toml"
    >>> _ = path.write_text(carom.cases.new("history"))
    >>> steps = carom.cases.history(path)
    >>> bool((np.hypot(steps.F_x, steps.F_y) <= 0.3 * steps.F_z * (1 + 1e-12)).all())
    True
    """
    columns = _carom.case_history(os.fspath(path))
    return HistorySteps._shaped(columns, (len(columns["step"]),))


class Solved(Result):
    """A contact on a grid after all its steps. Fields are arrays (ny, nx) after the last step.

    steps           the contact after each step, arrays (n,)
    x, y            cell centres, (nx,) and (ny,), m
    pressure        Pa
    traction_x, _y  on body 1, Pa
    displacement_x, _y  elastic, of body 1 against body 2, m
    cells           state of each: 0 separated, 1 sticks, 2 slips
    warnings        reasons to distrust the result: few cells, a plate bent by more than half its thickness
    """

    steps: SolverSteps
    x: Array
    y: Array
    pressure: Array
    traction_x: Array
    traction_y: Array
    displacement_x: Array
    displacement_y: Array
    cells: NDArray[np.int8]
    warnings: list[str]

    meanings = {
        "steps": "the contact after each step",
        "x": "cell centres",
        "y": "cell centres",
        "pressure": "after the last step",
        "traction_x": "on body 1",
        "traction_y": "on body 1",
        "displacement_x": "elastic, of body 1 against body 2",
        "displacement_y": "elastic, of body 1 against body 2",
        "cells": "0 separated, 1 sticks, 2 slips",
        "warnings": "reasons to distrust the result",
    }
    units = dict(zip(meanings, ("", "m", "m", "Pa", "Pa", "Pa", "m", "m", "", ""), strict=True))


def solve(path: Path, *, accuracy: float | None = None) -> Solved:
    """A contact with friction on a grid, step by step.

    If `accuracy` of loads and shifts is given, it chooses the grid; the grid of the case is then ignored.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "ball.toml"
    >>> _ = path.write_text(carom.cases.new("solve"))
    >>> solved = carom.cases.solve(path)
    >>> cell = (solved.x[1] - solved.x[0]) * (solved.y[1] - solved.y[0])
    >>> bool(np.isclose(solved.pressure.sum() * cell, solved.steps.F_z[-1]))
    True
    """
    steps, (x, y), fields, cells, warnings = _carom.case_solve(os.fspath(path), accuracy)
    shape = (len(y), len(x))
    named = dict(zip(FIELDS, (field.reshape(shape) for field in fields), strict=True))
    return Solved(
        {
            "steps": SolverSteps._shaped(steps, (len(steps["step"]),)),
            "x": x,
            "y": y,
            **named,
            "cells": cells.reshape(shape),
            "warnings": warnings,
        }
    )
