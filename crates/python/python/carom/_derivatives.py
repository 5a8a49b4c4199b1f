"""Derivatives of the rebound of spheres and planes."""

from __future__ import annotations

import numpy as np

from . import _carom
from ._arrays import number
from ._carom import Body
from ._impact import UP, _along
from ._record import Result
from ._types import Array, Vector
from ._validity import warn

#: Velocities and spins before and after, body by body, and all inputs, in their order.
_MOTIONS = [f"body_{i}_{what}_{axis}" for i in (1, 2) for what in ("velocity", "spin") for axis in "xyz"]
_OF_BODIES = ("radius", "mass", "inertia_ratio", "shear_modulus", "poisson")
_INPUTS = [*_MOTIONS, *(f"body_{i}_{name}" for name in _OF_BODIES for i in (1, 2)), "friction", "kappa"]


class ReboundDerivatives(Result):
    """A rebound with its derivatives: `found["body_1_velocity_x", "friction"]` is one of them, in SI units.

    An `inertia_ratio` is I/(m R^2), which mass and radius leave as it is; `kappa` is the ratio of the stiffnesses alone.
    """

    values: Array
    matrix: Array
    is_at_change: bool
    outputs: list[str]
    inputs: list[str]

    meanings = {
        "values": "velocities and spins after the impact",
        "matrix": "their derivatives, a row for each output and a column for each input",
        "is_at_change": "whether the regimes of the impact change here, so that derivatives are those of one side",
        "outputs": "names of the rows",
        "inputs": "names of the columns",
    }
    units = dict.fromkeys(meanings, "")

    def __getitem__(self, names: tuple[str, str]) -> float:
        for name, known in zip(names, (self.outputs, self.inputs), strict=True):
            if name not in known:
                raise KeyError(f"{name}: must be one of {', '.join(known)}")
        return float(self.matrix[self.outputs.index(names[0]), self.inputs.index(names[1])])


def rebound_derivatives(
    body_1: Body, body_2: Body, friction: float, *, normal: Vector | None = UP, kappa: float | None = None
) -> ReboundDerivatives:
    """Velocities and spins of spheres or planes after an elastic impact, with their derivatives by all inputs.

    Derivatives are exact where the contact slides throughout, elsewhere within 1e-7 of the largest of a row (inputs measured by
    their sizes). The arguments are those of `collide`; `kappa` replaces the ratio of the stiffnesses, of the materials. The
    spin about the normal is kept, and the coupling of dissimilar materials neglected. Balls that glance, so that their line
    of centres turns, are refused.

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> ball = carom.sphere(0.01, steel, 0.033, velocity=(9.0, 0, -1.0))
    >>> found = carom.rebound_derivatives(ball, carom.plane(steel), 0.1)
    >>> round(found["body_1_velocity_x", "friction"], 12)  # it slides: v_x' = v_x - 2 f |v_z|
    -2.0
    """
    along = _along(body_1, body_2, normal)
    ratio = None if kappa is None else number("kappa", kappa)
    found = _carom.rebound_derivatives(body_1, body_2, number("friction", friction), along, ratio)
    if found is None:
        raise ValueError(
            "body_1 and body_2: must be spheres or planes that approach each other, and no balls that glance, so that their "
            "line of centres turns"
        )
    values, entries, is_at_change, told = found
    warn(told)
    matrix = entries.reshape(len(_MOTIONS), len(_INPUTS))
    names = {"outputs": list(_MOTIONS), "inputs": list(_INPUTS)}
    return ReboundDerivatives({"values": np.array(values), "matrix": matrix, "is_at_change": is_at_change, **names})
