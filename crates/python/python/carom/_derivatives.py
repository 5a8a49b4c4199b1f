"""Derivatives of the rebound of spheres and planes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import _carom
from ._arrays import number
from ._carom import Body
from ._impact import UP, _along
from ._types import Array, Vector

_MOTION = [(f"_{what}_{axis}", unit) for what, unit in (("velocity", "m/s"), ("spin", "rad/s")) for axis in "xyz"]
_OF_BODIES = {"radius": "m", "mass": "kg", "inertia_ratio": "", "shear_modulus": "Pa", "poisson": ""}
#: Units of velocities and spins before and after, body by body, and of the inputs in their order.
_MOTIONS = {f"body_{i}{name}": unit for i in (1, 2) for name, unit in _MOTION}
_INPUTS = _MOTIONS | {f"body_{i}_{name}": unit for name, unit in _OF_BODIES.items() for i in (1, 2)}
_INPUTS |= {"friction": "", "kappa": ""}


@dataclass(frozen=True, eq=False)
class ReboundDerivatives:
    """A rebound with its derivatives: `found["body_1_velocity_x", "friction"]` is one of them.

    `inputs` and `outputs` are names with their units; `matrix` has a row for each output and a column for each input. An
    `inertia_ratio` is I/(m R^2), which mass and radius leave as it is; `kappa` is the ratio of the stiffnesses alone. `is_at_change` says
    whether the regimes of the impact change here, so that derivatives are those of one side.
    """

    values: Array
    matrix: Array
    is_at_change: bool

    @property
    def inputs(self) -> dict[str, str]:
        """Names and units of what the rebound depends on."""
        return dict(_INPUTS)

    @property
    def outputs(self) -> dict[str, str]:
        """Names and units of velocities and spins after the impact."""
        return dict(_MOTIONS)

    def __getitem__(self, names: tuple[str, str]) -> float:
        output, of = names
        for name, known in ((output, _MOTIONS), (of, _INPUTS)):
            if name not in known:
                raise KeyError(f"{name}: must be one of {', '.join(known)}")
        return float(self.matrix[list(_MOTIONS).index(output), list(_INPUTS).index(of)])


def rebound_derivatives(
    body_1: Body, body_2: Body, friction: float, *, normal: Vector | None = UP, kappa: float | None = None
) -> ReboundDerivatives:
    """Velocities and spins of spheres or planes after an elastic impact, with their derivatives by all inputs.

    Derivatives are exact where the contact slides throughout, elsewhere within 1e-7 of the largest of a row (inputs measured by
    their sizes). The arguments are those of `collide`; `kappa` replaces the ratio of the stiffnesses, of the materials. The
    spin about the normal and the line of centres are kept; the coupling of dissimilar materials is neglected.

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
        raise ValueError("body_1 and body_2: must be spheres or planes that approach each other")
    values, entries, is_at_change = found
    return ReboundDerivatives(np.array(values), entries.reshape(len(_MOTIONS), len(_INPUTS)), is_at_change)
