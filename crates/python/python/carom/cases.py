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
from collections.abc import Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _carom
from ._arrays import counted
from ._carom import RangeError
from ._case_results import (
    Bellows,
    Flange,
    Rolled,
    Scene,
    Solved,
    Stresses,
    Sweep,
    gridded,
)
from ._records import (
    BellowsResponse,
    BellowsStates,
    Bounces,
    CreepCoefficients,
    FlangeSummary,
    HertzState,
    HertzStates,
    HistorySteps,
    LineState,
    LineStates,
    PathEvents,
    PathPoint,
    PathPoints,
    Rebound,
    RingPlaces,
    RollStates,
    SolverSteps,
    WallPlaces,
)
from ._types import Array
from ._validity import warn

#: The path of a case file, the text of a case in TOML, or a dict with its tables.
Case = Union[str, "os.PathLike[str]", Mapping[str, Any]]

__all__ = [
    "Bellows",
    "Flange",
    "Rolled",
    "Scene",
    "Solved",
    "Stresses",
    "Sweep",
    "hertz",
    "history",
    "impact",
    "new",
    "roll",
    "scene",
    "shell",
    "solve",
    "stress",
]


def new(kind: str) -> str:
    """A commented case of a kind, with all its fields; it runs without changes.

    Kinds: impact, hertz, history, scene, solve, roll, stress, shell.

    >>> import carom
    >>> carom.cases.new("solve").splitlines()[0]
    '# A contact with friction on a grid, step by step.'
    """
    return _carom.case_new(kind)


def _toml(value: object, name: str = "") -> str:
    """A value of a case in TOML, on one line; the name of its field is that of errors."""
    import json

    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{json.dumps(str(key))} = {_toml(one, f'{name}.{key}')}" for key, one in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(one, name) for one in value) + "]"
    if isinstance(value, (bool, str)):
        return json.dumps(value)
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, os.PathLike):
        return json.dumps(os.fspath(value))
    of = f"`{name}` is a {type(value).__name__}" if name else f"holds a {type(value).__name__}"
    raise TypeError(f"case: {of}; must be a number, a text, a list or a dict of them, as in a case file")


def _given(case: Case) -> str | tuple[str]:
    """The path of a case file, or a text in TOML alone in a tuple. Warns of numbers that are unusual."""
    given = _source(case)
    warn((_carom.case_unusual(given), False))
    return given


def _source(case: Case) -> str | tuple[str]:
    """The path of a case file, or a text in TOML alone in a tuple."""
    if isinstance(case, Mapping):
        import json

        return ("".join(f"{json.dumps(str(key))} = {_toml(value, str(key))}\n" for key, value in case.items()),)
    if isinstance(case, str) and ("\n" in case or "=" in case):
        return (case,)
    if not isinstance(case, (str, os.PathLike)):
        raise TypeError(f"case: must be the path of a case file, its text, or a dict, not {type(case).__name__}")
    return os.fspath(case)


def impact(case: Case) -> Rebound | Sweep:
    """The impact of a case; for a sweep all impacts, arrays (n,), computed in parallel.

    `case` is a path, a text or a dict, as of all functions here:

    >>> import carom
    >>> steel = {"young_modulus": "208 GPa", "poisson": 0.3}
    >>> ball = {"shape": "sphere", "radius": 0.01, "density": 7850, "material": steel, "velocity": [0.5, 0, -1]}
    >>> floor = {"shape": "plane", "material": steel, "fixed": True}
    >>> round(carom.cases.impact({"body_1": ball, "body_2": floor, "contact": {"friction": 0.2}}).R_x, 3)
    0.428

    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "balls.toml"
    >>> once = carom.cases.new("impact")
    >>> _ = path.write_text(once.replace("friction = 0.2", "friction = [0.05, 0.1, 0.2]"))
    >>> rebounds = carom.cases.impact(path)
    >>> assert isinstance(rebounds, carom.cases.Sweep)  # for type checkers: the file has several impacts
    >>> rebounds.swept[0], rebounds.R_x.shape
    ('contact.friction', (3,))
    """
    swept, columns, exceeded = _carom.case_impact(_given(case))
    warn(exceeded)
    if swept is None:
        return Rebound._of(columns)
    return Sweep._shaped(columns, (len(swept[2]),), swept)


def history(case: Case) -> HistorySteps:
    """A contact that is pressed, shifted and twisted: arrays (n,) with an entry for each step.

    Columns of the twist are NaN if the case has none.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "loop.toml"
    >>> _ = path.write_text(carom.cases.new("history"))
    >>> steps = carom.cases.history(path)
    >>> bool((np.hypot(steps.F_x, steps.F_y) <= 0.3 * steps.F_z * (1 + 1e-12)).all())
    True
    """
    columns, exceeded = _carom.case_history(_given(case))
    warn(exceeded)
    return HistorySteps._shaped(columns, (len(columns["step"]),))


def solve(case: Case, *, accuracy: float | None = None) -> Solved:
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
    steps, axes, fields, cells, told = _carom.case_solve(_given(case), accuracy)
    warn(told)
    named = gridded(axes, fields, cells, told[0])
    return Solved({"steps": SolverSteps._shaped(steps, (len(steps["step"]),)), **named})


