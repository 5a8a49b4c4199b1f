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
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import _carom
from ._arrays import Array
from ._records import HistoryStep, Rebound, SolverStep
from ._validity import heed

Path = str | os.PathLike[str]

__all__ = ["Solved", "history", "impact", "new", "solve"]


def new(kind: str) -> str:
    """A commented case of a kind, with all its fields; it runs without changes.

    Kinds: impact, hertz, history, scene, solve, roll, stress.

    >>> import carom
    >>> carom.cases.new("solve").splitlines()[0]
    '# A contact with friction on a grid, step by step.'
    """
    return _carom.case_new(kind)


def impact(path: Path) -> Rebound:
    """The impact of a case; for a sweep all impacts, arrays (n,), computed in parallel.

    For a sweep, `swept` of the result holds the name of the field, its unit and its values. They are the
    index of `to_pandas` and the coordinate of `to_xarray`.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "balls.toml"
    >>> once = carom.cases.new("impact")
    >>> _ = path.write_text(once.replace("friction = 0.2", "friction = [0.05, 0.1, 0.2]"))
    >>> rebounds = carom.cases.impact(path)
    >>> rebounds.swept[0], rebounds.R_x.shape
    ('contact.friction', (3,))
    """
    swept, columns = _carom.case_impact(os.fspath(path))
    shape = () if swept is None else (len(swept[2]),)
    return heed(Rebound._of(columns, shape, swept))


def history(path: Path) -> HistoryStep:
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
    return HistoryStep._of(columns, (len(columns["step"]),))


@dataclass(frozen=True, eq=False)
class Solved:
    """A contact on a grid after all its steps. Fields are arrays (ny, nx) after the last step.

    steps           the contact after each step, arrays (n,)
    x, y            cell centres, (nx,) and (ny,), m
    pressure        Pa
    traction_x, _y  on body 1, Pa
    displacement_x, _y  elastic, of body 1 against body 2, m
    cells           state of each: 0 separated, 1 sticks, 2 slips
    warnings        reasons to distrust the result: few cells, a plate bent by more than half its thickness
    """

    steps: SolverStep
    x: Array
    y: Array
    pressure: Array
    traction_x: Array
    traction_y: Array
    displacement_x: Array
    displacement_y: Array
    cells: NDArray[np.int8]
    warnings: list[str]


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
    return Solved(
        SolverStep._of(steps, (len(steps["step"]),)),
        x,
        y,
        *(field.reshape(shape) for field in fields),
        cells.reshape(shape),
        warnings,
    )
