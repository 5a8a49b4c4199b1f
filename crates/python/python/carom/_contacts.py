"""Many contacts with memory."""

from __future__ import annotations

from copy import copy
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import Array, counted, line, numbers, spread
from ._carom import Hertz


class Contacts:
    """Many contacts of the same constants, advanced together: arrays of shifts in, arrays of loads out.

    `stiffness` is a Hertz contact or (c_x, c_y, c_z); `law` is 'coulomb', to a `tolerance` of the friction
    limit, or 'fixed-direction', one direction of traction in a slip ring: faster, exact on straight
    paths. With `directions=1` only xi moves, and the law is exact and fastest. With `threads` all cores
    help, to the same bits.

    These laws neglect the coupling of dissimilar materials, which may change R_x of an impact by
    `coupling_bound`, and take no twist. `law='rings'` has both, for circular Hertz contacts: a step costs some
    microseconds.

    >>> import carom, numpy as np
    >>> glass = carom.Material(70e9, 0.22)
    >>> hertz = carom.hertz_of_spheres(1e-3, 1e-3, glass)
    >>> contacts = carom.Contacts(1000, hertz, friction=0.4)
    >>> loads = contacts.advance(np.full(1000, 1e-7), xi=np.linspace(0, 1e-7, 1000))
    >>> loads.shape, bool((loads[:, 0] <= 0.4 * loads[:, 2] * (1 + 1e-12)).all())
    ((1000, 3), True)
    """

    def __init__(
        self,
        count: int,
        stiffness: Hertz | tuple[float, float, float],
        friction: float,
        *,
        law: str = "coulomb",
        tolerance: float = 1e-2,
        directions: int = 2,
        threads: bool = False,
    ) -> None:
        self._native = _carom.Contacts(
            counted("count", count), stiffness, friction, law, tolerance, directions, threads
        )
        self._directions = directions

    def __len__(self) -> int:
        return len(self._native)

    def advance(
        self,
        zeta: ArrayLike,
        xi: ArrayLike = 0.0,
        eta: ArrayLike | None = None,
        omega: ArrayLike | None = None,
    ) -> Array:
        """Goes straight to new shifts (m), one for each contact or one for all; returns the loads (n, 3), N.

        All go, or none. `omega` is the twist about the normal (radians) of law 'rings'; the loads are then
        (F_x, F_y, F_z, M_z), an array (n, 4).
        """

        def column(name: str, shift: ArrayLike) -> Array:
            return spread(name, shift, (len(self),)).reshape(-1, 1)

        across = None if eta is None else column("eta", eta)
        twist = None if omega is None else column("omega", omega)
        return self.follow(column("zeta", zeta), column("xi", xi), across, twist)[:, 0]

    def follow(
        self,
        zeta: ArrayLike,
        xi: ArrayLike = 0.0,
        eta: ArrayLike | None = None,
        omega: ArrayLike | None = None,
        *,
        out: Array | None = None,
    ) -> Array:
        """Goes along paths, arrays (n, steps) of shifts (m); returns the loads (n, steps, 3), N.

        All go, or none. `out` is where to write the loads, if given. With `omega`, of law 'rings', they have M_z
        behind the forces: (n, steps, 4).
        """
        told = {"zeta": zeta, "xi": xi} | {
            name: shift for name, shift in (("eta", eta), ("omega", omega)) if shift is not None
        }
        given = {name: numbers(name, v) for name, v in told.items()}
        lengths = (v.shape[-1] for v in given.values() if v.ndim)
        steps = next((length for length in lengths if length != 1), 1)
        shape = (len(self), steps)
        paths = {name: line(spread(name, v, shape)) for name, v in given.items()}
        whole = shape + (3 if omega is None else 4,)
        loads = np.empty(whole) if out is None else out
        fits = isinstance(loads, np.ndarray) and loads.shape == whole and loads.dtype == np.float64
        if not fits or not loads.flags.carray:
            raise ValueError(f"out: must be a contiguous array of float64 of shape {whole}")
        if any(np.may_share_memory(loads, way) for way in paths.values()):
            raise ValueError("out: must not be the memory of the paths")
        across = (paths.get(name) for name in ("eta", "omega"))
        self._native.follow(steps, paths["zeta"], paths["xi"], *across, loads.reshape(-1))
        return loads

    @property
    def loads(self) -> Array:
        """The present loads (F_x, F_y, F_z), N, an array (n, 3)."""
        return self._native.loads

    @property
    def torques(self) -> Array:
        """The present torques about the normal M_z, N m, an array (n,); 0 but for law 'rings'."""
        return self._native.torques

    @property
    def coupling_bound(self) -> float | None:
        """A bound of how much the coupling of dissimilar materials, which the law neglects, changes R_x of an impact.

        0 of like materials and for law 'rings'; None if the materials are not known.
        """
        return self._native.coupling_bound

    @property
    def stored_energy(self) -> Array:
        """The elastic energy of each contact, compression included, J."""
        return self._native.stored_energy

    def __copy__(self) -> Self:
        other = object.__new__(type(self))
        other._native, other._directions = copy(self._native), self._directions
        return other

    def __repr__(self) -> str:
        return f"Contacts({len(self)}, directions={self._directions})"