def hertz(case: Case) -> HertzStates | LineStates:
    """The contact of two surfaces under each of its normal loads, arrays (n,); along a line with `contact.length`.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "lens.toml"
    >>> _ = path.write_text(carom.cases.new("hertz"))
    >>> states = carom.cases.hertz(path)
    >>> bool((states.peak_pressure > 0).all())
    True
    """
    columns, exceeded = _carom.case_hertz(_given(case))
    warn(exceeded)
    kind = LineStates if "half_width" in columns else HertzStates
    return kind._shaped(columns, (len(columns["force"]),))


def stress(case: Case) -> Stresses:
    """The stresses in a body below a contact with normal force (Hertz) and tangential force (Cattaneo and Mindlin).

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "ball.toml"
    >>> _ = path.write_text(carom.cases.new("stress"))
    >>> below = carom.cases.stress(path)
    >>> below.stress.shape == (len(below.depth), len(below.y), len(below.x), 6)
    True
    >>> bool(np.allclose(carom.von_mises(below.stress), below.von_mises))
    True
    """
    contact, stick_radius, (x, y, depth), (flat, *scalars), exceeded = _carom.case_stress(_given(case))
    warn(exceeded)
    shape = (len(depth), len(y), len(x))
    von_mises, maximum_shear = (values.reshape(shape) for values in scalars)
    return Stresses(
        {
            "contact": (LineState if "half_width" in contact else HertzState)._of(contact),
            "stick_radius": stick_radius,
            "x": x,
            "y": y,
            "depth": depth,
            "stress": flat.reshape(*shape, 6),
            "von_mises": von_mises,
            "maximum_shear": maximum_shear,
        }
    )


def scene(case: Case, *, points: int = 0) -> Scene:
    """Path, bounces and events of a ball between walls; with `points` also the ball at so many instants of every flight.

    `points` is 0 or from 2 to 100000.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "ball.toml"
    >>> _ = path.write_text(carom.cases.new("scene").replace("[0, 0, 0.5]", "[0, 0, 0.1]"))
    >>> scene = carom.cases.scene(path, points=20)
    >>> len(scene.path) % 20, bool(scene.path.time[-1] <= scene.end.time), scene.events.event[:2]
    (0, True, ['bounce', 'apex'])
    """
    count = counted("points", points)
    if count == 1 or count > 100_000:
        error = RangeError(f"points = {count} is out of range: must be 0 or from 2 to 100000")
        error.field, error.value, error.index = "points", float(count), None
        raise error
    (bounces, events, ending, end, course), exceeded = _carom.case_scene(_given(case), count)
    warn(exceeded)
    return Scene(
        {
            "bounces": Bounces._shaped(bounces, (len(bounces["time"]),)),
            "events": PathEvents._shaped(events, (len(events["time"]),)),
            "ending": ending,
            "end": PathPoint._of(end),
            "path": PathPoints._shaped(course, (len(course["time"]),)),
        }
    )


def roll(
    case: Case, *, coefficients: bool = False, fastsim: bool = False, table: bool = False
) -> Rolled:
    """A rolling contact: creep forces in the steady state, or step by step from rest.

    `coefficients` also computes Kalker's creep coefficients of the contact, `fastsim` the forces of FASTSIM in the
    steady state, `rows.F_x_springs` and `rows.F_y_springs`, `table` those of the table of `carom.creep_force`,
    `rows.F_x_table` to `rows.table_error`. `carom.plot` draws the last contact.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "wheel.toml"
    >>> _ = path.write_text(carom.cases.new("roll"))
    >>> rolled = carom.cases.roll(path)
    >>> bool((rolled.rows.used <= 1 + 1e-6).all()), rolled.rows.slides.dtype
    (True, dtype('bool'))
    """
    rows, creep, axes, (fields, cells), (exceeded, is_outside), others = _carom.case_roll(
        _given(case), coefficients, fastsim, table
    )
    warn((exceeded + others, is_outside))
    return Rolled(
        {
            "rows": RollStates._shaped(rows, (len(rows["creepage"]),)),
            "coefficients": None if creep is None else CreepCoefficients._of(creep),
            **gridded(axes, fields, cells, exceeded + others),
        }
    )


def shell(case: Case) -> Bellows | Flange:
    """A bellows under pressure and axial load, or a flange under forces around it.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "bellows.toml"
    >>> _ = path.write_text(carom.cases.new("shell"))
    >>> bellows = carom.cases.shell(path)
    >>> bool(bellows.loads.force[2] > -bellows.loads.force[0])  # extension stiffens
    True
    """
    kind, summary, loads, places, warnings = _carom.case_shell(_given(case))
    warn((warnings, True))
    if kind == "bellows":
        assert loads is not None
        return Bellows(
            {
                "response": BellowsResponse._of(summary),
                "loads": BellowsStates._shaped(loads, (len(loads["force"]),)),
                "places": WallPlaces._shaped(places, (len(places["parameter"]),)),
                "warnings": warnings,
            }
        )
    return Flange(
        {
            "summary": FlangeSummary._of(summary),
            "places": RingPlaces._shaped(places, (len(places["angle"]),)),
            "warnings": warnings,
        }
    )
