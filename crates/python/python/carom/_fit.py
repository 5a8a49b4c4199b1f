"""Unknown numbers of a case from measured data."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import flag, numbers
from ._record import Result
from ._records import FitCorrelations, FitParameter, FitParameters, FitPoints, FitPredictions, FitQuality
from ._validity import warn
from .cases import Case, _given

#: Measured data: columns by name, a DataFrame, or the path of a file of comma-separated values.
Columns = Union[Mapping[str, Any], Any]


class Fit(Result):
    """What data tell of the unknown numbers of a case. `fit["contact.friction"]` is one of them.

    `statements` says in sentences what the data leave open.
    """

    parameters: FitParameters
    quality: FitQuality
    correlations: FitCorrelations
    points: FitPoints
    predictions: FitPredictions
    statements: list[str]

    meanings = {
        "parameters": "the unknowns",
        "quality": "how well the theory meets the data",
        "correlations": "of the unknowns",
        "points": "measured values beside the fitted ones",
        "predictions": "for the inputs that were asked for",
        "statements": "what the data leave open",
    }
    units = dict.fromkeys(meanings, "")

    def __getitem__(self, name: str) -> FitParameter:
        names = self.parameters.parameter
        fitting = [i for i, own in enumerate(names) if own == name or own.rsplit(".", 1)[-1] == name]
        if len(fitting) != 1:
            raise KeyError(f"{name}: must be one of {', '.join(names)}")
        return self.parameters[fitting[0]]

    def __repr__(self) -> str:
        parts = [repr(self.parameters), repr(self.quality), *self.statements]
        return "\n".join(parts)


def _table(name: str, data: Columns) -> list[tuple[str, list[float]]]:
    """Headings and numbers of data in any form."""
    if isinstance(data, (str, os.PathLike)):
        with open(data, encoding="utf-8") as file:
            return _carom.fit_table(file.read())
    columns = data if isinstance(data, Mapping) else getattr(data, "columns", None)
    if columns is None:
        given = type(data).__name__
        raise TypeError(f"{name}: must be columns by name, a DataFrame or the path of a CSV file, not {given}")

    def numbers(heading: str) -> list[float]:
        try:
            values = np.ma.filled(np.ma.asarray(data[heading], dtype=np.float64), np.nan)
        except (TypeError, ValueError) as error:
            raise TypeError(f"{name}[{heading!r}]: must be numbers: {error}") from None
        return [float(value) for value in np.atleast_1d(values)]

    return [(str(heading), numbers(heading)) for heading in columns]


def fit(
    case: Case,
    data: Columns,
    *,
    sd: ArrayLike | Mapping[str, ArrayLike] | None = None,
    robust: bool = False,
    predict: Columns | None = None,
) -> Fit:
    """The unknown numbers of a case, the path of its file, from measured data, as the command `carom fit`.

    In the case a number is unknown if it is `{ fit = [low, high] }` or `{ prior = { mean, sd } }`. Columns of `data` are
    numbers that the case states and each row replaces (`angle`, `body_1.velocity.x`), measured quantities (`R_x`,
    `body_1_spin_y`; NaN where none was measured) and their standard errors (`R_x_sd`); a unit may follow the name, as
    `angle (deg)`. `sd` is the standard error of the measured quantity, one or one of each row, or a mapping from names to them, in the
    unit of the column or one that follows the name; without any it is estimated. `robust` lets single wrong values count little (pseudo-Huber loss). `predict` are inputs of predictions.

    >>> import carom, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "ball.toml"
    >>> _ = path.write_text('''
    ... body_1 = { shape = "sphere", radius = 2.5e-3, material = { young_modulus = 380e9, poisson = 0.23 }, density = 4000 }
    ... body_2 = { shape = "plane", material = { young_modulus = 70e9, poisson = 0.25 }, fixed = true }
    ... approach = { speed = 3.9, angle = 45 }
    ... contact = { friction = { fit = [0.01, 1] }, normal_over_tangential_stiffness = { fit = [0.8, 1.5] } }
    ... ''')
    >>> measured = {"angle": [4.2, 9.8, 20.2, 30.4, 49.6, 71.1], "body_1_tangential_ratio": [0.75, 0.68, 0.60, 0.69, 0.85, 0.94]}
    >>> fit = carom.fit(path, measured, sd=0.014)
    >>> round(fit["friction"].value, 2), fit.quality.degrees_of_freedom
    (0.09, 4)
    """
    if sd is None:
        errors: list[tuple[str | None, list[float]]] = []
    elif isinstance(sd, Mapping):
        errors = [(str(name), numbers(f"sd[{name!r}]", error).ravel().tolist()) for name, error in sd.items()]
    else:
        errors = [(None, numbers("sd", sd).ravel().tolist())]
    ahead = None if predict is None else _table("predict", predict)
    tables, statements, told = _carom.fit(_given(case), _table("data", data), errors, flag("robust", robust), ahead)
    warn(told)
    parameters, quality, correlations, points, predictions = tables
    results = {
        "parameters": FitParameters._shaped(parameters, (len(parameters["parameter"]),)),
        "quality": FitQuality._of(quality),
        "correlations": FitCorrelations._shaped(correlations, (len(correlations["first"]),)),
        "points": FitPoints._shaped(points, (len(points["quantity"]),)),
        "predictions": FitPredictions._shaped(predictions, (len(predictions["quantity"]),)),
        "statements": statements,
    }
    return Fit(results)
