"""Whole contacts of many pairs of grains."""

from __future__ import annotations

from copy import copy
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _carom, _show
from ._arrays import counted, flag, number, spread, two, within
from ._carom import Material, MaterialPair
from ._contact_theory import hertz_of_spheres
from ._types import Array

if TYPE_CHECKING:
    from typing_extensions import Self


UNITS = {"place": "m", "velocity": "m/s", "spin": "rad/s"}
ROLLING = {"stiffness": "N/m", "damping": "N*s/m", "friction": ""}


def _above_zero(name: str, both: tuple[float, float]) -> tuple[float, float]:
    """A quantity of both bodies."""
    one, other = (within(f"{name}_{k}", x, x > 0, "> 0") for k, x in enumerate(both, 1))
    return one, other


def _resistance(rolling: object) -> list[float]:
    """Stiffness, damping and friction of a resistance to rolling."""
    if not isinstance(rolling, list | tuple | np.ndarray) or len(rolling) != len(ROLLING):
        raise ValueError(f"rolling: must be three numbers, ({', '.join(ROLLING)}), not {rolling!s:.60}")
    given = {f"rolling: {name}": (x, unit) for (name, unit), x in zip(ROLLING.items(), rolling, strict=True)}
    values = {name: number(name, x, unit) for name, (x, unit) in given.items()}
    return [within(name, x, 0 <= x < np.inf, "finite and >= 0") for name, x in values.items()]


class GrainLoads(NamedTuple):
    """The loads of contacts: forces on body 1 (N) and torques on both bodies about their centres (N m), arrays (n, 3)."""

    force: Array
    torque_1: Array
    torque_2: Array


class GrainContacts:
    """The contacts of many pairs of spheres, or of spheres and walls, as a particle code has them: positions and motions in,
    forces and torques out.

    All pairs have the `radii` of body 1 and 2 (m), an infinite one for a wall, and their materials. `law` is 'coulomb',
    'fixed-direction' or 'rings', as for `Contacts`. `relaxation` is the viscous relaxation time of the materials (s);
    with `restitution` below 1 grains part with so much of the speed with which they met, which needs `masses` (kg).
    With `torsion` friction resists the spin about the normal; 'rings' always counts it.

    `rolling` is a resistance to rolling, (stiffness, damping, friction): a spring (N/m) and a dashpot (N s/m) side by
    side, in series with a slider, whose force is at most `friction` times the normal force. With 1/R = 1/R_1 + 1/R_2 the
    bodies roll with the velocity R (spin_1 - spin_2) x normal; the force has the arm R.

    >>> import carom
    >>> glass = carom.Material(70e9, 0.22)
    >>> contacts = carom.GrainContacts(2, (1e-3, float("inf")), glass, 0.0, rolling=(1e6, 0.1, 0.01))
    >>> for _ in range(100):
    ...     loads = contacts.step(1e-6, [0.0, 0.0, 1e-3 - 1e-8], spin_1=[[0.0, 0.0, 0.0], [0.0, 9.0, 0.0]])
    >>> (loads.torque_1[:, 1] / loads.force[:, 2] / 1e-3).round(9).tolist()
    [0.0, -0.01]
    """

    def __init__(
        self,
        count: int,
        radii: tuple[float, float],
        materials: MaterialPair | Material,
        friction: float,
        *,
        law: str = "coulomb",
        relaxation: float = 0.0,
        restitution: float = 1.0,
        masses: tuple[float, float] = (np.inf, np.inf),
        torsion: bool = False,
        rolling: tuple[float, float, float] | None = None,
    ) -> None:
        pair = materials if isinstance(materials, MaterialPair) else MaterialPair(materials)
        both = _above_zero("radius", two("radii", radii, "m"))
        within("radius_1", both[0], both[0] < np.inf, "finite")
        hertz = hertz_of_spheres(*both, pair.material_1, pair.material_2)
        resists = None if rolling is None else _resistance(rolling)
        if not isinstance(law, str):
            raise TypeError(f"law: must be a name, not {law!r:.60}")
        options = (law, number("relaxation", relaxation, "s"), number("restitution", restitution), flag("torsion", torsion), resists)
        bodies = [both, _above_zero("mass", two("masses", masses, "kg"))]
        self._native = _carom.GrainContacts(counted("count", count), hertz, bodies, number("friction", friction), options)

    def __len__(self) -> int:
        return len(self._native)

    def step(
        self,
        dt: float,
        place_1: ArrayLike,
        velocity_1: ArrayLike = 0.0,
        spin_1: ArrayLike = 0.0,
        place_2: ArrayLike = 0.0,
        velocity_2: ArrayLike = 0.0,
        spin_2: ArrayLike = 0.0,
        *,
        heat: bool = False,
    ) -> GrainLoads:
        """A step of duration `dt` (s), at the end of which the centres are at `place_1` and `place_2` (m); velocities (m/s)
        and spins (rad/s) are those that led there. Arrays (n, 3), or one vector for all.

        Of a wall `place_2` is the point nearest to body 1, and `velocity_2` its velocity. If one contact is out of range,
        none is advanced. `heat` adds to `heats`, which costs several times as much. Without damping, friction of the last
        four steps before the bodies part is the mean over each of them, and may exceed the friction limit of the force at
        their end.
        """
        places, velocities, spins = (place_1, place_2), (velocity_1, velocity_2), (spin_1, spin_2)
        return self._step(dt, {"place": places, "velocity": velocities, "spin": spins}, heat)

    def _step(self, dt: float, given: dict[str, tuple[ArrayLike, ArrayLike]], heat: bool) -> GrainLoads:
        """A step, one function below the call of the user, to which warnings point."""
        bodies = np.empty((len(self), 2, 3, 3))
        for i, (name, both) in enumerate(given.items()):
            for k, one in enumerate(both):
                values = spread(f"{name}_{k + 1}", one, (len(self), 3), UNITS[name])
                for value in values[~np.isfinite(values)]:
                    within(f"{name}_{k + 1}", float(value), False, "finite")
                bodies[:, k, i] = values
        loads = self._native.step(number("dt", dt, "s"), bodies.reshape(-1, 9), flag("heat", heat))
        return GrainLoads(*(loads[:, i : i + 3] for i in (0, 3, 6)))

    @property
    def heats(self) -> dict[str, float]:
        """The heat so far of the steps with `heat=True`, by its cause: friction, damping, rolling, J."""
        return dict(zip(("friction", "damping", "rolling"), self._native.heats, strict=True))

    @property
    def stored_energy(self) -> Array:
        """The elastic energy of each contact: of compression, shift, twist and rolling, J."""
        return self._native.stored_energy

    def __copy__(self) -> Self:
        other = object.__new__(type(self))
        other._native = copy(self._native)
        return other

    def _rows(self) -> list[_show.Row]:
        return [
            ("count", str(len(self)), "", "number of contacts"),
            ("stored_energy", _show.short(self.stored_energy), "J", "of each"),
        ]

    def __repr__(self) -> str:
        return _show.text("GrainContacts", self._rows())

    def _repr_html_(self) -> str:
        return _show.html("GrainContacts", self._rows())
